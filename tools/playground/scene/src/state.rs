//! The state of the playground: everything that decides which picture is drawn.

use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
use heapless::{String, Vec};

/// The most items of a state.
pub const ITEMS: usize = 12;
/// The most points of an item.
pub const POINTS: usize = 16;
/// The most bytes of a text.
pub const LETTERS: usize = 24;

/// A choice among named alternatives: the names stand in the address of the page.
macro_rules! choices {
    ($(#[$doc:meta])+ $choice:ident { $($(#[$entry_doc:meta])+ $entry:ident = $name:literal,)+ }) => {
        $(#[$doc])+
        #[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
        pub enum $choice {
            $($(#[$entry_doc])+ $entry,)+
        }

        impl $choice {
            /// Every alternative.
            pub const ALL: &[Self] = &[$(Self::$entry),+];

            /// The name of the alternative in the address of the page.
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$entry => $name,)+
                }
            }

            /// The alternative of that name.
            pub fn of_name(name: &str) -> Option<Self> {
                Self::ALL.iter().copied().find(|choice| choice.name() == name)
            }
        }
    };
}

choices! {
    /// How much of a pixel an item covers, and by which method that is found out.
    Method {
        /// All or nothing: whether the centre of the pixel is inside.
        None = "none",
        /// Four samples, one in each row and column of 4 x 4.
        Rooks4 = "rooks_4",
        /// Sixteen samples, one in each row and column of 16 x 16.
        Rooks16 = "rooks_16",
        /// Sixteen samples on a grid of 4 x 4.
        Grid4 = "grid_4",
        /// Four rows within the pixel, exact along each of them.
        SubScanlines4 = "sub_scanlines_4",
        /// The exact area of outlines that do not cross themselves.
        SignedArea = "signed_area",
        /// The exact area, where edges cross as well.
        InsideArea = "inside_area",
        /// The cheapest method that is exact for an item, as antialiased styles choose it.
        #[default]
        Exact = "exact",
    }
}

choices! {
    /// How finely positions are rounded before an item is drawn.
    Precision {
        /// Whole pixels.
        Whole = "whole",
        /// 1/16 pixel.
        Sub4 = "sub4",
        /// 1/256 pixel, as finely as the playground keeps positions.
        #[default]
        Sub8 = "sub8",
    }
}

choices! {
    /// The colours of the panel.
    Depth {
        /// 8 bits a channel.
        Rgb888 = "rgb888",
        /// 5, 6 and 5 bits.
        #[default]
        Rgb565 = "rgb565",
        /// 5, 6 and 5 bits, dithered from 8 bits a channel.
        DitheredRgb565 = "dithered_rgb565",
        /// 16 greys, dithered from 256.
        Gray4 = "gray4",
        /// Black and white, dithered from 256 greys.
        Binary = "binary",
    }
}

choices! {
    /// How the teapot behind the items is drawn.
    Pot {
        /// There is none.
        #[default]
        None = "none",
        /// A colour for each face.
        Flat = "flat",
        /// One colour under a light, each face in one brightness.
        FlatLit = "flat_lit",
        /// One colour under a light, brightness between the vertices.
        Gouraud = "gouraud",
        /// The same, with the silhouettes antialiased.
        Silhouettes = "silhouettes",
        /// A texture in perspective, under a light.
        Textured = "textured",
        /// A colour for each face, half of what is behind it seen through it.
        Translucent = "translucent",
        /// A colour for each face, in a fog.
        Foggy = "foggy",
    }
}

choices! {
    /// What an item is.
    Kind {
        /// A polygon by the nonzero rule.
        #[default]
        Polygon = "polygon",
        /// A polygon by the even-odd rule.
        EvenOdd = "even_odd",
        /// A line of some width between two points.
        Line = "line",
        /// A disc: its centre, and a point on its rim.
        Circle = "circle",
        /// A text: where its baseline begins.
        Text = "text",
    }
}

/// A shape or a text.
#[derive(Debug, Clone)]
pub struct Item {
    /// What it is.
    pub kind: Kind,
    /// Its colour, before the panel rounds it.
    pub color: Rgb888,
    /// The width of a line or the size of a text, in 1/256 pixel.
    pub size: i32,
    /// x and y of its points, in 1/256 pixel, with pixel centres at whole pixels.
    pub points: Vec<[i32; 2], POINTS>,
    /// The letters of a text.
    pub text: String<LETTERS>,
}

impl Default for Item {
    fn default() -> Self {
        Self {
            kind: Kind::default(),
            color: Rgb888::WHITE,
            size: 256,
            points: Vec::new(),
            text: String::new(),
        }
    }
}

/// Everything that decides which picture is drawn.
#[derive(Debug, Clone)]
pub struct State {
    /// The teapot behind the items.
    pub pot: Pot,
    /// How far the teapot is turned about its upright axis, in 1/512 of a turn.
    pub turn: u32,
    /// How far it is tilted before that, in 1/512 of a turn.
    pub tilt: u32,
    /// The method of antialiasing.
    pub method: Method,
    /// The precision of positions.
    pub precision: Precision,
    /// The rows of a band; 0 stands for all rows of the picture.
    pub rows: u32,
    /// The colours of the panel.
    pub depth: Depth,
    /// The items, the lowest one first.
    pub items: Vec<Item, ITEMS>,
}

impl State {
    /// All bits are 0.
    pub(crate) const ZERO: Self = Self {
        pot: Pot::None,
        turn: 0,
        tilt: 0,
        method: Method::None,
        precision: Precision::Whole,
        rows: 0,
        depth: Depth::Rgb888,
        items: Vec::new(),
    };

    /// Without a teapot and items.
    pub const EMPTY: Self = Self {
        pot: Pot::None,
        turn: 496,
        tilt: 504,
        method: Method::Exact,
        precision: Precision::Sub8,
        rows: 1,
        depth: Depth::Rgb565,
        items: Vec::new(),
    };
}
