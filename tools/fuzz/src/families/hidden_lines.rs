//! `zrow::visible`: any edges by all methods of hidden lines, with memory that is enough or not.

use anyhow::ensure;
use arbitrary::Arbitrary;
use embedded_graphics::pixelcolor::Rgb565;
use zrow::{
    geometry::{Sub4, Sub8},
    scene::{DepthWidth, Edge, Prepared, ScreenPrecision},
    visible::{Appel, FaceAgainstSegment, HiddenLines, LinePart, Roberts},
};
use zrow_methods::LookOf;

use crate::{
    families::any_scene::{AnyScene, Kind, Mesh, case_of_each_kind},
    target::{Case, Verdict},
    values::List,
};

/// The look of a scene whose faces are cut.
type Look<S, D> = LookOf<Rgb565, S, D, true>;

/// Scenes as lines: with the sides of all faces as edges, and with any table of edges.
#[derive(Debug, Arbitrary)]
pub struct HiddenLinesCase {
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

impl HiddenLinesCase {
    fn check_kind<S: ScreenPrecision, D: DepthWidth>(&self) -> Verdict {
        let sides: Vec<_> = self.scene.meshes().iter().map(Mesh::edges).collect();
        let sides: Vec<_> = sides.iter().map(Vec::as_slice).collect();
        let edges: Vec<Edge> = self.edges.0.iter().map(|edge| edge.get()).collect();
        let any = vec![edges.as_slice(); sides.len()];
        self.scene.with_prepared::<S, D>(|_, _, prepared| {
            check_methods::<S, D>(&prepared, &sides)?;
            check_methods::<S, D>(&prepared, &any)
        })
    }
}

case_of_each_kind!(HiddenLinesCase);

/// The parts of all edges by a method: those of one edge are a chain, in turns hidden and visible, that is all of it. `None` where
/// the method has too little memory; then nothing was handed over.
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
    for (model, table) in edges.iter().enumerate() {
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
    Ok(Some(parts))
}

/// The same parts however little memory a method has.
fn check_methods<S: ScreenPrecision, D: DepthWidth>(
    prepared: &Prepared<'_, '_, Look<S, D>>,
    edges: &[&[Edge]],
) -> Verdict {
    let expected = parts_by::<S, D>(prepared, edges, &mut FaceAgainstSegment::<300, 16, true>::new())?;
    ensure!(expected.is_some(), "no room for all faces");
    let without_stack = parts_by::<S, D>(prepared, edges, &mut FaceAgainstSegment::<300, 0, true>::new())?;
    ensure!(without_stack == expected, "other parts without a stack");
    let with_few = parts_by::<S, D>(prepared, edges, &mut FaceAgainstSegment::<4, 2, true>::new())?;
    ensure!(with_few.is_none() || with_few == expected, "other parts with few faces");
    let by_rays = parts_by::<S, D>(prepared, edges, &mut Appel::<0, 0, 0, true>::new())?;
    ensure!(by_rays.is_some(), "no room for quantitative invisibility");
    let carried = parts_by::<S, D>(prepared, edges, &mut Appel::<300, 16, 600, true>::new())?;
    ensure!(carried == by_rays, "another number than by rays");
    let with_few = parts_by::<S, D>(prepared, edges, &mut Appel::<5, 1, 9, true>::new())?;
    ensure!(with_few == by_rays, "another number with little memory");
    let convex = parts_by::<S, D>(prepared, edges, &mut Roberts::<3, 80>::new())?;
    ensure!(convex.is_some(), "no room for three solids");
    for too_little in [
        parts_by::<S, D>(prepared, edges, &mut Roberts::<3, 6>::new())?,
        parts_by::<S, D>(prepared, edges, &mut Roberts::<1, 80>::new())?,
    ] {
        ensure!(
            too_little.is_none() || too_little == convex,
            "other parts with few planes or solids"
        );
    }
    Ok(())
}
