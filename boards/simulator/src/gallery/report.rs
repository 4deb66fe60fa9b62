//! What each scene costs: RAM against that of a frame buffer, and time.

use std::{any::type_name, fmt};

use comfy_table::{CellAlignment, Table, presets};
use embedded_graphics::pixelcolor::{PixelColor, raw::RawData};
use zrow::geometry::Window;
use zrow_scenes::{PictureCapacities, Scene};

use super::draw::row_bytes;

/// Bytes of a pixel of the depth buffer that a row of depths stands in for.
const DEPTH_BYTES: usize = 2;

/// A table with one line for each scene, and one with the capacities of those that are pictures.
#[derive(Default)]
pub struct Report {
    lines: Vec<[String; 9]>,
    pictures: Vec<[String; 7]>,
}

impl Report {
    /// Adds a scene, and what its frames have taken of its capacities, if it is a picture.
    pub fn add<S: Scene>(&mut self, frames_per_second: f64, used: PictureCapacities) {
        let memory = Memory::of::<S>();
        let bits = <S::Color as PixelColor>::Raw::BITS_PER_PIXEL;
        let color = type_name::<S::Color>().rsplit("::").next().unwrap_or_default();
        self.lines.push([
            S::NAME.into(),
            format!("{} x {}", S::AREA.size.width, S::AREA.size.height),
            format!("{bits} bit {color}"),
            bytes(memory.row),
            bytes(memory.depth_row),
            bytes(memory.scene),
            bytes(memory.sum()),
            bytes(memory.buffers),
            format!("{frames_per_second:.0}"),
        ]);
        if let Some(lent) = S::PICTURE {
            let both = |used, lent| format!("{} / {}", bytes(used), bytes(lent));
            self.pictures.push([
                S::NAME.into(),
                both(used.slots, lent.slots),
                both(used.words, lent.words),
                both(used.segments, lent.segments),
                both(used.edges, lent.edges),
                bytes(lent.damage_areas),
                bytes(memory.scene + lent.damage_areas * size_of::<Window>()),
            ]);
        }
    }
}

impl fmt::Display for Report {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let header = [
            "scene",
            "size",
            "colour",
            "colour row",
            "depth row",
            "scene data",
            "sum of bytes",
            "frame + depth buffer",
            "frames/s here",
        ];
        writeln!(formatter, "{}", table(header, &self.lines, 3))?;
        write!(
            formatter,
            "RAM in bytes; scene data with this machine's pointers of {} bytes. The frame buffer is packed to the panel's \
             bits, the depth buffer has {DEPTH_BYTES} bytes a pixel; scenes without depth need none.",
            size_of::<usize>()
        )?;
        if self.pictures.is_empty() {
            return Ok(());
        }
        let header = [
            "picture",
            "slots",
            "words",
            "segments",
            "edges",
            "damage rectangles",
            "bytes in all",
        ];
        writeln!(formatter, "\n\n{}", table(header, &self.pictures, 1))?;
        write!(
            formatter,
            "Scenes that are a prepared `Picture`: what one of the frames above takes at most / what the scene lends. Bytes \
             are the scene data and the damage rectangles; those of the row come on top. docs/which-way.md says how to find \
             the capacities of a picture."
        )
    }
}

/// A table whose columns are numbers from one of them on.
fn table<const COLUMNS: usize>(header: [&str; COLUMNS], lines: &[[String; COLUMNS]], first_number: usize) -> Table {
    let mut table = Table::new();
    table.load_preset(presets::UTF8_FULL_CONDENSED);
    table.set_header(header);
    table.add_rows(lines);
    for column in table.column_iter_mut().skip(first_number) {
        column.set_cell_alignment(CellAlignment::Right);
    }
    table
}

/// Bytes of RAM of a scene.
struct Memory {
    row: usize,
    depth_row: usize,
    scene: usize,
    buffers: usize,
}

impl Memory {
    fn of<S: Scene>() -> Self {
        let pixels = S::AREA.size.width as usize * S::AREA.size.height as usize;
        let depth_buffer = if S::DEPTH_ROW_BYTES > 0 {
            pixels * DEPTH_BYTES
        } else {
            0
        };
        Self {
            row: row_bytes::<S>(),
            depth_row: S::DEPTH_ROW_BYTES,
            scene: size_of::<S>() - S::DEPTH_ROW_BYTES + size_of::<S::Prepared<'_>>(),
            buffers: (pixels * <S::Color as PixelColor>::Raw::BITS_PER_PIXEL).div_ceil(8) + depth_buffer,
        }
    }

    fn sum(&self) -> usize {
        self.row + self.depth_row + self.scene
    }
}

/// A number with its thousands apart.
fn bytes(number: usize) -> String {
    let digits = number.to_string();
    let mut grouped = String::new();
    for (index, digit) in digits.chars().enumerate() {
        if index > 0 && (digits.len() - index).is_multiple_of(3) {
            grouped.push(',');
        }
        grouped.push(digit);
    }
    grouped
}
