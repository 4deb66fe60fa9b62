//! The functions that the page calls.

use atomic_refcell::AtomicRefCell;
use embedded_graphics::pixelcolor::{BinaryColor, Gray4, Rgb565, Rgb888};
use zrow_playground_scene::{Depth, EDGES, HEIGHT, POT_EDGES, PanelColor, Playground, WIDTH};

use crate::canvas::{Canvas, Pixels};

/// The most bytes of a state: `MOST_BYTES` in web/engine.js. Twelve texts of 16 points take 7,098.
const ADDRESS: usize = 8192;
/// Numbers of an edge: x and y of both ends.
const EDGE: usize = 4;
/// Numbers of the most edges of an item or of the teapot.
const EDGE_NUMBERS: usize = EDGE * if EDGES > POT_EDGES { EDGES } else { POT_EDGES };

/// All memory.
struct Memory {
    address: [u8; ADDRESS],
    playground: Playground,
    pixels: Pixels,
    mask: [u8; WIDTH * HEIGHT],
    edges: [i32; EDGE_NUMBERS],
}

static MEMORY: AtomicRefCell<Memory> = AtomicRefCell::new(Memory {
    address: [0; ADDRESS],
    playground: Playground::new(),
    pixels: [0; size_of::<Pixels>()],
    mask: [0; WIDTH * HEIGHT],
    edges: [0; EDGE_NUMBERS],
});

/// Runs a function on the memory; the default of its result while it runs already, which does not happen.
fn with<R: Default>(call: impl FnOnce(&mut Memory) -> R) -> R {
    MEMORY
        .try_borrow_mut()
        .map_or_else(|_| R::default(), |mut memory| call(&mut memory))
}

macro_rules! buffers {
    ($($(#[$doc:meta])+ $function:ident: $buffer:ident;)+) => {$(
        $(#[$doc])+
        // SAFETY: no other function of the program has this name.
        #[unsafe(no_mangle)]
        pub extern "C" fn $function() -> usize {
            with(|memory| memory.$buffer.as_ptr().addr())
        }
    )+};
}

buffers! {
    /// Where the page writes the text of a state, in UTF-8; it has room for 8,192 bytes.
    address_buffer: address;
    /// Red, green, blue and 255 for each pixel of the panel, row by row.
    pixel_buffer: pixels;
    /// The coverage of each pixel of the panel by the item that was asked for last, or by the teapot.
    mask_buffer: mask;
    /// The edges of the item that was asked for last, or of the teapot's faces: x and y of the first and of the second end, in 1/256
    /// pixel.
    edge_buffer: edges;
}

/// Draws the state of the buffer's first bytes. Returns 0; 1 where an item has more edges than there is room for, and 2 where
/// the bytes are no text.
// SAFETY: no other function of the program has this name.
#[unsafe(no_mangle)]
pub extern "C" fn draw(length: usize) -> u32 {
    with(
        |Memory {
             address,
             playground,
             pixels,
             ..
         }| {
            let address = address.get(..length).and_then(|bytes| core::str::from_utf8(bytes).ok());
            let Some(address) = address else { return 2 };
            let is_prepared = playground.prepare(address).is_ok();
            let is_drawn = match playground.state().depth {
                Depth::Rgb888 => show::<Rgb888>(playground, pixels),
                Depth::Rgb565 | Depth::DitheredRgb565 => show::<Rgb565>(playground, pixels),
                Depth::Gray4 => show::<Gray4>(playground, pixels),
                Depth::Binary => show::<BinaryColor>(playground, pixels),
            };
            u32::from(!(is_prepared && is_drawn))
        },
    )
}

fn show<C: PanelColor>(playground: &mut Playground, pixels: &mut Pixels) -> bool {
    playground.draw::<C, _>(Canvas(pixels)).is_ok()
}

/// Writes the coverage of an item into its buffer.
// SAFETY: no other function of the program has this name.
#[unsafe(no_mangle)]
pub extern "C" fn cover(item: usize) {
    with(|Memory { playground, mask, .. }| playground.cover(item, mask));
}

/// Writes the edges of an item into their buffer, and returns how many there are.
// SAFETY: no other function of the program has this name.
#[unsafe(no_mangle)]
pub extern "C" fn edges(item: usize) -> usize {
    write_edges(|playground, edge| playground.edges(item, edge))
}

/// Writes the coverage of the teapot into its buffer.
// SAFETY: no other function of the program has this name.
#[unsafe(no_mangle)]
pub extern "C" fn cover_pot() {
    // No error: a state with this pot was drawn before.
    with(|Memory { playground, mask, .. }| playground.cover_pot(mask).unwrap_or_default());
}

/// Writes the edges of the teapot's faces into their buffer, and returns how many there are.
// SAFETY: no other function of the program has this name.
#[unsafe(no_mangle)]
pub extern "C" fn pot_edges() -> usize {
    // No error: a state with this pot was drawn before.
    write_edges(|playground, edge| playground.pot_edges(edge).unwrap_or_default())
}

/// Receives both ends of each edge.
type Edges<'e> = &'e mut dyn FnMut([i32; 2], [i32; 2]);

/// Writes edges into their buffer, and returns how many there are.
fn write_edges(call: impl FnOnce(&Playground, Edges<'_>)) -> usize {
    with(|Memory { playground, edges, .. }| {
        let mut places = edges.chunks_exact_mut(EDGE);
        let mut count = 0;
        call(playground, &mut |[x0, y0], [x1, y1]| {
            if let Some(place) = places.next() {
                place.copy_from_slice(&[x0, y0, x1, y1]);
                count += 1;
            }
        });
        count
    })
}

/// Bytes that the state takes: of the band (0), the coverage of a row (1), the depths of a row (2), a frame buffer (3) and a
/// depth buffer (4).
// SAFETY: no other function of the program has this name.
#[unsafe(no_mangle)]
pub extern "C" fn bytes(which: usize) -> usize {
    with(|Memory { playground, .. }| {
        let footprint = playground.footprint();
        let bytes = [
            footprint.band,
            footprint.coverage_row,
            footprint.depth_row,
            footprint.frame_buffer,
            footprint.depth_buffer,
        ];
        bytes.get(which).copied().unwrap_or_default()
    })
}
