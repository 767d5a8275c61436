//! How numbers and lists are written in sentences: the one rule for what a person reads.
//!
//! A [`number`] that was found has at most four significant digits, a [`coordinate`] six, neither with trailing
//! zeros; an angle has three decimals ([`steady_angle`]), a share one in [`percent`]. A given number is repeated
//! as it is. The scripts of pages have the same rule in `viewer/numbers.js` of mindeg-compare, and
//! `tests/browser/numbers.txt` is what both are compared with.

/// A number as people read it: at most four significant digits, no trailing zeros, and no whole digit less below 1e9.
///
/// ```
/// use mindeg_mesh::number;
///
/// let numbers = [0.0, 60.0, 59.999_96, 0.012_345_6, 123_456.0, 1.5e-7, f64::INFINITY];
/// assert_eq!(numbers.map(number), ["0", "60", "60", "0.01235", "123456", "1.5e-7", "∞"]);
/// ```
#[must_use]
pub fn number(value: f64) -> String {
    significant(value, 4)
}

/// A coordinate: as [`number`], but six significant digits, so that places near each other read differently.
#[must_use]
pub fn coordinate(value: f64) -> String {
    significant(value, 6)
}

/// A place by its coordinates, in the plane or in space.
///
/// ```
/// use mindeg_mesh::place;
///
/// assert_eq!(place([0.1 + 0.2, 1.0]), "(0.3, 1)");
/// ```
#[must_use]
pub fn place<const N: usize>(at: impl Into<[f64; N]>) -> String {
    format!("({})", at.into().map(coordinate).join(", "))
}

/// An angle in degrees: to three decimals, and one too small for them as a [`number`].
///
/// ```
/// use mindeg_mesh::steady_angle;
///
/// assert_eq!([6.34, 26.565_05, 0.084_71].map(steady_angle), ["6.340°", "26.565°", "0.08471°"]);
/// ```
#[must_use]
pub fn steady_angle(degrees: f64) -> String {
    match degrees.abs() {
        0.1..1e9 => format!("{degrees:.3}°"),
        _ => format!("{}°", number(degrees)),
    }
}

/// A share in percent, in sentences and in columns: to one decimal, and none where the percent is whole, as a share that
/// was asked for is. What is more than nothing and less than all stays so.
///
/// ```
/// use mindeg_mesh::percent;
///
/// assert_eq!([1e-9, 0.9695, 0.95, 0.99999, 1.0].map(percent), ["<0.1%", "97.0%", "95%", ">99.9%", "100%"]);
/// ```
#[must_use]
pub fn percent(share: f64) -> String {
    match share * 100.0 {
        percent if percent == 0.0 || !(-1e9..1e9).contains(&percent) => {
            format!("{}%", number(percent))
        }
        percent if (percent - percent.round()).abs() < 1e-9 && percent >= 0.1 => {
            format!("{percent:.0}%")
        }
        percent if percent < 0.1 => "<0.1%".into(),
        percent if percent > 99.9 && percent < 100.0 => ">99.9%".into(),
        percent => format!("{percent:.1}%"),
    }
}

/// `value` with at most `digits >= 1` significant digits, and without trailing zeros: for the steps of axes and for
/// numbers to copy into a command. People read a [`number`].
///
/// ```
/// use mindeg_mesh::significant;
///
/// assert_eq!([6.340_19, 59.999_96, 1.234e-7].map(|v| significant(v, 3)), ["6.34", "60", "1.23e-7"]);
/// ```
#[must_use]
pub fn significant(value: f64, digits: usize) -> String {
    if !value.is_finite() {
        return if value > 0.0 { "∞".into() } else { "–".into() };
    }
    // Not "-0".
    let value = if value == 0.0 { 0.0 } else { value };
    let scientific = format!("{value:.*e}", digits - 1);
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let power: i32 = exponent.parse().unwrap_or(0);
    let trimmed = |text: &str| match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => text.to_owned(),
    };
    if (-5..9).contains(&power) {
        let decimals = (digits as i32 - 1 - power).max(0) as usize;
        trimmed(&format!("{value:.decimals$}"))
    } else {
        format!("{}e{power}", trimmed(mantissa))
    }
}

/// The first `most` of some texts, and an ellipsis if there are more.
///
/// ```
/// use mindeg_mesh::listed;
///
/// let names = || ["a", "b", "c"].map(str::to_owned);
/// assert_eq!([listed(names(), 3, ", "), listed(names(), 2, ", ")], ["a, b, c", "a, b, …"]);
/// ```
#[must_use]
pub fn listed(texts: impl IntoIterator<Item = String>, most: usize, between: &str) -> String {
    let mut texts = texts.into_iter();
    let mut first: Vec<String> = texts.by_ref().take(most).collect();
    first.extend(texts.next().map(|_| "…".to_owned()));
    first.join(between)
}
