//! Arcs, sectors and rounded rectangles in their styles.

use embedded_graphics::{
    mono_font::ascii::FONT_6X10,
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{Arc, CornerRadii, CornerRadiiBuilder, PrimitiveStyleBuilder, Rectangle, RoundedRectangle, Sector},
    text::Alignment,
};
use zrow::{
    band::{Band, Order},
    draw::{PrimitiveStyle, StrokeAlignment},
};

use crate::{
    PrepareError, Prepared, Scene,
    paint::{label, rgb, shape},
};

const TITLE_COLOR: Rgb565 = rgb(255, 255, 255);
const RED: Rgb565 = rgb(239, 83, 80);
const AMBER: Rgb565 = rgb(255, 202, 40);
const GREEN: Rgb565 = rgb(102, 187, 106);
const BLUE: Rgb565 = rgb(66, 165, 245);
const DARK: Rgb565 = rgb(38, 50, 66);

/// The scene; nothing outlives a row.
#[derive(Debug, Default)]
pub struct Arcs;

impl Scene for Arcs {
    type Color = Rgb565;
    type Prepared<'s> = &'s mut Self;
    const NAME: &'static str = "arcs";
    const TITLE: &'static str = "arcs, sectors, rounded rectangles";
    const AREA: Rectangle = Rectangle::new(Point::zero(), Size::new(320, 240));
    const BACKGROUND: Rgb565 = rgb(16, 20, 28);

    fn prepare(&mut self, _frame: u32) -> Result<&mut Self, PrepareError> {
        Ok(self)
    }
}

impl Prepared for Arcs {
    type Color = Rgb565;

    fn draw<O: Order>(&mut self, band: &mut Band<'_, Rgb565, O>) {
        for (name, y) in [("arcs", 4), ("sectors", 84), ("rounded rectangles", 164)] {
            label(
                band,
                name,
                Point::new(160, y),
                Alignment::Center,
                &FONT_6X10,
                TITLE_COLOR,
            );
        }
        draw_arcs(band);
        draw_sectors(band);
        draw_rounded_rectangles(band);
    }
}

/// The middle of one of five figures side by side.
fn middle(index: usize, y: i32) -> Point {
    Point::new(36 + 62 * index as i32, y)
}

/// Widths, sweeps of both signs, and rings around one centre.
fn draw_arcs<O: Order>(band: &mut Band<'_, Rgb565, O>) {
    let arcs = [
        (1, -45.0, 270.0),
        (3, 45.0, -270.0),
        (8, 135.0, 270.0),
        (16, 190.0, 200.0),
    ];
    for (index, (width, start, sweep)) in arcs.into_iter().enumerate() {
        let style = PrimitiveStyle::with_stroke(AMBER, width);
        shape(
            band,
            // Widths differ, outer diameters do not.
            &Arc::with_center(middle(index, 49), 55 - width, start.deg(), sweep.deg()).into_styled(style),
        );
    }
    for (ring, (color, sweep)) in [(RED, 300.0), (GREEN, 220.0), (BLUE, 130.0)].into_iter().enumerate() {
        let diameter = 49 - 17 * ring as u32;
        let whole = PrimitiveStyle::with_stroke(DARK, 6);
        let style = PrimitiveStyle::with_stroke(color, 6);
        let arc = |sweep: f32| Arc::with_center(middle(4, 49), diameter, (-90.0).deg(), sweep.deg());
        shape(band, &arc(360.0).into_styled(whole));
        shape(band, &arc(sweep).into_styled(style));
    }
}

/// Filled and stroked, sharp corners cut off, and a whole pie.
fn draw_sectors<O: Order>(band: &mut Band<'_, Rgb565, O>) {
    let outlined = |width, alignment| {
        PrimitiveStyleBuilder::new()
            .fill_color(DARK)
            .stroke_color(GREEN)
            .stroke_width(width)
            .stroke_alignment(alignment)
            .build()
            .into()
    };
    // The slim ones have their centres lower, so that all stand in the middle of their row.
    let sectors = [
        (142, -120.0, 60.0, PrimitiveStyle::with_fill(BLUE)),
        (142, -110.0, 40.0, outlined(3, StrokeAlignment::Center)),
        (129, 30.0, 300.0, outlined(2, StrokeAlignment::Inside)),
        (129, 15.0, 330.0, outlined(4, StrokeAlignment::Inside)),
    ];
    for (index, (y, start, sweep, style)) in sectors.into_iter().enumerate() {
        shape(
            band,
            &Sector::with_center(middle(index, y), 55, start.deg(), sweep.deg()).into_styled(style),
        );
    }
    let mut start = -90.0;
    for (color, sweep) in [(RED, 140.0), (AMBER, 95.0), (GREEN, 80.0), (BLUE, 45.0)] {
        let part = Sector::with_center(middle(4, 129), 55, start.deg(), sweep.deg());
        shape(band, &part.into_styled(PrimitiveStyle::with_fill(color)));
        start += sweep;
    }
}

/// Equal, elliptic and different corners, and radii that do not fit.
fn draw_rounded_rectangles<O: Order>(band: &mut Band<'_, Rgb565, O>) {
    let different = CornerRadiiBuilder::new()
        .top_left(Size::new(4, 4))
        .top_right(Size::new(30, 12))
        .bottom_right(Size::new(8, 30))
        .build();
    let corners = [
        CornerRadii::new(Size::new(12, 12)),
        CornerRadii::new(Size::new(25, 10)),
        different,
        CornerRadii::new(Size::new(90, 90)),
    ];
    let style: PrimitiveStyle<_> = PrimitiveStyleBuilder::new()
        .fill_color(DARK)
        .stroke_color(RED)
        .stroke_width(4)
        .build()
        .into();
    for (index, corners) in corners.into_iter().enumerate() {
        let rectangle = Rectangle::new(Point::new(10 + 77 * index as i32, 178), Size::new(68, 54));
        shape(band, &RoundedRectangle::new(rectangle, corners).into_styled(style));
    }
}
