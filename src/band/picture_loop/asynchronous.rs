//! The picture loop for `async` displays: band n + 1 is drawn while the future of band n is pending.

use core::{
    future::{Future, poll_fn},
    pin::{Pin, pin},
    task::Poll,
};

use embedded_graphics::{geometry::Dimensions, primitives::Rectangle};

use crate::{
    band::{Band, LoopError, PictureLoop, SceneResult, picture_loop::picture_loop::BandError},
    surface::{BandColor, Order},
};

impl<C: BandColor, O: Order> PictureLoop<C, O> {
    /// Draws the whole picture once, on a display whose transfers are futures, as with embassy. `send` gets the area of a band
    /// and its bytes, as [`Band::into_bytes`] packs them; `lcd-async`'s `show_raw_data` takes these.
    ///
    /// A transfer is polled once, so that it starts, then the next band is drawn into the other buffer, then the transfer is
    /// awaited: what overlaps with drawing is what goes on by itself after the first poll. Dropping the future drops the
    /// transfer under way. A program that shows frame after frame lends its closure to each of them: `&mut send`.
    ///
    /// # Errors
    /// As [`draw`](Self::draw).
    ///
    /// ```
    /// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
    /// use zrow::band::{BigEndian, LoopError, PictureLoop};
    ///
    /// async fn show(bus: &mut Vec<u8>) -> Result<(), LoopError<()>> {
    ///     let area = Rectangle::new(Point::zero(), Size::new(240, 320));
    ///     let picture = PictureLoop::new(area, Rgb565::BLACK).in_order::<BigEndian>();
    ///     let send = async |_: Rectangle, bytes: &[u8]| {
    ///         bus.extend_from_slice(bytes); // Await the driver here.
    ///         Ok(())
    ///     };
    ///     picture.draw_async([&mut [0; 240], &mut [0; 240]], send, |_| {}).await
    /// }
    /// ```
    pub async fn draw_async<E, F, R>(
        &self,
        buffers: [&mut [C::Word]; 2],
        mut send: impl AsyncFnMut(Rectangle, &[u8]) -> Result<(), E>,
        mut scene: F,
    ) -> Result<(), LoopError<E, R::Error>>
    where
        F: FnMut(&mut Band<'_, C, O>) -> R,
        R: SceneResult,
    {
        let [mut drawn, mut waiting] = buffers;
        self.check(drawn)?;
        self.check(waiting)?;
        let mut windows = self.windows();
        let mut band = match windows.next() {
            Some(window) => self.draw_band(window, drawn, &mut scene)?,
            None => return Ok(()),
        };
        loop {
            let area = band.bounding_box();
            let next_window = while_sent(pin!(send(area, band.into_bytes())), || match windows.next() {
                Some(next) => self.draw_band(next, waiting, &mut scene).map(|band| Some(band.window)),
                None => Ok(None),
            })
            .await?;
            let Some(next_window) = next_window else {
                trace!("{}: sent", self);
                return Ok(());
            };
            core::mem::swap(&mut drawn, &mut waiting);
            band = Band::over(next_window, drawn).map_err(BandError::<R::Error>::TooSmall)?;
        }
    }
}

/// Polls a transfer, so that it starts, draws what comes next, and waits for the end of the transfer. An error of drawing is
/// returned only then, so that the display has all that came before it. Nothing is drawn after a transfer that failed at once.
// No `async fn`: its future would have a panic of its own, for being polled after its end, which the compiler does not leave out.
pub(super) fn while_sent<T, E, X>(
    mut transfer: Pin<&mut impl Future<Output = Result<(), E>>>,
    draw_next: impl FnOnce() -> Result<T, BandError<X>>,
) -> impl Future<Output = Result<T, LoopError<E, X>>> {
    let (mut draw_next, mut next) = (Some(draw_next), None);
    poll_fn(move |context| {
        let is_sent = match transfer.as_mut().poll(context) {
            Poll::Ready(Ok(())) => true,
            Poll::Ready(Err(error)) => return Poll::Ready(Err(LoopError::Sink(error))),
            Poll::Pending => false,
        };
        if let Some(draw_next) = draw_next.take() {
            next = Some(draw_next());
        }
        match next.take_if(|_| is_sent) {
            Some(next) => Poll::Ready(next.map_err(LoopError::from)),
            None => Poll::Pending,
        }
    })
}
