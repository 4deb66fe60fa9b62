//! Others that fill polygons into masks, in the same run.

use std::panic;

use zrow_methods::{Rule, SIZE, Shape};

use crate::{digits::digits, errors::FULL};

/// Someone who fills masks.
pub struct Peer {
    pub name: &'static str,
    /// Fills a mask of [`SIZE`] x [`SIZE`] pixels; `None` where it has no such rule.
    fill: fn(&Shape) -> Option<Vec<u8>>,
}

pub const PEERS: &[Peer] = &[
    Peer {
        name: "zeno",
        fill: zeno,
    },
    Peer {
        name: "ab_glyph",
        fill: ab_glyph,
    },
    Peer {
        name: "tiny-skia",
        fill: tiny_skia,
    },
];

impl Peer {
    /// The largest error of a pixel of 255, or what else came out.
    pub fn largest_error(&self, shape: &Shape, coverage: &[f64]) -> String {
        match quietly(|| (self.fill)(shape)) {
            Some(Some(mask)) => {
                let pixels = coverage.iter().zip(&mask);
                let errors = pixels.map(|(coverage, drawn)| (f64::from(*drawn) - coverage * FULL).abs());
                digits(errors.fold(0.0, f64::max))
            }
            Some(None) => "no such rule".to_owned(),
            None => "panics".to_owned(),
        }
    }
}

/// What a function gives; `None` where it panics, of which nothing is printed.
pub fn quietly<T>(function: impl FnOnce() -> T + panic::UnwindSafe) -> Option<T> {
    let hook = panic::take_hook();
    panic::set_hook(Box::new(|_| ()));
    let result = panic::catch_unwind(function);
    panic::set_hook(hook);
    result.ok()
}

/// Contours in pixels from the corner of the mask.
fn contours(shape: &Shape) -> impl Iterator<Item = Vec<(f32, f32)>> {
    let pixels = |units: i32| (units + shape.units / 2) as f32 / shape.units as f32;
    let contours = shape.contours.iter();
    contours.map(move |contour| contour.iter().map(|&(x, y)| (pixels(x), pixels(y))).collect())
}

fn zeno(shape: &Shape) -> Option<Vec<u8>> {
    use zeno::{Command, Fill, Mask, Vector};
    let mut commands = Vec::new();
    for contour in contours(shape) {
        let mut points = contour.into_iter().map(|(x, y)| Vector::new(x, y));
        commands.extend(points.next().map(Command::MoveTo));
        commands.extend(points.map(Command::LineTo));
        commands.push(Command::Close);
    }
    let mut mask = vec![0; SIZE * SIZE];
    let rule = match shape.rule {
        Rule::EvenOdd => Fill::EvenOdd,
        Rule::NonZero => Fill::NonZero,
    };
    Mask::new(commands.as_slice())
        .style(rule)
        .size(SIZE as u32, SIZE as u32)
        .render_into(&mut mask, None);
    Some(mask)
}

/// Its sums know the non-zero rule alone.
fn ab_glyph(shape: &Shape) -> Option<Vec<u8>> {
    use ab_glyph_rasterizer::{Rasterizer, point};
    if matches!(shape.rule, Rule::EvenOdd) {
        return None;
    }
    let mut rasterizer = Rasterizer::new(SIZE, SIZE);
    for contour in contours(shape) {
        for ((x0, y0), (x1, y1)) in contour.iter().zip(contour.iter().cycle().skip(1)) {
            rasterizer.draw_line(point(*x0, *y0), point(*x1, *y1));
        }
    }
    let mut mask = vec![0; SIZE * SIZE];
    rasterizer.for_each_pixel(|index, coverage| mask[index] = (coverage * 255.0 + 0.5) as u8);
    Some(mask)
}

fn tiny_skia(shape: &Shape) -> Option<Vec<u8>> {
    use tiny_skia::{FillRule, Mask, PathBuilder, Transform};
    let mut builder = PathBuilder::new();
    for contour in contours(shape) {
        for (index, (x, y)) in contour.into_iter().enumerate() {
            match index {
                0 => builder.move_to(x, y),
                _ => builder.line_to(x, y),
            }
        }
        builder.close();
    }
    let mut mask = Mask::new(SIZE as u32, SIZE as u32)?;
    let rule = match shape.rule {
        Rule::EvenOdd => FillRule::EvenOdd,
        Rule::NonZero => FillRule::Winding,
    };
    mask.fill_path(&builder.finish()?, rule, true, Transform::identity());
    Some(mask.data().to_vec())
}

#[cfg(test)]
mod tests {
    use zrow_methods::Figure;

    use super::*;
    use crate::reference;

    /// A mask that is turned or shifted would be off by 255.
    #[test]
    fn peers_draw_a_plain_figure_where_it_is() {
        for figure in [Figure::Triangle, Figure::Star] {
            let shape = figure.shape(SIZE as u32);
            let coverage = reference::exact(&shape, SIZE);
            for peer in PEERS {
                let error: f64 = peer.largest_error(&shape, &coverage).parse().unwrap();
                assert!(error < 60.0, "{}: {error}", peer.name);
            }
        }
    }

    #[test]
    fn a_panic_is_no_result() {
        assert_eq!(quietly(|| 3), Some(3));
        assert_eq!(quietly(|| -> i32 { panic!("nobody reads this") }), None);
    }
}
