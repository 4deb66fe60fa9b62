//! How to use zrow, by task. Nothing is defined here.
//!
//! - [Which way to draw](#which-way-to-draw), and [how large a picture's tables are](#how-large-are-a-pictures-tables)
//! - [How tall should a band be](#how-tall-should-a-band-be)
//! - [Displays](#displays): the lines for each driver
//! - [What effects cost](#what-effects-cost) in scenes
//! - [Algorithms](crate::algorithms): which one for what, with their costs and sources
//!
// The first definition of a link counts: within this page these replace the files that the pages name.
//! [how tall a band should be]: #how-tall-should-a-band-be
#![doc = concat!(
    "[plot of bands]: data:image/svg+xml;base64,",
    include_str!("../docs/embedded/band-height.svg.txt"),
    "\n[plot of effects]: data:image/svg+xml;base64,",
    include_str!("../docs/embedded/effects.svg.txt"),
    "\n"
)]
//!
#![doc = include_str!("../docs/which-way.md")]
//!
#![doc = include_str!("../docs/band-height.md")]
//!
#![doc = include_str!("../docs/displays.md")]
//!
#![doc = include_str!("../docs/effects.md")]
