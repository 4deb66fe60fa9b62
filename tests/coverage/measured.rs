//! What a coverage method makes of a shape, and how far that is from the exact area.

use zrow::{
    coverage::CoverageMethod,
    draw::{AntialiasedPolygon, FillRule},
    geometry::{Sub8, SubPoint, TooSmall, Window},
};

use crate::reference::exact_area::Contour;

/// Rows of the usual window.
pub const SIZE: i32 = 48;

/// The window of the usual rows between two columns.
pub fn window(left: i32, right: i32) -> Window {
    Window {
        left,
        top: 0,
        right,
        bottom: SIZE,
    }
}

/// The corners of contours as points.
pub fn sub_contours(contours: &[Contour]) -> Vec<Vec<SubPoint<Sub8>>> {
    let point = |(x, y): &(i32, i32)| SubPoint::from_units(*x, *y).unwrap();
    contours
        .iter()
        .map(|contour| contour.iter().map(point).collect())
        .collect()
}

/// A polygon of contours, with room for all that are tested.
pub fn prepare(contours: &[Contour], fill_rule: FillRule) -> AntialiasedPolygon<512, 512> {
    let contours = sub_contours(contours);
    let contours: Vec<&[SubPoint<Sub8>]> = contours.iter().map(Vec::as_slice).collect();
    AntialiasedPolygon::prepare(contours.as_slice(), fill_rule).unwrap()
}

/// Coverage of the columns of a window, row by row. Fails where a pixel is handed over twice or out of order.
pub fn coverages<T: CoverageMethod>(method: &T, contours: &[Contour], fill_rule: FillRule, window: &Window) -> Vec<u8> {
    let width = (window.right - window.left) as usize;
    let mut memory = vec![T::Cell::default(); T::cells(width)];
    let mut coverages = vec![0u8; width * (window.bottom - window.top) as usize];
    let mut last = (i32::MIN, i32::MIN);
    prepare(contours, fill_rule)
        .cover(method, window, &mut memory, |span, coverage| {
            assert!(
                (span.y, span.start) >= last && span.start < span.end && coverage > 0,
                "{span:?} after {last:?}"
            );
            last = (span.y, span.end);
            for x in span.start..span.end {
                coverages[(span.y - window.top) as usize * width + (x - window.left) as usize] = coverage;
            }
            Ok::<_, TooSmall>(())
        })
        .unwrap();
    coverages
}

/// How far a coverage is from an area, in 1/255.
fn error((coverage, area): (&u8, &f64)) -> f64 {
    (f64::from(*coverage) - area * 255.0).abs()
}

/// The largest error, and in which pixel it is.
pub fn furthest(coverages: &[u8], areas: &[f64]) -> (f64, usize) {
    let errors = coverages.iter().zip(areas).map(error).zip(0..);
    errors.fold((0.0, 0), |one, other| if other.0 > one.0 { other } else { one })
}

/// Root mean square and largest error over the pixels that an edge crosses, in 1/255.
pub fn errors(coverages: &[u8], areas: &[f64]) -> (f64, f64, usize) {
    let edge_pixels = coverages
        .iter()
        .zip(areas)
        .filter(|(_, area)| **area > 1e-9 && **area < 1.0 - 1e-9);
    let errors: Vec<f64> = edge_pixels.map(error).collect();
    let squares: f64 = errors.iter().map(|error| error * error).sum();
    let count = errors.len();
    (
        (squares / count.max(1) as f64).sqrt(),
        errors.into_iter().fold(0.0, f64::max),
        count,
    )
}
