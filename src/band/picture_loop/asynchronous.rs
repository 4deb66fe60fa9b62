//! The picture loop for `async` displays: band n + 1 is drawn while the future of band n is pending.

use core::{
    future::{Future, poll_fn},
    pin::pin,
    task::Poll,
};

use embedded_graphics::{geometry::Dimensions, primitives::Rectangle};

use crate::{
    band::{Band, LoopError, PictureLoop, SceneResult, picture_loop::picture_loop::BandError},
    surface::{BandColor, Order},
};

/// A sink whose transfers are futures, as with embassy and `lcd-async` (whose `show_raw_data` takes these bytes).
///
/// A transfer must start when it is first polled, and not only when it is awaited to its end: what overlaps with
/// drawing is what goes on by itself after the first poll.
pub trait AsyncSink {
    /// What can go wrong on the way to the display.
    type Error;

    /// Sends the bytes of a band, as [`Band::into_bytes`] packs them.
    fn send(&mut self, area: Rectangle, bytes: &[u8]) -> impl Future<Output = Result<(), Self::Error>>;
}

impl<C: BandColor, O: Order> PictureLoop<C, O> {
    /// Draws the whole picture once. A transfer is polled once, so that it starts, then the next band is drawn into the
    /// other buffer, then the transfer is awaited. Dropping the future drops the transfer under way.
    ///
    /// # Errors
    /// As [`draw`](Self::draw).
    pub async fn draw_async<S, F, R>(
        &self,
        buffers: [&mut [C::Word]; 2],
        sink: &mut S,
        mut scene: F,
    ) -> Result<(), LoopError<S::Error, R::Error>>
    where
        S: AsyncSink,
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
            let next_window = windows.next();
            {
                let mut transfer = pin!(sink.send(area, band.into_bytes()));
                let first_poll = poll_fn(|context| Poll::Ready(transfer.as_mut().poll(context))).await;
                let drawing = match next_window {
                    Some(next_window) => self.draw_band(next_window, waiting, &mut scene).map(|_| ()),
                    None => Ok(()),
                };
                match first_poll {
                    Poll::Ready(sent) => sent,
                    Poll::Pending => transfer.await,
                }
                .map_err(LoopError::Sink)?;
                // Returned only now, so that the display has the whole band before this one.
                drawing?;
            }
            let Some(next_window) = next_window else {
                trace!("{}: sent", self);
                return Ok(());
            };
            core::mem::swap(&mut drawn, &mut waiting);
            band = Band::over(next_window, drawn).map_err(BandError::<R::Error>::TooSmall)?;
        }
    }
}
