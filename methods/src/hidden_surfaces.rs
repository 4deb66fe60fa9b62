//! The methods of visibility that are counted side by side, and up to what they are.

/// Calls another macro with `[name] [method]` of each method but the depth row. The method is an expression that makes one, with
/// room for `FACES` faces, of which `ACTIVE` cross a row, on `PIXELS` pixels in `TILES` tiles that `TILE_FACES` faces meet, and in
/// `CELLS` cells that have `ENTRIES` of them: constants of where the macro is called.
#[macro_export]
macro_rules! hidden_surfaces {
    ($visit:ident) => {
        $visit! {
            [intervals] [zrow::visible::SpanScanLine::<{ ACTIVE }>::new()]
            [buffer] [zrow::visible::DepthBuffer::<u16, { PIXELS }>::new()]
            [bins] [zrow::visible::TileBins::<u16, { TILES }, { TILE_FACES }>::new()]
            [sort] [zrow::visible::DepthSort::<{ FACES }, 200>::new()]
            [quarters] [zrow::visible::Warnock::<{ FACES }>::new()]
            [rays] [zrow::visible::RayCasting::<{ FACES }>::new()]
            [grid] [zrow::visible::GridRayCasting::<{ FACES }, { CELLS }, { ENTRIES }>::new()]
            [one] [zrow::visible::OneDepth::new(zrow::scan::Polygons::winding_number)]
        }
    };
}

/// A method of visibility: the name of its counts, what it is called in a table, and up to what it is counted.
#[derive(Debug, Clone, Copy)]
pub struct HiddenSurfaces {
    pub name: &'static str,
    pub title: &'static str,
    /// The most faces in one layer or two, and the most layers: beyond, a frame takes longer than the stopwatch of a Cortex-M0+
    /// counts, 671 million instructions, or all frames together longer than an emulated chip may run.
    most: [usize; 2],
}

/// All methods; the first one is the default, which is no method of `hidden_surfaces`.
pub const HIDDEN_SURFACES: [HiddenSurfaces; 9] = [
    method("row", "depth row", [usize::MAX; 2]),
    method("intervals", "intervals", [usize::MAX; 2]),
    method("buffer", "depth buffer", [usize::MAX; 2]),
    method("bins", "tile bins", [usize::MAX; 2]),
    method("sort", "painter", [usize::MAX, 8]),
    method("quarters", "Warnock", [usize::MAX; 2]),
    method("rays", "rays: boxes", [usize::MAX, 2]),
    method("grid", "rays: grid", [usize::MAX, 2]),
    method("one", "one depth", [768, 2]),
];

const fn method(name: &'static str, title: &'static str, most: [usize; 2]) -> HiddenSurfaces {
    HiddenSurfaces { name, title, most }
}

impl HiddenSurfaces {
    /// Whether the method is counted with a number of faces that lie in one layer or two.
    pub const fn draws_faces(&self, faces: usize) -> bool {
        let [most, _] = self.most;
        faces <= most
    }

    /// Whether the method is counted with a number of layers, each of which has two faces.
    pub const fn draws_layers(&self, layers: usize) -> bool {
        let [_, most] = self.most;
        layers <= most
    }
}
