//! Flood fill and boundary fill by spans (Lieberman 1978; Smith 1979, "Tint fill"; Heckbert 1990, "A seed fill
//! algorithm", Graphics Gems): from a seed over all that is connected with it, on a target that can be read back.
//!
//! Guarantees: exactly the pixels that a search pixel by pixel from the seed would reach inside the target's window, also
//! where that is against the first or the last column or row that there is; no recursion; the stack holds what is still to
//! be searched, not pixels. Where the stack is full, filling stops with an error before anything is lost: every pixel
//! painted so far belongs to the fill, and [`with_stack`](SeedFill::with_stack) carries on from there.
//!
//! Cost: each pixel of the area is painted once. Pixels are read at most three times as often as that, and seven times more
//! for each run of pixels side by side; none is read outside the window.

use embedded_graphics::{geometry::Point, image::GetPixel, pixelcolor::PixelColor};
use heapless::Vec;

use crate::{
    geometry::{DrawError, Table, TooSmall, Window},
    surface::{Span, Target},
};

/// Which neighbours of a pixel are connected with it.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Connectivity {
    /// A pixel's neighbours are those to the left and right, above and below: a diagonal line stops the fill.
    Four,
    /// The four pixels at its corners are neighbours, too: only a line whose pixels touch along their sides stops the fill.
    Eight,
}

impl Connectivity {
    /// Columns by which a neighbour in the next row may lie further out.
    const fn reach(self) -> i32 {
        match self {
            Self::Four => 0,
            Self::Eight => 1,
        }
    }
}

/// The rule by which a seed fill takes a pixel for inside: by its colour.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
enum Inside<C> {
    /// Pixels of the seed's colour are inside.
    Is(C),
    /// Pixels are inside that have neither the boundary's colour nor the new one.
    IsNot(C),
}

/// Columns of a row that have to be searched, next to a span that was painted in the row before.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
struct Search {
    y: i32,
    first: i32,
    last: i32,
    downwards: bool,
}

/// Spans that one painted span leads to at most: further on, and back on both sides.
const MOST_PUSHED: usize = 3;

/// A fill that has begun. `STACK` is the number of spans still to be searched that it has room for; 16 bytes each.
///
/// ```
/// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::{Circle, Rectangle}};
/// use zrow::{band::Band, draw::{Connectivity, DrawOn, PrimitiveStyle, SeedFill}};
///
/// let mut words = [0u16; 20 * 20];
/// let mut band = Band::<Rgb565>::new(Rectangle::new(Point::zero(), Size::new(20, 20)), &mut words)?;
/// let Ok(()) = Circle::new(Point::new(2, 2), 15)
///     .into_styled(PrimitiveStyle::with_stroke(Rgb565::WHITE, 1))
///     .draw_on(&mut band);
///
/// let mut fill = SeedFill::<_, 8>::flood(&band, Point::new(9, 9), Rgb565::RED, Connectivity::Four);
/// assert!(fill.run(&mut band).is_ok());
/// assert_eq!(band.colors().filter(|&color| color == Rgb565::RED).count(), 137);
/// # Ok::<(), zrow::geometry::TooSmall>(())
/// ```
#[derive(Debug, Clone)]
pub struct SeedFill<C, const STACK: usize> {
    inside: Option<Inside<C>>,
    color: C,
    connectivity: Connectivity,
    /// The pixel at which the fill begins; `None` once it is painted.
    seed: Option<Point>,
    /// What is being searched: again from its beginning when a run stopped in it.
    current: Option<Search>,
    stack: Vec<Search, STACK>,
}

impl<C: PixelColor, const STACK: usize> SeedFill<C, STACK> {
    /// A flood fill: everything of the seed's colour that is connected with the seed gets the new colour.
    ///
    /// Nothing is filled where the seed has that colour already, or lies outside the target.
    pub fn flood(target: &impl GetPixel<Color = C>, seed: Point, color: C, connectivity: Connectivity) -> Self {
        let old = target.pixel(seed).filter(|&old| old != color);
        Self::new(old.map(Inside::Is), seed, color, connectivity)
    }

    /// A boundary fill: everything that is connected with the seed gets the new colour, up to pixels of the boundary's
    /// colour. Pixels that have the new colour already count as boundary.
    pub fn boundary(seed: Point, boundary: C, color: C, connectivity: Connectivity) -> Self {
        Self::new(Some(Inside::IsNot(boundary)), seed, color, connectivity)
    }

    fn new(inside: Option<Inside<C>>, seed: Point, color: C, connectivity: Connectivity) -> Self {
        Self {
            inside,
            color,
            connectivity,
            seed: Some(seed),
            current: None,
            stack: Vec::new(),
        }
    }

    /// Moves the fill to a stack of another size, to go on where the old one was full.
    ///
    /// # Errors
    /// [`TooSmall`] where the new stack has no room for what the old one holds.
    pub fn with_stack<const LARGER: usize>(&self) -> Result<SeedFill<C, LARGER>, TooSmall> {
        let stack = Vec::from_slice(&self.stack).map_err(|_| stack_full(self.stack.len()))?;
        Ok(SeedFill {
            inside: self.inside,
            color: self.color,
            connectivity: self.connectivity,
            seed: self.seed,
            current: self.current,
            stack,
        })
    }

    /// Fills until nothing is left to be searched. On a target that shows a part of the picture, such as a band, the fill
    /// ends at the edge of that part.
    ///
    /// # Errors
    /// [`DrawError::TooSmall`] where the stack has no room for the next spans: go on with a larger one
    /// ([`with_stack`](Self::with_stack)). The error's `needed` is what the next step takes; later ones may take more.
    /// [`DrawError::Target`] with the target's own error. Either way the picture so far is correct, and the next run goes on where
    /// this one stopped.
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

    /// Paints every run of inside pixels that begins or ends in the columns of a search.
    fn search<T>(&mut self, target: &mut T, window: &Window, search: Search) -> Result<(), DrawError<T::Error>>
    where
        T: Target<Color = C> + GetPixel<Color = C>,
    {
        let mut x = search.first.max(window.left);
        // A window has no last column of `i32::MAX`.
        let last = search.last.min(window.right.saturating_sub(1));
        while x <= last {
            let Some(run) = self.run_at(target, Point::new(x, search.y)) else {
                x += 1;
                continue;
            };
            let (first, last) = self.paint(target, run)?;
            // Further on, and back as far as the run reaches beyond the span that the search came from.
            let reach = self.connectivity.reach();
            let before = search.first.saturating_add(reach).saturating_sub(1);
            let after = search.last.saturating_sub(reach).saturating_add(1);
            self.push(window, search.y, search.downwards, first, last);
            self.push(window, search.y, !search.downwards, first, last.min(before));
            self.push(window, search.y, !search.downwards, first.max(after), last);
            // The pixel after a run is not inside. Where that is column `i32::MAX`, no window goes on behind it.
            x = run.end.saturating_add(1);
        }
        Ok(())
    }

    /// The run of inside pixels around a pixel.
    fn run_at<T>(&self, target: &T, pixel: Point) -> Option<Span>
    where
        T: Target<Color = C> + GetPixel<Color = C>,
    {
        let is_inside = |x: i32| self.is_inside(target, Point::new(x, pixel.y));
        if !is_inside(pixel.x) {
            return None;
        }
        // There is a column after one of a window.
        let (mut start, mut end) = (pixel.x, pixel.x + 1);
        while let Some(before) = start.checked_sub(1).filter(|&before| is_inside(before)) {
            start = before;
        }
        while is_inside(end) {
            end += 1;
        }
        Some(Span::new(pixel.y, start, end))
    }

    /// Whether a pixel is one of those to be painted. None is that outside the window, which the target is asked for each
    /// time: for a band, this and its own question are one.
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

    /// Paints a run, when there is room for what it leads to. Returns the columns that its neighbours in other rows are in.
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
        let reach = self.connectivity.reach();
        Ok((run.start.saturating_sub(reach), (run.end - 1).saturating_add(reach)))
    }

    /// Notes the row after `y` in one direction, where it is in the window and has columns to be searched.
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
    TooSmall {
        table: Table::Searches,
        needed,
    }
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

    /// What a fill makes of a picture of 12 x 7 pixels.
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

    fn flooded(picture: [&str; HEIGHT as usize], connectivity: Connectivity) -> MockDisplay<Rgb565> {
        filled(picture, |band| {
            SeedFill::<_, 16>::flood(band, Point::new(2, 2), Rgb565::RED, connectivity)
                .run(band)
                .unwrap();
        })
    }

    /// A room whose right wall runs diagonally.
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
        flooded(ROOM, Connectivity::Four).assert_pattern(&[
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
        flooded(ROOM, Connectivity::Eight).assert_pattern(&[
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
            SeedFill::<_, 16>::boundary(Point::new(2, 2), Rgb565::WHITE, Rgb565::RED, Connectivity::Four)
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
            let mut small = SeedFill::<_, 3>::flood(band, Point::zero(), Rgb565::RED, Connectivity::Four);
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
            let mut small = SeedFill::<_, 3>::flood(band, Point::zero(), Rgb565::RED, Connectivity::Four);
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
