//! What a picture copies, and what becomes of it.

use core::fmt;

use embedded_graphics::primitives::{self, Styled};

use crate::{
    draw::{
        PrimitiveStyle,
        payload::Payload,
        picture::item::{Extent, PictureItem},
    },
    geometry::InputError,
    surface::{BandColor, Order},
};

// Not re-exported, and so sealed.
/// What a [`Picture`](crate::draw::Picture) takes by copy.
#[diagnostic::on_unimplemented(
    message = "a picture of this colour and byte order takes no copy of `{Self}`",
    note = "it copies shapes with a style, `shape.into_styled(PrimitiveStyle::with_fill(color))`, and texts, of the picture's colour",
    note = "a shape of sub-pixels, such as a `SubArc`, takes an antialiased style, `PrimitiveStyle::with_fill(color).antialiased()`",
    note = "a `PaintedShape`, a `SceneItem` and any `PictureItem` is added by `Picture::add_item`, which refers to it, and so is any \
            other drawable of embedded-graphics in a `DrawableItem`; images are added by `Picture::add_image`"
)]
pub trait Prepare<'a, C: BandColor, O: Order> {
    /// Writes the item's words, and says where it is and how it is drawn.
    fn prepare(&self, payload: &mut Payload<'_>) -> Draft<'a, C, O>;
}

/// An item before it has a slot.
#[derive(Clone, Copy)]
pub struct Draft<'a, C: BandColor, O: Order> {
    pub(super) extent: Extent,
    pub(super) word: C::Word,
    pub(super) kind: Option<&'a dyn PictureItem<C, O>>,
    /// Segments that a row of an item has at most which needs the memory of antialiasing: 0 where it needs cells alone, and `None`
    /// where it needs none of it.
    pub(super) segments: Result<Option<usize>, InputError>,
}

impl<C: BandColor, O: Order> fmt::Debug for Draft<'_, C, O> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter
            .debug_struct("Draft")
            .field("extent", &self.extent)
            .finish_non_exhaustive()
    }
}

#[cfg(feature = "defmt")]
impl<C: BandColor, O: Order> defmt::Format for Draft<'_, C, O> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "Draft {}", self.extent);
    }
}

impl<'a, C: BandColor, O: Order> Draft<'a, C, O> {
    /// An item that is drawn by a kind, without antialiasing.
    pub(super) fn new(extent: Extent, word: C::Word, kind: &'a dyn PictureItem<C, O>) -> Self {
        Self {
            extent,
            word,
            kind: Some(kind),
            segments: Ok(None),
        }
    }

    /// The item without pixels.
    pub(super) fn nothing() -> Self {
        Self {
            extent: Extent::EMPTY,
            word: not_used::<C>(),
            kind: None,
            segments: Ok(None),
        }
    }
}

/// The word of an item whose colours lie elsewhere.
pub(super) fn not_used<C: BandColor>() -> C::Word {
    <C::Word as crate::surface::PixelWord>::ZERO
}

/// A shape that a picture keeps in a form of its own.
#[diagnostic::on_unimplemented(
    message = "a picture takes no copy of `{Self}` in this style",
    note = "a shape of sub-pixels, such as a `SubArc`, takes an antialiased style, `PrimitiveStyle::with_fill(color).antialiased()`",
    note = "what else is drawn by a program lies in a `DrawableItem` or is a `PictureItem`, which `Picture::add_item` refers to"
)]
pub(super) trait CopiedShape {
    fn prepare<'a, C: BandColor, O: Order>(
        &self,
        style: &PrimitiveStyle<C>,
        payload: &mut Payload<'_>,
    ) -> Draft<'a, C, O>;
}

impl<'a, S: CopiedShape, C: BandColor, O: Order> Prepare<'a, C, O> for Styled<S, PrimitiveStyle<C>> {
    fn prepare(&self, payload: &mut Payload<'_>) -> Draft<'a, C, O> {
        self.primitive.prepare(&self.style, payload)
    }
}

impl<'a, S: CopiedShape, C: BandColor, O: Order> Prepare<'a, C, O> for Styled<S, primitives::PrimitiveStyle<C>> {
    fn prepare(&self, payload: &mut Payload<'_>) -> Draft<'a, C, O> {
        self.primitive.prepare(&self.style.into(), payload)
    }
}
