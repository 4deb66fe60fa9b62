//! Closed shapes of whole pixels: each pixel once, embedded-graphics' pixels, the exact ones at any size.

use anyhow::{Context, ensure};
use arbitrary::Arbitrary;
use embedded_graphics::{
    draw_target::DrawTargetExt,
    geometry::{Dimensions, Point},
    pixelcolor::Rgb565,
    prelude::{Drawable, Primitive},
    primitives::{
        self, Arc, Circle, CornerRadii, Ellipse, PointsIter, PrimitiveStyleBuilder, Rectangle, RoundedRectangle,
        Sector, Styled, StyledDrawable, Triangle,
    },
};
use zrow::{
    draw::{DrawOn, PrimitiveStyle, ThinCircle},
    geometry::Window,
};

use crate::{
    exact,
    picture::{Sheet, Work, agree_styled, background, full_picture, is_same},
    target::{Case, Verdict},
    values::{Degrees, Hue, Length, Spot, Stage, Style},
};

/// A shape within which embedded-graphics' own numbers are far from overflowing.
fn suits_peer(stage: &Stage, spots: &[Spot], lengths: &[u32]) -> bool {
    let window = stage.window;
    let is_near = |side: i32| (-2_000..=2_000).contains(&side);
    [window.left, window.top].into_iter().all(is_near)
        && spots.iter().all(|spot| spot.is_near())
        && lengths.iter().all(|length| *length <= 60)
}

/// embedded-graphics' picture of a shape.
fn peer_picture<S>(stage: &Stage, shape: S, style: Style) -> anyhow::Result<Vec<Rgb565>>
where
    S: Primitive + StyledDrawable<primitives::PrimitiveStyle<Rgb565>, Color = Rgb565, Output = ()>,
{
    let mut sheet = Sheet::new(stage.window, background());
    let area = sheet.bounding_box();
    let drawn = shape.into_styled(style.peer()).draw(&mut sheet.clipped(&area));
    ensure!(drawn.is_ok(), "an error that nobody told");
    Ok(sheet.pixels().to_vec())
}

/// Whether a filled shape has exactly the pixels that a test says.
fn has_pixels(
    stage: &Stage,
    filled: &impl zrow::draw::DrawOn<Color = Rgb565>,
    belongs: impl Fn(Point) -> bool,
) -> Verdict {
    let color = Hue::Odd.color();
    let picture = full_picture(stage.window, filled)?;
    let expected: Vec<_> = stage
        .area()
        .points()
        .map(|point| if belongs(point) { color } else { background() })
        .collect();
    is_same(&stage.window, &expected, &picture).context("by definition, the other drawn")
}

/// Whether a filled circle or ellipse has the pixels of its inequality.
fn has_pixels_of_ellipse<S>(stage: &Stage, shape: S) -> Verdict
where
    S: Primitive + Dimensions,
    Styled<S, PrimitiveStyle<Rgb565>>: DrawOn<Color = Rgb565>,
{
    let area = shape.bounding_box();
    has_pixels(stage, &shape.into_styled(with_fill()), |point| {
        exact::ellipse_has(&area, point)
    })
}

fn with_fill() -> PrimitiveStyle<Rgb565> {
    PrimitiveStyle::with_fill(Hue::Odd.color())
}

/// A rectangle.
#[derive(Debug, Arbitrary)]
pub struct RectangleCase {
    stage: Stage,
    corner: Spot,
    width: Length,
    height: Length,
    style: Style,
}

impl Case for RectangleCase {
    fn check(&self) -> Verdict {
        let Self { stage, style, .. } = self;
        let shape = Rectangle::new(stage.point(self.corner), self.width.by(self.height));
        let picture = agree_styled(stage, shape, *style, Work::ONCE)?;
        if suits_peer(stage, &[self.corner], &[self.width.0, self.height.0, style.width()]) {
            is_same(&stage.window, &peer_picture(stage, shape, *style)?, &picture)
                .context("embedded-graphics, zrow")?;
        }
        let window = Window::from(shape);
        has_pixels(stage, &shape.into_styled(with_fill()), |point| window.contains(point))
    }
}

/// A rectangle with rounded corners, all alike or each another one.
#[derive(Debug, Arbitrary)]
pub struct RoundedRectangleCase {
    stage: Stage,
    corner: Spot,
    width: Length,
    height: Length,
    radii: [Length; 8],
    alike: bool,
    style: Style,
}

impl Case for RoundedRectangleCase {
    fn check(&self) -> Verdict {
        let radius = |corner: usize| self.radii[2 * corner].by(self.radii[2 * corner + 1]);
        let corners = if self.alike {
            CornerRadii::new(radius(0))
        } else {
            CornerRadii {
                top_left: radius(0),
                top_right: radius(1),
                bottom_right: radius(2),
                bottom_left: radius(3),
            }
        };
        let area = Rectangle::new(self.stage.point(self.corner), self.width.by(self.height));
        let shape = RoundedRectangle::new(area, corners);
        agree_styled(&self.stage, shape, self.style, Work::ONCE).map(drop)
    }
}

/// A circle in its box.
#[derive(Debug, Arbitrary)]
pub struct CircleCase {
    stage: Stage,
    corner: Spot,
    diameter: Length,
    style: Style,
}

impl Case for CircleCase {
    fn check(&self) -> Verdict {
        let Self { stage, style, .. } = self;
        let shape = Circle::new(stage.point(self.corner), self.diameter.0);
        let picture = agree_styled(stage, shape, *style, Work::ONCE)?;
        if suits_peer(stage, &[self.corner], &[self.diameter.0, style.width()]) {
            is_same(&stage.window, &peer_picture(stage, shape, *style)?, &picture)
                .context("embedded-graphics, zrow")?;
        }
        has_pixels_of_ellipse(stage, shape)
    }
}

/// An ellipse in its box.
#[derive(Debug, Arbitrary)]
pub struct EllipseCase {
    stage: Stage,
    corner: Spot,
    width: Length,
    height: Length,
    style: Style,
}

impl Case for EllipseCase {
    fn check(&self) -> Verdict {
        let Self { stage, style, .. } = self;
        let shape = Ellipse::new(stage.point(self.corner), self.width.by(self.height));
        let picture = agree_styled(stage, shape, *style, Work::ONCE)?;
        // embedded-graphics draws no row of an ellipse that has none in the first row of its box.
        let has_first_row = |by: i32| {
            let area = shape.bounding_box().offset(by);
            let middle = Point::new(area.top_left.x + (area.size.width / 2) as i32, area.top_left.y);
            area.is_zero_sized() || exact::ellipse_has(&area, middle)
        };
        let suits_peer = suits_peer(stage, &[self.corner], &[self.width.0, self.height.0, style.width()]);
        if suits_peer && (-(style.width() as i32)..=style.width() as i32).all(has_first_row) {
            is_same(&stage.window, &peer_picture(stage, shape, *style)?, &picture)
                .context("embedded-graphics, zrow")?;
        }
        has_pixels_of_ellipse(stage, shape)
    }
}

/// Bresenham's circle about a pixel.
#[derive(Debug, Arbitrary)]
pub struct ThinCircleCase {
    stage: Stage,
    center: Spot,
    radius: Length,
    style: Style,
}

impl Case for ThinCircleCase {
    fn check(&self) -> Verdict {
        let shape = ThinCircle::new(self.stage.point(self.center), self.radius.0);
        agree_styled(&self.stage, shape, self.style, Work::ONCE).map(drop)
    }
}

/// A circle between two angles.
#[derive(Debug, Arbitrary)]
pub struct ArcCase {
    stage: Stage,
    corner: Spot,
    diameter: Length,
    angles: [Degrees; 2],
    in_radians: bool,
    style: Style,
}

impl ArcCase {
    fn angles(&self) -> [embedded_graphics::geometry::Angle; 2] {
        self.angles.map(if self.in_radians {
            Degrees::as_radians
        } else {
            Degrees::angle
        })
    }
}

impl Case for ArcCase {
    fn check(&self) -> Verdict {
        let [start, sweep] = self.angles();
        let shape = Arc::new(self.stage.point(self.corner), self.diameter.0, start, sweep);
        agree_styled(&self.stage, shape, self.style, Work::ONCE).map(drop)
    }
}

/// The part of a disc between two angles.
#[derive(Debug, Arbitrary)]
pub struct SectorCase(ArcCase);

impl Case for SectorCase {
    fn check(&self) -> Verdict {
        let Self(arc) = self;
        let [start, sweep] = arc.angles();
        let shape = Sector::new(arc.stage.point(arc.corner), arc.diameter.0, start, sweep);
        agree_styled(&arc.stage, shape, arc.style, Work::ONCE).map(drop)
    }
}

/// A triangle, often with corners in a line or in one point.
#[derive(Debug, Arbitrary)]
pub struct TriangleCase {
    stage: Stage,
    corners: [Spot; 3],
    in_line: bool,
    style: Style,
}

impl TriangleCase {
    /// Whether its fill has the pixels by definition, and so has its outline with what is inside.
    fn is_defined(&self, shape: Triangle) -> Verdict {
        let corners = shape.vertices.map(exact::wide);
        let color = Hue::Odd.color();
        let filled = PrimitiveStyle::with_fill(color);
        let outlined: PrimitiveStyle<_> = PrimitiveStyleBuilder::from(&filled.into())
            .stroke_color(color)
            .stroke_width(1)
            .build()
            .into();
        type HasPixel = fn([[i128; 2]; 3], [i128; 2]) -> bool;
        let looks: [(&str, PrimitiveStyle<Rgb565>, HasPixel); 2] = [
            ("filled", filled, exact::filled_triangle_has),
            ("outlined", outlined, exact::outlined_triangle_has),
        ];
        for (name, style, has) in looks {
            let picture = full_picture(self.stage.window, &shape.into_styled(style))?;
            let pixels = self.stage.area().points();
            let expected: Vec<Rgb565> = pixels
                .map(|pixel| {
                    if has(corners, exact::wide(pixel)) {
                        color
                    } else {
                        background()
                    }
                })
                .collect();
            is_same(&self.stage.window, &expected, &picture)
                .with_context(|| format!("by definition, the other {name}"))?;
        }
        Ok(())
    }
}

impl Case for TriangleCase {
    fn check(&self) -> Verdict {
        let Self { stage, style, .. } = self;
        let [a, b, mut c] = self.corners.map(|corner| stage.point(corner));
        if self.in_line {
            // On the line through the two others, or a pixel beside it.
            let between = |one: i32, other: i32| ((i64::from(one) + i64::from(other)) / 2) as i32;
            c = Point::new(between(a.x, b.x), between(a.y, b.y));
        }
        let shape = Triangle::new(a, b, c);
        let picture = agree_styled(stage, shape, *style, Work::ONCE)?;
        for vertices in [[b, c, a], [a, c, b]] {
            let [a, b, c] = vertices;
            let turned = full_picture(stage.window, &Triangle::new(a, b, c).into_styled(style.get()))?;
            is_same(&stage.window, &picture, &turned).context("in one order of corners, in another")?;
        }
        self.is_defined(shape)?;
        // embedded-graphics takes the fill of a triangle without an area for its stroke, also where that has no width.
        let is_peers_exception =
            exact::doubled_area([a, b, c].map(exact::wide)) == 0 && style.width() == 0 && style.is_inside();
        if style.width() <= 1 && suits_peer(stage, &self.corners, &[]) && !is_peers_exception {
            is_same(&stage.window, &peer_picture(stage, shape, *style)?, &picture)
                .context("embedded-graphics, zrow")?;
        }
        Ok(())
    }
}
