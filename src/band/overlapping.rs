//! Overlapping: band n + 1 is drawn while band n is on its way.

use core::marker::PhantomData;

use embedded_graphics::primitives::Rectangle;

use crate::{
    band::{Band, LoopError, PictureLoop, Sink},
    target::{BandColor, Order},
};

/// A sink that takes a buffer away and gives it back later, as DMA does.
pub trait OverlappingSink<B> {
    /// A transfer under way; it owns the buffer.
    type Transfer;
    /// What can go wrong on the way to the display.
    type Error;

    /// Starts to send the words of a band and returns at once.
    ///
    /// # Errors
    /// What kept the transfer from starting, and the buffer.
    fn start(&mut self, area: Rectangle, buffer: B) -> Result<Self::Transfer, (B, LoopError<Self::Error>)>;

    /// Waits for the end of a transfer and gives its buffer back, whatever came of it.
    fn finish(&mut self, transfer: Self::Transfer) -> (B, Result<(), Self::Error>);
}

impl<C: BandColor> PictureLoop<C> {
    /// Draws the whole picture once, each band while the one before it is sent.
    ///
    /// Both buffers come back in every case, so that the next picture can be drawn.
    ///
    /// # Errors
    /// As [`draw`](Self::draw). No transfer is under way when it returns.
    pub fn draw_overlapping<O, B, S, F>(
        &self,
        buffers: [B; 2],
        sink: &mut S,
        mut scene: F,
    ) -> ([B; 2], Result<(), LoopError<S::Error>>)
    where
        O: Order,
        B: AsMut<[C::Word]>,
        S: OverlappingSink<B>,
        F: FnMut(&mut Band<'_, C, O>),
    {
        let [mut drawn, mut waiting] = buffers;
        if let Err(error) = self.check(drawn.as_mut()).and_then(|()| self.check(waiting.as_mut())) {
            return ([drawn, waiting], Err(error.into()));
        }
        let mut bands = self.bands();
        let Some(mut area) = bands.next() else {
            return ([drawn, waiting], Ok(()));
        };
        if let Err(error) = self.draw_band(area, drawn.as_mut(), &mut scene) {
            return ([drawn, waiting], Err(error.into()));
        }
        loop {
            let transfer = match sink.start(area, drawn) {
                Ok(transfer) => transfer,
                Err((buffer, error)) => return ([buffer, waiting], Err(error)),
            };
            let next = bands.next();
            let drawing = match next {
                Some(next) => self.draw_band(next, waiting.as_mut(), &mut scene).map(|_| ()),
                None => Ok(()),
            };
            let (buffer, sent) = sink.finish(transfer);
            let result = sent.map_err(LoopError::Sink).and(drawing.map_err(LoopError::from));
            match (result, next) {
                (Ok(()), Some(next)) => (area, drawn, waiting) = (next, waiting, buffer),
                (result, _) => return ([buffer, waiting], result),
            }
        }
    }
}

/// Any [`Sink`] as an [`OverlappingSink`]: sends at the start, and waits for nothing at the end.
#[derive(Debug)]
pub struct Blocking<S, C, O> {
    sink: S,
    words: PhantomData<(C, O)>,
}

impl<S: Sink<C, O>, C: BandColor, O: Order> Blocking<S, C, O> {
    /// Wraps a sink.
    pub const fn new(sink: S) -> Self {
        Self {
            sink,
            words: PhantomData,
        }
    }
}

impl<B, S, C, O> OverlappingSink<B> for Blocking<S, C, O>
where
    B: AsMut<[C::Word]>,
    S: Sink<C, O>,
    C: BandColor,
    O: Order,
{
    type Transfer = B;
    type Error = S::Error;

    fn start(&mut self, area: Rectangle, mut buffer: B) -> Result<B, (B, LoopError<S::Error>)> {
        let sent = match Band::new(area, buffer.as_mut()) {
            Ok(band) => self.sink.send(band).map_err(LoopError::Sink),
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
