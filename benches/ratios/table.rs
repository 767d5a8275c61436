//! Markdown tables.

/// Prints the head of a table; columns after the first are to the right.
pub(crate) fn head(title: &str, columns: &[&str]) {
    println!("\n### {title}\n\n| {} |", columns.join(" | "));
    println!("|---|{}", "--:|".repeat(columns.len() - 1));
}

/// Prints a row.
pub(crate) fn row(cells: &[String]) {
    println!("| {} |", cells.join(" | "));
}

/// A count with a power of ten where it is one.
pub(crate) fn count(count: u64) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let digits = count.to_string();
    let power = digits.len() - 1;
    if digits[1..].bytes().all(|digit| digit == b'0') && power < 10 {
        let times =
            if digits.starts_with('1') { String::new() } else { format!("{} × ", &digits[..1]) };
        return format!("{times}10{}", DIGITS[power]);
    }
    digits
}

/// A ratio that is to be `limit` at most.
pub(crate) fn at_most(ratio: f64, limit: f64) -> String {
    marked(format!("{ratio:.2}"), ratio <= limit)
}

/// A ratio that is to be `limit` at least.
pub(crate) fn at_least(ratio: f64, limit: f64) -> String {
    marked(format!("{ratio:.2}"), ratio >= limit)
}

/// A figure that is to meet its aim, in bold where it does not.
pub(crate) fn marked(text: String, met: bool) -> String {
    if met { text } else { format!("**{text}**") }
}
