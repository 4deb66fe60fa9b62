//! How many instructions the rows of a prepared frame will take: a prediction from what its tables hold.
//!
//! Drawing takes about the same for each row, each face that is set up, each span and each pixel; so its time is the sum of
//! their numbers, each times a weight. Rows, faces and spans are counted exactly, pixels are the areas of faces. The weights
//! are those with which the sum fits what was counted on emulated chips, in scenes of several meshes, sizes and poses: by least
//! squares, and those that all scenes share by the least greatest error.
//!
//! Cost: a look at each face that is to be drawn, or at every fourth one where there are many, and at each row.

use core::{
    borrow::Borrow,
    num::{NonZeroU32, Wrapping},
};

use crate::{
    clip::convex::CutAttributes,
    geometry::SubPixel,
    scene::{
        Look, faces,
        frame::{AttributesOf, corners, is_whole},
        lens::ScreenVertexOf,
        preparation::is_front,
        prepared_faces::PreparedFaces,
    },
    shade::{AttributeInstructions, InstructionSet, Planes, Shading},
    surface::BandColor,
    view::{DepthWidth, Position, ScreenVertex},
    visible::{FEW, FaceTable, NONE, Silhouettes},
};

/// How the rows of a frame are drawn.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
pub(super) enum RowDrawing {
    /// Without depths, as long as no span overlaps another.
    Disjoint,
    /// With depths, all faces of a row at once.
    WithDepths,
    /// With depths, a row that more faces cross in passes of so many.
    InPasses(usize),
}

/// Fractional bits of areas, so that small faces count.
const AREA_BITS: u32 = 4;

/// Numbers of rows, faces, spans and pixels that are drawn in a prepared frame. The instructions of the frame are predicted as
/// the sum of these numbers, each times the instructions that one of the kind takes.
#[derive(Debug, Copy, Clone, Default)]
struct Work {
    /// Rows that faces cross.
    busy_rows: u32,
    /// Faces, and fragments of those that were cut.
    faces: u32,
    /// Faces that are searched in the list of models, and fragments.
    searched_faces: u32,
    /// Rows of all faces.
    spans: u32,
    /// The pixels of all faces, in 1/16.
    area: u32,
    /// Faces whose attributes are divided by the depth; of these, rows and pixels in 1/16.
    divided_faces: u32,
    divided_spans: u32,
    divided_area: u32,
    /// Rows that so few faces cross that these are taken to be drawn without depths, and rows of faces in them.
    untested_rows: u32,
    untested_spans: u32,
    /// Rows of translucent faces, and their pixels in 1/16.
    blended_spans: u32,
    blended_area: u32,
    /// For each row in passes, the faces that cross it, and those that begin in it or above.
    crossing_in_passes: u32,
    begun_in_passes: u32,
    /// Rows and columns of silhouettes.
    edge_rows: u32,
    edge_columns: u32,
}

/// Faces of the first model of a scene above which a prediction looks at every fourth one alone, which counts for four.
const MANY: usize = 256;
/// Faces that a prediction leaves out after each that it looks at, where there are [`MANY`].
const SKIPPED: u32 = 3;

/// Instructions a unit of [`Work`], on ARMv6-M and ARMv7-M.
mod weights {
    /// A row, with what the loop over bands does for it.
    pub(super) const ROW: [u32; 2] = [370, 270];
    /// A byte of a row of the picture, which is filled before the scene is drawn, in 1/16.
    pub(super) const ROW_BYTE: [u32; 2] = [2, 3];
    /// A byte of depths, which is cleared in rows that faces cross, in 1/16.
    pub(super) const DEPTH_BYTE: [u32; 2] = [7, 7];
    /// A face, a row of it and a pixel of it without depths, the last in 1/16.
    pub(super) const DISJOINT: [[u32; 2]; 3] = [[736, 250], [80, 43], [16, 7]];
    /// A face, a row of it and a pixel of it with depths, the last in 1/16.
    pub(super) const WITH_DEPTHS: [[u32; 2]; 3] = [[660, 222], [100, 47], [150, 97]];
    /// By how much less a pixel takes whose attributes vary, with depths, in a shading without holes.
    pub(super) const WITHOUT_HOLES: [u32; 2] = [11, 4];
    /// By how much less a pixel takes where few faces cross a row and none overlaps another, in looks whose attributes are
    /// divided by the depth, in 1/16.
    pub(super) const UNTESTED: [u32; 2] = [144, 128];
    /// By how much more a face takes with depths of 32 bits, and with positions at 1/256 pixel, in 1/16.
    pub(super) const DEEP: [u32; 2] = [72, 59];
    pub(super) const FINE: [u32; 2] = [76, 76];
    /// A face that is searched, and each model that may be looked through for it.
    pub(super) const SEARCHED: [u32; 2] = [100, 70];
    pub(super) const MODEL: [u32; 2] = [10, 6];
    /// A row and a pixel of a translucent face, beside those of an opaque one.
    pub(super) const BLENDED: [[u32; 2]; 2] = [[370, 270], [142, 109]];
    /// A face that crosses a row in passes, and one that begins above it.
    pub(super) const CROSSING: [u32; 2] = [1_750, 510];
    pub(super) const BEGUN: [u32; 2] = [75, 48];
    /// A row and a column of a silhouette, and a face of the models.
    pub(super) const EDGE: [[u32; 2]; 2] = [[690, 490], [480, 250]];
    pub(super) const SILHOUETTE_FACE: [u32; 2] = [110, 55];
}

impl<L: Look> PreparedFaces<'_, '_, L> {
    /// Predicts how many instructions of an instruction set drawing all rows of the frame will take.
    pub(super) fn estimate(&self, set: InstructionSet, drawing: RowDrawing) -> u32 {
        let work = self.work(drawing);
        let [of_face, fragment] = L::Shading::instructions(set);
        let AttributeInstructions {
            face,
            span,
            pixel,
            divided,
        } = AttributesOf::<L>::instructions(set);
        let (is_disjoint, depth_bytes) = (drawing == RowDrawing::Disjoint, size_of::<L::Depth>() as u32);
        let basic = if is_disjoint {
            weights::DISJOINT
        } else {
            weights::WITH_DEPTHS
        };
        let [basic_face, basic_span, basic_pixel] = basic.map(|weight| set.of(weight));
        // Where planes are set up, larger numbers take longer.
        let size = match (L::Precision::FRACTION_BITS, depth_bytes) {
            (4, 2) => 16,
            (4, _) => set.of(weights::DEEP),
            _ => set.of(weights::FINE),
        };
        let in_size = |weight: u32| weight * size / 16;
        let saved = if is_disjoint || L::Shading::HAS_HOLES {
            0
        } else {
            set.of(weights::WITHOUT_HOLES)
        };
        let shaded = if AttributesOf::<L>::VARY {
            pixel.saturating_add(fragment).saturating_sub(saved)
        } else {
            0
        };

        let [rows, columns] = [self.viewport.height(), self.viewport.width()];
        let word_bytes = size_of::<<L::Color as BandColor>::Word>() as u32;
        let mut sum = Sum(0);
        sum.add(rows, set.of(weights::ROW));
        sum.add_16ths(rows, columns * word_bytes * set.of(weights::ROW_BYTE));
        if !is_disjoint {
            let rows = work.busy_rows - work.untested_rows;
            sum.add_16ths(rows, columns * depth_bytes * set.of(weights::DEPTH_BYTE));
        }
        sum.add(work.faces, in_size(basic_face + face).saturating_add(of_face));
        let models = self.models.len().min(usize::from(u16::MAX)) as u32;
        sum.add(
            work.searched_faces,
            set.of(weights::SEARCHED) + models * set.of(weights::MODEL),
        );
        sum.add(work.spans, basic_span + span);
        let untested_area = u64::from(work.untested_spans) * u64::from(work.area) / u64::from(work.spans.max(1));
        sum.add_16ths(work.area / 16, basic_pixel);
        sum.add_16ths(work.area, shaded);
        sum.take_16ths((untested_area / 16) as u32, set.of(weights::UNTESTED));
        if may_divide::<L>() {
            let [face, span, pixel] = divided;
            sum.add(work.divided_faces, in_size(face));
            sum.add(work.divided_spans, span);
            sum.add_16ths(work.divided_area, pixel);
        }
        if L::Shading::BLENDS {
            let [span, pixel] = weights::BLENDED.map(|weight| set.of(weight));
            sum.add(work.blended_spans, span);
            sum.add_16ths(work.blended_area, shaded.saturating_add(pixel));
        }
        if L::DRAWS_IN_PASSES {
            sum.add(work.crossing_in_passes, in_size(set.of(weights::CROSSING) + face));
            sum.add(work.begun_in_passes, set.of(weights::BEGUN));
        }
        if L::Silhouettes::BY_AREA {
            let [row, column] = weights::EDGE.map(|weight| set.of(weight));
            sum.add(work.edge_rows, row);
            sum.add(work.edge_columns, column);
            for model in self.models {
                sum.add(model.mesh().faces().len() as u32, set.of(weights::SILHOUETTE_FACE));
            }
        }
        u32::try_from(sum.0).unwrap_or(u32::MAX)
    }

    /// Counts what there is to draw.
    fn work(&self, drawing: RowDrawing) -> Work {
        let mut work = Work::default();
        let viewport = &self.viewport;
        let edges = [viewport.left, viewport.right, viewport.top, viewport.bottom];
        let edges = edges.map(|edge| edge << L::Precision::FRACTION_BITS);
        let first_faces = self.first_faces.len();
        let are_many = first_faces > MANY;
        let (mut crossing, mut faces) = (Wrapping(0), 0);
        for row in self.rows.iter().take(viewport.height() as usize) {
            crossing += row.change();
            let active = u32::from(crossing.0);
            work.busy_rows += u32::from(active > 0);
            add(&mut work.spans, active);
            if may_be_untested::<L>() && active as usize <= FEW {
                work.untested_rows += u32::from(active > 0);
                add(&mut work.untested_spans, active);
            }
            let mut node = row.first();
            while node != NONE {
                faces += 1;
                if !are_many || usize::from(node) >= first_faces {
                    self.add_face(&mut work, node, &edges, 1);
                } else if faces & SKIPPED == 0 {
                    self.add_face(&mut work, node, &edges, SKIPPED + 1);
                }
                node = self.next(node);
            }
            if let (true, RowDrawing::InPasses(slots)) = (L::DRAWS_IN_PASSES, drawing) {
                if active as usize > slots {
                    add(&mut work.crossing_in_passes, active);
                    add(&mut work.begun_in_passes, faces);
                }
            }
        }
        work.faces = faces;
        work
    }

    /// Counts a face that is to be drawn so many times.
    #[inline(never)]
    fn add_face(&self, work: &mut Work, node: u16, edges: &[i32; 4], times: u32) {
        let corners = match self.first_faces.get(usize::from(node)) {
            Some(face) => corners(self.vertices, face),
            None => {
                add(&mut work.searched_faces, times);
                self.searched_corners(node)
            }
        };
        let Some(corners) = corners else { return };
        let area = self
            .visible_area(corners.map(ScreenVertex::position), edges)
            .saturating_mul(times);
        add(&mut work.area, area);
        if may_divide::<L>() && self.is_divided(node, corners) {
            add(&mut work.divided_faces, times);
            add(&mut work.divided_spans, self.visible_rows(corners) * times);
            add(&mut work.divided_area, area);
        }
        if L::Shading::BLENDS && self.is_translucent(node) {
            add(&mut work.blended_spans, self.visible_rows(corners) * times);
            add(&mut work.blended_area, area);
        } else if L::Silhouettes::BY_AREA && is_whole::<L>(node) {
            self.add_silhouettes(work, node, corners, times);
        }
    }

    #[cold]
    #[inline(never)]
    fn searched_corners(&self, node: u16) -> Option<[&ScreenVertexOf<L>; 3]> {
        if is_whole::<L>(node) {
            self.corners_in_mesh(node)
        } else {
            self.fragment(node)
        }
    }

    /// Whether the attributes of a face are divided by its depth.
    fn is_divided(&self, node: u16, vertices: [&ScreenVertexOf<L>; 3]) -> bool {
        // Of the stored depths, as 32-bit fractions.
        let depths = vertices.map(|vertex| (vertex.z.units() as u32) << L::Depth::FRACTION_BITS);
        let attributes = self.attributes(node, |of_corners| of_corners);
        attributes.is_some_and(|corners| {
            let corners = corners.each_ref().map(Borrow::borrow);
            !AttributesOf::<L>::are_nearly_even(corners, depths, L::Shading::TOLERANCE)
        })
    }

    /// Counts the edges of a face that has no neighbour there which is seen from the same side.
    fn add_silhouettes(&self, work: &mut Work, node: u16, of_face: [&ScreenVertexOf<L>; 3], times: u32) {
        let Some((model, first_vertex, face)) = faces::find(self.models, node) else {
            return;
        };
        let is_clockwise = |corners: [&ScreenVertexOf<L>; 3]| {
            let [a, b, c] = corners.map(ScreenVertex::position);
            is_front::<L::Precision>(a, b, c)
        };
        let side = is_clockwise(of_face);
        let (mesh, vertices) = (model.mesh(), self.vertices.get(first_vertex..).unwrap_or_default());
        let neighbours = mesh.neighbours().get(face).copied().unwrap_or([NONE; 3]);
        let pixels = |units: u32, most: u32| (units >> L::Precision::FRACTION_BITS).min(most);
        let [a, b, c] = of_face.map(ScreenVertex::position);
        for (neighbour, [from, to]) in neighbours.into_iter().zip([[a, b], [b, c], [c, a]]) {
            let neighbour = mesh.faces().get(usize::from(neighbour));
            let goes_on = neighbour.and_then(|face| corners(vertices, face)).map(is_clockwise) == Some(side);
            if !goes_on {
                let rows = pixels(from.y.abs_diff(to.y), self.viewport.height()) + 1;
                add(&mut work.edge_rows, rows * times);
                add(
                    &mut work.edge_columns,
                    pixels(from.x.abs_diff(to.x), self.viewport.width()) * times,
                );
            }
        }
    }

    /// The rows of the viewport that a face crosses, and one more where it begins within one.
    fn visible_rows(&self, vertices: [&ScreenVertexOf<L>; 3]) -> u32 {
        let [a, b, c] = vertices.map(|vertex| vertex.y_units() >> L::Precision::FRACTION_BITS);
        let top = a.min(b).min(c).max(self.viewport.top);
        let bottom = a.max(b).max(c).min(self.viewport.bottom);
        (bottom - top + 1).max(0) as u32
    }

    /// The area of a face within the viewport, the edges of which are in units of the corners, in 1/16 pixel.
    #[inline(always)]
    fn visible_area(&self, corners: [Position; 3], [left, right, top, bottom]: &[i32; 4]) -> u32 {
        // The sign tells whether any difference is below 0: one branch for all of them.
        let beyond = |corner: Position| (corner.x - left) | (right - corner.x) | (corner.y - top) | (bottom - corner.y);
        let [a, b, c] = corners;
        if beyond(a) | beyond(b) | beyond(c) >= 0 {
            area::<L::Precision>(corners)
        } else {
            self.sampled_area(corners)
        }
    }

    /// The area of a face within the viewport from eight of its rows, in 1/16 pixel.
    #[cold]
    #[inline(never)]
    fn sampled_area(&self, corners: [Position; 3]) -> u32 {
        let viewport = &self.viewport;
        // Whole pixels: products are below 2^32.
        let pixel = |units: i32| units >> L::Precision::FRACTION_BITS;
        let [a, b, c] = corners.map(|corner| [pixel(corner.x), pixel(corner.y)]);
        let [top, bottom] = [
            a[1].min(b[1]).min(c[1]).max(viewport.top),
            a[1].max(b[1]).max(c[1]).min(viewport.bottom),
        ];
        let height = bottom - top;
        if height <= 0 {
            return 0;
        }
        let mut widths = 0;
        for sample in 0..ROWS_OF_AREA {
            let y = top + ((2 * sample + 1) * height) / (2 * ROWS_OF_AREA);
            let (mut start, mut end) = (viewport.right, viewport.left);
            for edge in [[a, b], [b, c], [c, a]] {
                if let Some(x) = column_of(edge, y) {
                    (start, end) = (start.min(x), end.max(x));
                }
            }
            widths += (end.min(viewport.right) - start.max(viewport.left)).max(0) as u32;
        }
        let area = (u64::from(widths) * u64::from(height.unsigned_abs())) << AREA_BITS >> ROWS_OF_AREA.ilog2();
        u32::try_from(area).unwrap_or(u32::MAX)
    }
}

/// The rows from which the area of a face that reaches beyond the picture is found.
const ROWS_OF_AREA: i32 = 8;

/// Whether attributes may be divided by the depth.
const fn may_divide<L: Look>() -> bool {
    <AttributesOf<L> as CutAttributes>::NEED_DEPTH && !L::IS_ORTHOGRAPHIC
}

/// Whether rows that few faces cross may be drawn without depths, though faces have planes.
const fn may_be_untested<L: Look>() -> bool {
    <AttributesOf<L> as CutAttributes>::NEED_DEPTH
        && !L::Shading::HAS_HOLES
        && !L::Shading::BLENDS
        && !L::Silhouettes::BY_AREA
        && !L::IS_MULTISAMPLED
}

/// A number of instructions.
struct Sum(u64);

impl Sum {
    /// Adds so many instructions for each of a number.
    fn add(&mut self, number: u32, weight: u32) {
        self.0 = self.0.saturating_add(u64::from(number) * u64::from(weight));
    }

    /// Adds so many instructions for each of a number, one of which is in 1/16.
    fn add_16ths(&mut self, number: u32, weight: u32) {
        self.0 = self.0.saturating_add((u64::from(number) * u64::from(weight)) >> 4);
    }

    /// Takes so many instructions away for each of a number, one of which is in 1/16.
    fn take_16ths(&mut self, number: u32, weight: u32) {
        self.0 = self.0.saturating_sub((u64::from(number) * u64::from(weight)) >> 4);
    }
}

fn add(sum: &mut u32, more: u32) {
    *sum = sum.saturating_add(more);
}

/// The area of a face, in 1/16 pixel.
#[inline]
fn area<S: SubPixel>([a, b, c]: [Position; 3]) -> u32 {
    let (x1, y1) = (b.x - a.x, b.y - a.y);
    let (x2, y2) = (c.x - a.x, c.y - a.y);
    let shift = 2 * S::FRACTION_BITS + 1 - AREA_BITS;
    if S::FRACTION_BITS <= 4 {
        // Differences are at most 32,752, and twice the area is at most their product.
        (x1 * y2 - x2 * y1).unsigned_abs() >> shift
    } else {
        let doubled = i64::from(x1) * i64::from(y2) - i64::from(x2) * i64::from(y1);
        u32::try_from(doubled.unsigned_abs() >> shift).unwrap_or(u32::MAX)
    }
}

/// The column in which an edge between pixels crosses a row, if it does.
fn column_of([one, other]: [[i32; 2]; 2], y: i32) -> Option<i32> {
    let ([from_x, from_y], [to_x, to_y]) = if one[1] <= other[1] { (one, other) } else { (other, one) };
    if !(from_y..=to_y).contains(&y) {
        return None;
    }
    let height = NonZeroU32::new(to_y.abs_diff(from_y))?;
    // Differences below 2^16.
    let part = (to_x.abs_diff(from_x).saturating_mul(y.abs_diff(from_y)) / height) as i32;
    Some(if to_x < from_x { from_x - part } else { from_x + part })
}

#[cfg(test)]
mod tests {
    use core::cell::Cell;
    use std::{boxed::Box, vec, vec::Vec};

    use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
    use fixed::types::I16F16;

    use super::*;
    use crate::{
        band::Band,
        scene::{Camera, Counted, Counters, FaceSet, Memory, Model, Unhurried},
    };

    /// Faces of all sizes and shapes, some of them partly or wholly beside the picture.
    fn faces(number: usize) -> (Vec<[i16; 3]>, Vec<[u16; 3]>) {
        let mut state = 1u32;
        let mut random = move |most: i32| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 8) as i32 % most
        };
        let mut vertices = Vec::new();
        for index in 0..number {
            let ([x, y], size) = ([0; 2].map(|_| random(2_400) - 1_200), 20 + (index as i32 % 20) * 20);
            for _ in 0..3 {
                let [right, up] = [0; 2].map(|_| random(2 * size) - size);
                vertices.push([x + right, y + up, 1_000 + random(50)].map(|part| part as i16));
            }
        }
        let indices = (0..number as u16).map(|face| [3 * face, 3 * face + 1, 3 * face + 2]);
        (vertices, indices.collect())
    }

    fn check<L: Look<Color = Rgb565, Shading = Rgb565, Counting = Cell<Counters>>>(number: usize, error: f64) {
        let area = Rectangle::new(Point::zero(), Size::new(128, 128));
        let camera = Camera::new(area, I16F16::from_num(128)).unwrap();
        let (vertices, faces) = faces(number);
        let colors = vec![Rgb565::RED; number];
        let models = [Model::new(FaceSet::new(&vertices, &faces).unwrap(), &colors).unwrap()];
        let mut memory = Box::new(Memory::<L, 3_000, 1_000, 128, 128, 900>::new());
        let mut prepared = memory.prepare(&camera, &models).unwrap();
        let work = prepared.faces.work(RowDrawing::WithDepths);
        prepared.draw(&mut Band::<Rgb565>::new(area, &mut vec![0; 128 * 128]).unwrap());
        let counters = prepared.counters();
        assert_eq!(work.faces, counters.faces - counters.faces_culled);
        let pixels = f64::from(work.area >> AREA_BITS) / f64::from(counters.pixels_tested);
        assert!((1.0 - error..1.0 + error).contains(&pixels), "{pixels} of the pixels");
        // Rows of a face that are between pixels, or beside the picture, have no span.
        let spans = f64::from(work.spans) / f64::from(counters.spans_tested);
        assert!((1.0..1.4).contains(&spans), "{spans} of the spans");
    }

    /// All faces are looked at, or a part of them.
    #[test]
    fn spans_and_pixels_are_those_that_are_drawn() {
        for number in [40, 120, MANY] {
            check::<Unhurried<Counted<Rgb565>>>(number, 0.06);
        }
        check::<Unhurried<Counted<Rgb565>>>(900, 0.12);
    }
}
