//! One algorithm of a family, named by a feature, with inputs that the compiler cannot know.
#![no_std]
#![no_main]

use core::hint::black_box;

use cortex_m_rt::entry;
use zrow_measure::{report, stack};

#[entry]
fn main() -> ! {
    black_box(sibling::work());
    stack::report(0);
    report::exit(true)
}

/// Without a feature: nothing.
#[cfg(not(any(feature = "cohen_sutherland", feature = "liang_barsky")))]
mod sibling {
    pub fn work() {}
}

/// Segment clippers, at 1/16 pixel.
#[cfg(any(feature = "cohen_sutherland", feature = "liang_barsky"))]
mod sibling {
    use core::hint::black_box;

    #[cfg(feature = "cohen_sutherland")]
    use zrow::clip::cohen_sutherland as sibling;
    #[cfg(feature = "liang_barsky")]
    use zrow::clip::liang_barsky as sibling;
    use zrow::geometry::{Sub4, SubPoint, SubWindow};

    pub fn work() -> Option<(SubPoint<Sub4>, SubPoint<Sub4>)> {
        let (from, to, window) = black_box((SubPoint::default(), SubPoint::default(), None::<SubWindow<Sub4>>));
        sibling::clip(from, to, &window?)
    }
}
