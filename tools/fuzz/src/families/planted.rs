//! Defects that are there on purpose: the loop finds each of them, or it does not work. No run takes them unless it is told
//! to.

use std::time::{Duration, Instant};

use anyhow::ensure;
use arbitrary::Arbitrary;
use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{Dimensions, Point},
    pixelcolor::Rgb565,
};

use crate::{
    picture::{Sheet, background},
    target::{Case, Verdict},
    values::{Count, Hue, Stage},
};

/// Panics for one number of 64.
#[derive(Debug, Arbitrary)]
pub struct Panic {
    number: Count,
    rest: u8,
}

impl Case for Panic {
    fn check(&self) -> Verdict {
        if self.rest % 64 == 63 {
            panic!("planted for {:?}", self.number);
        }
        Ok(())
    }
}

/// Draws a pixel beyond the right side of the display, where that is a display of nine columns.
#[derive(Debug, Arbitrary)]
pub struct Outside {
    stage: Stage,
    hue: Hue,
}

impl Case for Outside {
    fn check(&self) -> Verdict {
        let mut sheet = Sheet::<Rgb565>::new(self.stage.window, background());
        let beyond = u32::from(sheet.bounding_box().size.width == 9);
        let point = Point::new(
            self.stage.window.right.saturating_add_unsigned(beyond) - 1,
            self.stage.window.top,
        );
        ensure!(
            sheet.draw_iter([Pixel(point, self.hue.color())]).is_ok(),
            "an error that nobody told"
        );
        sheet.was_treated_well()
    }
}

/// Takes very long for one number of 64.
#[derive(Debug, Arbitrary)]
pub struct Slow {
    rest: u8,
}

impl Case for Slow {
    fn check(&self) -> Verdict {
        if self.rest % 64 == 63 {
            let start = Instant::now();
            // The limit is one of the processor's time.
            while start.elapsed() < Duration::from_secs(3_600) {
                std::hint::spin_loop();
            }
        }
        Ok(())
    }
}

/// Overflows the stack for one number of 64.
#[derive(Debug, Arbitrary)]
pub struct Deep {
    rest: u8,
}

impl Case for Deep {
    fn check(&self) -> Verdict {
        ensure!(self.rest % 64 != 63 || depth(u64::MAX) > 0, "no depth");
        Ok(())
    }
}

/// Calls itself without an end that anyone sees.
fn depth(calls: u64) -> u64 {
    let here = std::hint::black_box([calls; 64]);
    if calls == 0 {
        return 0;
    }
    depth(calls - 1).max(here[1])
}
