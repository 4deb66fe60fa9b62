//! `zrow::visible`: any faces by all methods of visibility and of hidden lines, with memory that is enough or not.

use anyhow::{Context, bail, ensure};
use arbitrary::Arbitrary;
use embedded_graphics::{pixelcolor::Rgb565, primitives::PointsIter};
use zrow::{
    band::{Band, LittleEndian},
    geometry::{Sub4, Sub8, Window},
    scan::Polygons,
    scene::{Camera, DepthWidth, DoubleSided, Edge, Memory, Model, Prepared, ScreenPrecision},
    visible::{
        Appel, DepthBuffer, DepthSort, FaceAgainstSegment, GridRayCasting, HiddenLines, LinePart, OneDepth, RayCasting,
        Roberts, SolidCombination, SolidNode, SpanScanLine, TileBins, Visibility, Warnock, Work,
    },
};
use zrow_methods::LookOf;

use crate::{
    families::scene::{AnyScene, Kind, Large, Mesh, color, colors, models},
    picture::{Canvas, background, is_same},
    target::{Case, Verdict},
    values::List,
};

/// Scenes in a part of the picture, by all methods.
#[derive(Debug, Arbitrary)]
pub struct VisibilityCase {
    scene: AnyScene,
    part: [u8; 4],
    kind: Kind,
}

/// The look of a scene whose faces are cut.
type Look<S, D> = LookOf<Rgb565, S, D, true>;

/// Whether what is painted or tested lies in the part that is drawn.
fn lies_within(work: &Work, part: &Window) -> bool {
    match work {
        Work::Painted { span, .. } | Work::Tested { span, .. } => span.is_empty() || *span == span.clipped_to(part),
        _ => true,
    }
}

/// Draws a part of the picture by a method: the picture of the depth row; or an error, and nothing was drawn.
fn check_method<S: ScreenPrecision, D: DepthWidth>(
    prepared: &mut Prepared<'_, '_, Look<S, D>>,
    part: &Window,
    expected: &[Rgb565],
    method: &mut impl Visibility<D>,
    is_enough: bool,
) -> Verdict {
    let (mut result, mut is_within) = (Ok(()), true);
    let drawn = Canvas::new(*part).draw::<LittleEndian>(|band| {
        result = if part.left % 2 == 0 {
            prepared.draw_by(method, band)
        } else {
            prepared.draw_by_with(method, band, |work| is_within &= lies_within(&work, part))
        };
        Ok(())
    })?;
    ensure!(is_within, "work beside what is drawn");
    match result {
        Ok(()) => is_same(part, expected, &drawn).context("by the depth row, the other by a method"),
        Err(error) if is_enough => bail!("{error} with room for all"),
        Err(error) => {
            ensure!(error.needed() > 0, "{error}");
            ensure!(drawn.iter().all(|color| *color == background()), "{error}, but drawn");
            Ok(())
        }
    }
}

/// The parts of all edges by a method, of which those of one edge are a chain; or an error, and nothing was handed over.
fn parts_by<S: ScreenPrecision, D: DepthWidth>(
    prepared: &Prepared<'_, '_, Look<S, D>>,
    edges: &[&[Edge]],
    method: &mut impl HiddenLines<D>,
) -> anyhow::Result<Option<Vec<LinePart<S>>>> {
    let mut parts: Vec<LinePart<S>> = Vec::new();
    if let Err(error) = prepared.visible_parts(method, edges, |part| parts.push(part)) {
        ensure!(error.needed() > 0 && parts.is_empty(), "{error}");
        return Ok(None);
    }
    for pair in parts.windows(2) {
        let [one, other] = pair else { continue };
        let is_same_edge = one.edge.is_some() && (one.model, one.edge) == (other.model, other.edge);
        let follows = one.ends[1] == other.ends[0] && one.is_hidden != other.is_hidden;
        ensure!(follows || !is_same_edge, "{one:?} before {other:?}");
    }
    Ok(Some(parts))
}

/// Hidden lines: the same parts however little memory the method has.
fn check_lines<S: ScreenPrecision, D: DepthWidth>(
    prepared: &Prepared<'_, '_, Look<S, D>>,
    edges: &[&[Edge]],
) -> Verdict {
    let expected = parts_by::<S, D>(prepared, edges, &mut FaceAgainstSegment::<300, 16, true>::new())?;
    ensure!(expected.is_some(), "no room for all faces");
    let without_stack = parts_by::<S, D>(prepared, edges, &mut FaceAgainstSegment::<300, 0, true>::new())?;
    ensure!(without_stack == expected, "other parts without a stack");
    let with_few = parts_by::<S, D>(prepared, edges, &mut FaceAgainstSegment::<4, 2, true>::new())?;
    ensure!(with_few.is_none() || with_few == expected, "other parts with few faces");
    let by_rays = parts_by::<S, D>(prepared, edges, &mut Appel::<0, 0, 0>::new())?;
    ensure!(by_rays.is_some(), "no room for quantitative invisibility");
    let carried = parts_by::<S, D>(prepared, edges, &mut Appel::<300, 16, 600>::new())?;
    ensure!(carried == by_rays, "another number than by rays");
    let with_few = parts_by::<S, D>(prepared, edges, &mut Appel::<5, 1, 9>::new())?;
    ensure!(with_few == by_rays, "another number with little memory");
    Ok(())
}

/// Draws faces that are taken for two solids, one without the other: by room for few crossings as by room for many. A solid without
/// itself is nothing.
fn check_solids<S: ScreenPrecision, D: DepthWidth>(
    camera: &Camera,
    models: &[Model<'_, Rgb565>],
    part: &Window,
) -> Verdict {
    let mut frame = Memory::<DoubleSided<Look<S, D>>, 512, 24, 24, 24, 24>::new();
    let Ok(mut prepared) = frame.prepare(camera, models) else {
        return Ok(());
    };
    let mut draw =
        |method: &mut dyn FnMut(&mut Prepared<'_, '_, _>, &mut Band<'_, Rgb565, LittleEndian>) -> Verdict| {
            Canvas::new(*part).draw::<LittleEndian>(|band| method(&mut prepared, band))
        };
    let [first, second] = [SolidNode::Primitive(0..5), SolidNode::Primitive(5..u16::MAX)];
    let difference = [first.clone(), second, SolidNode::Difference];
    let nothing = [first.clone(), first, SolidNode::Difference];
    let drawn =
        draw(&mut |prepared, band| Ok(prepared.draw_by(&mut SolidCombination::<300, 30>::new(&difference), band)?))?;
    let selected =
        draw(&mut |prepared, band| Ok(prepared.draw_by(&mut SolidCombination::<300, 1>::new(&difference), band)?))?;
    is_same(part, &drawn, &selected).context("with room for 30 crossings, the other for one")?;
    let drawn =
        draw(&mut |prepared, band| Ok(prepared.draw_by(&mut SolidCombination::<300, 0>::new(&nothing), band)?))?;
    ensure!(
        drawn.iter().all(|color| *color == background()),
        "a solid without itself"
    );
    Ok(())
}

impl VisibilityCase {
    fn check_kind<S: ScreenPrecision, D: DepthWidth>(&self) -> Verdict {
        let Some(camera) = self.scene.camera() else {
            return Ok(());
        };
        let meshes = self.scene.meshes();
        let colors = colors(&meshes);
        let models = models(&meshes, &colors)?;
        let mut frame = Large::<S, D, true>::new();
        // What may be wrong with a frame is the scene's.
        let Ok(mut prepared) = frame.prepare(&camera, &models) else {
            return Ok(());
        };
        let viewport = camera.viewport();
        let [left, top, right, bottom] = self.part.map(|margin| i32::from(margin % 8) - 2);
        let part = Window {
            left: viewport.left + left,
            top: viewport.top + top,
            right: (viewport.right - right).max(viewport.left + left + 1),
            bottom: (viewport.bottom - bottom).max(viewport.top + top + 1),
        };
        let expected = Canvas::new(part).draw::<LittleEndian>(|band| {
            prepared.draw(band);
            Ok(())
        })?;
        for (point, expected) in part.to_rectangle().points().zip(&expected).step_by(5) {
            let seen = prepared.face_at(point).map_or(background(), color);
            ensure!(seen == *expected, "another face at {point:?}");
        }
        macro_rules! check {
            ($($method:expr, $is_enough:literal;)*) => {
                $(check_method::<S, D>(&mut prepared, &part, &expected, &mut $method, $is_enough)?;)*
            };
        }
        check! {
            DepthBuffer::<D, 576>::new(), true;
            DepthBuffer::<D, 99>::new(), false;
            DepthSort::<400, 50>::new(), true;
            DepthSort::<300, 1>::new(), true;
            DepthSort::<3, 2>::new(), false;
            GridRayCasting::<300, 512, 4_000>::new(), true;
            GridRayCasting::<300, 60, 200>::new(), true;
            GridRayCasting::<4, 8, 9>::new(), false;
            OneDepth::new(Polygons::winding_number), true;
            RayCasting::<300>::new(), true;
            RayCasting::<4>::new(), false;
            SpanScanLine::<24>::new(), true;
            SpanScanLine::<2>::new(), true;
            TileBins::<D, 4, 1_200>::new(), true;
            TileBins::<D, 2, 9>::new(), false;
            Warnock::<300>::new(), true;
            Warnock::<3, _>::by_region_codes(), true;
        }
        let edges: Vec<_> = meshes.iter().map(Mesh::edges).collect();
        let edges: Vec<_> = edges.iter().map(Vec::as_slice).collect();
        check_lines::<S, D>(&prepared, &edges)?;
        check_solids::<S, D>(&camera, &models, &part)
    }
}

impl Case for VisibilityCase {
    fn check(&self) -> Verdict {
        match self.kind {
            Kind::CoarseNarrow => self.check_kind::<Sub4, u16>(),
            Kind::CoarseWide => self.check_kind::<Sub4, u32>(),
            Kind::FineNarrow => self.check_kind::<Sub8, u16>(),
            Kind::FineWide => self.check_kind::<Sub8, u32>(),
        }
    }
}

/// Scenes as lines, with any tables of edges.
#[derive(Debug, Arbitrary)]
pub struct RobertsCase {
    scene: AnyScene,
    edges: List<AnyEdge, 9>,
    kind: Kind,
}

/// An edge of any two vertices and faces.
#[derive(Debug, Copy, Clone, Arbitrary)]
enum AnyEdge {
    Boundary([u8; 2], u8),
    Crease([u8; 2], [u8; 2]),
    Smooth([u8; 2], [u8; 2]),
}

impl AnyEdge {
    fn get(self) -> Edge {
        let few = |indices: [u8; 2]| indices.map(|index| u16::from(index) % 8);
        match self {
            Self::Boundary(vertices, face) => Edge::boundary(few(vertices), u16::from(face) % 8),
            Self::Crease(vertices, faces) => Edge::crease(few(vertices), few(faces)),
            Self::Smooth(vertices, faces) => Edge::smooth(few(vertices), few(faces)),
        }
    }
}

impl RobertsCase {
    fn check_kind<S: ScreenPrecision, D: DepthWidth>(&self) -> Verdict {
        let Some(camera) = self.scene.camera() else {
            return Ok(());
        };
        let meshes = self.scene.meshes();
        let colors = colors(&meshes);
        let models = models(&meshes, &colors)?;
        let mut frame = Large::<S, D, true>::new();
        let Ok(prepared) = frame.prepare(&camera, &models) else {
            return Ok(());
        };
        let edges: Vec<Edge> = self.edges.0.iter().map(|edge| edge.get()).collect();
        let tables = vec![edges.as_slice(); models.len()];
        check_parts(&prepared, &tables, &mut Roberts::<3, 80>::new(), true)?;
        check_parts(&prepared, &tables, &mut Roberts::<3, 6>::new(), false)?;
        check_parts(&prepared, &tables, &mut Roberts::<1, 80>::new(), false)
    }
}

/// Asks a method for its parts: they cover each edge without gaps, hidden and visible ones in turns; or an error, and nothing was
/// handed over.
fn check_parts<S: ScreenPrecision, D: DepthWidth>(
    prepared: &Prepared<'_, '_, Look<S, D>>,
    tables: &[&[Edge]],
    method: &mut impl HiddenLines<D>,
    is_enough: bool,
) -> Verdict {
    let mut parts = Vec::new();
    if let Err(error) = prepared.visible_parts(method, tables, |part| parts.push(part)) {
        ensure!(!is_enough, "{error} with room for all");
        ensure!(error.needed() > 0 && parts.is_empty(), "{error}, but handed over");
        return Ok(());
    }
    for (model, table) in tables.iter().enumerate() {
        for edge in prepared.edges(model, table) {
            let of_edge = parts
                .iter()
                .filter(|part| (part.model, part.edge) == (model, Some(edge.index)));
            let of_edge: Vec<_> = of_edge.collect();
            let [start, end] = edge.ends.map(|end| end.point);
            let (Some(first), Some(last)) = (of_edge.first(), of_edge.last()) else {
                ensure!(start == end, "no part of an edge");
                continue;
            };
            ensure!([first.ends[0], last.ends[1]] == [start, end], "not the whole edge");
            for two in of_edge.windows(2) {
                ensure!(two[0].ends[1] == two[1].ends[0], "a gap");
                ensure!(two[0].is_hidden != two[1].is_hidden, "two parts that are one");
            }
        }
    }
    Ok(())
}

impl Case for RobertsCase {
    fn check(&self) -> Verdict {
        match self.kind {
            Kind::CoarseNarrow => self.check_kind::<Sub4, u16>(),
            Kind::CoarseWide => self.check_kind::<Sub4, u32>(),
            Kind::FineNarrow => self.check_kind::<Sub8, u16>(),
            Kind::FineWide => self.check_kind::<Sub8, u32>(),
        }
    }
}
