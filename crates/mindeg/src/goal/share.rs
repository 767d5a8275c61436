//! Shares as people write them.

/// A share from `0.95` or `95%`.
pub(super) fn read(text: &str) -> Result<f64, String> {
    let text = text.trim();
    let (number, whole) = match text.strip_suffix('%') {
        Some(number) => (number.trim_end(), 100.0),
        None => (text, 1.0),
    };
    match number.parse::<f64>() {
        Ok(number) if (0.0..=whole).contains(&number) => Ok(number / whole),
        Ok(number) if whole == 1.0 && (1.0..=100.0).contains(&number) => Err(format!(
            "{number} is more than all of it; for {number} percent write {} or {number}%",
            number / 100.0
        )),
        _ => Err("give a share from 0 to 1, such as 0.95, or from 0% to 100%".to_owned()),
    }
}

/// A share as a percentage, if that is read back as the same number.
pub(super) fn percentage(share: f64) -> String {
    let percent = (share * 100.0).round();
    if percent / 100.0 == share { format!("{percent}%") } else { share.to_string() }
}
