//! Random shapes of the classes for which accuracy is published.

use crate::reference::exact_area::Contour;

/// xorshift32 (Marsaglia 2003).
pub struct Numbers(pub u32);

impl Numbers {
    /// A number from 0 to `end`, exclusive.
    pub fn next(&mut self, end: i32) -> i32 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 17;
        self.0 ^= self.0 << 5;
        (self.0 % end as u32) as i32
    }
}

/// The corners of a regular polygon, or every `step`-th of them in turn: a star.
pub fn regular(center: (f64, f64), radius: f64, corners: i32, step: i32, turn: f64) -> Contour {
    (0..corners)
        .map(|corner| {
            let angle = f64::from(corner * step) / f64::from(corners) * std::f64::consts::TAU + turn;
            let coordinate = |center: f64, part: f64| ((center + radius * part) * 256.0).round() as i32;
            (coordinate(center.0, angle.cos()), coordinate(center.1, angle.sin()))
        })
        .collect()
}

/// A segment as a polygon of a width.
pub fn line(numbers: &mut Numbers, width: f64, rise: Option<f64>) -> Contour {
    let mut coordinate = || f64::from(numbers.next(46 * 256)) / 256.0 + 1.0;
    let (a, mut b) = ((coordinate(), coordinate()), (coordinate(), coordinate()));
    if let Some(rise) = rise {
        b.1 = a.1 + (b.0 - a.0) * rise;
    }
    let (dx, dy) = (b.0 - a.0, b.1 - a.1);
    let half = width / 2.0 / dx.hypot(dy).max(1e-6);
    let corner = |p: (f64, f64), s: f64| {
        (
            ((p.0 - dy * s * half) * 256.0).round() as i32,
            ((p.1 + dx * s * half) * 256.0).round() as i32,
        )
    };
    vec![corner(a, 1.0), corner(b, 1.0), corner(b, -1.0), corner(a, -1.0)]
}

/// Number of shapes in a class.
pub const SHAPES: usize = 100;

/// The classes of shapes for which accuracy is published.
pub fn classes() -> Vec<(&'static str, Vec<Vec<Contour>>)> {
    let mut numbers = Numbers(0x0123_4567);
    let mut shapes =
        |make: &mut dyn FnMut(&mut Numbers) -> Vec<Contour>| (0..SHAPES).map(|_| make(&mut numbers)).collect();
    let real = |numbers: &mut Numbers, from: f64, to: f64| {
        from + (to - from) * f64::from(numbers.next(1 << 20)) / f64::from(1 << 20)
    };
    vec![
        (
            "triangle",
            shapes(&mut |n| {
                vec![
                    (0..3)
                        .map(|_| (n.next(46 * 256) + 256, n.next(46 * 256) + 256))
                        .collect(),
                ]
            }),
        ),
        ("line", shapes(&mut |n| vec![line(n, 1.0, None)])),
        (
            "near-horizontal",
            shapes(&mut |n| {
                let rise = real(n, -0.05, 0.05);
                vec![line(n, 1.0, Some(rise))]
            }),
        ),
        (
            "near-vertical",
            shapes(&mut |n| {
                let rise = real(n, -0.05, 0.05);
                vec![line(n, 1.0, Some(rise)).into_iter().map(|(x, y)| (y, x)).collect()]
            }),
        ),
        ("hairline", shapes(&mut |n| vec![line(n, 0.15, None)])),
        (
            "circle",
            shapes(&mut |n| {
                let (center, radius) = ((real(n, 20.0, 28.0), real(n, 20.0, 28.0)), real(n, 3.0, 18.0));
                vec![regular(center, radius, 200, 1, 0.0)]
            }),
        ),
        (
            "ring",
            shapes(&mut |n| {
                let (center, radius) = ((real(n, 20.0, 28.0), real(n, 20.0, 28.0)), real(n, 8.0, 18.0));
                let inner = regular(center, radius - 3.0, 100, 1, 0.0);
                vec![regular(center, radius, 100, 1, 0.0), inner.into_iter().rev().collect()]
            }),
        ),
        (
            "star",
            shapes(&mut |n| {
                let (center, turn) = ((real(n, 22.0, 26.0), real(n, 22.0, 26.0)), real(n, 0.0, 6.0));
                vec![regular(center, 22.0, 7, 3, turn)]
            }),
        ),
    ]
}
