//! `zrow::visible`: any faces by all methods of visibility, with memory that is enough or not.

use anyhow::{Context, bail, ensure};
use arbitrary::Arbitrary;
use embedded_graphics::{pixelcolor::Rgb565, primitives::PointsIter};
use zrow::{
    band::{Band, LittleEndian},
    geometry::{Sub4, Sub8, TooSmall, Window},
    scan::Polygons,
    scene::{Antialiased, Camera, DepthWidth, DoubleSided, Memory, Model, Prepared, ScreenPrecision, VisibleBy},
    visible::{
        DepthBuffer, DepthSort, GridRayCasting, OneDepth, RayCasting, SolidCombination, SolidNode, SpanScanLine,
        TileBins, Visibility, Warnock, Work,
    },
};
use zrow_methods::LookOf;

use crate::{
    families::any_scene::{AnyScene, Kind, case_of_each_kind, color},
    picture::{Canvas, background, is_same},
    target::{Case, Verdict},
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

/// A part of the picture, as the depth row draws it.
struct Expected<'e> {
    part: &'e Window,
    colors: &'e [Rgb565],
}

impl Expected<'_> {
    /// Draws the part by a method.
    fn check<S: ScreenPrecision, D: DepthWidth>(
        &self,
        prepared: &mut Prepared<'_, '_, Look<S, D>>,
        method: &mut impl Visibility<D>,
        is_enough: bool,
    ) -> Verdict {
        self.check_drawn(is_enough, |band| prepared.draw_by(method, band))
    }

    /// Draws the part by a method that reports its work, which lies in the part.
    fn check_with_work<S: ScreenPrecision, D: DepthWidth>(
        &self,
        prepared: &mut Prepared<'_, '_, Look<S, D>>,
        method: &mut impl Visibility<D>,
        is_enough: bool,
    ) -> Verdict {
        let mut is_within = true;
        self.check_drawn(is_enough, |band| {
            prepared.draw_by_with(method, band, |work| is_within &= lies_within(&work, self.part))
        })?;
        ensure!(is_within, "work beside what is drawn");
        Ok(())
    }

    /// Draws the part: the picture of the depth row; or an error, and nothing was drawn.
    fn check_drawn(
        &self,
        is_enough: bool,
        draw: impl FnOnce(&mut Band<'_, Rgb565, LittleEndian>) -> Result<(), TooSmall>,
    ) -> Verdict {
        let mut result = Ok(());
        let drawn = Canvas::new(*self.part).draw::<LittleEndian>(|band| {
            result = draw(band);
            Ok(())
        })?;
        match result {
            Ok(()) => is_same(self.part, self.colors, &drawn).context("by the depth row, the other by a method"),
            Err(error) if is_enough => bail!("{error} with room for all"),
            Err(error) => {
                ensure!(error.needed() > 0, "{error}");
                ensure!(drawn.iter().all(|color| *color == background()), "{error}, but drawn");
                Ok(())
            }
        }
    }
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

/// Draws faces with antialiased silhouettes by the painter's algorithm: with room for parts as without, and the picture of the depth row
/// if no face is cut.
fn check_silhouettes<S: ScreenPrecision, D: DepthWidth>(
    camera: &Camera,
    models: &[Model<'_, Rgb565>],
    part: &Window,
) -> Verdict {
    let mut frame = Memory::<Antialiased<Look<S, D>>, 512, 24, 24, 24, 24>::new();
    let Ok(mut prepared) = frame.prepare(camera, models) else {
        return Ok(());
    };
    let vertices = models.iter().map(|model| model.mesh().vertices().len()).sum::<usize>();
    let is_cut = prepared.vertices_needed() > vertices;
    let mut draw =
        |method: &mut dyn FnMut(&mut Prepared<'_, '_, _>, &mut Band<'_, Rgb565, LittleEndian>) -> Verdict| {
            Canvas::new(*part).draw::<LittleEndian>(|band| method(&mut prepared, band))
        };
    let drawn = draw(&mut |prepared, band| Ok(prepared.draw_by(&mut DepthSort::<400, 50>::new(), band)?))?;
    let whole = draw(&mut |prepared, band| Ok(prepared.draw_by(&mut DepthSort::<300, 0>::new(), band)?))?;
    is_same(part, &drawn, &whole).context("with silhouettes and room for parts, the other without")?;
    if is_cut {
        return Ok(());
    }
    let by_row = draw(&mut |prepared, band| {
        prepared.draw(band);
        Ok(())
    })?;
    is_same(part, &by_row, &drawn).context("with silhouettes by the depth row, the other by the painter's algorithm")
}

/// Draws faces in looks that name a method, with memory that is enough for it or not: the picture of the depth row.
fn check_named<S: ScreenPrecision, D: DepthWidth>(
    camera: &Camera,
    models: &[Model<'_, Rgb565>],
    expected: &Expected<'_>,
) -> Verdict {
    macro_rules! check {
        ($($method:ty;)*) => {$(
            let mut memory = Memory::<VisibleBy<$method, Look<S, D>>, 512, 24, 24, 24, 24>::new();
            let mut prepared = memory.prepare(camera, models)?;
            let drawn = Canvas::new(*expected.part).draw::<LittleEndian>(|band| {
                prepared.draw(band);
                Ok(())
            })?;
            is_same(expected.part, expected.colors, &drawn)
                .context(concat!("by the depth row, the other in a look by ", stringify!($method)))?;
        )*};
    }
    check! {
        SpanScanLine<24>;
        DepthSort<3, 2>;
    }
    Ok(())
}

impl VisibilityCase {
    fn check_kind<S: ScreenPrecision, D: DepthWidth>(&self) -> Verdict {
        self.scene
            .with_prepared::<S, D>(|camera, models, prepared| self.check_methods::<S, D>(camera, models, prepared))
    }

    fn check_methods<S: ScreenPrecision, D: DepthWidth>(
        &self,
        camera: &Camera,
        models: &[Model<'_, Rgb565>],
        mut prepared: Prepared<'_, '_, Look<S, D>>,
    ) -> Verdict {
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
        let mut grid = GridRayCasting::<400, 200, 900>::new();
        let mut face_at = prepared.picking(&mut grid)?;
        for (point, expected) in part.to_rectangle().points().zip(&expected).step_by(5) {
            let seen = prepared.face_at(point);
            ensure!(
                seen.map_or(background(), color) == *expected,
                "another face at {point:?}"
            );
            ensure!(face_at(point) == seen, "another face through a grid at {point:?}");
        }
        drop(face_at);
        let expected = Expected {
            part: &part,
            colors: &expected,
        };
        macro_rules! check {
            ($($check:ident: $method:expr, $is_enough:literal;)*) => {
                $(expected.$check::<S, D>(&mut prepared, &mut $method, $is_enough)?;)*
            };
        }
        // Each method reports its work once: what reports is compiled anew.
        check! {
            check_with_work: DepthBuffer::<D, 576>::new(), true;
            check: DepthBuffer::<D, 99>::new(), false;
            check_with_work: DepthSort::<400, 50>::new(), true;
            check: DepthSort::<300, 1>::new(), true;
            check: DepthSort::<3, 2>::new(), false;
            check: GridRayCasting::<300, 512, 4_000>::new(), true;
            check_with_work: GridRayCasting::<300, 60, 200>::new(), true;
            check: GridRayCasting::<4, 8, 9>::new(), false;
            check_with_work: OneDepth::new(Polygons::winding_number), true;
            check_with_work: RayCasting::<300>::new(), true;
            check: RayCasting::<4>::new(), false;
            check: SpanScanLine::<24>::new(), true;
            check_with_work: SpanScanLine::<2>::new(), true;
            check_with_work: TileBins::<D, 4, 1_200>::new(), true;
            check: TileBins::<D, 2, 9>::new(), false;
            check_with_work: Warnock::<300>::new(), true;
            check: Warnock::<3, _>::by_region_codes(), true;
        }
        check_named::<S, D>(camera, models, &expected)?;
        check_silhouettes::<S, D>(camera, models, &part)?;
        check_solids::<S, D>(camera, models, &part)
    }
}

case_of_each_kind!(VisibilityCase);
