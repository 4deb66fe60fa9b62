//! `zrow::visible`: scenes, lines, polygons and pixels by a state of the depth test.

use anyhow::{Context, ensure};
use arbitrary::Arbitrary;
use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::Point,
    pixelcolor::{
        Rgb565,
        raw::{RawData, RawU16},
    },
};
use fixed::types::I16F16;
use zrow::{
    band::LittleEndian,
    geometry::{Sub4, Sub8, TooSmall, Window},
    scan::FillRule,
    scene::{DepthWidth, Memory, Prepared, ScreenPrecision},
    visible::{Comparison, DepthLine, DepthPolygon, DepthState, PolygonOffset},
};
use zrow_methods::LookOf;

use crate::{
    families::any_scene::{AnyScene, Kind, Large, case_of_each_kind, colors, models},
    picture::{Canvas, is_same, sure},
    target::{Case, Verdict},
    values::{Int, List, Spot},
};

/// The look of a scene whose faces are cut.
type Look<S, D> = LookOf<Rgb565, S, D, true>;

/// Scenes, lines, polygons and pixels by a state of the depth test into the rows of another scene, whose viewport may be another one: in
/// one band and row by row from below, with room for all faces and for two in a row.
#[derive(Debug, Arbitrary)]
pub struct DepthStateCase {
    scenes: [AnyScene; 2],
    lines: List<[(Spot, u32); 2], 3>,
    /// Whether the inside of the polygon, whose contours are the vertices of the first scene, is found by the non-zero rule.
    is_nonzero: bool,
    comparison: AnyComparison,
    writes: bool,
    offset: [Int; 2],
    /// The range of depths, if it is not the whole one.
    range: Option<[u32; 2]>,
    kind: Kind,
}

#[derive(Debug, Copy, Clone, Arbitrary)]
enum AnyComparison {
    Never,
    Less,
    Equal,
    LessOrEqual,
    Greater,
    NotEqual,
    GreaterOrEqual,
    Always,
}

impl AnyComparison {
    const fn get(self) -> Comparison {
        match self {
            Self::Never => Comparison::Never,
            Self::Less => Comparison::Less,
            Self::Equal => Comparison::Equal,
            Self::LessOrEqual => Comparison::LessOrEqual,
            Self::Greater => Comparison::Greater,
            Self::NotEqual => Comparison::NotEqual,
            Self::GreaterOrEqual => Comparison::GreaterOrEqual,
            Self::Always => Comparison::Always,
        }
    }
}

/// A scene in which a row has two faces at once.
type Few<S, D> = Memory<Look<S, D>, 512, 24, 24, 24, 2>;

impl DepthStateCase {
    fn state<D: DepthWidth>(&self) -> DepthState<D> {
        let [factor, units] = self.offset.map(|number| number.0);
        let whole = [D::FARTHEST, D::NEAREST];
        DepthState {
            comparison: self.comparison.get(),
            writes: self.writes,
            offset: PolygonOffset {
                factor: I16F16::from_bits(factor),
                units,
            },
            range: self.range.map_or(whole, |range| range.map(D::from_interpolated)),
        }
    }

    fn check_kind<S: ScreenPrecision, D: DepthWidth>(&self) -> Verdict {
        let [first, second] = &self.scenes;
        let (Some(camera), Some(other_camera)) = (first.camera(), second.camera()) else {
            return Ok(());
        };
        let (meshes, other_meshes) = (first.meshes(), second.meshes());
        let (colors, other_colors) = (colors(&meshes), colors(&other_meshes));
        let (models, other_models) = (models(&meshes, &colors)?, models(&other_meshes, &other_colors)?);
        let (mut frame, mut large, mut few) = (
            Large::<S, D, true>::new(),
            Large::<S, D, true>::new(),
            Few::<S, D>::new(),
        );
        // What may be wrong with a frame is the scene's.
        let (Ok(mut prepared), Ok(mut all), Ok(mut in_passes)) = (
            frame.prepare(&camera, &models),
            large.prepare(&other_camera, &other_models),
            few.prepare(&other_camera, &other_models),
        ) else {
            return Ok(());
        };
        let (state, viewport) = (self.state::<D>(), camera.viewport());
        let origin = Point::new(viewport.left, viewport.top);
        let lines = self.lines.0.iter();
        let ends = |ends: &[(Spot, u32); 2]| {
            DepthLine::new([0, 1].map(|end: usize| (ends[end].0.from(origin), D::from_interpolated(ends[end].1))))
        };
        let lines: Vec<DepthLine<D>> = lines.map(ends).collect();
        let (mut polygon, mut small) = (DepthPolygon::<D, 256>::new(), DepthPolygon::<D, 3>::new());
        let contours: Vec<&[[i16; 3]]> = meshes.iter().map(|mesh| mesh.vertices.as_slice()).collect();
        let rule = if self.is_nonzero {
            FillRule::NonZero
        } else {
            FillRule::EvenOdd
        };
        if let Some(mesh) = meshes.first() {
            // Seven corners a contour; each of six planes makes at most three of two.
            prepared.prepare_polygon(&mut polygon, &mesh.pose, &contours, rule)?;
            let fits = prepared.prepare_polygon(&mut small, &mesh.pose, &contours, rule);
            ensure!(matches!(fits, Ok(()) | Err(TooSmall::Edges(4..=256))), "{fits:?}");
        }
        let mut draw = |part: Window, other: &mut Prepared<'_, '_, Look<S, D>>| {
            Canvas::new(part).draw::<LittleEndian>(|band| {
                prepared.draw_with(band, |row| {
                    other.draw_in(row, &state);
                    row.draw_polygon(&mut polygon, Rgb565::from(RawU16::from_u32(0x0103)), &state);
                    row.draw_polygon(&mut small, Rgb565::from(RawU16::from_u32(0x0104)), &state);
                    for line in &lines {
                        row.draw_line(line, Rgb565::from(RawU16::from_u32(0x0101)), &state);
                    }
                    let pixels = self.lines.0.iter().flatten().map(|(spot, _)| spot.from(origin));
                    let pixels = pixels.map(|point| Pixel(point, Rgb565::from(RawU16::from_u32(0x0102))));
                    sure(
                        row.at_depth_with(D::from_interpolated(u32::MAX / 3), &state)
                            .draw_iter(pixels),
                    );
                });
                Ok(())
            })
        };
        let expected = draw(viewport, &mut all)?;
        let found = draw(viewport, &mut in_passes)?;
        is_same(&viewport, &expected, &found).context("the other with two faces in a row")?;
        for row in (viewport.top..viewport.bottom).rev() {
            let part = Window {
                top: row,
                bottom: row + 1,
                ..viewport
            };
            let width = viewport.width() as usize;
            let first = (row - viewport.top) as usize * width;
            let expected = expected.get(first..first + width).unwrap_or_default();
            is_same(&part, expected, &draw(part, &mut all)?).context("the other row by row")?;
        }
        Ok(())
    }
}

case_of_each_kind!(DepthStateCase);
