//! A double-buffered `async` loop, as with embassy: while one band is on its way by DMA, the next one is drawn.
//!
//! `cargo run --release --example async_loop` plays it on a simulated display and writes `target/async_loop.png`.

use std::{error::Error, future::poll_fn, pin::pin, task::Context, task::Poll, task::Waker};

use embedded_graphics::image::{Image, ImageRawBE};
use embedded_graphics::primitives::{Circle, Rectangle};
use embedded_graphics::{pixelcolor::Rgb565, prelude::*};
use embedded_graphics_simulator::{OutputSettings, SimulatorDisplay};
use zrow::{band::BigEndian, band::LoopError, prelude::*};

const AREA: Rectangle = Rectangle::new(Point::zero(), Size::new(240, 135));

/// Shows frames. With the crate `lcd-async`, `display.show_raw_data(x, y, width, height, bytes).await` sends a band.
async fn show<E>(
    mut send: impl AsyncFnMut(Rectangle, &[u8]) -> Result<(), E>,
    frames: i32,
) -> Result<(), LoopError<E>> {
    // Two bands of eight rows. The order of their bytes is the display's, so that they are sent as they are.
    let (mut one, mut other) = ([0; 8 * 240], [0; 8 * 240]);
    let picture = PictureLoop::new(AREA, Rgb565::CSS_MIDNIGHT_BLUE).rows(8);
    let picture = picture.in_order::<BigEndian>();
    for frame in 0..frames {
        let bounce = |n: i32, range: i32| range - (n % (2 * range) - range).abs();
        let scene = |band: &mut Band<'_, Rgb565, BigEndian>| {
            // A ball, and before it the places where it was.
            for age in (0..6).rev() {
                let time = frame - age;
                let ball = Circle::new(Point::new(bounce(5 * time, 200), bounce(3 * time, 95)), 40);
                let color = Rgb565::new(31 - 5 * age as u8, 50 - 8 * age as u8, 12);
                let Ok(()) = ball.into_styled(PrimitiveStyle::with_fill(color)).draw_on(band);
            }
        };
        picture.draw_async([&mut one, &mut other], &mut send, scene).await?;
    }
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut display = SimulatorDisplay::<Rgb565>::new(AREA.size);
    {
        let send = async |area: Rectangle, bytes: &[u8]| {
            // Returns to the executor once, as a driver does that waits for the end of a transfer.
            let mut polls = [Poll::Pending, Poll::Ready(())].into_iter();
            poll_fn(|_| polls.next().unwrap_or(Poll::Pending)).await;
            let band = ImageRawBE::<Rgb565>::new(bytes, area.size.width);
            Image::new(&band, area.top_left).draw(&mut display)
        };
        // Embassy's executor does this on a microcontroller.
        let mut show = pin!(show(send, 50));
        let mut context = Context::from_waker(Waker::noop());
        while show.as_mut().poll(&mut context)?.is_pending() {}
    }
    let image = display.to_rgb_output_image(&OutputSettings::default());
    Ok(image.save_png("target/async_loop.png")?)
}
