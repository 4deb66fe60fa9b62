//! Texture coordinates as they are stored: u to the right and v down, in 1/4096 of the texture's width and height.

use anyhow::Context;

/// 1 in the stored format, `I4F12`.
const ONE: f64 = 4_096.0;

/// The stored coordinates of a face's corners from those of the file, in which v is up.
///
/// A face that does not fit is shifted by whole repeats of the texture.
///
/// # Errors
/// A face over more than 16 repeats.
pub fn of_face(corners: &[[f64; 2]]) -> anyhow::Result<Vec<[i16; 2]>> {
    let u = of_axis(corners.iter().map(|&[u, _]| u))?;
    let v = of_axis(corners.iter().map(|&[_, v]| 1.0 - v))?;
    Ok(u.into_iter().zip(v).map(|(u, v)| [u, v]).collect())
}

fn of_axis(values: impl Iterator<Item = f64>) -> anyhow::Result<Vec<i16>> {
    let stored: Vec<f64> = values.map(|value| (value * ONE).round()).collect();
    let fits = |shift: f64| -> Option<Vec<i16>> {
        let range = f64::from(i16::MIN)..=f64::from(i16::MAX);
        let shifted = stored.iter().map(|value| value + shift);
        shifted
            .map(|value| range.contains(&value).then_some(value as i16))
            .collect()
    };
    let least = stored.iter().copied().fold(f64::INFINITY, f64::min);
    // From repeat 0 on if it fits there, or else from -8 on.
    let shifted = |repeat: f64| (repeat - (least / ONE).floor()) * ONE;
    fits(0.0)
        .or_else(|| fits(shifted(0.0)))
        .or_else(|| fits(shifted(-8.0)))
        .context("the texture is repeated more than 15 times over a face: cut it into several faces, or use a larger picture")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn v_is_down_and_faces_move_by_whole_repeats() {
        let face = |corners: &[[f64; 2]]| of_face(corners).unwrap();
        assert_eq!(face(&[[0.0, 0.0], [0.25, 1.0]]), [[0, 4_096], [1_024, 0]]);
        assert_eq!(
            face(&[[-8.0, 9.0], [7.5, -6.5]]),
            [[-32_768, -32_768], [30_720, 30_720]]
        );
        // From 100.5 to 104 right is from 0.5 to 4.
        assert_eq!(face(&[[100.5, 1.0], [104.0, 1.0]]), [[2_048, 0], [16_384, 0]]);
        assert_eq!(face(&[[-20.25, 1.0], [-10.0, 1.0]]), [[-29_696, 0], [12_288, 0]]);
        assert!(of_face(&[[0.0, 0.0], [16.5, 0.0]]).is_err());
        assert!(of_face(&[[0.0, -1e9], [0.0, 1e9]]).is_err());
        assert!(of_face(&[[1e9, 0.0], [1e9, 0.5]]).is_ok());
    }
}
