//! Prepared pictures that are edited, in memory of any size, against their items drawn one after the other.

use anyhow::{Context, bail, ensure};
use arbitrary::Arbitrary;
use embedded_graphics::{
    geometry::Point,
    mono_font::{
        MonoTextStyle,
        ascii::{FONT_4X6, FONT_6X10},
    },
    pixelcolor::Rgb565,
    prelude::Primitive,
    primitives::{
        Arc, Circle, CornerRadii, Ellipse, Line, PointsIter, Polyline, Rectangle, RoundedRectangle, Sector, Triangle,
    },
    text::Text,
};
use zrow::{
    band::LittleEndian,
    draw::{DrawOn, ItemId, Picture, PictureSlot, Polygon, ThinCircle},
    geometry::{InputError, TooSmall, Window},
};

use crate::{
    picture::{Canvas, background, cut, is_same, sure},
    target::{Case, Verdict},
    values::{Degrees, Hue, Length, List, Rule, Spot, Stage, Stroke, Style},
};

type Prepared<'m> = Picture<'m, 'static, Rgb565>;

/// The rows and columns in which a picture draws its items; elsewhere it draws nothing.
const DRAWN: core::ops::Range<i32> = -32_768..32_767;

/// A picture in lent memory and what is done with it.
#[derive(Debug, Arbitrary)]
pub struct PictureCase {
    stage: Stage,
    memory: Memory,
    /// Each with whether the picture is drawn after it; the damage of those that are not drawn comes together.
    edits: List<(Edit, bool), 10>,
}

/// Lengths of the memory that is lent to a picture, from nothing to enough, and the grid of its damage.
#[derive(Debug, Copy, Clone, Arbitrary)]
struct Memory {
    slots: u8,
    words: u8,
    buckets: u8,
    areas: u8,
    grid: (u8, u8),
}

/// A change of a picture; the number chooses an item.
#[derive(Debug, Clone, Arbitrary)]
enum Edit {
    Add(Item),
    Replace(u8, Item),
    Remove(u8),
    /// There and back again.
    Translate(u8, i32, i32),
    Clear,
}

/// An item of a prepared picture.
#[derive(Debug, Clone, Arbitrary)]
enum Item {
    Rectangle(Spot, Length, Length, Style),
    Rounded(Spot, Length, Length, [Length; 2], Style),
    Circle(Spot, Length, Style),
    Thin(Spot, Length, Style),
    Ellipse(Spot, Length, Length, Style),
    Arc(Spot, Length, Degrees, Degrees, Style),
    Sector(Spot, Length, Degrees, Degrees, Style),
    Triangle([Spot; 3], Style),
    Line([Spot; 2], Style),
    /// Up to three corners each of two contours.
    Polygon([Spot; 3], [Spot; 3], Rule, Style),
    Polyline([Spot; 4], Style),
    Stroke([Spot; 4], Stroke),
    Text(u8, Spot, Hue),
}

/// Evaluates an expression with the shape or the text that an item stands for, or another one with a polygon, which is drawn by itself
/// only where it is prepared.
macro_rules! with_drawn {
    ($item:expr, $stage:expr, |$drawn:ident| $result:expr, |$polygon:ident| $of_polygon:expr) => {{
        let stage: &Stage = $stage;
        let area = |spot: &Spot, width: &Length, height: &Length| Rectangle::new(stage.point(*spot), width.by(*height));
        let circle = |spot: &Spot, diameter: &Length| Circle::new(stage.point(*spot), diameter.0);
        match $item {
            Item::Rectangle(spot, width, height, style) => {
                let $drawn = area(spot, width, height).into_styled(style.get());
                $result
            }
            Item::Rounded(spot, width, height, [x, y], style) => {
                let rounded = RoundedRectangle::new(area(spot, width, height), CornerRadii::new(x.by(*y)));
                let $drawn = rounded.into_styled(style.get());
                $result
            }
            Item::Circle(spot, diameter, style) => {
                let $drawn = circle(spot, diameter).into_styled(style.get());
                $result
            }
            Item::Thin(spot, diameter, style) => {
                let $drawn = ThinCircle::new(stage.point(*spot), diameter.0).into_styled(style.get());
                $result
            }
            Item::Ellipse(spot, width, height, style) => {
                let ellipse = Ellipse::new(stage.point(*spot), width.by(*height));
                let $drawn = ellipse.into_styled(style.get());
                $result
            }
            Item::Arc(spot, diameter, start, sweep, style) => {
                let arc = Arc::from_circle(circle(spot, diameter), start.angle(), sweep.angle());
                let $drawn = arc.into_styled(style.get());
                $result
            }
            Item::Sector(spot, diameter, start, sweep, style) => {
                let sector = Sector::from_circle(circle(spot, diameter), start.angle(), sweep.angle());
                let $drawn = sector.into_styled(style.get());
                $result
            }
            Item::Triangle(corners, style) => {
                let [a, b, c] = corners.map(|corner| stage.point(corner));
                let $drawn = Triangle::new(a, b, c).into_styled(style.get());
                $result
            }
            Item::Line(ends, style) => {
                let [start, end] = ends.map(|end| stage.point(end));
                let $drawn = Line::new(start, end).into_styled(style.get());
                $result
            }
            Item::Polygon(outer, inner, rule, style) => {
                let contours = [outer, inner].map(|corners| corners.map(|corner| stage.point(corner)));
                let contours = contours.each_ref().map(|contour| contour.as_slice());
                let $polygon = Polygon::new(&contours, rule.get()).into_styled(style.get());
                $of_polygon
            }
            Item::Polyline(vertices, style) => {
                let vertices = vertices.map(|vertex| stage.point(vertex));
                let $drawn = Polyline::new(&vertices).into_styled(style.get());
                $result
            }
            Item::Stroke(vertices, stroke) => {
                let vertices = vertices.map(|vertex| stage.point(vertex));
                let lengths = stroke.lengths();
                let $drawn = Polyline::new(&vertices).into_styled(stroke.style(&lengths));
                $result
            }
            Item::Text(kind, spot, hue) => {
                let string = ["0", "42 km/h", "a\nb", "", "\u{b0}C"][usize::from(kind >> 1) % 5];
                let font = if kind & 1 == 0 { &FONT_4X6 } else { &FONT_6X10 };
                let style = MonoTextStyle::new(font, hue.color());
                let $drawn = Text::new(string, stage.point(*spot), style);
                $result
            }
        }
    }};
}

/// The items that a picture has to show, in painter's order, with their ids; `None` for those that were removed.
#[derive(Debug, Default)]
struct Model {
    items: Vec<(ItemId, Option<Item>)>,
}

impl Model {
    /// Edits the picture, and the model where the picture succeeds. An error of the picture has to ask for more memory than
    /// it was lent.
    fn apply(&mut self, edit: &Edit, picture: &mut Prepared<'_>, stage: &Stage, memory: &Memory) -> Verdict {
        let chosen = |number: u8, items: &[_]| usize::from(number).checked_rem(items.len());
        let result = match edit {
            Edit::Add(item) => {
                let added = with_drawn!(item, stage, |drawn| picture.add(&drawn), |polygon| picture
                    .add(&polygon));
                added.map(|id| self.items.push((id, Some(item.clone()))))
            }
            Edit::Replace(number, item) => match chosen(*number, &self.items) {
                Some(index) => {
                    let (id, shown) = &mut self.items[index];
                    let replaced = with_drawn!(item, stage, |drawn| picture.replace(*id, &drawn), |polygon| picture
                        .replace(*id, &polygon));
                    replaced.map(|()| *shown = Some(item.clone()))
                }
                None => Ok(()),
            },
            Edit::Remove(number) => {
                if let Some(index) = chosen(*number, &self.items) {
                    let (id, shown) = &mut self.items[index];
                    picture.remove(*id);
                    *shown = None;
                }
                Ok(())
            }
            Edit::Translate(number, x, y) => {
                if let Some(index) = chosen(*number, &self.items) {
                    let (id, _) = self.items[index];
                    let by = Point::new(*x, *y);
                    let back = Point::new(x.wrapping_neg(), y.wrapping_neg());
                    match picture.translate(id, by) {
                        Ok(()) => ensure!(picture.translate(id, back) == Ok(()), "moved by {by}, and not back"),
                        Err(InputError::OutOfDomain { min, max }) => ensure!(min < max, "nothing is inside"),
                        Err(other) => bail!("an error of another kind: {other:?}"),
                    }
                }
                Ok(())
            }
            Edit::Clear => {
                picture.clear();
                self.items.clear();
                Ok(())
            }
        };
        ensure!(picture.slots_used() == self.items.len(), "slots are lost");
        match result {
            Ok(()) => Ok(()),
            Err(InputError::TooSmall(TooSmall::Items(needed))) => {
                ensure!(needed > memory.slots(), "{needed} slots are needed, which there are");
                Ok(())
            }
            Err(InputError::TooSmall(TooSmall::PictureWords(needed))) => {
                ensure!(needed > memory.words(), "{needed} words are needed, which there are");
                Ok(())
            }
            Err(other) => bail!("an error of another table: {other:?}"),
        }
    }

    /// The colours of the window when the items are drawn one after the other, without a picture.
    fn replayed(&self, stage: &Stage) -> anyhow::Result<Vec<Rgb565>> {
        Canvas::new(stage.window).draw::<LittleEndian>(|band| {
            for item in self.items.iter().filter_map(|(_, item)| item.as_ref()) {
                with_drawn!(item, stage, |drawn| sure(drawn.draw_on(band)), |polygon| {
                    let prepared = polygon.primitive.prepare::<6, 6>()?;
                    sure(prepared.into_styled(polygon.style).draw_on(band));
                });
            }
            Ok(())
        })
    }
}

impl Memory {
    const fn slots(&self) -> usize {
        self.slots as usize % 9
    }

    const fn words(&self) -> usize {
        self.words as usize
    }
}

/// Draws a picture into a band over this window, on the background, and returns the colours of the band's pixels.
fn shown(picture: &mut Prepared<'_>, band: Window) -> anyhow::Result<Vec<Rgb565>> {
    Canvas::new(band).draw::<LittleEndian>(|band| {
        picture.draw(band);
        Ok(())
    })
}

/// Draws the rectangles that have changed, and nothing else, over the colours of a display.
fn draw_damage(picture: &mut Prepared<'_>, window: &Window, display: &mut [Rgb565]) -> Verdict {
    let mut is_drawn = vec![false; display.len()];
    while let Some(area) = picture.next_damage() {
        let area = Window::from(area).intersection(window);
        if area.is_empty() {
            continue;
        }
        let colors = shown(picture, area)?;
        for (point, color) in area.to_rectangle().points().zip(colors) {
            let (x, y) = (point.x.abs_diff(window.left), point.y.abs_diff(window.top));
            let index = (y * window.width() + x) as usize;
            ensure!(!is_drawn[index], "{point} is damage twice");
            (display[index], is_drawn[index]) = (color, true);
        }
    }
    Ok(())
}

impl Case for PictureCase {
    fn check(&self) -> Verdict {
        let Self { stage, memory, edits } = self;
        let window = stage.window;
        let mut slots = vec![PictureSlot::EMPTY; memory.slots()];
        let mut pool = vec![0; memory.words()];
        let mut buckets = vec![0; usize::from(memory.buckets % 24)];
        let mut areas = vec![Window::EMPTY; usize::from(memory.areas % 9)];
        let has_damage = !areas.is_empty();
        let (columns, rows) = memory.grid;
        let mut picture = Picture::new(stage.area(), &mut slots, &mut pool, &mut buckets)
            .with_damage(&mut areas, (columns.into(), rows.into()));
        let sides = [window.left, window.top, window.right, window.bottom];
        let is_in_range = sides.iter().all(|side| DRAWN.contains(side));
        let mut model = Model::default();
        let mut display = vec![background(); stage.pixels()];
        for (edit, draws) in &edits.0 {
            model.apply(edit, &mut picture, stage, memory)?;
            if !draws {
                continue;
            }
            let expected = model.replayed(stage)?;
            for rows in [1, stage.rows] {
                for band in stage.bands(rows) {
                    let found = shown(&mut picture, band)?;
                    if is_in_range {
                        is_same(&band, &cut(&window, &expected, &band), &found)
                            .with_context(|| format!("replayed, the other prepared, in bands of {rows} rows"))?;
                    }
                }
            }
            draw_damage(&mut picture, &window, &mut display)?;
            if is_in_range && has_damage {
                is_same(&window, &expected, &display).context("replayed, the other by its damage")?;
            }
        }
        Ok(())
    }
}
