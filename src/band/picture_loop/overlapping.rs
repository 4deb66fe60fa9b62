//! Overlapping: band n + 1 is drawn while band n is on its way.

use embedded_graphics::primitives::Rectangle;

use crate::{
    band::{Band, LoopError, PictureLoop, SceneResult, Sink},
    surface::{BandColor, Order},
};

/// A sink that takes a buffer away and gives it back later, as DMA does.
///
/// `C` and `O` say what it sends: a loop over words of another colour or byte order does not compile.
/// [`Band::into_bytes`] turns a buffer into bytes for the display. Every [`Sink`] is one that sends a band before it returns.
///
/// ```
/// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
/// use zrow::band::{BigEndian, LoopError, OverlappingSink, PictureLoop};
///
/// # #[derive(Debug)] pub struct SpiError;
/// # pub struct Bus(Vec<u8>);
/// # impl Bus {
/// #     fn set_window(&mut self, _: Rectangle) -> Result<(), SpiError> { Ok(()) }
/// #     fn start_dma(&mut self, words: &[u16]) { self.0.extend_from_slice(bytemuck::cast_slice(words)) }
/// #     fn wait_for_dma(&mut self) -> Result<(), SpiError> { Ok(()) }
/// # }
/// /// A panel on an SPI bus with DMA.
/// struct Panel { bus: Bus }
///
/// impl<'a> OverlappingSink<Rgb565, BigEndian, &'a mut [u16]> for Panel {
///     type Transfer = &'a mut [u16];
///     type Error = SpiError;
///
///     fn start(
///         &mut self,
///         area: Rectangle,
///         buffer: &'a mut [u16],
///     ) -> Result<Self::Transfer, (&'a mut [u16], LoopError<SpiError>)> {
///         if let Err(error) = self.bus.set_window(area) {
///             return Err((buffer, LoopError::Sink(error)));
///         }
///         self.bus.start_dma(&buffer[..(area.size.width * area.size.height) as usize]);
///         Ok(buffer)
///     }
///
///     fn finish(&mut self, transfer: Self::Transfer) -> (&'a mut [u16], Result<(), SpiError>) {
///         let sent = self.bus.wait_for_dma();
///         (transfer, sent)
///     }
/// }
///
/// let mut panel = Panel { bus: Bus(Vec::new()) };
/// let (mut one, mut other) = ([0; 8 * 2], [0; 8 * 2]);
/// let area = Rectangle::new(Point::zero(), Size::new(8, 5));
/// let (_, result) = PictureLoop::new(area, Rgb565::BLUE)
///     .rows(2)
///     .in_order::<BigEndian>()
///     .draw_overlapping([&mut one[..], &mut other[..]], &mut panel, |band| {
///         // Draw the scene.
///     });
/// assert!(result.is_ok());
/// assert_eq!(panel.bus.0, [0x00, 0x1f].repeat(8 * 5));
/// ```
pub trait OverlappingSink<C: BandColor, O: Order, B: AsMut<[C::Word]>> {
    /// A transfer under way; it owns the buffer.
    type Transfer;
    /// What can go wrong on the way to the display.
    type Error;

    /// Starts to send the first `width * height` words of a buffer and returns at once.
    ///
    /// # Errors
    /// What kept the transfer from starting, and the buffer.
    fn start(&mut self, area: Rectangle, buffer: B) -> Result<Self::Transfer, (B, LoopError<Self::Error>)>;

    /// Waits for the end of a transfer and gives its buffer back, whatever came of it.
    fn finish(&mut self, transfer: Self::Transfer) -> (B, Result<(), Self::Error>);
}

/// Both buffers, and how the picture loop ended: `E` is the error of the sink, `X` that of the scene.
type Overlapped<B, E, X> = ([B; 2], Result<(), LoopError<E, X>>);

impl<C: BandColor, O: Order> PictureLoop<C, O> {
    /// Draws the whole picture once, each band while the one before it is sent.
    ///
    /// Both buffers come back in every case, so that the next picture can be drawn.
    ///
    /// # Errors
    /// As [`draw`](Self::draw). No transfer is under way when it returns.
    pub fn draw_overlapping<B, S, F, R>(
        &self,
        buffers: [B; 2],
        sink: &mut S,
        mut scene: F,
    ) -> Overlapped<B, S::Error, R::Error>
    where
        B: AsMut<[C::Word]>,
        S: OverlappingSink<C, O, B>,
        F: FnMut(&mut Band<'_, C, O>) -> R,
        R: SceneResult,
    {
        let [mut drawn, mut waiting] = buffers;
        if let Err(error) = self.check(drawn.as_mut()).and_then(|()| self.check(waiting.as_mut())) {
            return ([drawn, waiting], Err(error.into()));
        }
        let mut windows = self.windows();
        let Some(mut window) = windows.next() else {
            return ([drawn, waiting], Ok(()));
        };
        // Drawn bands may have been rotated: what is sent is the window of the band, not that of the loop.
        window = match self.draw_band(window, drawn.as_mut(), &mut scene) {
            Ok(band) => band.window,
            Err(error) => return ([drawn, waiting], Err(error.into())),
        };
        loop {
            let transfer = match sink.start(window.to_rectangle(), drawn) {
                Ok(transfer) => transfer,
                Err((buffer, error)) => {
                    let error = match error {
                        LoopError::TooSmall(error) => error.into(),
                        LoopError::Sink(error) => LoopError::Sink(error),
                        LoopError::Scene(never) => match never {},
                    };
                    return ([buffer, waiting], Err(error));
                }
            };
            let drawing = match windows.next() {
                Some(next) => self
                    .draw_band(next, waiting.as_mut(), &mut scene)
                    .map(|band| Some(band.window)),
                None => Ok(None),
            };
            let (buffer, sent) = sink.finish(transfer);
            match sent.map_err(LoopError::Sink).and(drawing.map_err(LoopError::from)) {
                Ok(Some(next)) => (window, drawn, waiting) = (next, waiting, buffer),
                Ok(None) => {
                    trace!("{}: sent", self);
                    return ([buffer, waiting], Ok(()));
                }
                Err(error) => return ([buffer, waiting], Err(error)),
            }
        }
    }
}

/// Any [`Sink`] is an [`OverlappingSink`], too: it sends at the start, and waits for nothing at the end.
impl<C, O, B, S> OverlappingSink<C, O, B> for S
where
    C: BandColor,
    O: Order,
    B: AsMut<[C::Word]>,
    S: Sink<C, O>,
{
    type Transfer = B;
    type Error = S::Error;

    fn start(&mut self, area: Rectangle, mut buffer: B) -> Result<B, (B, LoopError<S::Error>)> {
        let sent = match Band::new(area, buffer.as_mut()) {
            Ok(band) => self.send(band).map_err(LoopError::Sink),
            Err(error) => Err(error.into()),
        };
        match sent {
            Ok(()) => Ok(buffer),
            Err(error) => Err((buffer, error)),
        }
    }

    fn finish(&mut self, transfer: B) -> (B, Result<(), S::Error>) {
        (transfer, Ok(()))
    }
}
