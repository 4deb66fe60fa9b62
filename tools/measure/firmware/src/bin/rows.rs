//! Counts what shapes take in a row of 240 pixels: one that they do not meet, above or below them, and one that they meet.
#![no_std]
#![no_main]

use core::hint::black_box;

use cortex_m::Peripherals;
use cortex_m_rt::entry;
use embedded_graphics::{
    geometry::{AngleUnit, Point, Size},
    pixelcolor::{Rgb565, RgbColor},
    primitives::{
        Arc, Circle, CornerRadii, Ellipse, Line, Polyline, Primitive, Rectangle, RoundedRectangle, Sector, Triangle,
    },
};
use zrow::{
    band::Band,
    draw::{DrawOn, PrimitiveStyle},
};
use zrow_measure_firmware::{
    report,
    run::{Canvas, Checksum, Runner},
    stopwatch::Stopwatch,
};

/// A row, whose pixels are those that were drawn last.
struct Row([u16; 240]);

impl Canvas for Row {
    fn erase(&mut self) {
        self.0.fill(0);
    }

    fn checksum(&mut self) -> u32 {
        Checksum::of(self.0.iter().copied())
    }
}

/// The rows of each kind that are counted.
const ROWS: usize = 20;

/// Counts a shape that has rows 100 to 139.
fn count(runner: &mut Runner, kind: &str, shape: &impl DrawOn<Color = Rgb565>) {
    for (name, first) in [("row.above", 40), ("row.below", 180), ("row.met", 110)] {
        let rows: [i32; ROWS] = core::array::from_fn(|row| first + row as i32);
        let mut row = Row([0; 240]);
        runner.count(name, kind, &mut row, &rows, |row, &y| {
            let area = Rectangle::new(Point::new(0, y), Size::new(240, 1));
            let Ok(mut band) = Band::<Rgb565>::new(area, &mut row.0) else {
                report::exit(false)
            };
            let Ok(()) = black_box(shape).draw_on(&mut band);
        });
    }
}

/// Draws nothing: what the band and the call take.
struct Nothing;

impl DrawOn for Nothing {
    type Color = Rgb565;

    fn draw_on<T: zrow::band::Target<Color = Rgb565>>(&self, _target: &mut T) -> Result<(), T::Error> {
        Ok(())
    }
}

#[entry]
fn main() -> ! {
    let mut words = [0; 256];
    let wanted = report::wanted(&mut words);
    let Some(peripherals) = Peripherals::take() else {
        report::exit(false)
    };
    let mut runner = Runner::new(Stopwatch::new(peripherals.SYST), wanted);
    let runner = &mut runner;
    let corner = Point::new(60, 100);
    let (fill, thin, wide) = (
        black_box(PrimitiveStyle::with_fill(Rgb565::RED)),
        black_box(PrimitiveStyle::with_stroke(Rgb565::RED, 1)),
        black_box(PrimitiveStyle::with_stroke(Rgb565::RED, 5)),
    );
    let circle = Circle::new(corner, 40);
    let rectangle = Rectangle::new(corner, Size::new(100, 40));
    let triangle = Triangle::new(corner, Point::new(160, 120), Point::new(80, 139));
    let line = Line::new(corner, Point::new(120, 139));
    let vertices = black_box([corner, Point::new(150, 120), Point::new(90, 110), Point::new(120, 139)]);
    let polyline = Polyline::new(&vertices);
    let sector = Sector::new(corner, 40, 30.0.deg(), 200.0.deg());
    count(runner, "nothing", &Nothing);
    count(runner, "rectangle", &rectangle.into_styled(fill));
    count(runner, "disc", &circle.into_styled(fill));
    count(runner, "circle", &circle.into_styled(thin));
    count(
        runner,
        "ellipse",
        &Ellipse::new(corner, Size::new(100, 40)).into_styled(fill),
    );
    let radii = CornerRadii::new(Size::new(8, 8));
    count(
        runner,
        "rounded_rectangle",
        &RoundedRectangle::new(rectangle, radii).into_styled(fill),
    );
    count(runner, "triangle", &triangle.into_styled(fill));
    count(runner, "line", &line.into_styled(thin));
    count(runner, "line_5_px", &line.into_styled(wide));
    count(runner, "polyline", &polyline.into_styled(thin));
    count(runner, "polyline_5_px", &polyline.into_styled(wide));
    count(
        runner,
        "arc",
        &Arc::from_circle(circle, 30.0.deg(), 200.0.deg()).into_styled(thin),
    );
    count(runner, "sector", &sector.into_styled(fill));
    report::exit(true)
}
