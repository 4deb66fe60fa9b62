//! Shapes that are kept as they were given, and are drawn anew in each band that meets them.

use core::{marker::PhantomData, ops::Range};

use embedded_graphics::{
    geometry::{Angle, AngleUnit, Point, Size},
    primitives::{
        Arc, Circle, CornerRadii, Ellipse, Line, Rectangle, RoundedRectangle, Sector, StrokeAlignment,
        StyledDimensions, Triangle,
    },
};

use crate::{
    band::Band,
    draw::{
        PrimitiveStyle, StrokedShape, StyledShape, ThinCircle,
        payload::{Payload, Reader},
        picture::{
            item::{Extent, PictureItem, PictureSlot},
            pool::Pool,
            prepare::{CopiedShape, Draft, not_used},
        },
    },
    geometry::{Bounds, Window},
    surface::{BandColor, Order},
};

/// A shape that can be written as words and read from them.
pub(super) trait Words {
    /// How many points it writes before anything else. What follows them says nothing of where the shape is.
    const POINTS: usize = 1;

    fn write(&self, payload: &mut Payload<'_>);
    fn read(reader: &mut Reader<'_>) -> Self;

    /// The columns of the shape with a stroke of a width in some rows, or more of them; `None` where they are not
    /// known.
    fn columns_in(&self, _stroke_width: u32, _rows: Range<i32>) -> Option<Range<i64>> {
        None
    }
}

/// Widths of strokes beyond this one count as this one.
const MOST_STROKE: u32 = 4_096;

/// A shape in its style, both of them words.
struct Replayed<S>(PhantomData<S>);

/// Words of a style, which lie before those of the shape.
const STYLE_WORDS: usize = 6;

/// The item of a shape whose pixels are in a window.
pub(super) fn replayed<'a, S: Words + StyledShape + 'static, C: BandColor, O: Order>(
    shape: &S,
    style: &PrimitiveStyle<C>,
    window: Window,
    payload: &mut Payload<'_>,
) -> Draft<'a, C, O> {
    write_style(style, payload);
    shape.write(payload);
    Draft::new(
        Extent::of(&window),
        not_used::<C>(),
        const { &Replayed::<S>(PhantomData) },
    )
}

/// A window around what a wide stroke of a shape may have around vertices that are so far out that it is not generated there,
/// once it is moved.
pub(super) fn out_of_reach(shape: &dyn StrokedShape, width_in_halves: u64) -> Window {
    let mut bounds = Bounds::EMPTY;
    shape.paths(width_in_halves, &mut |path| {
        bounds = bounds.around(&path.out_of_reach(path.reach()));
    });
    bounds.to_rectangle().into()
}

/// Writes a style.
#[inline(always)]
pub(super) fn write_style<C: BandColor>(style: &PrimitiveStyle<C>, payload: &mut Payload<'_>) {
    let word = |color: Option<C>| color.map(C::to_word);
    payload.push_optional_pixel(word(style.fill_color));
    payload.push_optional_pixel(word(style.stroke_color));
    payload.push(style.stroke_width);
    payload.push(match style.stroke_alignment {
        StrokeAlignment::Inside => 0,
        StrokeAlignment::Center => 1,
        StrokeAlignment::Outside => 2,
    });
}

/// Reads a style that [`write_style`] wrote.
#[inline(always)]
pub(super) fn read_style<C: BandColor>(reader: &mut Reader<'_>) -> PrimitiveStyle<C> {
    let mut color = || reader.next_optional_pixel().map(C::from_word);
    PrimitiveStyle {
        fill_color: color(),
        stroke_color: color(),
        stroke_width: reader.next(),
        stroke_alignment: match reader.next() {
            0 => StrokeAlignment::Inside,
            1 => StrokeAlignment::Center,
            _ => StrokeAlignment::Outside,
        },
    }
}

impl<S: Words + StyledShape + 'static, C: BandColor, O: Order> PictureItem<C, O> for Replayed<S> {
    fn bounds(&self) -> Window {
        Window::EMPTY
    }

    fn draw(&self, _: &mut Band<'_, C, O>) {}

    fn columns_in(&self, slot: &PictureSlot<'_, C, O>, pool: &Pool<'_>, rows: Range<i32>) -> (i32, i32) {
        let (shape, style) = read::<S, C>(slot, pool);
        visible_columns(slot.extent, shape.columns_in(style.stroke_width, rows))
    }

    fn translate(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, by: Point) {
        let words = pool.slice_mut(slot.at, slot.words);
        let points = words
            .get_mut(STYLE_WORDS..STYLE_WORDS + 2 * S::POINTS)
            .unwrap_or_default();
        points.chunks_exact_mut(2).for_each(|point| translate_point(point, by));
    }

    fn draw_row(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, band: &mut Band<'_, C, O>) {
        self.draw_rows(slot, pool, band);
    }

    fn draw_rows(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, band: &mut Band<'_, C, O>) {
        let (shape, style) = read::<S, C>(slot, pool);
        let Ok(()) = shape.draw_styled_on(&style, band);
    }
}

/// Columns of an item, as far as they lie in its box; all of that where they are not known.
pub(super) fn visible_columns(extent: Extent, columns: Option<Range<i64>>) -> (i32, i32) {
    let (left, right) = extent.columns();
    match columns {
        // Between the two, which are numbers of 16 bits.
        Some(columns) => (
            columns.start.max(left.into()).min(right.into()) as i32,
            columns.end.max(left.into()).min(right.into()) as i32,
        ),
        None => (left, right),
    }
}

/// Moves a point that lies as two words.
pub(super) fn translate_point(words: &mut [u32], by: Point) {
    for (word, by) in words.iter_mut().zip([by.x, by.y]) {
        // Only a point 2^31 pixels from the picture, which a pixel more or less does not show, ends at the number range.
        *word = (*word as i32).saturating_add(by) as u32;
    }
}

/// The shape and the style of an item.
fn read<S: Words, C: BandColor>(slot: &PictureSlot<'_, C, impl Order>, pool: &Pool<'_>) -> (S, PrimitiveStyle<C>) {
    let mut reader = Reader::new(pool.slice(slot.at, slot.words));
    let style = read_style(&mut reader);
    (S::read(&mut reader), style)
}

macro_rules! always_replayed {
    ($($shape:ty),+) => {$(
        impl CopiedShape for $shape {
            fn prepare<'a, C: BandColor, O: Order>(
                &self,
                style: &PrimitiveStyle<C>,
                payload: &mut Payload<'_>,
            ) -> Draft<'a, C, O> {
                replayed(self, style, self.styled_bounding_box(style).into(), payload)
            }
        }
    )+};
}
always_replayed!(RoundedRectangle, Arc, Sector, ThinCircle);

impl Words for u32 {
    const POINTS: usize = 0;

    fn write(&self, payload: &mut Payload<'_>) {
        payload.push(*self);
    }

    fn read(reader: &mut Reader<'_>) -> Self {
        reader.next()
    }
}

impl Words for Point {
    fn write(&self, payload: &mut Payload<'_>) {
        payload.push_signed(self.x);
        payload.push_signed(self.y);
    }

    fn read(reader: &mut Reader<'_>) -> Self {
        Self::new(reader.next_signed(), reader.next_signed())
    }
}

impl Words for Size {
    const POINTS: usize = 0;

    fn write(&self, payload: &mut Payload<'_>) {
        payload.push_all(&[self.width, self.height]);
    }

    fn read(reader: &mut Reader<'_>) -> Self {
        Self::new(reader.next(), reader.next())
    }
}

impl Words for Angle {
    const POINTS: usize = 0;

    fn write(&self, payload: &mut Payload<'_>) {
        payload.push(self.to_radians().to_bits());
    }

    fn read(reader: &mut Reader<'_>) -> Self {
        f32::from_bits(reader.next()).rad()
    }
}

impl Words for Triangle {
    const POINTS: usize = 3;

    fn write(&self, payload: &mut Payload<'_>) {
        for vertex in &self.vertices {
            vertex.write(payload);
        }
    }

    fn read(reader: &mut Reader<'_>) -> Self {
        let mut vertex = || Point::read(reader);
        Self::new(vertex(), vertex(), vertex())
    }
}

impl Words for Line {
    const POINTS: usize = 2;

    fn write(&self, payload: &mut Payload<'_>) {
        self.start.write(payload);
        self.end.write(payload);
    }

    fn read(reader: &mut Reader<'_>) -> Self {
        Self::new(Point::read(reader), Point::read(reader))
    }

    fn columns_in(&self, stroke_width: u32, rows: Range<i32>) -> Option<Range<i64>> {
        let (upper, lower) = if self.start.y < self.end.y {
            (self.start, self.end)
        } else {
            (self.end, self.start)
        };
        let [x, y] = [upper.x, upper.y].map(i64::from);
        let (columns, height) = (i64::from(lower.x) - x, i64::from(lower.y) - y);
        // Half the stroke, half a pixel beyond the ends, and what rounding and a pixel's own size take.
        let reach = i64::from(stroke_width.min(MOST_STROKE) / 2) + 3;
        let column_at = |row: i64| {
            let down = (row - y).max(0).min(height);
            Some(x + columns.checked_mul(down)?.checked_div(height)?)
        };
        let (from, to) = (
            column_at(i64::from(rows.start) - reach)?,
            column_at(i64::from(rows.end) + reach)?,
        );
        Some(from.min(to) - reach..from.max(to) + reach + 1)
    }
}

macro_rules! words_of_fields {
    ($($shape:ident { $($field:ident: $kind:ty),+ })+) => {$(
        impl Words for $shape {
            const POINTS: usize = 0 $(+ <$kind as Words>::POINTS)+;

            fn write(&self, payload: &mut Payload<'_>) {
                $(self.$field.write(payload);)+
            }

            fn read(reader: &mut Reader<'_>) -> Self {
                Self { $($field: <$kind>::read(reader)),+ }
            }
        }
    )+};
}
words_of_fields! {
    Rectangle { top_left: Point, size: Size }
    Circle { top_left: Point, diameter: u32 }
    Ellipse { top_left: Point, size: Size }
    Arc { top_left: Point, diameter: u32, angle_start: Angle, angle_sweep: Angle }
    Sector { top_left: Point, diameter: u32, angle_start: Angle, angle_sweep: Angle }
    CornerRadii { top_left: Size, top_right: Size, bottom_right: Size, bottom_left: Size }
    RoundedRectangle { rectangle: Rectangle, corners: CornerRadii }
    ThinCircle { center: Point, radius: u32 }
}
