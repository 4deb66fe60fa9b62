//! The methods of antialiasing by their names: each is linked once, for all colours.

use embedded_graphics::pixelcolor::Rgb565;
use zrow::{
    band::{Band, Span},
    coverage::{AnyCoverage, CentreSample, CoverageMethod, Grid, InsideArea, Rooks, SignedArea, SubScanlines},
    draw::{AntialiasedPolygon, SubOutline},
    geometry::{DrawError, InputError, TooSmall, Window},
};

use crate::{
    playground::{ACTIVE, EDGES, WIDTH},
    state::Method,
};

/// Receives spans of equal coverage.
pub type Emit<'e> = &'e mut dyn FnMut(Span, u8) -> Result<(), TooSmall>;
/// An item, prepared.
pub type Polygon = AntialiasedPolygon<EDGES, ACTIVE>;

/// A polygon, and the method that is taken for it.
#[derive(Debug)]
pub struct ReadyItem {
    /// Its edges.
    pub polygon: Polygon,
    /// That of the state, or the one that is chosen for the polygon.
    pub method: Method,
}

/// The method that is taken for a polygon, where one is asked for: its own choice stands for [`Method::Exact`].
pub fn choose(method: Method, polygon: &Polygon, outline: &impl SubOutline) -> Method {
    if method != Method::Exact {
        return method;
    }
    match polygon.exact_method(outline) {
        AnyCoverage::CentreSample => Method::None,
        AnyCoverage::SignedArea => Method::SignedArea,
        AnyCoverage::InsideArea => Method::InsideArea,
    }
}

/// Hands over the coverage of a polygon in a window by a method.
///
/// # Errors
/// The first one that `emit` returns.
pub fn cover(polygon: &Polygon, method: Method, window: &Window, emit: Emit<'_>) -> Result<(), TooSmall> {
    match method {
        Method::None => cover_by(&CentreSample, polygon, window, emit),
        Method::Rooks4 => cover_by(&Rooks::<4>, polygon, window, emit),
        Method::Rooks16 => cover_by(&Rooks::<16>, polygon, window, emit),
        Method::Grid4 => cover_by(&Grid::<4>::default(), polygon, window, emit),
        Method::SubScanlines4 => cover_by(&SubScanlines::<4>, polygon, window, emit),
        Method::SignedArea => cover_by(&SignedArea, polygon, window, emit),
        Method::InsideArea | Method::Exact => cover_by(&InsideArea, polygon, window, emit),
    }
}

#[inline(never)]
fn cover_by<T: CoverageMethod>(method: &T, polygon: &Polygon, window: &Window, emit: Emit<'_>) -> Result<(), TooSmall> {
    // No method takes more than a cell beyond the columns.
    let mut row_memory = [T::Cell::default(); WIDTH + 2];
    polygon.cover(method, window, &mut row_memory, emit)
}

/// Blends a polygon over a band by a method, without a function that is called for each span.
///
/// # Errors
/// None, as there is memory for a row of the panel.
pub fn draw(polygon: &Polygon, method: Method, color: Rgb565, band: &mut Band<'_, Rgb565>) -> Result<(), InputError> {
    match method {
        Method::None => draw_by(&CentreSample, polygon, color, band),
        Method::Rooks4 => draw_by(&Rooks::<4>, polygon, color, band),
        Method::Rooks16 => draw_by(&Rooks::<16>, polygon, color, band),
        Method::Grid4 => draw_by(&Grid::<4>::default(), polygon, color, band),
        Method::SubScanlines4 => draw_by(&SubScanlines::<4>, polygon, color, band),
        Method::SignedArea => draw_by(&SignedArea, polygon, color, band),
        Method::InsideArea | Method::Exact => draw_by(&InsideArea, polygon, color, band),
    }
}

fn draw_by<T: CoverageMethod>(
    method: &T,
    polygon: &Polygon,
    color: Rgb565,
    band: &mut Band<'_, Rgb565>,
) -> Result<(), InputError> {
    let mut row_memory = [T::Cell::default(); WIDTH + 2];
    match polygon.draw(method, color, band, &mut row_memory) {
        Ok(()) | Err(DrawError::Target(_) | DrawError::OutOfDomain { .. }) => Ok(()),
        Err(DrawError::TooSmall(too_small)) => Err(InputError::TooSmall(too_small)),
    }
}

/// The bytes that a method takes for a row of pixels, beside the row itself.
pub fn bytes_per_row(method: Method, width: usize) -> usize {
    const fn of<T: CoverageMethod>(_: &T) -> fn(usize) -> usize {
        |width| T::cells(width) * size_of::<T::Cell>()
    }
    let bytes = match method {
        Method::None => of(&CentreSample),
        Method::Rooks4 => of(&Rooks::<4>),
        Method::Rooks16 => of(&Rooks::<16>),
        Method::Grid4 => of(&Grid::<4>::default()),
        Method::SubScanlines4 => of(&SubScanlines::<4>),
        Method::SignedArea => of(&SignedArea),
        Method::InsideArea | Method::Exact => of(&InsideArea),
    };
    bytes(width)
}
