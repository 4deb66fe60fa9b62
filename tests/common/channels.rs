//! Colour types as the levels of their channels.

use std::fmt::Debug;

use embedded_graphics::pixelcolor::{
    Bgr555, Bgr565, Bgr666, Bgr888, BinaryColor, Gray2, Gray4, Gray8, GrayColor, Rgb555, Rgb565, Rgb666, Rgb888,
    RgbColor,
};
use zrow::shade::ChannelColor;

/// A colour type as its channels.
pub trait Channels: ChannelColor + Debug {
    const MAX: [u32; 3];
    fn from_channels(channels: [u32; 3]) -> Self;
    fn channels(self) -> [u32; 3];
}

macro_rules! rgb {
    ($($color:ident),+) => {$(
        impl Channels for $color {
            const MAX: [u32; 3] = [Self::MAX_R as u32, Self::MAX_G as u32, Self::MAX_B as u32];
            fn from_channels([red, green, blue]: [u32; 3]) -> Self {
                Self::new(red as u8, green as u8, blue as u8)
            }
            fn channels(self) -> [u32; 3] {
                [self.r(), self.g(), self.b()].map(u32::from)
            }
        }
    )+};
}
rgb!(Rgb555, Bgr555, Rgb565, Bgr565, Rgb666, Bgr666, Rgb888, Bgr888);

macro_rules! gray {
    ($($color:ident: $max:literal),+) => {$(
        impl Channels for $color {
            const MAX: [u32; 3] = [$max, 0, 0];
            fn from_channels([luma, _, _]: [u32; 3]) -> Self {
                Self::new(luma as u8)
            }
            fn channels(self) -> [u32; 3] {
                [u32::from(self.luma()), 0, 0]
            }
        }
    )+};
}
gray!(Gray2: 3, Gray4: 15, Gray8: 255);

impl Channels for BinaryColor {
    const MAX: [u32; 3] = [1, 0, 0];
    fn from_channels([level, _, _]: [u32; 3]) -> Self {
        Self::from(level > 0)
    }
    fn channels(self) -> [u32; 3] {
        [self.is_on().into(), 0, 0]
    }
}
