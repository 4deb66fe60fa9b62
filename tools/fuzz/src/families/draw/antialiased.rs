//! Outlines with antialiased edges, drawn over what is there.

use anyhow::{Context, ensure};
use arbitrary::Arbitrary;
use embedded_graphics::{
    pixelcolor::{Gray8, Rgb565},
    prelude::{Dimensions, GrayColor},
    primitives::PointsIter,
};
use fixed::types::{U0F16, U24F8};
use zrow::{
    band::{Band, Order},
    coverage::{AnyCoverage, CoverageMethod, Rooks, SamplePattern},
    draw::{AntialiasedPolygon, FillRule, FilteredLine, Path, SubArc, SubEllipse, SubLine, SubOutline},
    geometry::{InputError, Sub8, SubPixel, SubPoint},
};

use crate::{
    picture::{OnBand, agree_on_bands, background},
    target::{Case, Verdict},
    values::{Command, Hue, List, Number, Rule, Stage, SubContours, SubSpot, commands},
};

/// Room for every outline here, but for the largest ellipses.
pub const EDGES: usize = 256;
/// Edges in a row of pixels.
pub const ACTIVE: usize = 96;
/// An outline that is set up.
pub type Prepared = AntialiasedPolygon<EDGES, ACTIVE>;

/// An outline of any kind.
#[derive(Debug, Arbitrary)]
pub enum Outline {
    /// Contours of points of the domain.
    Contours(SubContours<2, 8>),
    /// Contours of points of any bits.
    ByHand(SubContours<2, 6>),
    /// A path, flattened.
    Path(List<Command, 4>),
    /// A line of a width in 1/256 pixel.
    Line([SubSpot; 2], Number<u32>),
    /// An ellipse of two radii in 1/256 pixel.
    Ellipse(SubSpot, [Number<u16>; 2]),
    /// An ellipse of any radii.
    AnyEllipse(SubSpot, [Number<u32>; 2]),
    /// An arc between two radii in 1/256 pixel and two angles in 1/65,536 turn.
    Arc(SubSpot, [Number<u16>; 2], [u16; 2]),
}

/// What can be drawn of an outline.
pub trait WithOutline {
    /// Uses it.
    ///
    /// # Errors
    /// Says what does not hold.
    fn check<O: SubOutline + ?Sized>(self, outline: &O) -> Verdict;
}

impl Outline {
    /// Makes the outline and hands it over; nothing where it has none. Points that were made by hand are handed over as they
    /// are.
    ///
    /// # Errors
    /// Says what does not hold.
    pub fn with(&self, stage: &Stage, rule: FillRule, check: impl WithOutline) -> Verdict {
        let width = |bits: Number<u32>| U24F8::from_bits(bits.0);
        let radii = |radii: [Number<u16>; 2]| radii.map(|radius| U24F8::from_bits(radius.0.into()));
        match self {
            Self::Contours(contours) => {
                let contours = contours.inside::<Sub8>(stage);
                let slices: Vec<_> = contours.iter().map(Vec::as_slice).collect();
                check.check(slices.as_slice())
            }
            Self::ByHand(contours) => {
                let contours = contours.by_hand::<Sub8>(stage);
                let slices: Vec<_> = contours.iter().map(Vec::as_slice).collect();
                check.check(slices.as_slice())
            }
            Self::Path(list) => {
                let commands = commands::<Sub8, 4>(list, stage, true);
                let path = Path::new(&commands, rule).context("points of the domain are outside of it")?;
                check.check(&path)
            }
            Self::Line([from, to], bits) => {
                let line = SubLine::new(from.by_hand(stage), to.by_hand(stage), width(*bits));
                line.map_or(Ok(()), |line| check.check(&line))
            }
            Self::Ellipse(center, of) => {
                let ellipse = SubEllipse::new(center.by_hand(stage), radii(*of));
                ellipse.map_or(Ok(()), |ellipse| check.check(&ellipse))
            }
            Self::AnyEllipse(center, of) => {
                let ellipse = SubEllipse::new(center.by_hand(stage), of.map(width));
                ellipse.map_or(Ok(()), |ellipse| check.check(&ellipse))
            }
            Self::Arc(center, of, [start, sweep]) => {
                let arc = SubArc::new(
                    center.by_hand(stage),
                    radii(*of),
                    U0F16::from_bits(*start),
                    U0F16::from_bits(*sweep),
                );
                arc.map_or(Ok(()), |arc| check.check(&arc))
            }
        }
    }
}

/// An outline, drawn by a method of its own choice, in linear light and by samples.
#[derive(Debug, Arbitrary)]
pub struct AntialiasedCase {
    stage: Stage,
    outline: Outline,
    rule: Rule,
    hue: Hue,
    variant: Variant,
}

#[derive(Debug, Copy, Clone, PartialEq, Eq, Arbitrary)]
enum Variant {
    Band,
    LinearLight,
    Samples,
}

struct Drawing<'d> {
    polygon: &'d Prepared,
    method: AnyCoverage,
    variant: Variant,
    color: Rgb565,
}

impl OnBand for Drawing<'_> {
    fn draw_on_band<O: Order>(&self, band: &mut Band<'_, Rgb565, O>) -> Verdict {
        let Self {
            polygon, method, color, ..
        } = self;
        let area = band.bounding_box().size;
        let mut memory = vec![0; AnyCoverage::cells(area.width as usize)];
        match self.variant {
            Variant::Band => polygon.draw(method, *color, band, &mut memory)?,
            Variant::LinearLight => polygon.draw(method, *color, &mut band.in_linear_light::<22>(), &mut memory)?,
            Variant::Samples => {
                let mut samples = vec![0; Rooks::<4>::SAMPLES * (area.width * area.height) as usize];
                let mut memory = vec![0; Rooks::<4>::cells(area.width as usize)];
                band.multisample(Rooks::<4>, &mut samples, |samples| {
                    polygon.draw_samples(*color, samples, &mut memory)
                })??;
                ensure!(memory.iter().all(|cell| *cell == 0), "the row memory is not as it was");
            }
        }
        ensure!(memory.iter().all(|cell| *cell == 0), "the row memory is not as it was");
        Ok(())
    }
}

struct CheckDrawing<'c>(&'c AntialiasedCase);

impl WithOutline for CheckDrawing<'_> {
    fn check<O: SubOutline + ?Sized>(self, outline: &O) -> Verdict {
        let AntialiasedCase {
            stage,
            rule,
            hue,
            variant,
            ..
        } = self.0;
        let small = AntialiasedPolygon::<6, 3>::prepare(outline, rule.get());
        let Ok(polygon) = Prepared::prepare(outline, rule.get()) else {
            ensure!(small.is_err(), "a small table has room where a large one has none");
            return Ok(());
        };
        let method = polygon.exact_method(outline);
        let drawing = Drawing {
            polygon: &polygon,
            method,
            variant: *variant,
            color: hue.color(),
        };
        let picture = agree_on_bands(stage, &drawing)?;
        if let Ok(small) = small {
            let mut window = Vec::new();
            let mut memory = vec![0; AnyCoverage::cells(stage.window.width() as usize)];
            for polygon in [true, false] {
                let mut coverages = Vec::new();
                let emit = |span, coverage| {
                    coverages.push((span, coverage));
                    Ok::<_, zrow::geometry::TooSmall>(())
                };
                if polygon {
                    small.cover(&method, &stage.window, &mut memory, emit)?;
                } else {
                    drawing.polygon.cover(&method, &stage.window, &mut memory, emit)?;
                }
                window.push(coverages);
            }
            ensure!(window[0] == window[1], "a small table gives another picture");
        }
        // What it covers wholly has its colour, and what it does not cover the background.
        let mut memory = vec![0; AnyCoverage::cells(stage.window.width() as usize)];
        let mut nothing = true;
        polygon.cover(&method, &stage.window, &mut memory, |_, coverage| {
            nothing &= coverage == 0;
            Ok::<_, zrow::geometry::TooSmall>(())
        })?;
        let is_untouched = picture.iter().all(|color| *color == background());
        ensure!(
            *variant == Variant::Samples || !nothing || is_untouched,
            "what covers nothing is drawn"
        );
        Ok(())
    }
}

impl Case for AntialiasedCase {
    fn check(&self) -> Verdict {
        self.outline.with(&self.stage, self.rule.get(), CheckDrawing(self))
    }
}

/// A line filtered by a cone.
#[derive(Debug, Arbitrary)]
pub struct FilteredLineCase {
    stage: Stage,
    ends: [SubSpot; 2],
    hue: Hue,
}

struct Filtered {
    line: FilteredLine,
    color: Rgb565,
}

impl OnBand for Filtered {
    fn draw_on_band<O: Order>(&self, band: &mut Band<'_, Rgb565, O>) -> Verdict {
        let Ok(()) = self.line.draw(band, self.color);
        Ok(())
    }
}

impl Case for FilteredLineCase {
    fn check(&self) -> Verdict {
        let Self { stage, ends, hue } = self;
        let [from, to]: [SubPoint<Sub8>; 2] = ends.map(|end| end.by_hand(stage));
        let color = hue.color();
        let line = FilteredLine::new(from, to);
        let is_inside = |point: SubPoint<Sub8>| {
            let domain = Sub8::MIN_UNITS..=Sub8::MAX_UNITS;
            domain.contains(&point.x_units()) && domain.contains(&point.y_units())
        };
        ensure!(
            line.is_ok() == (is_inside(from) && is_inside(to)),
            "{line:?} between {from:?} and {to:?}"
        );
        let Ok(line) = line else { return Ok(()) };
        let picture = agree_on_bands(stage, &Filtered { line, color })?;
        if let Ok(line) = FilteredLine::new(to, from) {
            let reversed = agree_on_bands(stage, &Filtered { line, color })?;
            ensure!(picture == reversed, "the order of the ends counts");
        }
        let bounds = zrow::geometry::Window::from(line.bounding_box());
        let outside = stage.area().points().zip(&picture);
        let outside = outside
            .filter(|(point, _)| !bounds.contains(*point))
            .all(|(_, color)| *color == background());
        ensure!(outside, "a pixel lies outside of the box {bounds:?}");
        Ok(())
    }
}

/// The ends of the domain are where they are said to be.
#[derive(Debug, Arbitrary)]
pub struct SubShapeCase {
    stage: Stage,
    center: SubSpot,
    other: SubSpot,
    lengths: [Number<u32>; 2],
    angles: [u16; 2],
}

impl Case for SubShapeCase {
    fn check(&self) -> Verdict {
        let (center, other) = (self.center.by_hand(&self.stage), self.other.by_hand(&self.stage));
        let [one, two] = self.lengths.map(|length| U24F8::from_bits(length.0));
        let [start, sweep] = self.angles.map(U0F16::from_bits);
        corners_are_inside(SubEllipse::new(center, [one, two]))?;
        corners_are_inside(SubEllipse::circle(center, one))?;
        corners_are_inside(SubArc::new(center, [one, two], start, sweep))?;
        corners_are_inside(SubLine::new(center, other, one))?;
        // What is small and in the middle of the domain is never outside of it.
        let small = U24F8::from_bits(self.lengths[0].0 % (1 << 20));
        let middle = SubPoint::<Sub8>::default();
        ensure!(
            SubEllipse::circle(middle, small).is_ok(),
            "a circle of {small} pixels is refused"
        );
        ensure!(
            SubLine::new(middle, middle, small).is_ok(),
            "a line {small} pixels wide is refused"
        );
        Ok(())
    }
}

/// Every corner of what is not refused is in the domain; there are no more than the documented 3,200 edges of a turn, twice.
fn corners_are_inside<O: SubOutline>(outline: Result<O, InputError>) -> Verdict {
    let Ok(outline) = outline else { return Ok(()) };
    let (mut edges, mut outside) = (0u32, None);
    outline.edges(&mut |from, to| {
        edges += 1;
        let domain = Sub8::MIN_UNITS..=Sub8::MAX_UNITS;
        let corners = from.iter().chain(&to);
        if !corners.clone().all(|units| domain.contains(units)) {
            outside = Some((from, to));
        }
    });
    ensure!(outside.is_none(), "the edge {outside:?} leaves the domain");
    ensure!(edges <= 2 * 3_202, "{edges} edges");
    Ok(())
}

/// Colours of one channel are blended as those of three.
#[derive(Debug, Arbitrary)]
pub struct GreyCase {
    stage: Stage,
    outline: Outline,
    rule: Rule,
}

struct CheckGrey<'c>(&'c GreyCase);

impl WithOutline for CheckGrey<'_> {
    fn check<O: SubOutline + ?Sized>(self, outline: &O) -> Verdict {
        let GreyCase { stage, rule, .. } = self.0;
        let Ok(polygon) = Prepared::prepare(outline, rule.get()) else {
            return Ok(());
        };
        // White over black is the coverage itself.
        let mut words = vec![0u8; stage.pixels()];
        let mut band = Band::<Gray8>::new(stage.area(), &mut words)?;
        let mut memory = vec![0; AnyCoverage::cells(stage.window.width() as usize)];
        polygon.draw(&AnyCoverage::InsideArea, Gray8::WHITE, &mut band, &mut memory)?;
        let mut coverages = vec![0u8; stage.pixels()];
        polygon.cover(
            &AnyCoverage::InsideArea,
            &stage.window,
            &mut memory,
            |span, coverage| {
                for x in span.start..span.end {
                    let (column, row) = (x.abs_diff(stage.window.left), span.y.abs_diff(stage.window.top));
                    coverages[(row * stage.window.width() + column) as usize] = coverage;
                }
                Ok::<_, zrow::geometry::TooSmall>(())
            },
        )?;
        ensure!(words == coverages, "white over black is not the coverage");
        Ok(())
    }
}

impl Case for GreyCase {
    fn check(&self) -> Verdict {
        self.outline.with(&self.stage, self.rule.get(), CheckGrey(self))
    }
}
