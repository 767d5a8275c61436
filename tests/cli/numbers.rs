//! Numbers as people read them, in a table with which `tests/browser` compares the scripts of pages.

use super::pinned;
use mindeg_mesh::{number, percent, steady_angle};

#[test]
fn pinned_numbers_are_written_by_one_rule() {
    pinned::check("tests/browser/numbers.txt", |input| {
        let value = input.parse().unwrap_or(f64::NAN);
        format!("{} | {} | {}", number(value), steady_angle(value), percent(value))
    });
}
