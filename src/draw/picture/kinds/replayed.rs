//! Shapes that are kept as they were given, and are drawn anew in each band that meets them.

use core::marker::PhantomData;

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
        PrimitiveStyle, StyledShape, ThinCircle,
        picture::{
            item::{Extent, PictureItem, PictureSlot},
            payload::{Payload, Pool, Reader},
            prepare::{Draft, PreparedShape, not_used},
        },
    },
    geometry::Window,
    surface::{BandColor, Order},
};

/// A shape that can be written as words and read from them.
pub(super) trait Words {
    fn write(&self, payload: &mut Payload<'_>);
    fn read(reader: &mut Reader<'_>) -> Self;
}

/// A shape in its style, both of them words.
struct Replayed<S>(PhantomData<S>);

/// The item of a shape whose pixels are in a window.
pub(super) fn replayed<'a, S: Words + StyledShape + 'static, C: BandColor, O: Order>(
    shape: &S,
    style: &PrimitiveStyle<C>,
    window: Window,
    payload: &mut Payload<'_>,
) -> Draft<'a, C, O> {
    let word = |color: Option<C>| color.map(C::to_word);
    payload.push_optional_pixel(word(style.fill_color));
    payload.push_optional_pixel(word(style.stroke_color));
    payload.push(style.stroke_width);
    payload.push(match style.stroke_alignment {
        StrokeAlignment::Inside => 0,
        StrokeAlignment::Center => 1,
        StrokeAlignment::Outside => 2,
    });
    shape.write(payload);
    Draft {
        extent: Extent::of(&window),
        word: not_used::<C>(),
        kind: Some(const { &Replayed::<S>(PhantomData) }),
    }
}

impl<S: Words + StyledShape + 'static, C: BandColor, O: Order> PictureItem<C, O> for Replayed<S> {
    fn bounds(&self) -> Window {
        Window::EMPTY
    }

    fn draw(&self, _: &mut Band<'_, C, O>) {}

    fn draw_row(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, band: &mut Band<'_, C, O>) {
        self.draw_rows(slot, pool, band);
    }

    fn draw_rows(&self, slot: &mut PictureSlot<'_, C, O>, pool: &mut Pool<'_>, band: &mut Band<'_, C, O>) {
        let mut reader = Reader::new(pool.slice(slot.at, slot.words));
        let mut color = || reader.next_optional_pixel().map(C::from_word);
        let style = PrimitiveStyle {
            fill_color: color(),
            stroke_color: color(),
            stroke_width: reader.next(),
            stroke_alignment: match reader.next() {
                0 => StrokeAlignment::Inside,
                1 => StrokeAlignment::Center,
                _ => StrokeAlignment::Outside,
            },
        };
        let Ok(()) = S::read(&mut reader).draw_styled_on(&style, band);
    }
}

macro_rules! always_replayed {
    ($($shape:ty),+) => {$(
        impl PreparedShape for $shape {
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
    fn write(&self, payload: &mut Payload<'_>) {
        payload.push_all(&[self.width, self.height]);
    }

    fn read(reader: &mut Reader<'_>) -> Self {
        Self::new(reader.next(), reader.next())
    }
}

impl Words for Angle {
    fn write(&self, payload: &mut Payload<'_>) {
        payload.push(self.to_radians().to_bits());
    }

    fn read(reader: &mut Reader<'_>) -> Self {
        f32::from_bits(reader.next()).rad()
    }
}

impl Words for Triangle {
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

macro_rules! words_of_fields {
    ($($shape:ident { $($field:ident: $kind:ty),+ })+) => {$(
        impl Words for $shape {
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
    Line { start: Point, end: Point }
    Arc { top_left: Point, diameter: u32, angle_start: Angle, angle_sweep: Angle }
    Sector { top_left: Point, diameter: u32, angle_start: Angle, angle_sweep: Angle }
    CornerRadii { top_left: Size, top_right: Size, bottom_right: Size, bottom_left: Size }
    RoundedRectangle { rectangle: Rectangle, corners: CornerRadii }
    ThinCircle { center: Point, radius: u32 }
}
