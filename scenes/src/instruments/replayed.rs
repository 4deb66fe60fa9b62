//! The panel without a picture: every outline is set up for a frame with a table of its own, and drawn again in each band.
//!
//! Drawing the panel this way takes seven times the memory of a [`Picture`](zrow::draw::Picture), and works in any method of antialiasing, also in
//! the one that a picture does not have: by the centres of pixels, which is no antialiasing.

use core::marker::PhantomData;

use embedded_graphics::{pixelcolor::Rgb565, primitives::Rectangle};
use heapless::Vec;
use zrow::{
    band::{Band, Order},
    coverage::{AnyCoverage, CoverageMethod},
    draw::{AntialiasedPolygon, DrawOn, FillRule, SubOutline},
};

use crate::{
    PrepareError, Prepared, Scene,
    instruments::outlines::{AREA, BACKGROUND, FRAMES, PORTRAIT, Part, WIDTH, digits, draw_outlines, rule, texts},
    paint::shape,
};

/// Edges of an outline with long curves, and of any other.
const CURVED: usize = 272;
const STRAIGHT: usize = 64;
/// Edges of an outline in one row.
const ACTIVE: usize = 32;
/// Outlines of either kind.
const CURVES: usize = 4;
const OTHERS: usize = 24;

/// The method of antialiasing in which all outlines of the panel are drawn, and the names of the scene that shows it.
pub trait Look: core::fmt::Debug {
    /// See [`Scene::NAME`].
    const NAME: &'static str;
    /// See [`Scene::TITLE`].
    const TITLE: &'static str;
    /// The method for an outline that is set up.
    fn method<const EDGES: usize>(
        outline: &(impl SubOutline + ?Sized),
        polygon: &AntialiasedPolygon<EDGES, ACTIVE>,
    ) -> AnyCoverage;
}

/// Each shape in the cheapest method that is exact for it, as in the picture.
#[derive(Debug)]
pub struct Smooth;

impl Look for Smooth {
    const NAME: &'static str = "instruments-replayed";
    const TITLE: &'static str = "instruments, replayed";

    fn method<const EDGES: usize>(
        outline: &(impl SubOutline + ?Sized),
        polygon: &AntialiasedPolygon<EDGES, ACTIVE>,
    ) -> AnyCoverage {
        polygon.exact_method(outline)
    }
}

/// Each shape by the centres of pixels.
#[derive(Debug)]
pub struct Jagged;

impl Look for Jagged {
    const NAME: &'static str = "instruments-aliased";
    const TITLE: &'static str = "instruments, aliased";

    fn method<const EDGES: usize>(
        _outline: &(impl SubOutline + ?Sized),
        _polygon: &AntialiasedPolygon<EDGES, ACTIVE>,
    ) -> AnyCoverage {
        AnyCoverage::CentreSample
    }
}

/// The scene's storage: the outlines of a frame, and the memory of one row.
#[derive(Debug)]
pub struct Replayed<L: Look> {
    curves: Vec<Painted<CURVED>, CURVES>,
    others: Vec<Painted<STRAIGHT>, OTHERS>,
    row_memory: [i32; WIDTH + 1],
    look: PhantomData<L>,
}

/// An outline that is set up, its method and its colour.
#[derive(Debug)]
struct Painted<const EDGES: usize> {
    polygon: AntialiasedPolygon<EDGES, ACTIVE>,
    method: AnyCoverage,
    color: Rgb565,
}

impl<const EDGES: usize> Painted<EDGES> {
    fn new<L: Look>(outline: &(impl SubOutline + ?Sized), color: Rgb565) -> Result<Self, PrepareError> {
        let polygon = AntialiasedPolygon::prepare(outline, FillRule::NonZero)?;
        let method = L::method(outline, &polygon);
        Ok(Self { polygon, method, color })
    }
}

/// A frame of the scene.
#[derive(Debug)]
pub struct Ready<'s> {
    curves: &'s [Painted<CURVED>],
    others: &'s [Painted<STRAIGHT>],
    row_memory: &'s mut [i32],
    frame: u32,
}

impl<L: Look> Default for Replayed<L> {
    fn default() -> Self {
        Self {
            curves: Vec::new(),
            others: Vec::new(),
            row_memory: [0; WIDTH + 1],
            look: PhantomData,
        }
    }
}

impl<L: Look> Scene for Replayed<L> {
    type Color = Rgb565;
    type Prepared<'s>
        = Ready<'s>
    where
        Self: 's;
    const NAME: &'static str = L::NAME;
    const TITLE: &'static str = L::TITLE;
    const AREA: Rectangle = AREA;
    const BACKGROUND: Rgb565 = BACKGROUND;
    const FRAMES: u32 = FRAMES;
    const PORTRAIT: u32 = PORTRAIT;

    fn prepare(&mut self, frame: u32) -> Result<Ready<'_>, PrepareError> {
        let frame = frame % FRAMES;
        self.curves.clear();
        self.others.clear();
        let (curves, others) = (&mut self.curves, &mut self.others);
        draw_outlines(frame, &mut |outline, color, part| {
            let is_full = match part {
                Part::LitArc | Part::Curve => curves.push(Painted::new::<L>(outline, color)?).is_err(),
                Part::Needle | Part::Other => others.push(Painted::new::<L>(outline, color)?).is_err(),
            };
            debug_assert!(!is_full, "there is room for every outline");
            Ok(())
        })?;
        Ok(Ready {
            curves: &self.curves,
            others: &self.others,
            row_memory: &mut self.row_memory,
            frame,
        })
    }
}

impl Prepared for Ready<'_> {
    type Color = Rgb565;

    fn draw<O: Order>(&mut self, band: &mut Band<'_, Rgb565, O>) {
        paint(self.curves, band, self.row_memory);
        paint(self.others, band, self.row_memory);
        let digits = digits(self.frame);
        for text in texts(&digits) {
            let Ok(()) = text.draw_on(band);
        }
        shape(band, &rule());
    }
}

/// Draws outlines in order.
fn paint<O: Order, const EDGES: usize>(
    outlines: &[Painted<EDGES>],
    band: &mut Band<'_, Rgb565, O>,
    row_memory: &mut [i32],
) {
    for Painted { polygon, method, color } in outlines {
        let drawn = polygon.draw(method, *color, band, row_memory);
        debug_assert!(
            drawn.is_ok(),
            "the row memory is as wide as the panel: {}",
            AnyCoverage::cells(WIDTH)
        );
    }
}
