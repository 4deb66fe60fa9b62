//! Multisampling: several samples a pixel, each with its own colour word, and one colour per fragment.
//!
//! Guarantees: a shape's mask says which samples of a pixel it takes; its colour in a pixel is found once, with a paint too.
//! Painter's order holds sample by sample, so two shapes that share an edge leave nothing of what was below along it. In the
//! end a pixel is the mean of its samples, each channel rounded once (ties up), and a pixel whose samples are alike keeps
//! that colour, to the bit. Of `BinaryColor` an ordered threshold takes one or the other.
//!
//! A [scene](crate::scene) whose look is [`Multisampled`](crate::scene::Multisampled) draws with a depth a sample
//! ([`Prepared::draw_samples`](crate::scene::Prepared::draw_samples)); any other one has one depth a pixel and draws into the
//! band, before (its pixels are then what the samples begin as) or afterwards.
//!
//! Memory: `SAMPLES` words a pixel beside the band's own; for 240 pixels of 16 bits 1,920, 3,840 or 7,680 bytes with 4, 8
//! or 16 samples. Shapes take the row memory of their pattern, as any coverage does.
//!
//! Source: Akeley 1993 (RealityEngine); the standard patterns of Direct3D.

use core::{convert::Infallible, marker::PhantomData, slice::from_mut};

use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{Dimensions, Point},
    primitives::Rectangle,
};

use crate::{
    band::{Band, words_needed},
    coverage::{Coverage, SamplePattern},
    geometry::{TooSmall, Window, offset_from},
    shade::{
        BatchBlend, BlendTarget, ChannelColor, Encoded, SampleTarget, SpanBlender, blend_words,
        samples::mean::add_levels,
    },
    surface::{
        BandColor, BatchTarget, LineSteps, Order, PixelWord, Span, Target,
        contiguous::{ContiguousRows, skip},
        not_constant,
    },
};

impl<C: ChannelColor, O: Order> Band<'_, C, O> {
    /// Draws with several samples a pixel, which begin as what the band holds; afterwards the band holds their means.
    ///
    /// The target that `draw` gets is a [`SampleTarget`], which a function takes as `&mut impl SampleTarget<Color = C>`: polygons
    /// are drawn into the samples that they cover, by
    /// [`AntialiasedPolygon::draw_samples`](crate::draw::AntialiasedPolygon::draw_samples). What is drawn without a mask, such as
    /// text and shapes without antialiasing, takes whole pixels, in its turn; the target is a [`BlendTarget`] too.
    ///
    /// `samples` takes [`P::SAMPLES`](SamplePattern::SAMPLES) words for each pixel of the band.
    ///
    /// ```
    /// use embedded_graphics::{pixelcolor::Gray8, prelude::*, primitives::Rectangle};
    /// use zrow::{
    ///     band::Band,
    ///     coverage::{CoverageMethod, Rooks, SamplePattern},
    ///     draw::{AntialiasedPolygon, FillRule},
    ///     geometry::{Sub8, SubPoint},
    /// };
    ///
    /// const WIDTH: usize = 4;
    /// // Two triangles on either side of a diagonal.
    /// let corner = |x, y| SubPoint::<Sub8>::from_units(x, y);
    /// let [a, b, c, d] = [corner(-128, -128)?, corner(896, -128)?, corner(896, 896)?, corner(-128, 896)?];
    /// let upper = AntialiasedPolygon::<3, 3>::prepare(&[[a, b, c].as_slice()], FillRule::NonZero)?;
    /// let lower = AntialiasedPolygon::<3, 3>::prepare(&[[a, c, d].as_slice()], FillRule::NonZero)?;
    ///
    /// let (mut words, mut memory) = ([0; WIDTH * 4], [0; WIDTH / 2]);
    /// let mut band = Band::<Gray8>::new(Rectangle::new(Point::zero(), Size::new(4, 4)), &mut words)?;
    /// let mut samples = [0; Rooks::<4>::SAMPLES * WIDTH * 4];
    /// band.multisample(Rooks::<4>, &mut samples, |samples| {
    ///     upper.draw_samples(Gray8::WHITE, samples, &mut memory)?;
    ///     lower.draw_samples(Gray8::WHITE, samples, &mut memory)
    /// })??;
    /// // No seam, where blending a half and a half of what is left would give 191.
    /// assert_eq!(words, [255; 16]);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`TooSmall`] if `samples` has fewer words; then nothing is drawn.
    pub fn multisample<P: SamplePattern, R>(
        &mut self,
        _pattern: P,
        samples: &mut [C::Word],
        draw: impl FnOnce(&mut Multisampled<'_, C, O, P>) -> R,
    ) -> Result<R, TooSmall> {
        const { assert!(P::SAMPLES.is_power_of_two() && P::SAMPLES <= 32) };
        let needed = words_needed(&self.window).saturating_mul(P::SAMPLES);
        let words = samples.get_mut(..needed).ok_or(TooSmall::Words(needed))?;
        for (pixel, &word) in words.chunks_exact_mut(P::SAMPLES).zip(&*self.words) {
            pixel.fill(word);
        }
        let mut target = Multisampled {
            window: self.window,
            stride: self.stride,
            words,
            pixels: self.words,
            color: PhantomData,
        };
        let result = draw(&mut target);
        let Multisampled { words, pixels, .. } = target;
        let (top_left, stride) = (Point::new(self.window.left, self.window.top), self.stride.max(1));
        let pixels = pixels.iter_mut().zip(words.chunks_exact(P::SAMPLES));
        for (index, (word, pixel)) in pixels.enumerate() {
            // Only colours without levels between them ask for the position.
            let position = || top_left + Point::new((index % stride) as i32, (index / stride) as i32);
            *word = resolve::<C, O>(pixel, position);
        }
        Ok(result)
    }
}

/// The mean of a pixel's samples.
#[inline]
fn resolve<C: ChannelColor, O: Order>(samples: &[C::Word], position: impl FnOnce() -> Point) -> C::Word {
    let Some((&first, rest)) = samples.split_first() else {
        return <C::Word as PixelWord>::ZERO;
    };
    // Most pixels are inside or outside.
    if rest.iter().all(|&word| word == first) {
        return first;
    }
    let mut levels = [0; 3];
    for &word in samples {
        add_levels::<C::Layout, O>(&mut levels, word, 1);
    }
    C::mean::<O>(levels, samples.len().trailing_zeros(), position)
}

// Not re-exported: `Band::multisample` hands it to a closure, and says what it is.
/// The samples of a band's pixels: a target that takes masks.
#[derive(Debug)]
pub struct Multisampled<'s, C: ChannelColor, O: Order, P> {
    window: Window,
    /// Pixels in a row.
    stride: usize,
    /// The colours of all samples, those of a pixel one after the other.
    words: &'s mut [C::Word],
    /// The pixels of the band, which are written when all is drawn: memory to draw in until then.
    pixels: &'s mut [C::Word],
    color: PhantomData<(O, P)>,
}

/// A row of pixels to draw in, and their samples, those of a pixel one after the other.
type RowOfSamples<'r, C, O> = (Band<'r, C, O>, &'r mut [<C as BandColor>::Word]);

impl<C: ChannelColor, O: Order, P: SamplePattern> Multisampled<'_, C, O, P> {
    /// The mask of all samples, of which there is at least one.
    const ALL: u32 = u32::MAX >> (32 - P::SAMPLES);

    /// A row of pixels that may be drawn over, as a band, and the samples of these pixels; `None` where there is no such row.
    pub(crate) fn row_of_samples(&mut self, y: i32) -> Option<RowOfSamples<'_, C, O>> {
        let window = Window {
            top: y,
            bottom: y.checked_add(1)?,
            ..self.window
        };
        if !self.window.contains(Point::new(window.left, y)) {
            return None;
        }
        let row = offset_from(self.window.top, y) as usize * self.stride;
        let pixels = self.pixels.get_mut(row..row + self.stride)?;
        let samples = self.words.get_mut(row * P::SAMPLES..(row + self.stride) * P::SAMPLES)?;
        let band = Band {
            window,
            stride: self.stride,
            words: pixels,
            order: PhantomData,
        };
        Some((band, samples))
    }

    /// The samples of the pixels of a span that [`Span::clipped_to`] the window returned; of another one, some or none.
    #[inline]
    fn samples(&mut self, span: Span) -> &mut [C::Word] {
        // Of a row outside the window an index of 32 bits may wrap.
        let row = (offset_from(self.window.top, span.y) as usize).wrapping_mul(self.stride);
        let position = |x: i32| {
            let column = offset_from(self.window.left, x) as usize;
            row.wrapping_add(column).wrapping_mul(P::SAMPLES)
        };
        self.words
            .get_mut(position(span.start)..position(span.end))
            .unwrap_or_default()
    }

    /// The samples of a mask, pixel by pixel, of a span that was clipped to the window.
    #[inline]
    fn masked(&mut self, span: Span, mask: u32) -> impl Iterator<Item = impl Iterator<Item = &mut C::Word>> {
        let chosen = move |&(sample, _): &(u32, &mut C::Word)| mask >> sample & 1 != 0;
        let pixels = self.samples(span).chunks_exact_mut(P::SAMPLES);
        pixels.map(move |pixel| (0..32).zip(pixel).filter(chosen).map(|(_, word)| word))
    }
}

impl<C: ChannelColor, O: Order, P: SamplePattern> SampleTarget for Multisampled<'_, C, O, P> {
    type Pattern = P;

    #[inline]
    fn fill_samples(&mut self, span: Span, mask: u32, raw: C::Word) -> Result<(), Infallible> {
        let visible = span.clipped_to(&self.window);
        if mask & Self::ALL == Self::ALL {
            C::Word::fill(self.samples(visible), raw);
            return Ok(());
        }
        for word in self.masked(visible, mask).flatten() {
            *word = raw;
        }
        Ok(())
    }

    fn set_samples<I>(&mut self, span: Span, mask: u32, colors: I) -> Result<(), Infallible>
    where
        I: IntoIterator<Item = C>,
    {
        let visible = span.clipped_to(&self.window);
        let mut colors = colors.into_iter();
        if visible.is_empty() || !skip(&mut colors, visible.start.abs_diff(span.start).into()) {
            return Ok(());
        }
        for (pixel, color) in self.masked(visible, mask).zip(colors) {
            let raw = Band::<C, O>::word(color);
            for word in pixel {
                *word = raw;
            }
        }
        Ok(())
    }
}

impl<C: ChannelColor, O: Order, P: SamplePattern> Dimensions for Multisampled<'_, C, O, P> {
    fn bounding_box(&self) -> Rectangle {
        self.window.to_rectangle()
    }
}

impl<C: ChannelColor, O: Order, P: SamplePattern> DrawTarget for Multisampled<'_, C, O, P> {
    type Color = C;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<C>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        for Pixel(point, color) in pixels {
            if self.window.contains(point) {
                self.samples(pixel_span(point)).fill(Band::<C, O>::word(color));
            }
        }
        Ok(())
    }

    fn fill_contiguous<I: IntoIterator<Item = C>>(&mut self, area: &Rectangle, colors: I) -> Result<(), Infallible> {
        let visible = Window::from(*area).intersection(&self.window);
        let mut rows = ContiguousRows::new(area, visible, colors.into_iter());
        while let Some((span, colors)) = rows.next_row() {
            for (pixel, color) in self.samples(span).chunks_exact_mut(P::SAMPLES).zip(colors) {
                pixel.fill(Band::<C, O>::word(color));
            }
        }
        Ok(())
    }

    fn fill_solid(&mut self, area: &Rectangle, color: C) -> Result<(), Infallible> {
        self.fill_window(Window::from(*area), Band::<C, O>::word(color))
    }
}

impl<C: ChannelColor, O: Order, P: SamplePattern> Target for Multisampled<'_, C, O, P> {
    fn window(&self) -> Window {
        self.window
    }

    fn raw(&self, color: C) -> C::Word {
        not_constant(Band::<C, O>::word(color))
    }
}

impl<C: ChannelColor, O: Order, P: SamplePattern> BatchTarget for Multisampled<'_, C, O, P> {
    type Raw = C::Word;

    #[inline]
    fn fill_clipped_span(&mut self, span: Span, raw: C::Word) -> Result<(), Infallible> {
        C::Word::fill(self.samples(span), raw);
        Ok(())
    }

    fn fill_clipped_window(&mut self, window: Window, raw: C::Word) -> Result<(), Infallible> {
        if window.is_empty() {
            return Ok(());
        }
        for y in window.top..window.bottom {
            C::Word::fill(self.samples(Span::new(y, window.left, window.right)), raw);
        }
        Ok(())
    }

    fn draw_steps(&mut self, steps: &LineSteps, raw: C::Word) -> Result<(), Infallible> {
        for point in *steps {
            C::Word::fill(self.samples(pixel_span(point)), raw);
        }
        Ok(())
    }
}

/// Coverage is blended into every sample of a pixel alike, so that shapes by any coverage method may be mixed with those of masks.
impl<C: ChannelColor, O: Order, P: SamplePattern> BlendTarget for Multisampled<'_, C, O, P> {}

impl<C: ChannelColor, O: Order, P: SamplePattern> BatchBlend for Multisampled<'_, C, O, P> {
    type Blender<'t>
        = SpanBlender<'t, Self>
    where
        Self: 't;

    fn blender(&mut self, color: C) -> SpanBlender<'_, Self> {
        SpanBlender::new(self, color)
    }

    fn blend_clipped_span(&mut self, span: Span, color: C, coverage: Coverage) -> Result<(), Infallible> {
        if C::IS_MIXED {
            // Alike at any position.
            blend_words::<C, Encoded, O>(self.samples(span), Point::new(span.start, span.y), color, coverage);
            return Ok(());
        }
        let pixels = self.samples(span).chunks_exact_mut(P::SAMPLES);
        // The pixels come first: behind the last one there may be no column.
        for (pixel, x) in pixels.zip(span.start..) {
            for word in pixel {
                blend_words::<C, Encoded, O>(from_mut(word), Point::new(x, span.y), color, coverage);
            }
        }
        Ok(())
    }
}

/// The span of one pixel that is inside a window, so that there is a column after its own.
fn pixel_span(point: Point) -> Span {
    Span::new(point.y, point.x, point.x + 1)
}

#[cfg(feature = "defmt")]
impl<C: ChannelColor, O: Order, P: SamplePattern> defmt::Format for Multisampled<'_, C, O, P> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "Multisampled {}, {} samples", self.window, P::SAMPLES);
    }
}
