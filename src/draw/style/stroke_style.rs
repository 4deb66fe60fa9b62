//! Strokes with any caps, joins and dashes.
//!
//! A stroke is the union of convex primitives: a rectangle for each segment or dash, a wedge or a disc at a corner, and
//! caps at ends. Their edges are filled by the nonzero rule, which draws each pixel once. Without dashes, the edges of
//! the whole stroke are filled together. With dashes, primitives that share no pixel are filled separately, because
//! each of them then needs few edges.

use embedded_graphics::{
    pixelcolor::PixelColor,
    primitives::{self, Rectangle, Styled},
};
use fixed::types::{I16F16, U16F16};

use crate::{
    draw::{Antialiased, DrawOn, FillRule, LineCap, LineJoin, PrimitiveStyle, style::stroke},
    geometry::{Bounds, Window},
    scan::{
        polygon::{
            banded_polygon::{self, EdgeSource},
            bounding_box::MOST_LINE_TESTS,
            scanline_polygon::PartRule,
        },
        stroke::{
            DashPattern,
            grouped_primitives::{self, EdgedPrimitive},
            stroke_edge::StrokeEdge,
            styled_stroke::{StrokeShape, StyledStroke},
            wide_stroke::Path,
        },
    },
    surface::Target,
};

/// A stroke with caps, joins and dashes: a style beside [`PrimitiveStyle`], for `Line`, `Polyline`, `Triangle`,
/// `Rectangle`, [`Polygon`](crate::draw::Polygon) and [`Path`](crate::draw::Path).
///
/// The stroke is the exact union of its segments, joins and caps, each pixel once, at every width from 1 on. A stroke
/// of one pixel is a polygon as well, not Bresenham's line. The stroke is centred on the path; the path of a
/// `Rectangle` goes through the centres of its outermost pixels. With the default cap and join, the stroke has the
/// pixels of the [wide strokes](crate::draw#wide-strokes) of a [`PrimitiveStyle`].
///
/// Cost: that of wide strokes, and with dashes a square root for every segment, visible or not. Without dashes, a band
/// is halved until at most 14 sides of rectangles, wedges and discs cross each part, and the path is generated anew for
/// each part. Dashes and the joins between them are drawn one after the other, not from top to bottom, except for those
/// that may overlap, which are drawn together: the path is generated twice for each band that up to 32 of these
/// primitives reach, and again for overlapping clusters of them. A segment that shows more than 32 dashes, or more than
/// 4 that may overlap, is drawn row by row, and a pixel is examined only where the pattern may change.
///
/// However short dashes are, and however far their caps overlap, drawing in a window takes at most 24 (n + 8) v (p + r)
/// steps. A step is a dash or a pixel that is examined, or an edge that is generated; n is the number of lengths in the
/// pattern, v the number of vertices of the path, p the number of pixels that the stroke without gaps has in the
/// window, and r the number of rows of the window.
///
/// Memory: none that grows with vertices or dashes; with dashes about 5 KB of stack. Flash: the code for this style is
/// linked only where the style is used.
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor, prelude::*, primitives::Line};
/// use zrow::fixed::types::U16F16;
/// use zrow::draw::{LineCap, StrokeStyle};
///
/// const DASHES: [U16F16; 2] = [U16F16::lit("3"), U16F16::lit("2")];
/// let style = StrokeStyle::new(BinaryColor::On, 2)
///     .cap(LineCap::Butt)
///     .dashes(&DASHES);
/// let mut display = MockDisplay::new();
/// Line::new(Point::new(0, 1), Point::new(10, 1))
///     .into_styled(style)
///     .draw(&mut display)?;
/// display.assert_pattern(&["###  ###", "###  ###"]);
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Debug, Copy, Clone, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub struct StrokeStyle<'dashes, C: PixelColor> {
    /// Colour of the stroke; `None` draws nothing.
    pub color: Option<C>,
    /// Width of the stroke in pixels; 0 draws nothing.
    pub width: u32,
    /// The cap at each end of the stroke and of each dash.
    pub cap: LineCap,
    /// The join at each corner of the path.
    pub join: LineJoin,
    /// The lengths of dashes and gaps along the path, in pixels; `None` is a solid stroke.
    pub dashes: Option<&'dashes [U16F16]>,
    /// How many pixels into the pattern of dashes and gaps the path begins.
    pub dash_offset: I16F16,
}

impl<'dashes, C: PixelColor> StrokeStyle<'dashes, C> {
    /// A solid stroke of this colour and width, with the caps and joins of a [`PrimitiveStyle`].
    pub const fn new(color: C, width: u32) -> Self {
        Self {
            color: Some(color),
            width,
            cap: LineCap::WholePixel,
            join: LineJoin::MITER,
            dashes: None,
            dash_offset: I16F16::ZERO,
        }
    }

    /// Sets the cap at each end of the stroke and of each dash.
    #[must_use]
    pub const fn cap(self, cap: LineCap) -> Self {
        Self { cap, ..self }
    }

    /// Sets the join at each corner of the path.
    #[must_use]
    pub const fn join(self, join: LineJoin) -> Self {
        Self { join, ..self }
    }

    /// Sets the lengths of dashes and gaps along the path, in pixels.
    ///
    /// The lengths are those of a dash, a gap, a dash and so on; after the last one the first follows again, and an odd number
    /// of them so swaps dashes and gaps with every round: `[5]` is `[5, 5]`, `[1, 2, 3]` is `[1, 2, 3, 1, 2, 3]`. A pattern
    /// without lengths, or of zeros alone, is a solid stroke. A dash of length 0 is its two caps: a dot where they are round.
    /// The first 65,536 lengths count.
    ///
    /// Every dash has the stroke's caps. They lie outside its length, except for butt caps. Where a cap reaches further than the
    /// pattern is long, dashes of one segment whose caps close the gap between them are drawn as one: with whole-pixel and
    /// square caps where they touch, with round caps where the notch between the two discs would be at most 1/131,072 pixel
    /// deep (a gap of 1/181 pixel at width 1, of 1/11 at width 256).
    ///
    /// Lengths may be far below a pixel: a pixel is drawn where its centre lies in a dash. What that costs is bounded by the
    /// pixels of the stroke, not by the number of dashes (see [`StrokeStyle`]).
    #[must_use]
    pub const fn dashes(self, lengths: &'dashes [U16F16]) -> Self {
        Self {
            dashes: Some(lengths),
            ..self
        }
    }

    /// Lets the path begin so many pixels into the pattern of dashes and gaps: larger offsets move the dashes backwards along
    /// the path. Without dashes it does not count.
    #[must_use]
    pub const fn dash_offset(self, dash_offset: I16F16) -> Self {
        Self { dash_offset, ..self }
    }

    /// The lengths and the offset of the dashes; `None` for a solid stroke.
    pub(in crate::draw) fn dash_pattern(&self) -> Option<DashPattern<'dashes>> {
        let dashes = DashPattern::new(self.dashes?);
        Some(dashes.offset(self.dash_offset))
    }

    /// The style with antialiased edges, for shapes on [`Band::antialiased`](crate::band::Band::antialiased). The stroke is one
    /// outline, without seams between its segments, joins and caps.
    pub const fn antialiased(self) -> Antialiased<Self> {
        Antialiased(self)
    }

    /// Draws the stroke of a shape. A shape of one path with disjoint dashes is drawn dash by dash, any other dashed
    /// shape in groups of primitives that share no pixel, and a solid stroke at once.
    pub(crate) fn draw_on<T: Target<Color = C>>(
        &self,
        shape: &dyn StrokedShape,
        target: &mut T,
    ) -> Result<(), T::Error> {
        let Some(color) = self.color.filter(|_| self.width > 0) else {
            return Ok(());
        };
        let raw = target.raw(color);
        let window = target.window();
        let mut result = Ok(());
        let mut fill = |source: &EdgeSource<'_, StrokeEdge>, window: &Window| {
            let rule = PartRule::fill(FillRule::NonZero);
            if result.is_ok() {
                result = banded_polygon::scan(source, rule, window, |span, _| target.fill_clipped_span(span, raw));
            }
        };
        if self.dashes.is_some() && shape.is_one_path() {
            let mut is_disjoint = false;
            self.strokes(shape, &mut |stroke| {
                is_disjoint = stroke.is_disjoint();
                if is_disjoint {
                    stroke.each_dash(&window, &mut |edges| fill(edges, &window));
                }
            });
            if is_disjoint {
                return result;
            }
        }
        if self.dashes.is_some() {
            let primitives = |window: &Window, call: &mut dyn FnMut(&EdgedPrimitive<'_>)| {
                let mut path = 0usize;
                self.strokes(shape, &mut |stroke| {
                    stroke.each_primitive(path, window, call);
                    path += 1;
                });
            };
            grouped_primitives::each_group(&primitives, &window, &mut fill);
        } else {
            let edges = |window: &Window, sink: &mut dyn FnMut(StrokeEdge)| {
                self.strokes(shape, &mut |stroke| stroke.edges(window, sink));
            };
            fill(&edges, &window);
        }
        result
    }

    /// The smallest box around the pixels of a stroke, with or without a colour. For a segment of more than 2,048
    /// pixels with more than 256 dashes, dashes and their caps are assumed everywhere along it.
    ///
    /// Cost: a square root for each segment, and some divisions for each dash, cap and join that exceeds the box of
    /// those before it (see [`bounding_box`](crate::scan::polygon::bounding_box)).
    pub(crate) fn bounds(&self, shape: &dyn StrokedShape) -> Rectangle {
        let (mut bounds, mut tests_left) = (Bounds::EMPTY, MOST_LINE_TESTS);
        if self.width > 0 {
            self.strokes(shape, &mut |stroke| {
                stroke.shapes(&mut |shape| match shape {
                    StrokeShape::Polygon(corners, discs) => {
                        bounds = stroke::with_polygon(bounds, corners, &mut tests_left);
                        for center in discs.into_iter().flatten() {
                            bounds = stroke.with_disc(bounds, center);
                        }
                    }
                    StrokeShape::Join(corners) => bounds = stroke::with_polygon(bounds, corners, &mut tests_left),
                    StrokeShape::Dashes(dashes) => bounds = dashes.grow(bounds),
                });
            });
        }
        bounds.to_rectangle()
    }

    /// A box around what the stroke may have around vertices that are so far out that it is not generated there, once it is moved.
    pub(crate) fn out_of_reach(&self, shape: &dyn StrokedShape) -> Window {
        let mut bounds = Bounds::EMPTY;
        shape.paths(u64::from(self.width) * 2, &mut |path| {
            let reach = path.reach().max(self.join.reach(path.half_width));
            bounds = bounds.around(&path.out_of_reach(reach));
        });
        bounds.to_rectangle().into()
    }

    /// Calls `call` with the stroke of each path of a shape.
    fn strokes(&self, shape: &dyn StrokedShape, call: &mut dyn FnMut(&StyledStroke<'_>)) {
        shape.paths(u64::from(self.width) * 2, &mut |path| {
            call(&StyledStroke::new(path, self.cap, self.join, self.dash_pattern()));
        });
    }
}

impl<C: PixelColor> From<PrimitiveStyle<C>> for StrokeStyle<'_, C> {
    /// The stroke of a [`PrimitiveStyle`], but always centred. Its fill is dropped.
    fn from(style: PrimitiveStyle<C>) -> Self {
        Self {
            color: style.stroke_color,
            width: style.stroke_width,
            cap: LineCap::default(),
            join: LineJoin::default(),
            dashes: None,
            dash_offset: I16F16::ZERO,
        }
    }
}

impl<C: PixelColor> From<primitives::PrimitiveStyle<C>> for StrokeStyle<'_, C> {
    /// The stroke of embedded-graphics' style, but always centred. Its fill is dropped.
    fn from(style: primitives::PrimitiveStyle<C>) -> Self {
        PrimitiveStyle::from(style).into()
    }
}

#[cfg(feature = "defmt")]
impl<C: PixelColor + defmt::Format> defmt::Format for StrokeStyle<'_, C> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        let dashes = self.dashes.map_or(0, <[_]>::len);
        defmt::write!(
            formatter,
            "StrokeStyle {} wide in {}, {}, {}, {} lengths of dashes",
            self.width,
            self.color,
            self.cap,
            self.join,
            dashes
        );
    }
}

/// A shape that consists of paths to stroke. Implemented by shapes of this crate and of embedded-graphics; for a shape
/// of your own, stroke a [`Path`](crate::draw::Path) or a [`Polygon`](crate::draw::Polygon).
pub trait StrokedShape {
    /// Calls `call` with each path of the shape. The width of the stroke is given in half pixels.
    #[doc(hidden)]
    fn paths(&self, width_in_halves: u64, call: &mut dyn FnMut(&Path<'_>));

    /// Whether [`paths`](Self::paths) has one path, for any vertices.
    #[doc(hidden)]
    fn is_one_path(&self) -> bool {
        false
    }

    /// Whether vertices lie between the centres of pixels, in general: an antialiased stroke then has butt caps in the
    /// place of [`LineCap::WholePixel`].
    #[doc(hidden)]
    fn is_sub_pixel(&self) -> bool {
        false
    }
}

impl<S: StrokedShape, C: PixelColor> DrawOn for Styled<S, StrokeStyle<'_, C>> {
    type Color = C;

    fn draw_on<T: Target<Color = C>>(&self, target: &mut T) -> Result<(), T::Error> {
        self.style.draw_on(&self.primitive, target)
    }
}

#[cfg(test)]
mod tests {
    extern crate std;

    use std::{vec, vec::Vec};

    use embedded_graphics::{
        geometry::{Point, Size},
        pixelcolor::{Rgb565, RgbColor},
        primitives::{Line, Polyline},
    };
    use proptest::prelude::*;

    use super::*;
    use crate::{
        band::Band,
        cases::{config, is_deep},
        draw::Polygon,
        scan::stroke::work::{self, MOST_STEPS},
    };

    /// Draws in bands of `rows` rows. Returns the number of steps that drawing takes, and the number of pixels that are
    /// drawn.
    fn drawn(shape: &impl StrokedShape, style: StrokeStyle<'_, Rgb565>, size: Size, rows: u32) -> (u64, u64) {
        let mut words = vec![0u16; (size.width * rows) as usize];
        let (mut steps, mut pixels) = (0, 0);
        for top in (0..size.height).step_by(rows as usize) {
            words.fill(0);
            let area = Rectangle::new(Point::new(0, top as i32), Size::new(size.width, rows));
            let mut band = Band::<Rgb565>::new(area, &mut words).unwrap();
            steps += work::of(|| {
                let Ok(()) = style.draw_on(shape, &mut band);
            });
            pixels += words.iter().filter(|&&word| word != 0).count() as u64;
        }
        (steps, pixels)
    }

    /// Draws in one band and in bands of one row, and checks the documented bound of [`StrokeStyle`] on the steps.
    /// Returns the larger number of steps.
    fn check(shape: &impl StrokedShape, vertices: usize, style: StrokeStyle<'_, Rgb565>, size: Size) -> u64 {
        let without_gaps = StrokeStyle { dashes: None, ..style };
        let (_, pixels) = drawn(shape, without_gaps, size, size.height);
        let lengths = style.dashes.map_or(0, <[_]>::len) as u64;
        let most = MOST_STEPS * (8 + lengths) * vertices as u64 * (pixels + u64::from(size.height));
        let steps = [size.height, 1].map(|rows| drawn(shape, style, size, rows).0);
        let steps = steps.into_iter().max().unwrap();
        assert!(steps <= most, "{steps} steps of {most}: {pixels} pixels, {style:?}");
        steps
    }

    const SCREEN: Size = Size::new(320, 240);

    #[test]
    fn the_number_of_dashes_does_not_bound_the_work_but_the_pixels_do() {
        let line = [Point::new(0, 20), Point::new(319, 27)];
        for (bits, most) in [(256, 15_000), (16, 90_000), (1, 300_000)] {
            let lengths = [U16F16::from_bits(bits); 2];
            let style = StrokeStyle::new(Rgb565::WHITE, 3).cap(LineCap::Butt);
            let style = style.dashes(&lengths);
            let steps = [
                check(&Line::new(line[0], line[1]), 2, style, SCREEN),
                check(&Polyline::new(&line), 2, style, SCREEN),
            ];
            assert!(steps.iter().all(|&steps| steps < most), "{bits}: {steps:?}");
        }
        // The zigzag is 900 pixels long.
        let zigzag = [(20, 40), (300, 60), (20, 200), (310, 230)].map(|(x, y)| Point::new(x, y));
        for (width, gap, most) in [(64, 1 << 16, 200_000), (256, 1 << 15, 150_000), (256, 700, 30_000)] {
            let lengths = [U16F16::ZERO, U16F16::from_bits(gap)];
            let style = StrokeStyle::new(Rgb565::WHITE, width).cap(LineCap::Round);
            let style = style.dashes(&lengths);
            let steps = check(&Polyline::new(&zigzag), 4, style, SCREEN);
            assert!(steps < most, "{width}, {gap}: {steps}");
        }
        // The largest number of lengths that a pattern takes, all within a pixel or two.
        let lengths = vec![U16F16::from_bits(1); 1 << 16];
        for count in [1 << 16, 65_535] {
            let style = StrokeStyle::new(Rgb565::WHITE, 1).cap(LineCap::Butt);
            let style = style.dashes(&lengths[..count]);
            check(
                &Line::new(Point::new(2, 3), Point::new(60, 9)),
                2,
                style,
                Size::new(64, 16),
            );
        }
    }

    /// Many segments show a few dashes each, so that a row has more dashes than the table of primitives.
    #[test]
    fn many_segments_with_a_few_dashes_each_are_bounded_too() {
        // All widths where everything is tried, however long it takes.
        let widths: &[u32] = if is_deep() { &[1, 2, 5] } else { &[2] };
        for (step, drop) in [(0, 0), (0, 3), (1, 2), (3, 9), (0, 40), (5, 40)] {
            let points: Vec<Point> = (0..60)
                .map(|index| Point::new(-4 + (index % 2) * 70, 3 + step * index / 4 + (index % 2) * drop))
                .collect();
            for (dash, gap, cap) in [
                (70_000, 75_000, LineCap::Butt),
                (100_000, 110_000, LineCap::Butt),
                (0, 230_000, LineCap::Round),
                (0, 120_000, LineCap::Round),
            ] {
                let lengths = [U16F16::from_bits(dash), U16F16::from_bits(gap)];
                for &width in widths {
                    let style = StrokeStyle::new(Rgb565::WHITE, width).cap(cap);
                    let style = style.dashes(&lengths);
                    check(&Polyline::new(&points), points.len(), style, Size::new(64, 64));
                }
            }
        }
    }

    /// Segments between two points, many more than the window has pixels.
    #[test]
    fn segments_upon_each_other_are_bounded_too() {
        for (right, down) in [(1, 0), (0, 1), (3, 2)] {
            let points: Vec<Point> = (0..2_000)
                .map(|index| Point::new(5 + (index % 2) * right, 5 + (index % 2) * down))
                .collect();
            for cap in [LineCap::Butt, LineCap::WholePixel, LineCap::Round] {
                let lengths = [20_000, 10_000].map(U16F16::from_bits);
                let style = StrokeStyle::new(Rgb565::WHITE, 1).cap(cap);
                let style = style.dashes(&lengths);
                check(&Polyline::new(&points), points.len(), style, Size::new(16, 16));
            }
        }
    }

    fn coordinate() -> impl Strategy<Value = i32> {
        prop_oneof![
            6 => -30..94i32,
            1 => -9_000..9_000i32,
            1 => any::<i32>(),
            1 => prop::sample::select(vec![i32::MIN, i32::MAX]),
        ]
    }

    /// Lengths of dashes in 1/65,536 pixel, from 0 to the largest number.
    fn length() -> impl Strategy<Value = u32> {
        prop_oneof![
            2 => 0..10u32,
            2 => 0..1_000u32,
            2 => 0..100_000u32,
            1 => any::<u32>(),
            1 => Just(0),
        ]
    }

    proptest! {
        #![proptest_config(config(400))]

        #[test]
        fn work_is_bounded_by_the_pixels_without_gaps(
            points in prop::collection::vec((coordinate(), coordinate()), 2..6),
            closed in any::<bool>(),
            width in prop_oneof![3 => 1..12u32, 2 => 1..200u32, 1 => any::<u32>()],
            cap in prop::sample::select(vec![LineCap::WholePixel, LineCap::Butt, LineCap::Square, LineCap::Round]),
            lengths in prop_oneof![
                4 => prop::collection::vec(length(), 1..6),
                1 => prop::collection::vec(length(), 1..80),
            ],
            offset in any::<i32>(),
        ) {
            let points: Vec<Point> = points.into_iter().map(|(x, y)| Point::new(x, y)).collect();
            let lengths: Vec<U16F16> = lengths.into_iter().map(U16F16::from_bits).collect();
            let style = StrokeStyle::new(Rgb565::WHITE, width).cap(cap).dashes(&lengths);
            let style = style.dash_offset(I16F16::from_bits(offset));
            let size = Size::new(64, 64);
            if closed {
                check(&Polygon::new(&[points.as_slice()], FillRule::NonZero), points.len() + 1, style, size);
            } else {
                check(&Polyline::new(&points), points.len(), style, size);
            }
        }
    }
}
