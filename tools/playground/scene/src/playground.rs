//! Prepares the items of a state and draws it, band by band.

use embedded_graphics::{
    geometry::{Dimensions, Point, Size},
    pixelcolor::{Rgb565, Rgb888},
    primitives::Rectangle,
};
use heapless::Vec;
use zrow::{
    band::{Band, LittleEndian, LoopError, PictureLoop, Sink},
    draw::{AntialiasedPolygon, SubOutline},
    geometry::{InputError, TooSmall, Window},
    shade::BlendTarget,
};

use crate::{
    coverage::{self, ReadyItem, bytes_per_row},
    outline::ItemOutline,
    panel_color::{DrawnColor, PanelColor},
    pot,
    state::{Depth, ITEMS, Item, Method, Pot, State},
};

/// Columns of the panel.
pub const WIDTH: usize = 240;
/// Rows of the panel.
pub const HEIGHT: usize = 320;
/// The whole panel.
pub const AREA: Rectangle = Rectangle::new(Point::zero(), Size::new(WIDTH as u32, HEIGHT as u32));
/// What is there before anything is drawn.
pub const BACKGROUND: Rgb888 = Rgb888::new(12, 16, 24);
/// The most edges of an item.
pub const EDGES: usize = 1024;
/// The most edges of the teapot's faces: of 992 triangles fewer than two thirds are turned to the viewer.
pub const POT_EDGES: usize = 2048;
/// The most edges of an item that lie in the same row.
pub const ACTIVE: usize = 256;

const WINDOW: Window = Window {
    left: 0,
    top: 0,
    right: WIDTH as i32,
    bottom: HEIGHT as i32,
};

/// A state that is ready to be drawn, with all memory that it takes.
#[derive(Debug)]
pub struct Playground {
    state: State,
    /// One for each item.
    ready: Vec<ReadyItem, ITEMS>,
    /// A band of all rows in the largest words.
    words: [u32; WIDTH * HEIGHT],
    /// A band of all rows in which the teapot is drawn.
    pot_words: pot::Words,
}

impl Default for Playground {
    fn default() -> Self {
        Self::new()
    }
}

impl Playground {
    /// Nothing is prepared. All bits are 0, so that a `static` is not stored in the program.
    pub const fn new() -> Self {
        Self {
            state: State::ZERO,
            ready: Vec::new(),
            words: [0; WIDTH * HEIGHT],
            pot_words: [0; WIDTH * HEIGHT],
        }
    }

    /// Reads a state and sets the edges of its items up.
    ///
    /// # Errors
    /// An item has more edges than there is room for. The items before it are ready.
    pub fn prepare(&mut self, address: &str) -> Result<(), InputError> {
        self.state = State::of_address(address);
        self.set_up()
    }

    /// Takes a state over, of which nothing is set up yet.
    pub fn take(&mut self, state: State) {
        self.state = state;
        self.ready.clear();
    }

    /// Sets the edges of all items up.
    ///
    /// # Errors
    /// An item has more edges than there is room for. The items before it are ready.
    pub fn set_up(&mut self) -> Result<(), InputError> {
        self.ready.clear();
        for item in &self.state.items {
            // There is room for as many as items.
            let _ = self.ready.push(ReadyItem {
                polygon: AntialiasedPolygon::empty(),
                method: self.state.method,
            });
            let Some(ReadyItem { polygon, method }) = self.ready.last_mut() else {
                break;
            };
            let outline = outline(item, &self.state);
            polygon.set_up(&outline, outline.fill_rule())?;
            *method = coverage::choose(*method, polygon, &outline);
        }
        Ok(())
    }

    /// The state that is prepared.
    pub const fn state(&self) -> &State {
        &self.state
    }

    /// The method that is taken for an item.
    pub fn method_of(&self, item: usize) -> Option<Method> {
        self.ready.get(item).map(|ready| ready.method)
    }

    /// Draws the state on a panel of a colour.
    ///
    /// # Errors
    /// The panel's own, and those of the scene.
    pub fn draw<C: PanelColor, S: Sink<C, LittleEndian>>(
        &mut self,
        sink: S,
    ) -> Result<(), LoopError<S::Error, InputError>> {
        C::draw(self, sink)
    }

    /// Draws the state in bands of RGB565 as a program does that names its method and its colour where it draws: the same
    /// picture in less time than for the page, whose program links each method once for all colours. For counting.
    ///
    /// # Errors
    /// The panel's own, and those of the scene.
    pub fn draw_directly<S: Sink<Rgb565, LittleEndian>>(
        &mut self,
        sink: &mut S,
    ) -> Result<(), LoopError<S::Error, InputError>> {
        let Self {
            state,
            ready,
            pot_words,
            ..
        } = self;
        let bands = PictureLoop::new(AREA, BACKGROUND.into()).rows(rows_of_band(state));
        let mut drawn = Ok(());
        let prepared = pot::with(state, &mut |pot| {
            drawn = bands.draw(pot_words, sink, |band| {
                pot(band);
                let mut items = state.items.iter().zip(&*ready);
                items
                    .try_for_each(|(item, ready)| coverage::draw(&ready.polygon, ready.method, item.color.into(), band))
            });
        });
        prepared.map_err(LoopError::Scene)?;
        drawn
    }

    /// Draws the state in bands of a colour.
    pub(crate) fn draw_bands<C: DrawnColor, S: Sink<C, LittleEndian>>(
        &mut self,
        sink: &mut S,
    ) -> Result<(), LoopError<S::Error, InputError>> {
        let Self {
            state,
            ready,
            words,
            pot_words,
        } = self;
        let bands = PictureLoop::new(AREA, C::from(BACKGROUND)).rows(rows_of_band(state));
        // As large and as aligned as the words of any colour.
        let words = bytemuck::try_cast_slice_mut(words).unwrap_or_default();
        let mut drawn = Ok(());
        let prepared = pot::with(state, &mut |pot| {
            drawn = bands.draw(words, sink, |band| {
                if state.pot != Pot::None {
                    pot::convert(pot, pot_words, band);
                }
                draw_items(state, ready, band)
            });
        });
        prepared.map_err(LoopError::Scene)?;
        drawn
    }

    /// Writes the coverage of each pixel of the panel by one item into a mask; nothing where there is no such item.
    pub fn cover(&self, item: usize, mask: &mut [u8; WIDTH * HEIGHT]) {
        mask.fill(0);
        let Some(ReadyItem { polygon, method }) = self.ready.get(item) else {
            return;
        };
        // No error: there is memory for a row of the panel.
        let _ = coverage::cover(polygon, *method, &WINDOW, &mut |span, coverage| {
            let pixels = span.start as usize..span.end as usize;
            let row = mask.chunks_exact_mut(WIDTH).nth(span.y as usize);
            if let Some(pixels) = row.and_then(|row| row.get_mut(pixels)) {
                pixels.fill(coverage);
            }
            Ok(())
        });
    }

    /// Calls with the ends of each edge of an item, in 1/256 pixel.
    pub fn edges(&self, item: usize, edge: &mut dyn FnMut([i32; 2], [i32; 2])) {
        if let Some(item) = self.state.items.get(item) {
            outline(item, &self.state).edges(edge);
        }
    }

    /// Writes the coverage of each pixel of the panel by the teapot into a mask; nothing where there is none.
    ///
    /// # Errors
    /// Those of the scene.
    pub fn cover_pot(&self, mask: &mut [u8; WIDTH * HEIGHT]) -> Result<(), InputError> {
        pot::cover(&self.state, mask)
    }

    /// Calls with the ends of each edge of the teapot's faces that are turned to the viewer, clockwise, in 1/256 pixel: one that
    /// two of them share is there in both directions.
    ///
    /// # Errors
    /// Those of the scene.
    pub fn pot_edges(&self, edge: &mut dyn FnMut([i32; 2], [i32; 2])) -> Result<(), InputError> {
        pot::edges(&self.state, edge)
    }

    /// The memory that the picture takes.
    pub fn footprint(&self) -> Footprint {
        let state = &self.state;
        let pixels = WIDTH * HEIGHT;
        let (drawn_bits, panel_bits) = match state.depth {
            Depth::Rgb888 => (32, 24),
            Depth::Rgb565 => (16, 16),
            Depth::DitheredRgb565 => (32, 16),
            Depth::Gray4 => (8, 4),
            Depth::Binary => (8, 1),
        };
        let has_depths = state.pot != Pot::None;
        // The teapot is drawn in RGB565 before it becomes another colour.
        let pot_bits = if has_depths && state.depth != Depth::Rgb565 {
            16
        } else {
            0
        };
        let has_items = !state.items.is_empty();
        Footprint {
            band: WIDTH * rows_of_band(state) as usize * (drawn_bits + pot_bits) / 8,
            coverage_row: if has_items {
                bytes_per_row(state.method, WIDTH)
            } else {
                0
            },
            depth_row: if has_depths { 2 * WIDTH } else { 0 },
            frame_buffer: pixels * panel_bits / 8,
            depth_buffer: if has_depths { 2 * pixels } else { 0 },
        }
    }
}

/// Bytes of memory that grow with the size of the panel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Footprint {
    /// The band that is drawn in.
    pub band: usize,
    /// What the method of antialiasing takes for a row.
    pub coverage_row: usize,
    /// The depths of a row.
    pub depth_row: usize,
    /// All pixels of the panel, without gaps.
    pub frame_buffer: usize,
    /// The depths of all pixels.
    pub depth_buffer: usize,
}

/// The rows of a band.
fn rows_of_band(state: &State) -> u32 {
    if state.rows == 0 { HEIGHT as u32 } else { state.rows }
}

fn outline<'a>(item: &'a Item, state: &State) -> ItemOutline<'a> {
    ItemOutline {
        item,
        precision: state.precision,
    }
}

/// Blends all items over a band.
fn draw_items<C: DrawnColor>(state: &State, ready: &[ReadyItem], band: &mut Band<'_, C>) -> Result<(), InputError> {
    let window = Window::from(band.bounding_box());
    for (item, ReadyItem { polygon, method }) in state.items.iter().zip(ready) {
        let color = C::from(item.color);
        coverage::cover(polygon, *method, &window, &mut |span, coverage| {
            let Ok(()) = band.blend_span(span, color, coverage);
            Ok::<_, TooSmall>(())
        })
        .map_err(InputError::TooSmall)?;
    }
    Ok(())
}
