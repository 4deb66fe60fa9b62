//! What most programs import: `use zrow::prelude::*;`
//!
//! The traits whose methods draw (`draw_on`, `send`; `pixels`, `fill_area` and `stroke_area` of styled shapes, by traits
//! without a name here), the band with its picture loop, and zrow's own styles. It goes beside embedded-graphics'
//! prelude; none of its names is in both.
//!
//! ```
//! use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Rgb565, prelude::*, primitives::Circle};
//! use zrow::prelude::*;
//!
//! let mut display = MockDisplay::<Rgb565>::new();
//! let disc = Circle::new(Point::zero(), 9).into_styled(PrimitiveStyle::with_fill(Rgb565::RED));
//! let mut row = [0; 64];
//! PictureLoop::new(display.bounding_box(), Rgb565::BLACK)
//!     .draw(&mut row, &mut DisplaySink(&mut display), |band| disc.draw_on(band))?;
//! assert_eq!(display.get_pixel(Point::new(4, 4)), Some(Rgb565::RED));
//! # Ok::<(), Box<dyn core::error::Error>>(())
//! ```

pub use crate::{
    band::{Band, BandColor, BytesSink, DisplaySink, Generic, OverlappingSink, PictureLoop, Sink, Target},
    coverage::CoverageMethod,
    draw::{
        BlendOn, DrawAntialiased, DrawOn, PrimitiveStyle, StrokeStyle, SubOutline,
        eg::{StyledAreas as _, StyledPixels as _},
    },
    geometry::{SubPixel, Vertex},
    shade::{BlendTarget, Paint, SampleTarget},
};
