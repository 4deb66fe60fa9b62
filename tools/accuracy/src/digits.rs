//! Numbers as people read them.

/// Three digits that matter, or all before the point.
pub fn digits(number: f64) -> String {
    let size = number.abs();
    let text = match () {
        () if size >= 100.0 || number.fract() == 0.0 => format!("{number:.0}"),
        () if size >= 10.0 => format!("{number:.1}"),
        () if size >= 1.0 => format!("{number:.2}"),
        () => format!("{number:.3}"),
    };
    let (whole, fraction) = text.split_once('.').unwrap_or((&text, ""));
    let mut grouped = String::new();
    for (index, digit) in whole.chars().enumerate() {
        if index > 0 && (whole.len() - index).is_multiple_of(3) && !grouped.ends_with('-') {
            grouped.push(',');
        }
        grouped.push(digit);
    }
    if fraction.is_empty() {
        grouped
    } else {
        format!("{grouped}.{fraction}")
    }
}

#[cfg(test)]
mod tests {
    use super::digits;

    #[test]
    fn small_numbers_keep_three_digits() {
        let texts = [0.0, 0.1234, 7.0, 7.123, 42.42, 1234.6].map(digits);
        assert_eq!(texts, ["0", "0.123", "7", "7.12", "42.4", "1,235"]);
    }
}
