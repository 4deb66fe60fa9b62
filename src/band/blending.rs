//! A band reads back what it holds: blending without a frame buffer.

use core::convert::Infallible;

use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{Dimensions, Point},
    primitives::Rectangle,
};

use crate::{
    band::{Band, row_blender::BandBlender},
    coverage::Coverage,
    geometry::{Window, leading_zeros},
    shade::{BatchBlend, BlendTarget, ChannelColor, Encoded, Gamma, TransferFunction, blend_words},
    surface::{BatchTarget, LineSteps, Order, Span, SymmetricBox, SymmetricCurve, Target, Trapezoids},
};

impl<C: ChannelColor, O: Order> Band<'_, C, O> {
    #[inline]
    fn blend_span_by<T: TransferFunction>(&mut self, span: Span, color: C, alpha: Coverage) {
        debug_assert!(self.encloses(span) || span.is_empty());
        if let Some(words) = self.words_of(span) {
            blend_words::<C, T, O>(words, Point::new(span.start, span.y), color, alpha);
        }
    }
}

impl<C: ChannelColor, O: Order> BlendTarget for Band<'_, C, O> {}

impl<C: ChannelColor, O: Order> BatchBlend for Band<'_, C, O> {
    type Blender<'t>
        = BandBlender<'t, C, O, Encoded>
    where
        Self: 't;

    #[inline(always)]
    fn blender(&mut self, color: C) -> BandBlender<'_, C, O, Encoded> {
        BandBlender::new(self, color)
    }

    #[inline]
    fn blend_clipped_span(&mut self, span: Span, color: C, alpha: Coverage) -> Result<(), Infallible> {
        self.blend_span_by::<Encoded>(span, color, alpha);
        Ok(())
    }

    /// Pixel by pixel: most of a glyph's are covered partly, and differently from their neighbours.
    #[inline]
    fn blend_clipped_fifteenths(&mut self, y: i32, start: i32, mut eight: u32, color: C) -> Result<(), Infallible> {
        let first = self.index_unchecked(start, y);
        let mut pixels = self.words.get_mut(first..).unwrap_or_default();
        let word = Self::word(color);
        let mut x = start;
        while eight != 0 {
            let gap = leading_zeros(eight) / 4;
            eight <<= 4 * gap;
            let fifteenths = eight >> 28;
            eight <<= 4;
            let Some((pixel, behind)) = pixels.get_mut(gap as usize..).and_then(<[_]>::split_first_mut) else {
                break;
            };
            pixels = behind;
            x += gap as i32;
            if fifteenths == 15 {
                *pixel = word;
            } else {
                let pixel = core::slice::from_mut(pixel);
                C::blend_run::<Encoded, O>(pixel, Point::new(x, y), color, 17 * fifteenths as Coverage);
            }
            x += 1;
        }
        Ok(())
    }
}

impl<'words, C: ChannelColor, O: Order> Band<'words, C, O> {
    /// The band as a [`BlendTarget`] that blends in linear light; whatever is not blended is drawn as on the band itself.
    ///
    /// Levels stand for light to the power of `TENTHS / 10`, 10 to 30; 22 is what displays are made for. Shapes have the light
    /// of their coverage, so that thin ones look neither too thin on dark ground, as they do on a band, nor too fat on bright
    /// ground. Each channel is at most 0.502 levels away from the exact mix (0.53 above gamma 2.5). Cost: some ten operations
    /// a channel and one of its bits; a table for each channel width in use, 768 bytes for `Rgb565`, 2,048 for 8 bits.
    ///
    /// Shapes in an [`Antialiased`](crate::draw::Antialiased) style are drawn on its own `antialiased`, as on
    /// [`Band::antialiased`].
    ///
    /// ```
    /// use embedded_graphics::{pixelcolor::Gray8, prelude::*, primitives::Rectangle};
    /// use zrow::{band::{Band, Span}, shade::BlendTarget};
    ///
    /// let mut words = [0; 8];
    /// let mut band = Band::<Gray8>::new(Rectangle::new(Point::zero(), Size::new(8, 1)), &mut words)?;
    /// let Ok(()) = band.blend_span(Span::new(0, 0, 1), Gray8::WHITE, 128);
    /// let Ok(()) = band.in_linear_light::<22>().blend_span(Span::new(0, 1, 2), Gray8::WHITE, 128);
    /// assert_eq!(words[..3], [128, 186, 0]);
    /// # Ok::<(), zrow::geometry::TooSmall>(())
    /// ```
    pub const fn in_linear_light<const TENTHS: u32>(&mut self) -> InLinearLight<'_, 'words, C, O, TENTHS> {
        InLinearLight(self)
    }
}

// Not re-exported: who takes one is generic over blend targets.
/// A band that is blended into in linear light.
#[derive(Debug)]
pub struct InLinearLight<'a, 'words, C: ChannelColor, O: Order, const TENTHS: u32>(&'a mut Band<'words, C, O>);

impl<C: ChannelColor, O: Order, const TENTHS: u32> BlendTarget for InLinearLight<'_, '_, C, O, TENTHS> {}

impl<C: ChannelColor, O: Order, const TENTHS: u32> BatchBlend for InLinearLight<'_, '_, C, O, TENTHS> {
    type Blender<'t>
        = BandBlender<'t, C, O, Gamma<TENTHS>>
    where
        Self: 't;

    #[inline(always)]
    fn blender(&mut self, color: C) -> BandBlender<'_, C, O, Gamma<TENTHS>> {
        BandBlender::new(self.0, color)
    }

    #[inline]
    fn blend_clipped_span(&mut self, span: Span, color: C, alpha: Coverage) -> Result<(), Infallible> {
        self.0.blend_span_by::<Gamma<TENTHS>>(span, color, alpha);
        Ok(())
    }
}

impl<C: ChannelColor, O: Order, const TENTHS: u32> Dimensions for InLinearLight<'_, '_, C, O, TENTHS> {
    fn bounding_box(&self) -> Rectangle {
        self.0.bounding_box()
    }
}

impl<C: ChannelColor, O: Order, const TENTHS: u32> DrawTarget for InLinearLight<'_, '_, C, O, TENTHS> {
    type Color = C;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<C>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        self.0.draw_iter(pixels)
    }

    fn fill_contiguous<I: IntoIterator<Item = C>>(&mut self, area: &Rectangle, colors: I) -> Result<(), Infallible> {
        self.0.fill_contiguous(area, colors)
    }

    fn fill_solid(&mut self, area: &Rectangle, color: C) -> Result<(), Infallible> {
        self.0.fill_solid(area, color)
    }

    fn clear(&mut self, color: C) -> Result<(), Infallible> {
        self.0.clear(color)
    }
}

impl<C: ChannelColor, O: Order, const TENTHS: u32> Target for InLinearLight<'_, '_, C, O, TENTHS> {
    fn window(&self) -> Window {
        self.0.window()
    }

    fn raw(&self, color: C) -> C::Word {
        self.0.raw(color)
    }

    fn fill_span(&mut self, span: Span, raw: C::Word) -> Result<(), Infallible> {
        self.0.fill_span(span, raw)
    }
}

impl<C: ChannelColor, O: Order, const TENTHS: u32> BatchTarget for InLinearLight<'_, '_, C, O, TENTHS> {
    type Raw = C::Word;

    fn fill_clipped_span(&mut self, span: Span, raw: C::Word) -> Result<(), Infallible> {
        self.0.fill_clipped_span(span, raw)
    }

    fn fill_clipped_window(&mut self, window: Window, raw: C::Word) -> Result<(), Infallible> {
        self.0.fill_clipped_window(window, raw)
    }

    fn fill_trapezoids(&mut self, trapezoids: &Trapezoids, raw: C::Word) -> Result<(), Infallible> {
        self.0.fill_trapezoids(trapezoids, raw)
    }

    fn draw_steps(&mut self, steps: &LineSteps, raw: C::Word) -> Result<(), Infallible> {
        self.0.draw_steps(steps, raw)
    }

    fn fill_symmetric(
        &mut self,
        shape: &SymmetricBox,
        curve: &mut dyn SymmetricCurve,
        raw: C::Word,
        inner_raw: Option<C::Word>,
    ) -> Result<(), Infallible> {
        self.0.fill_symmetric(shape, curve, raw, inner_raw)
    }
}

#[cfg(feature = "defmt")]
impl<C: ChannelColor, O: Order, const TENTHS: u32> defmt::Format for InLinearLight<'_, '_, C, O, TENTHS> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "InLinearLight {}/10 of {}", TENTHS, self.0);
    }
}
