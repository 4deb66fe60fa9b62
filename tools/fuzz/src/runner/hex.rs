//! Bytes as text, to be given back on a command line.

use anyhow::{Context, ensure};

/// Two digits a byte.
pub fn encode(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

/// The bytes again.
///
/// # Errors
/// The text is not made of pairs of digits.
pub fn decode(text: &str) -> anyhow::Result<Vec<u8>> {
    ensure!(
        text.len().is_multiple_of(2) && text.is_ascii(),
        "an even number of digits"
    );
    let pairs = (0..text.len()).step_by(2).map(|start| &text[start..start + 2]);
    pairs
        .map(|pair| u8::from_str_radix(pair, 16).with_context(|| format!("{pair} is no byte")))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_decoded_was_encoded() {
        assert_eq!(decode(&encode(&[0, 1, 0xfe, 0xff])).unwrap(), [0, 1, 0xfe, 0xff]);
        assert!(decode("0").is_err() && decode("0g").is_err() && decode("é").is_err());
    }
}
