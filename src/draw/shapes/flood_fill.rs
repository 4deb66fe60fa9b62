//! Flood fill and boundary fill by spans (Lieberman 1978; Smith 1979, "Tint fill"; Heckbert 1990, "A seed fill
//! algorithm", Graphics Gems): everything that is connected with a seed pixel is filled, on a target whose pixels can
//! be read.
//!
//! A run of inside pixels is painted at once. The columns above and below it are then pushed on a stack as searches. A
//! search paints each run that has a pixel in its columns, and pushes the columns beyond that run in the same
//! direction. Back in the direction that it came from, only the parts of the run that extend past the searched columns
//! are pushed:
//!
//! ```text
//!       ####      painted run: the row below it is searched over the same columns (four-connected)
//!     ==####===   run found by that search: the next row is searched over all of its columns,
//!                 the row above only over the columns marked =
//! ```
//!
//! Guarantees: exactly the pixels that a pixel-by-pixel search from the seed reaches inside the target's window, also
//! where the window ends at the first or the last column or row of the number range; no recursion; the stack holds
//! searches, not pixels. Where the stack is full, filling stops with an error before anything is lost: every pixel
//! painted so far belongs to the fill, and [`with_stack`](SeedFill::with_stack) continues from there.
//!
//! Cost: each pixel of the area is painted once. Pixels are read at most three times as often as that, and seven times
//! more for each run of pixels side by side; none is read outside the window.

use embedded_graphics::{geometry::Point, image::GetPixel, pixelcolor::PixelColor};
use heapless::Vec;

use crate::{
    geometry::{DrawError, TooSmall, Window},
    surface::{Span, Target},
};

/// The rule that decides by its colour whether a pixel is inside, which means to be filled.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
enum Inside<C> {
    /// A pixel is inside if it has the colour that the seed had.
    Is(C),
    /// A pixel is inside if it has neither the boundary's colour nor the new colour.
    IsNot(C),
}

/// Columns of a row that have to be searched, next to a run that was painted in the row before. `last` is included;
/// `downwards` says whether the row lies below that run or above it.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
struct Search {
    y: i32,
    first: i32,
    last: i32,
    downwards: bool,
}

/// The most searches that a painted run is followed by: one further in its direction, and one at each end back in the
/// other direction.
const MOST_PUSHED: usize = 3;

/// A fill in progress, of pixels that share a side with each other, or also a corner
/// ([`eight_connected`](Self::eight_connected)). `STACK` is the number of searches that its stack has room for, 16 bytes each.
///
/// ```
/// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::{Circle, Rectangle}};
/// use zrow::{band::Band, draw::{DrawOn, PrimitiveStyle, SeedFill}};
///
/// let mut words = [0u16; 20 * 20];
/// let mut band = Band::<Rgb565>::new(Rectangle::new(Point::zero(), Size::new(20, 20)), &mut words)?;
/// let Ok(()) = Circle::new(Point::new(2, 2), 15)
///     .into_styled(PrimitiveStyle::with_stroke(Rgb565::WHITE, 1))
///     .draw_on(&mut band);
///
/// let mut fill = SeedFill::<_, 8>::flood(&band, Point::new(9, 9), Rgb565::RED);
/// assert!(fill.run(&mut band).is_ok());
/// assert_eq!(band.colors().filter(|&color| color == Rgb565::RED).count(), 137);
/// # Ok::<(), zrow::geometry::TooSmall>(())
/// ```
#[derive(Debug, Clone)]
pub struct SeedFill<C, const STACK: usize> {
    inside: Option<Inside<C>>,
    color: C,
    /// The number of columns by which a run's neighbours in the next row extend beyond each end of the run: 1 where pixels are
    /// connected at corners, or else 0.
    reach: i32,
    /// The pixel at which the fill begins; `None` once its run is painted.
    seed: Option<Point>,
    /// The search in progress. It is repeated from its first column after an error stopped the run in it.
    current: Option<Search>,
    stack: Vec<Search, STACK>,
}

impl<C: PixelColor, const STACK: usize> SeedFill<C, STACK> {
    /// A flood fill: all pixels of the seed's colour that are connected with the seed get the new colour.
    ///
    /// Nothing is filled where the seed already has the new colour, or lies outside the target.
    pub fn flood(target: &impl GetPixel<Color = C>, seed: Point, color: C) -> Self {
        let old = target.pixel(seed).filter(|&old| old != color);
        Self::new(old.map(Inside::Is), seed, color)
    }

    /// A boundary fill: all pixels that are connected with the seed get the new colour, up to pixels of the boundary's
    /// colour. Pixels that already have the new colour count as boundary.
    pub fn boundary(seed: Point, boundary: C, color: C) -> Self {
        Self::new(Some(Inside::IsNot(boundary)), seed, color)
    }

    /// The fill with other neighbours: the eight pixels that share a side or a corner with a pixel, so that only a line whose
    /// pixels share sides stops it; or else the four that share a side, as a new fill has it, so that a diagonal line does.
    #[must_use]
    pub fn eight_connected(self, eight: bool) -> Self {
        Self {
            reach: eight.into(),
            ..self
        }
    }

    fn new(inside: Option<Inside<C>>, seed: Point, color: C) -> Self {
        Self {
            inside,
            color,
            reach: 0,
            seed: Some(seed),
            current: None,
            stack: Vec::new(),
        }
    }

    /// Copies the fill, with its searches, to a stack of another size, to continue where the old stack was full.
    ///
    /// # Errors
    /// [`TooSmall`] where the new stack has no room for the searches in the old one.
    pub fn with_stack<const LARGER: usize>(&self) -> Result<SeedFill<C, LARGER>, TooSmall> {
        let stack = Vec::from_slice(&self.stack).map_err(|_| stack_full(self.stack.len()))?;
        Ok(SeedFill {
            inside: self.inside,
            color: self.color,
            reach: self.reach,
            seed: self.seed,
            current: self.current,
            stack,
        })
    }

    /// Fills until no search is left. On a target that shows a part of the picture, such as a band, the fill ends at
    /// the edge of that part.
    ///
    /// # Errors
    /// [`DrawError::TooSmall`] where the stack has no room for the next searches: continue with a larger stack
    /// ([`with_stack`](Self::with_stack)). The error's `needed` is the size for the next step; later steps may need
    /// more. [`DrawError::Target`] with the target's own error. In both cases every painted pixel is correct, and the
    /// next call of `run` continues where this one stopped.
    pub fn run<T>(&mut self, target: &mut T) -> Result<(), DrawError<T::Error>>
    where
        T: Target<Color = C> + GetPixel<Color = C>,
    {
        let window = target.window();
        if let Some(run) = self.seed.and_then(|seed| self.run_at(target, seed)) {
            let (first, last) = self.paint(target, run)?;
            self.push(&window, run.y, true, first, last);
            self.push(&window, run.y, false, first, last);
        }
        self.seed = None;
        while let Some(search) = self.current.or_else(|| self.stack.pop()) {
            self.current = Some(search);
            self.search(target, &window, search)?;
            self.current = None;
        }
        Ok(())
    }

    /// Paints every run of inside pixels that has a pixel in the columns of a search, and pushes the searches that
    /// follow.
    fn search<T>(&mut self, target: &mut T, window: &Window, search: Search) -> Result<(), DrawError<T::Error>>
    where
        T: Target<Color = C> + GetPixel<Color = C>,
    {
        let mut x = search.first.max(window.left);
        // The last column of a window is less than `i32::MAX`, since its `right` is excluded.
        let last = search.last.min(window.right.saturating_sub(1));
        while x <= last {
            let Some(run) = self.run_at(target, Point::new(x, search.y)) else {
                x += 1;
                continue;
            };
            let (first, last) = self.paint(target, run)?;
            // Onwards in the search's direction, and back where the run extends past the columns next to the span that
            // the search came from.
            let reach = self.reach;
            let before = search.first.saturating_add(reach).saturating_sub(1);
            let after = search.last.saturating_sub(reach).saturating_add(1);
            self.push(window, search.y, search.downwards, first, last);
            self.push(window, search.y, !search.downwards, first, last.min(before));
            self.push(window, search.y, !search.downwards, first.max(after), last);
            // The pixel after a run is not inside. Saturating at `i32::MAX` is harmless: no window has that column.
            x = run.end.saturating_add(1);
        }
        Ok(())
    }

    /// The run of inside pixels in a row that a pixel belongs to; `None` where the pixel is not inside.
    fn run_at<T>(&self, target: &T, pixel: Point) -> Option<Span>
    where
        T: Target<Color = C> + GetPixel<Color = C>,
    {
        let is_inside = |x: i32| self.is_inside(target, Point::new(x, pixel.y));
        if !is_inside(pixel.x) {
            return None;
        }
        // No overflow: an inside pixel lies in a window, whose last column is less than `i32::MAX`.
        let (mut start, mut end) = (pixel.x, pixel.x + 1);
        while let Some(before) = start.checked_sub(1).filter(|&before| is_inside(before)) {
            start = before;
        }
        while is_inside(end) {
            end += 1;
        }
        Some(Span::new(pixel.y, start, end))
    }

    /// Whether a pixel is to be painted. It is not where it lies outside the window. The window is read from the target
    /// at each call, because the compiler then merges this test with that of a band's `pixel`.
    fn is_inside<T>(&self, target: &T, pixel: Point) -> bool
    where
        T: Target<Color = C> + GetPixel<Color = C>,
    {
        if !target.window().contains(pixel) {
            return false;
        }
        match (self.inside, target.pixel(pixel)) {
            (Some(Inside::Is(old)), Some(found)) => found == old,
            (Some(Inside::IsNot(boundary)), Some(found)) => found != boundary && found != self.color,
            _ => false,
        }
    }

    /// Paints a run. Returns the first and the last column of its neighbours in the rows above and below.
    ///
    /// # Errors
    /// [`DrawError::TooSmall`], before anything is painted, where the stack has no room for [`MOST_PUSHED`] searches
    /// more. [`DrawError::Target`] with the target's own error.
    #[inline(never)]
    fn paint<T>(&mut self, target: &mut T, run: Span) -> Result<(i32, i32), DrawError<T::Error>>
    where
        T: Target<Color = C>,
    {
        let needed = self.stack.len().saturating_add(MOST_PUSHED);
        if needed > STACK {
            return Err(DrawError::TooSmall(stack_full(needed)));
        }
        let raw = target.raw(self.color);
        target.fill_clipped_span(run, raw).map_err(DrawError::Target)?;
        let reach = self.reach;
        Ok((run.start.saturating_sub(reach), (run.end - 1).saturating_add(reach)))
    }

    /// Pushes a search of the row below `y` or above it, where that row is in the window and `first..=last` is not
    /// empty.
    fn push(&mut self, window: &Window, y: i32, downwards: bool, first: i32, last: i32) {
        let next = if downwards { y.checked_add(1) } else { y.checked_sub(1) };
        let Some(y) = next.filter(|y| (window.top..window.bottom).contains(y)) else {
            return;
        };
        if first <= last {
            let pushed = self.stack.push(Search {
                y,
                first,
                last,
                downwards,
            });
            debug_assert!(pushed.is_ok(), "room on the stack was asked for before");
        }
    }
}

fn stack_full(needed: usize) -> TooSmall {
    TooSmall::Searches(needed)
}

#[cfg(feature = "defmt")]
impl<C, const STACK: usize> defmt::Format for SeedFill<C, STACK> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "SeedFill with {} of {} searches", self.stack.len(), STACK);
    }
}

#[cfg(test)]
mod tests {
    use embedded_graphics::{
        draw_target::DrawTarget,
        geometry::{Dimensions, Size},
        mock_display::MockDisplay,
        pixelcolor::{Rgb565, RgbColor},
        primitives::{PointsIter, Rectangle},
    };

    use super::*;
    use crate::band::Band;

    const WIDTH: u32 = 12;
    const HEIGHT: u32 = 7;

    /// The picture of 12 x 7 pixels after a fill.
    fn filled(picture: [&str; HEIGHT as usize], fill: impl FnOnce(&mut Band<'_, Rgb565>)) -> MockDisplay<Rgb565> {
        let mut words = [0; (WIDTH * HEIGHT) as usize];
        let area = Rectangle::new(Point::zero(), Size::new(WIDTH, HEIGHT));
        let mut band = Band::new(area, &mut words).unwrap();
        let before = MockDisplay::from_pattern(&picture);
        let Ok(()) = band.fill_contiguous(&area, area.points().filter_map(|point| before.get_pixel(point)));
        fill(&mut band);
        let mut after = MockDisplay::new();
        let Ok(()) = after.fill_contiguous(&band.bounding_box(), band.colors());
        after
    }

    fn flooded(picture: [&str; HEIGHT as usize], eight: bool) -> MockDisplay<Rgb565> {
        filled(picture, |band| {
            SeedFill::<_, 16>::flood(band, Point::new(2, 2), Rgb565::RED)
                .eight_connected(eight)
                .run(band)
                .unwrap();
        })
    }

    /// An area whose right wall is a diagonal line.
    const ROOM: [&str; 7] = [
        "WWWWWWWWWKKK",
        "WKKKKKKWKKKK",
        "WKKKKKWKKKKK",
        "WKWWKWKKKKKK",
        "WKKWKKWKKKWW",
        "WKKKKKKWKWWK",
        "WWWWWWWWWWKK",
    ];

    #[test]
    fn a_flood_fill_ends_at_a_diagonal_wall() {
        flooded(ROOM, false).assert_pattern(&[
            "WWWWWWWWWKKK",
            "WRRRRRRWKKKK",
            "WRRRRRWKKKKK",
            "WRWWRWKKKKKK",
            "WRRWRRWKKKWW",
            "WRRRRRRWKWWK",
            "WWWWWWWWWWKK",
        ]);
    }

    #[test]
    fn over_the_corners_of_pixels_it_goes_through_a_diagonal_wall() {
        flooded(ROOM, true).assert_pattern(&[
            "WWWWWWWWWRRR",
            "WRRRRRRWRRRR",
            "WRRRRRWRRRRR",
            "WRWWRWRRRRRR",
            "WRRWRRWRRRWW",
            "WRRRRRRWRWWK",
            "WWWWWWWWWWKK",
        ]);
    }

    #[test]
    fn a_boundary_fill_covers_every_other_colour() {
        let picture = [
            "KKKKKKKKKKKK",
            "KWWWWWWWWWKK",
            "KWKGGGKKKWKK",
            "KWKGBGKKKWKK",
            "KWKGGGKKKWKK",
            "KWWWWWWWWWKK",
            "KKKKKKKKKKKK",
        ];
        let display = filled(picture, |band| {
            SeedFill::<_, 16>::boundary(Point::new(2, 2), Rgb565::WHITE, Rgb565::RED)
                .run(band)
                .unwrap();
        });
        display.assert_pattern(&[
            "KKKKKKKKKKKK",
            "KWWWWWWWWWKK",
            "KWRRRRRRRWKK",
            "KWRRRRRRRWKK",
            "KWRRRRRRRWKK",
            "KWWWWWWWWWKK",
            "KKKKKKKKKKKK",
        ]);
    }

    #[test]
    fn a_fill_whose_stack_is_full_goes_on_with_a_larger_one() {
        let comb = [
            "KKKKKKKKKKKK",
            "KWKWKWKWKWKW",
            "KWKWKWKWKWKW",
            "KKKKKKKKKKKK",
            "WKWKWKWKWKWK",
            "WKWKWKWKWKWK",
            "KKKKKKKKKKKK",
        ];
        let display = filled(comb, |band| {
            let mut small = SeedFill::<_, 3>::flood(band, Point::zero(), Rgb565::RED);
            assert!(matches!(small.run(band), Err(DrawError::TooSmall(_))));
        });
        display.assert_pattern(&[
            "RRRRRRRRRRRR",
            "RWKWKWKWKWKW",
            "KWKWKWKWKWKW",
            "KKKKKKKKKKKK",
            "WKWKWKWKWKWK",
            "WKWKWKWKWKWK",
            "KKKKKKKKKKKK",
        ]);
        let display = filled(comb, |band| {
            let mut small = SeedFill::<_, 3>::flood(band, Point::zero(), Rgb565::RED);
            assert!(small.run(band).is_err());
            small.with_stack::<32>().unwrap().run(band).unwrap();
        });
        display.assert_pattern(&[
            "RRRRRRRRRRRR",
            "RWRWRWRWRWRW",
            "RWRWRWRWRWRW",
            "RRRRRRRRRRRR",
            "WRWRWRWRWRWR",
            "WRWRWRWRWRWR",
            "RRRRRRRRRRRR",
        ]);
    }
}
