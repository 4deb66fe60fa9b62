//! Antialiased polygons as items of a picture.

use core::{cell::RefCell, fmt, ops::Range};

use crate::{
    band::Band,
    coverage::CoverageMethod,
    draw::{
        AntialiasedPolygon,
        payload::Pool,
        picture::item::{PictureItem, PictureSlot},
    },
    geometry::{DrawError, Table, TooSmall, Window},
    shade::{BatchBlend, ChannelColor},
    surface::{Order, Target},
};

/// A prepared polygon in a colour, blended over what lies behind it in the picture.
///
/// All items share one row memory. The polygon is set up once, for as long as it does not change; in rows that it does
/// not meet it costs nothing.
///
/// ```
/// use core::cell::RefCell;
/// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
/// use zrow::{
///     band::Band,
///     coverage::{CoverageMethod, SignedArea},
///     draw::{AntialiasedItem, AntialiasedPolygon, FillRule, Picture, PictureSlot, SubEllipse},
///     geometry::{Sub8, SubPoint},
/// };
/// use zrow::fixed::types::U24F8;
///
/// const WIDTH: usize = 64;
/// let disc = SubEllipse::circle(SubPoint::<Sub8>::from_units(32 * 256, 32 * 256)?, U24F8::from_num(20.5))?;
/// let disc = AntialiasedPolygon::<84, 16>::prepare(&disc, FillRule::NonZero)?;
/// let row_memory = RefCell::new([0; WIDTH + 1]);
/// let disc = AntialiasedItem::new(&disc, SignedArea, Rgb565::RED, &row_memory, WIDTH)?;
///
/// let area = Rectangle::new(Point::zero(), Size::new(WIDTH as u32, 64));
/// let (mut slots, mut buckets, mut row) = ([PictureSlot::EMPTY; 1], [0; 64], [0; WIDTH]);
/// let mut picture = Picture::new(area, &mut slots, &mut [], &mut buckets);
/// picture.add_item(&disc)?;
/// let mut band = Band::<Rgb565>::new(Rectangle::new(Point::new(0, 32), Size::new(WIDTH as u32, 1)), &mut row)?;
/// picture.draw(&mut band);
/// assert_eq!(row[32], Rgb565::RED.into_storage());
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
pub struct AntialiasedItem<'p, C, T: CoverageMethod, const EDGES: usize, const ACTIVE: usize> {
    polygon: &'p AntialiasedPolygon<EDGES, ACTIVE>,
    method: T,
    color: C,
    row_memory: &'p RefCell<[T::Cell]>,
    /// Columns that the row memory is enough for, at least 1.
    width: u32,
}

impl<'p, C, T: CoverageMethod, const EDGES: usize, const ACTIVE: usize> AntialiasedItem<'p, C, T, EDGES, ACTIVE> {
    /// A polygon by a coverage method, in bands of up to `width` columns; in wider bands nothing is drawn. The row
    /// memory is as many cells as [`CoverageMethod::cells`] says for that width, all of them 0, and is so again after
    /// each band.
    ///
    /// # Errors
    /// [`TooSmall`] if it has fewer. A row memory that is borrowed counts as one without cells.
    pub fn new(
        polygon: &'p AntialiasedPolygon<EDGES, ACTIVE>,
        method: T,
        color: C,
        row_memory: &'p RefCell<[T::Cell]>,
        width: usize,
    ) -> Result<Self, TooSmall> {
        let width = width.max(1);
        let needed = T::cells(width);
        if row_memory.try_borrow().map_or(0, |cells| cells.len()) < needed {
            return Err(TooSmall {
                table: Table::Cells,
                needed,
            });
        }
        Ok(Self {
            polygon,
            method,
            color,
            row_memory,
            width: u32::try_from(width).unwrap_or(u32::MAX),
        })
    }
}

impl<C, O, T, const EDGES: usize, const ACTIVE: usize> PictureItem<C, O> for AntialiasedItem<'_, C, T, EDGES, ACTIVE>
where
    C: ChannelColor,
    O: Order,
    T: CoverageMethod,
{
    fn bounds(&self) -> Window {
        self.polygon.bounds()
    }

    fn draw(&self, band: &mut Band<'_, C, O>) {
        let Ok(mut row_memory) = self.row_memory.try_borrow_mut() else {
            return;
        };
        let mut strip = band.window();
        let end = strip.right;
        while strip.left < end {
            strip.right = end.min(strip.left.saturating_add_unsigned(self.width));
            // Neither fails: the band never does, and the row memory is as wide as the strip.
            let _ = self
                .polygon
                .cover(&self.method, &strip, &mut row_memory, |span, coverage| {
                    band.blend_clipped_span(span, self.color, coverage)
                        .map_err(DrawError::Target)
                });
            strip.left = strip.right;
        }
    }

    fn columns_in(&self, _: &PictureSlot<'_, C, O>, _: &Pool<'_>, rows: Range<i32>) -> (i32, i32) {
        self.polygon.columns_in(&rows)
    }
}

impl<C, T, const EDGES: usize, const ACTIVE: usize> fmt::Debug for AntialiasedItem<'_, C, T, EDGES, ACTIVE>
where
    C: fmt::Debug,
    T: CoverageMethod + fmt::Debug,
{
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter
            .debug_struct("AntialiasedItem")
            .field("polygon", &self.polygon)
            .field("method", &self.method)
            .field("color", &self.color)
            .finish_non_exhaustive()
    }
}

#[cfg(feature = "defmt")]
impl<C, T, const EDGES: usize, const ACTIVE: usize> defmt::Format for AntialiasedItem<'_, C, T, EDGES, ACTIVE>
where
    T: CoverageMethod,
{
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "AntialiasedItem, {}", self.polygon);
    }
}
