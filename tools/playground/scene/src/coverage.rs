//! The methods of antialiasing by their names: each is linked once, for all colours.

use zrow::{
    band::Span,
    coverage::{CentreSample, CoverageMethod, Grid, InsideArea, Rooks, SignedArea, SubScanlines},
    draw::AntialiasedPolygon,
    geometry::{TooSmall, Window},
};

use crate::{
    playground::{ACTIVE, EDGES, WIDTH},
    state::Method,
};

/// Receives spans of equal coverage.
pub type Emit<'e> = &'e mut dyn FnMut(Span, u8) -> Result<(), TooSmall>;
/// An item, prepared.
pub type Polygon = AntialiasedPolygon<EDGES, ACTIVE>;

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
        Method::InsideArea => cover_by(&InsideArea, polygon, window, emit),
    }
}

#[inline(never)]
fn cover_by<T: CoverageMethod>(method: &T, polygon: &Polygon, window: &Window, emit: Emit<'_>) -> Result<(), TooSmall> {
    // No method takes more than a cell beyond the columns.
    let mut row_memory = [T::Cell::default(); WIDTH + 2];
    polygon.cover(method, window, &mut row_memory, emit)
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
        Method::InsideArea => of(&InsideArea),
    };
    bytes(width)
}
