//! Thin circles from a point to the largest radius of a screen's numbers.

use embedded_graphics::geometry::Point;
use zrow::{geometry::Window, scan::Conics};
use zrow_methods::UPRIGHT_SCREEN;

use crate::{
    axis::{Cell, Summary},
    digits::digits,
};

/// Radii, and the centre from which a part of the circle is seen.
const CASES: &[(&str, u32, (i32, i32))] = &[
    ("a point", 0, (120, 160)),
    ("radius 1", 1, (120, 160)),
    ("radius 2", 2, (120, 160)),
    ("radius 3", 3, (120, 160)),
    ("radius 119: touches both sides", 119, (120, 160)),
    (
        "radius 23,170: its diameter squared exceeds 31 bits",
        23_170,
        (23_290, 160),
    ),
    ("radius 32,767, seen at 45 degrees", 32_767, (23_290, 23_330)),
    ("radius 1,000,000,000", 1_000_000_000, (120, 1_000_000_160)),
];

/// How often the pixels of a circle in the window are wrong: no nearest ones, there twice, or missing.
fn wrong_pixels(radius: u32, center: (i32, i32), window: &Window, drawn: &[(i32, i32)]) -> usize {
    let is_nearest = |&(x, y): &(i32, i32)| {
        let offset = [
            i128::from(x) - i128::from(center.0),
            i128::from(y) - i128::from(center.1),
        ];
        let [near, far] = [
            offset[0].abs().min(offset[1].abs()),
            offset[0].abs().max(offset[1].abs()),
        ];
        // The circle is at sqrt(r^2 - near^2): within half a pixel of the offset along its larger axis, all in half pixels.
        let square = 4 * (i128::from(radius).pow(2) - near.pow(2));
        square <= (2 * far + 1).pow(2) && (far == 0 || square >= (2 * far - 1).pow(2))
    };
    let columns = window.left..window.right;
    let all = (window.top..window.bottom).flat_map(|y| columns.clone().map(move |x| (x, y)));
    let mut sorted = drawn.to_vec();
    sorted.sort_unstable();
    let twice = sorted.windows(2).filter(|pair| pair[0] == pair[1]).count();
    let different = all.filter(|pixel| is_nearest(pixel) != sorted.binary_search(pixel).is_ok());
    different.count() + twice
}

fn drawn(radius: u32, center: (i32, i32)) -> anyhow::Result<Vec<(i32, i32)>> {
    let center = Point::new(center.0, center.1);
    let points =
        Conics::bresenham_circle(center, radius, &UPRIGHT_SCREEN).map_err(|error| anyhow::anyhow!("{error}"))?;
    Ok(points.map(|point| (point.x, point.y)).collect())
}

/// A row for each circle.
pub fn summary() -> anyhow::Result<Summary> {
    let rows = CASES.iter().map(|&(title, radius, center)| {
        let pixels = drawn(radius, center)?;
        let wrong = wrong_pixels(radius, center, &UPRIGHT_SCREEN, &pixels);
        let figures = [pixels.len(), wrong].map(|number| digits(number as f64));
        Ok([title.to_owned()].into_iter().chain(figures).map(Cell::from).collect())
    });
    Ok(Summary {
        title: "Small and very large circles".to_owned(),
        columns: ["circle", "visible pixels", "wrong pixels of zrow"]
            .map(str::to_owned)
            .to_vec(),
        rows: rows.collect::<anyhow::Result<_>>()?,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn zrow_draws_the_nearest_pixels_of_all() {
        for &(title, radius, center) in CASES {
            let pixels = drawn(radius, center).unwrap();
            assert!(!pixels.is_empty(), "{title}");
            assert_eq!(wrong_pixels(radius, center, &UPRIGHT_SCREEN, &pixels), 0, "{title}");
        }
    }

    #[test]
    fn pixels_that_are_missing_moved_or_there_twice_are_found() {
        let mut pixels = drawn(119, (120, 160)).unwrap();
        let wrong = |pixels: &[(i32, i32)]| wrong_pixels(119, (120, 160), &UPRIGHT_SCREEN, pixels);
        let first = pixels[0];
        pixels.push(first);
        assert_eq!(wrong(&pixels), 1);
        pixels.retain(|pixel| *pixel != first);
        assert_eq!(wrong(&pixels), 1);
        pixels[0].1 += 3;
        assert_eq!(wrong(&pixels), 3);
    }
}
