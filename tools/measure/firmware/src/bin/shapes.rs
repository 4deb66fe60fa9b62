//! Counts 2D drawing at 240 x 320 RGB565: embedded-graphics on its `Framebuffer`, zrow on a full-frame `Band`.
//!
//! Each shape is drawn three times: by the peer; by zrow through `Drawable::draw`, which takes any `DrawTarget` (variant
//! `draw`); and by zrow through `DrawOn::draw_on`, which takes a `Target` (variant `fast`).
#![no_std]
#![no_main]

use cortex_m::Peripherals;
use cortex_m_rt::entry;
use embedded_graphics::{
    framebuffer::{Framebuffer, buffer_size},
    pixelcolor::{
        Rgb565,
        raw::{LittleEndian, RawU16},
    },
    prelude::*,
    primitives::{
        self, Arc, Circle, CornerRadii, Ellipse, Line, Rectangle, RoundedRectangle, Sector, Styled, StyledDrawable,
        Triangle,
    },
};
use zrow::{
    band::Band,
    draw::{DrawOn, PrimitiveStyle, ThinCircle},
};
use zrow_measure_firmware::{
    inputs::{Colored, colored},
    report,
    run::{Canvas, Checksum, Runner},
    stopwatch::Stopwatch,
};

const WIDTH: usize = 240;
const HEIGHT: usize = 320;
const SCREEN: Size = Size::new(WIDTH as u32, HEIGHT as u32);

type Frame = Framebuffer<Rgb565, RawU16, LittleEndian, WIDTH, HEIGHT, { buffer_size::<Rgb565>(WIDTH, HEIGHT) }>;

/// The peer's canvas.
struct PeerFrame(Frame);

impl Canvas for PeerFrame {
    fn erase(&mut self) {
        self.0.data_mut().fill(0);
    }

    fn checksum(&mut self) -> u32 {
        Checksum::of(
            self.0
                .data()
                .as_chunks()
                .0
                .iter()
                .map(|&bytes| u16::from_le_bytes(bytes)),
        )
    }
}

/// zrow's canvas.
struct BandFrame<'a>(Band<'a, Rgb565>);

impl Canvas for BandFrame<'_> {
    fn erase(&mut self) {
        self.0.words_mut().fill(0);
    }

    fn checksum(&mut self) -> u32 {
        Checksum::of(self.0.words().iter().copied())
    }
}

#[entry]
fn main() -> ! {
    let mut words = [0; 512];
    let wanted = report::wanted(&mut words);
    let peer = cortex_m::singleton!(: PeerFrame = PeerFrame(Frame::new()));
    let words = cortex_m::singleton!(: [u16; WIDTH * HEIGHT] = [0; WIDTH * HEIGHT]);
    let (Some(peripherals), Some(peer), Some(words)) = (Peripherals::take(), peer, words) else {
        report::exit(false)
    };
    let Ok(band) = Band::new(Rectangle::new(Point::zero(), SCREEN), words) else {
        report::exit(false)
    };
    let mut bench = Bench {
        runner: Runner::new(Stopwatch::new(peripherals.SYST), wanted),
        peer,
        band: BandFrame(band),
    };
    bench.clear();
    bench.lines();
    bench.circles();
    bench.triangles();
    bench.rectangles_and_ellipses();
    bench.arcs();
    bench.rounded_rectangles();
    report::exit(true)
}

/// The stopwatch and the canvases.
struct Bench<'a> {
    runner: Runner<'a>,
    peer: &'a mut PeerFrame,
    band: BandFrame<'a>,
}

impl Bench<'_> {
    fn clear(&mut self) {
        let inputs: [Colored<()>; 50] = colored(|_| ());
        if !self.runner.wants("clear") {
            return;
        }
        self.runner.count("clear", "peer", self.peer, &inputs, |canvas, input| {
            let _ = canvas.0.clear(input.color);
        });
        self.runner
            .count("clear", "draw", &mut self.band, &inputs, |canvas, input| {
                let _ = canvas.0.clear(input.color);
            });
    }

    fn lines(&mut self) {
        for (name, margin) in [("line.on_screen", 0), ("line.off_screen", 3000)] {
            let inputs: [Colored<Line>; 200] = colored(|uniform| {
                let start = uniform.around_screen(SCREEN, margin);
                same_ties(start, uniform.around_screen(SCREEN, margin))
            });
            self.strokes(name, &inputs);
        }
    }

    fn circles(&mut self) {
        let circles: [Colored<Circle>; 100] = colored(|uniform| Circle::with_center(uniform.on_screen(SCREEN), 101));
        self.strokes("circle.outline", &circles);
        self.fills("circle.filled", &circles);
        let thin: [Colored<ThinCircle>; 100] = colored(|uniform| ThinCircle::new(uniform.on_screen(SCREEN), 50));
        self.zrow_variants("circle.thin", &thin, |color| PrimitiveStyle::with_stroke(color, 1));
    }

    fn rectangles_and_ellipses(&mut self) {
        let rectangles: [Colored<Rectangle>; 100] =
            colored(|uniform| Rectangle::with_center(uniform.on_screen(SCREEN), Size::new(100, 100)));
        self.fills("rectangle.filled", &rectangles);
        let ellipses: [Colored<Ellipse>; 100] =
            colored(|uniform| Ellipse::with_center(uniform.on_screen(SCREEN), Size::new(120, 80)));
        self.fills("ellipse.filled", &ellipses);
    }

    fn arcs(&mut self) {
        let arcs: [Colored<Arc>; 100] =
            colored(|uniform| Arc::with_center(uniform.on_screen(SCREEN), 101, 90.0.deg(), 180.0.deg()));
        self.strokes("arc.outline", &arcs);
        let sectors: [Colored<Sector>; 100] = colored(|uniform| {
            let start = uniform.number(0, 360) as f32;
            Sector::with_center(uniform.on_screen(SCREEN), 101, start.deg(), 120.0.deg())
        });
        self.fills("sector.filled", &sectors);
    }

    fn rounded_rectangles(&mut self) {
        let square = |length| Size::new(length, length);
        let unequal = CornerRadii {
            top_left: square(4),
            top_right: square(12),
            bottom_right: square(20),
            bottom_left: square(28),
        };
        for (name, corners) in [
            ("rounded.equal", CornerRadii::new(square(12))),
            ("rounded.unequal", unequal),
        ] {
            let rounded: [Colored<RoundedRectangle>; 100] = colored(|uniform| {
                let rectangle = Rectangle::with_center(uniform.on_screen(SCREEN), Size::new(100, 60));
                RoundedRectangle::new(rectangle, corners)
            });
            self.fills(name, &rounded);
        }
    }

    fn triangles(&mut self) {
        let random: [Colored<Triangle>; 100] = colored(|uniform| triangle(|| uniform.on_screen(SCREEN)));
        self.fills("triangle.filled", &random);
        let small: [Colored<Triangle>; 100] = colored(|uniform| {
            let corner = uniform.on_screen(SCREEN);
            triangle(|| corner + Point::new(uniform.number(0, 16), uniform.number(0, 16)))
        });
        self.fills("triangle.small", &small);
    }

    /// Counts strokes of one pixel through all variants.
    fn strokes<Shape: Counted, const N: usize>(&mut self, name: &str, inputs: &[Colored<Shape>; N])
    where
        Styled<Shape, PrimitiveStyle<Rgb565>>: DrawOn<Color = Rgb565>,
    {
        self.variants(
            name,
            inputs,
            |color| primitives::PrimitiveStyle::with_stroke(color, 1),
            |color| PrimitiveStyle::with_stroke(color, 1),
        );
    }

    /// Counts fills through all variants.
    fn fills<Shape: Counted, const N: usize>(&mut self, name: &str, inputs: &[Colored<Shape>; N])
    where
        Styled<Shape, PrimitiveStyle<Rgb565>>: DrawOn<Color = Rgb565>,
    {
        self.variants(
            name,
            inputs,
            primitives::PrimitiveStyle::with_fill,
            PrimitiveStyle::with_fill,
        );
    }

    /// The styles are part of the inputs on both sides: the compiler does not see whether they are strokes or fills.
    fn variants<Shape: Counted, const N: usize>(
        &mut self,
        name: &str,
        inputs: &[Colored<Shape>; N],
        peer_style: impl Fn(Rgb565) -> primitives::PrimitiveStyle<Rgb565>,
        style: impl Fn(Rgb565) -> PrimitiveStyle<Rgb565>,
    ) where
        Styled<Shape, PrimitiveStyle<Rgb565>>: DrawOn<Color = Rgb565>,
    {
        if !self.runner.wants(name) {
            return;
        }
        let styled = inputs
            .each_ref()
            .map(|input| input.shape.into_styled(peer_style(input.color)));
        self.runner.count(name, "peer", self.peer, &styled, |canvas, styled| {
            let _ = styled.draw(&mut canvas.0);
        });
        self.zrow_variants(name, inputs, style);
    }

    /// Counts what only zrow draws.
    fn zrow_variants<Shape, const N: usize>(
        &mut self,
        name: &str,
        inputs: &[Colored<Shape>; N],
        style: impl Fn(Rgb565) -> PrimitiveStyle<Rgb565>,
    ) where
        Shape: Primitive + Copy,
        Styled<Shape, PrimitiveStyle<Rgb565>>: DrawOn<Color = Rgb565>,
        Shape: StyledDrawable<PrimitiveStyle<Rgb565>, Color = Rgb565, Output = ()>,
    {
        let Self { runner, band, .. } = self;
        if !runner.wants(name) {
            return;
        }
        let styled = inputs
            .each_ref()
            .map(|input| input.shape.into_styled(style(input.color)));
        runner.count(name, "draw", band, &styled, |canvas, styled| {
            let _ = styled.draw(&mut canvas.0);
        });
        runner.count(name, "fast", band, &styled, |canvas, styled| {
            let _ = styled.draw_on(&mut canvas.0);
        });
    }
}

/// A line from the end that is further down its minor axis: from there the peer breaks exact ties as zrow does from
/// either end, so that both draw the same pixels.
fn same_ties(one: Point, other: Point) -> Line {
    let delta = one - other;
    let minor = if delta.x.abs() >= delta.y.abs() {
        delta.y
    } else {
        delta.x
    };
    if minor > 0 {
        Line::new(one, other)
    } else {
        Line::new(other, one)
    }
}

fn triangle(mut vertex: impl FnMut() -> Point) -> Triangle {
    Triangle::new(vertex(), vertex(), vertex())
}

/// A shape that the peer and zrow draw, through both variants.
trait Counted:
    Primitive
    + Copy
    + StyledDrawable<primitives::PrimitiveStyle<Rgb565>, Color = Rgb565, Output = ()>
    + StyledDrawable<PrimitiveStyle<Rgb565>, Color = Rgb565, Output = ()>
{
}

impl<Shape> Counted for Shape where
    Shape: Primitive
        + Copy
        + StyledDrawable<primitives::PrimitiveStyle<Rgb565>, Color = Rgb565, Output = ()>
        + StyledDrawable<PrimitiveStyle<Rgb565>, Color = Rgb565, Output = ()>
{
}
