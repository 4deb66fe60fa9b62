//! Items of a picture: each kind that is added by copy and one by reference, at random or as a test wants them, and the same drawn one
//! after the other without a picture.

use embedded_graphics::{
    mono_font::{
        MonoTextStyle, MonoTextStyleBuilder,
        ascii::{FONT_4X6, FONT_6X10, FONT_10X20},
    },
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{
        Arc, Circle, CornerRadii, Ellipse, Line, Polyline, PrimitiveStyleBuilder, Rectangle, RoundedRectangle, Sector,
        Triangle,
    },
    text::{Alignment, Baseline, LineHeight, Text, TextStyleBuilder},
};
use proptest::prelude::*;
use zrow::{
    band::Band,
    draw::{DrawOn, ItemId, Picture, PictureItem, PictureSlot, PrimitiveStyle, ThinCircle},
    geometry::{InputError, Window},
};

use crate::{
    common::hostile::any_length,
    contour_items::{ContourItem, PathItem, contour_items, path_items},
    stroke_items::{StrokeItem, stroke_items},
};

pub type Prepared<'m, 'a> = Picture<'m, 'a, Rgb565>;
pub type Slot<'a> = PictureSlot<'a, Rgb565>;
pub type Style = PrimitiveStyle<Rgb565>;

/// Where pictures are drawn: small, so that most items meet each other and the sides.
pub const AREA: Rectangle = Rectangle::new(Point::new(-3, 5), Size::new(61, 47));

/// What a picture is made of.
#[derive(Debug, Clone)]
pub enum Item {
    Rectangle(Rectangle, Style),
    Rounded(RoundedRectangle, Style),
    Circle(Circle, Style),
    Ellipse(Ellipse, Style),
    Triangle(Triangle, Style),
    Line(Line, Style),
    Arc(Arc, Style),
    Sector(Sector, Style),
    Thin(ThinCircle, Style),
    Text(String, Point, TextKind),
    Contours(ContourItem),
    Path(PathItem),
    Stroke(StrokeItem),
    Polyline([Point; 4], Point, Style),
    /// By reference.
    Own([Point; 4], Style),
}

/// Font, colours and decorations by bits, then alignment and so on.
pub type TextKind = (u32, Rgb565);

fn text((bits, color): TextKind, string: &str, position: Point) -> Text<'_, MonoTextStyle<'static, Rgb565>> {
    let font = [&FONT_4X6, &FONT_6X10, &FONT_10X20][(bits % 3) as usize];
    let mut style = MonoTextStyleBuilder::new().font(font).text_color(color);
    // Most texts are plain.
    let decoration = bits >> 2 & 15;
    style = match decoration {
        0 => style.background_color(Rgb565::BLUE),
        1 => style.underline(),
        2 => style.strikethrough_with_color(Rgb565::GREEN),
        3 => style.underline_with_color(Rgb565::RED).background_color(Rgb565::WHITE),
        4 => style.reset_text_color(),
        _ => style,
    };
    let layout = TextStyleBuilder::new()
        .alignment([Alignment::Left, Alignment::Center, Alignment::Right][(bits >> 6 & 3).min(2) as usize])
        .baseline([Baseline::Top, Baseline::Bottom, Baseline::Middle, Baseline::Alphabetic][(bits >> 8 & 3) as usize])
        .line_height(if bits >> 10 & 1 == 0 {
            LineHeight::Percent(80)
        } else {
            LineHeight::Pixels(9)
        })
        .build();
    Text::with_text_style(string, position, style.build(), layout)
}

/// Evaluates an expression with the styled shape or the text that an item is, or others with contours, or with the points
/// and the style of a polyline by reference.
macro_rules! with_drawn {
    ($item:expr, |$drawn:ident| $result:expr, |$contours:ident| $of_contours:expr, |$points:ident, $style:ident| $of_own:expr) => {
        match $item {
            Item::Rectangle(shape, style) => with_drawn!(shape, style, $drawn, $result),
            Item::Rounded(shape, style) => with_drawn!(shape, style, $drawn, $result),
            Item::Circle(shape, style) => with_drawn!(shape, style, $drawn, $result),
            Item::Ellipse(shape, style) => with_drawn!(shape, style, $drawn, $result),
            Item::Triangle(shape, style) => with_drawn!(shape, style, $drawn, $result),
            Item::Line(shape, style) => with_drawn!(shape, style, $drawn, $result),
            Item::Arc(shape, style) => with_drawn!(shape, style, $drawn, $result),
            Item::Sector(shape, style) => with_drawn!(shape, style, $drawn, $result),
            Item::Thin(shape, style) => with_drawn!(shape, style, $drawn, $result),
            Item::Text(string, position, kind) => {
                let $drawn = text(*kind, string, *position);
                $result
            }
            Item::Contours($contours) => $of_contours,
            Item::Path($contours) => $of_contours,
            Item::Stroke($contours) => $of_contours,
            Item::Polyline(points, offset, style) => {
                let $drawn = Polyline::new(points).translate(*offset).into_styled(*style);
                $result
            }
            Item::Own($points, $style) => $of_own,
        }
    };
    ($shape:ident, $style:ident, $drawn:ident, $result:expr) => {{
        let $drawn = $shape.into_styled(*$style);
        $result
    }};
}

impl Item {
    /// Draws it as it is drawn without a picture.
    pub fn draw(&self, band: &mut Band<'_, Rgb565>) {
        let Ok(()) = with_drawn!(
            self,
            |drawn| drawn.draw_on(band),
            |contours| {
                contours.draw(band);
                Ok(())
            },
            |points, style| Polyline::new(points).into_styled(*style).draw_on(band)
        );
    }

    pub fn add<'a>(&'a self, picture: &mut Prepared<'_, 'a>) -> Result<ItemId, InputError> {
        with_drawn!(
            self,
            |drawn| picture.add(&drawn),
            |contours| contours.add(picture),
            |_points, _style| picture.add_item(self)
        )
    }

    pub fn replace<'a>(&'a self, picture: &mut Prepared<'_, 'a>, id: ItemId) -> Result<(), InputError> {
        with_drawn!(
            self,
            |drawn| picture.replace(id, &drawn),
            |contours| contours.replace(picture, id),
            |_points, _style| picture.replace_item(id, self)
        )
    }
}

/// An item of the program's own.
impl PictureItem<Rgb565> for Item {
    fn bounds(&self) -> Window {
        match self {
            Self::Own(points, style) => Polyline::new(points).into_styled(*style).bounding_box().into(),
            other => unreachable!("{other:?} is added by copy"),
        }
    }

    fn draw(&self, band: &mut Band<'_, Rgb565>) {
        Item::draw(self, band);
    }
}

pub fn points() -> impl Strategy<Value = Point> + Clone {
    let near = (-30..90, -30..80);
    let far = (-40_000..40_000, -40_000..40_000);
    prop_oneof![12 => near, 1 => far].prop_map(|(x, y)| Point::new(x, y))
}

fn sizes() -> impl Strategy<Value = Size> + Clone {
    let small = (0..50u32, 0..50u32);
    let thin = (0..5u32, 0..90u32);
    let large = (0..3_000u32, 0..3_000u32);
    let huge = (0..100_000u32, 0..100_000u32);
    prop_oneof![12 => small, 3 => thin, 2 => large, 1 => huge].prop_map(|(width, height)| Size::new(width, height))
}

fn colors() -> impl Strategy<Value = Rgb565> + Clone {
    (1..32u8, 0..64u8, 0..32u8).prop_map(|(red, green, blue)| Rgb565::new(red, green, blue))
}

fn styles() -> impl Strategy<Value = Style> + Clone {
    use embedded_graphics::primitives::StrokeAlignment::{Center, Inside, Outside};
    let alignments = prop_oneof![Just(Inside), Just(Center), Just(Outside)];
    let widths = prop_oneof![4 => Just(1), 2 => 2..6u32, 1 => 0..40u32];
    (
        proptest::option::of(colors()),
        proptest::option::of(colors()),
        widths,
        alignments,
    )
        .prop_map(|(fill, stroke, width, alignment)| {
            let mut style = PrimitiveStyleBuilder::new().stroke_alignment(alignment);
            if let Some(color) = fill {
                style = style.fill_color(color);
            }
            if let Some(color) = stroke {
                style = style.stroke_color(color).stroke_width(width);
            }
            style.build().into()
        })
}

pub fn items() -> impl Strategy<Value = Item> + Clone {
    items_of(points(), sizes())
}

/// Items with numbers of their whole type.
pub fn hostile_items() -> impl Strategy<Value = Item> + Clone {
    let number = || prop_oneof![2 => -50..50, 1 => any::<i32>(), 1 => (0..40).prop_map(|by| i32::MAX - by), 1 => (0..40).prop_map(|by| i32::MIN + by)];
    let points = (number(), number()).prop_map(|(x, y)| Point::new(x, y));
    let sizes = (any_length(), any_length()).prop_map(|(width, height)| Size::new(width, height));
    items_of(points, sizes)
}

fn items_of(
    points: impl Strategy<Value = Point> + Clone + 'static,
    sizes: impl Strategy<Value = Size> + Clone + 'static,
) -> impl Strategy<Value = Item> + Clone {
    let boxes = (points.clone(), sizes.clone()).prop_map(|(point, size)| Rectangle::new(point, size));
    let circles = (points.clone(), sizes.clone()).prop_map(|(point, size)| Circle::new(point, size.width));
    let angles = (-720.0..720.0f32, -400.0..400.0f32).prop_map(|(start, sweep)| (start.deg(), sweep.deg()));
    let corners = (sizes.clone(), sizes.clone(), sizes.clone(), sizes.clone()).prop_map(|(a, b, c, d)| CornerRadii {
        top_left: a,
        top_right: b,
        bottom_right: c,
        bottom_left: d,
    });
    let four_points = [points.clone(), points.clone(), points.clone(), points.clone()];
    prop_oneof![
        (boxes.clone(), styles()).prop_map(|(shape, style)| Item::Rectangle(shape, style)),
        (circles.clone(), styles()).prop_map(|(shape, style)| Item::Circle(shape, style)),
        (boxes.clone(), styles())
            .prop_map(|(shape, style)| Item::Ellipse(Ellipse::new(shape.top_left, shape.size), style)),
        (points.clone(), points.clone(), points.clone(), styles())
            .prop_map(|(a, b, c, style)| Item::Triangle(Triangle::new(a, b, c), style)),
        (points.clone(), points.clone(), styles()).prop_map(|(a, b, style)| Item::Line(Line::new(a, b), style)),
        (boxes, corners, styles())
            .prop_map(|(shape, corners, style)| Item::Rounded(RoundedRectangle::new(shape, corners), style)),
        (circles.clone(), angles.clone(), styles())
            .prop_map(|(circle, (start, sweep), style)| Item::Arc(Arc::from_circle(circle, start, sweep), style)),
        (circles.clone(), angles, styles())
            .prop_map(|(circle, (start, sweep), style)| Item::Sector(Sector::from_circle(circle, start, sweep), style)),
        (circles, styles())
            .prop_map(|(circle, style)| Item::Thin(ThinCircle::new(circle.top_left, circle.diameter), style)),
        ("[ -~\n\r]{0,3}|[0-9A-z ]{0,9}", points.clone(), any::<u32>(), colors())
            .prop_map(|(string, point, bits, color)| Item::Text(string, point, (bits, color))),
        contour_items(points.clone(), styles()).prop_map(Item::Contours),
        path_items(points.clone(), styles()).prop_map(Item::Path),
        stroke_items(points.clone(), colors()).prop_map(Item::Stroke),
        (four_points.clone(), points, styles())
            .prop_map(|(points, offset, style)| Item::Polyline(points, offset, style)),
        (four_points, styles()).prop_map(|(points, style)| Item::Own(points, style)),
    ]
}

/// Every item drawn one after the other into a band of a whole area.
pub fn replayed<'i>(area: Rectangle, items: impl IntoIterator<Item = &'i Item>) -> Vec<u16> {
    let mut words = vec![0; (area.size.width * area.size.height) as usize];
    let mut band = Band::new(area, &mut words).unwrap();
    for item in items {
        item.draw(&mut band);
    }
    words
}

/// As much memory as any picture here needs.
pub fn with_picture<'a, R>(buckets: usize, test: impl FnOnce(&mut Prepared<'_, 'a>) -> R) -> R {
    let (mut slots, mut pool, mut buckets) = (vec![Slot::EMPTY; 256], vec![0; 60_000], vec![0; buckets]);
    test(&mut Prepared::new(AREA, &mut slots, &mut pool, &mut buckets))
}
