//! A panel that hangs: no wait for its DMA is without an end, the panel is started anew, and a watchdog is fed by whole frames only.
//!
//! `cargo run --release --example watchdog` plays it with a panel that hangs three times, and writes `target/watchdog.png`.

use std::error::Error;

use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Circle, primitives::Rectangle};
use embedded_graphics_simulator::{OutputSettings, SimulatorDisplay};
use zrow::band::{Band, BigEndian, LoopError, OverlappingSink};
use zrow::prelude::*;

/// Looks at the DMA's flag before a transfer is given up; a band of 240 pixels takes some 60 microseconds at 62.5 MHz.
const MOST_LOOKS: u32 = 10_000;

/// The DMA did not end: after the panel was started anew, the next frame is whole.
#[derive(Debug)]
struct Timeout;

/// A panel behind a DMA channel; here it draws on a simulated display, and hangs in some of its transfers.
struct Panel {
    display: SimulatorDisplay<Rgb565>,
    transfers: u32,
    hangs_in: &'static [u32],
    watchdog: Watchdog,
}

/// That of the chip resets it where too much time passes after the last `feed`: here, where too many looks do.
struct Watchdog {
    looks_left: u32,
}

impl Watchdog {
    fn feed(&mut self) {
        self.looks_left = 4 * MOST_LOOKS
    }

    fn pass(&mut self) {
        self.looks_left = self.looks_left.checked_sub(1).expect("the chip is reset")
    }
}

impl<'a> OverlappingSink<Rgb565, BigEndian, &'a mut [u16]> for Panel {
    type Transfer = (Rectangle, &'a mut [u16]);
    type Error = Timeout;

    fn start(
        &mut self,
        area: Rectangle,
        band: &'a mut [u16],
    ) -> Result<Self::Transfer, (&'a mut [u16], LoopError<Timeout>)> {
        self.transfers += 1;
        Ok((area, band))
    }

    fn finish(&mut self, (area, words): Self::Transfer) -> (&'a mut [u16], Result<(), Timeout>) {
        // A loop with an end, whatever the hardware does. On a chip: abort the channel before the buffer is given back.
        let hangs = self.hangs_in.contains(&self.transfers);
        let is_done = (0..MOST_LOOKS).any(|_| {
            self.watchdog.pass();
            !hangs
        });
        let shown = Band::<Rgb565, BigEndian>::new(area, words)
            .ok()
            .filter(|_| is_done)
            .map(|band| self.display.fill_contiguous(&area, band.colors()));
        (words, shown.map(|_| ()).ok_or(Timeout))
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let display = SimulatorDisplay::new(Size::new(240, 240));
    let mut panel = Panel {
        display,
        transfers: 0,
        hangs_in: &[7, 300, 301],
        watchdog: Watchdog {
            looks_left: 4 * MOST_LOOKS,
        },
    };
    let (mut one, mut other) = ([0; 240], [0; 240]);
    let mut buffers = [&mut one[..], &mut other[..]];
    let (mut whole, mut lost) = (0, 0);
    for frame in 0..8 {
        let disc = Circle::with_center(Point::new(120, 120), 60 + 16 * frame)
            .into_styled(PrimitiveStyle::with_fill(Rgb565::CSS_GOLD));
        let area = PictureLoop::new(panel.display.bounding_box(), Rgb565::CSS_NAVY).in_order::<BigEndian>();
        let result;
        (buffers, result) = area.draw_overlapping(buffers, &mut panel, |band| disc.draw_on(band));
        match result {
            Ok(()) => {
                whole += 1;
                panel.watchdog.feed()
            }
            // Where the panel hangs on and on, nobody feeds the watchdog. On a chip: reset the panel's pin, and `init` it again.
            Err(error) => {
                lost += 1;
                eprintln!("frame {frame}: {error:?}")
            }
        }
    }
    assert_eq!((whole, lost), (5, 3));
    let image = panel.display.to_rgb_output_image(&OutputSettings::default());
    Ok(image.save_png("target/watchdog.png")?)
}
