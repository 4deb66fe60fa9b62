//! Reads a state from the text behind the `#` in the address of the page: `key=value` pairs with `&` between them.
//!
//! ```text
//! pot=textured&turn=496&tilt=504&method=inside_area&precision=sub8&rows=1&depth=rgb565
//! item=KIND,RRGGBB,SIZE,X:Y;X:Y;..,TEXT      as many as there are items, the lowest one first
//! ```
//!
//! Positions and sizes are in pixels, as decimals; the letters of a text are percent-encoded. What cannot be read is left
//! out: an address that somebody has cut off still shows what is left of it.

use embedded_graphics::pixelcolor::Rgb888;
use heapless::{String, Vec};

use crate::state::{Depth, Item, Kind, LETTERS, Method, POINTS, Pot, Precision, State};

/// The farthest coordinate, in 1/256 pixel: four times the height of the panel.
const FARTHEST: i32 = 1280 * 256;
/// The largest width of a line and size of a text, in 1/256 pixel.
const LARGEST: i32 = 320 * 256;
/// The most rows of a band but for all of them.
const MOST_ROWS: u32 = 16;

impl State {
    /// The state that a text names.
    pub fn of_address(text: &str) -> Self {
        let mut state = Self::EMPTY;
        for (key, value) in text.split('&').filter_map(|pair| pair.split_once('=')) {
            state.set(key, value);
        }
        state
    }

    fn set(&mut self, key: &str, value: &str) {
        match key {
            "pot" => self.pot = Pot::of_name(value).unwrap_or(self.pot),
            "turn" => self.turn = steps(value).unwrap_or(self.turn),
            "tilt" => self.tilt = steps(value).unwrap_or(self.tilt),
            "method" => self.method = Method::of_name(value).unwrap_or(self.method),
            "precision" => self.precision = Precision::of_name(value).unwrap_or(self.precision),
            "rows" => self.rows = value.parse().map_or(self.rows, |rows: u32| rows.min(MOST_ROWS)),
            "depth" => self.depth = Depth::of_name(value).unwrap_or(self.depth),
            "item" => {
                if let Some(item) = item(value) {
                    // One more than there is room for is left out.
                    let _ = self.items.push(item);
                }
            }
            _ => (),
        }
    }
}

/// An angle in 1/512 of a turn.
fn steps(text: &str) -> Option<u32> {
    let steps: u32 = text.parse().ok()?;
    Some(steps % 512)
}

fn item(text: &str) -> Option<Item> {
    let mut parts = text.split(',');
    let kind = Kind::of_name(parts.next()?)?;
    let [_, red, green, blue] = u32::from_str_radix(parts.next()?, 16).ok()?.to_be_bytes();
    let size = units(parts.next()?)?.clamp(0, LARGEST);
    let points: Vec<_, POINTS> = parts.next()?.split(';').filter_map(point).take(POINTS).collect();
    let needed = match kind {
        Kind::Polygon | Kind::EvenOdd => 3,
        Kind::Line | Kind::Circle => 2,
        Kind::Text => 1,
    };
    (points.len() >= needed).then(|| Item {
        kind,
        color: Rgb888::new(red, green, blue),
        size,
        points,
        text: decoded(parts.next().unwrap_or_default()),
    })
}

fn point(text: &str) -> Option<[i32; 2]> {
    let (x, y) = text.split_once(':')?;
    let coordinate = |text| Some(units(text)?.clamp(-FARTHEST, FARTHEST));
    Some([coordinate(x)?, coordinate(y)?])
}

/// A decimal number of pixels, rounded to the nearest 1/256 pixel.
fn units(text: &str) -> Option<i32> {
    let (is_negative, digits) = match text.strip_prefix('-') {
        Some(digits) => (true, digits),
        None => (false, text),
    };
    let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
    if !fraction.bytes().all(|digit| digit.is_ascii_digit()) {
        return None;
    }
    // Up to eight digits of a fraction: 1/256 has as many.
    let fraction = fraction.get(..8).unwrap_or(fraction);
    let scale = 10i64.pow(fraction.len() as u32);
    let whole: u16 = whole.parse().ok()?;
    let fraction: u32 = if fraction.is_empty() { 0 } else { fraction.parse().ok()? };
    let numerator = (i64::from(whole) * scale + i64::from(fraction)) * 256;
    let units = i32::try_from((2 * numerator + scale) / (2 * scale)).ok()?;
    Some(if is_negative { -units } else { units })
}

/// Takes the percent-encoding of a text away; what the font does not have becomes a question mark.
fn decoded(text: &str) -> String<LETTERS> {
    let mut letters = String::new();
    let mut bytes = text.bytes();
    while let Some(byte) = bytes.next() {
        let byte = if byte == b'%' {
            encoded_byte(&mut bytes).unwrap_or(b'?')
        } else {
            byte
        };
        let letter = if (b' '..=b'~').contains(&byte) {
            char::from(byte)
        } else {
            '?'
        };
        if letters.push(letter).is_err() {
            break;
        }
    }
    letters
}

/// The byte that two hexadecimal digits name.
fn encoded_byte(digits: &mut impl Iterator<Item = u8>) -> Option<u8> {
    let mut digit = || char::from(digits.next()?).to_digit(16);
    let (high, low) = (digit()?, digit()?);
    u8::try_from(16 * high + low).ok()
}

#[cfg(test)]
mod tests {
    use embedded_graphics::pixelcolor::RgbColor;

    use super::*;

    #[test]
    fn decimals_become_units_of_a_256th() {
        for (text, expected) in [
            ("0", 0),
            ("1.5", 384),
            ("-1.5", -384),
            ("120.00390625", 120 * 256 + 1),
            ("0.001953125", 0),
            ("0.00195313", 1),
        ] {
            assert_eq!(units(text), Some(expected), "{text}");
        }
        for wrong in ["", "x", "1.x", "1.-5", "1.+5", "--1", "99999", "0.1234567ééééééé"] {
            assert_eq!(units(wrong), None, "{wrong}");
        }
    }

    #[test]
    fn an_address_names_a_state() {
        let state = State::of_address(
            "pot=flat&turn=600&method=rooks_4&precision=sub4&rows=4&depth=gray4\
             &item=text,ff8000,23.5,10:20.25,42%20km%2Fh&item=line,00ff00,3,1:2;3:-4",
        );
        assert_eq!((state.pot, state.turn, state.tilt), (Pot::Flat, 88, 504));
        assert_eq!((state.method, state.precision), (Method::Rooks4, Precision::Sub4));
        assert_eq!((state.rows, state.depth), (4, Depth::Gray4));
        let [text, line] = state.items.as_slice() else {
            panic!("{state:?}")
        };
        assert_eq!(
            (text.kind, text.text.as_str(), text.size),
            (Kind::Text, "42 km/h", 6016)
        );
        assert_eq!(text.color, Rgb888::new(255, 128, 0));
        assert_eq!(text.points, [[2560, 5184]]);
        assert_eq!((line.kind, line.color, line.size), (Kind::Line, Rgb888::GREEN, 768));
        assert_eq!(line.points, [[256, 512], [768, -1024]]);
    }

    #[test]
    fn what_cannot_be_read_is_left_out() {
        let state = State::of_address("pot=kettle&rows=x&rows=99&item=&item=line,00ff00,3,1:2&item=blob,0,0,0:0&=&a");
        assert_eq!((state.pot, state.rows), (Pot::None, 16));
        assert!(state.items.is_empty());
    }
}
