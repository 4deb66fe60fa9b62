//! The same figures into a mask of 8 bits a pixel: zrow's exact methods and four other rasterizers, each from its corners on,
//! with whatever it allocates as its interface demands.

use zrow::{
    coverage::{CoverageMethod, InsideArea, SignedArea},
    draw::{AntialiasedPolygon, FillRule},
    geometry::TooSmall,
    geometry::{Sub8, SubPoint, Window},
};
use zrow_methods::{FIGURE_SIZES, Figure, UNITS};

/// A figure in a mask of `size` x `size` pixels.
pub struct Input {
    pub figure: Figure,
    pub size: usize,
    /// In the numbers of zrow, from the centre of the first pixel.
    points: Vec<Vec<SubPoint<Sub8>>>,
    /// In those of the others: pixels from the corner of the mask.
    contours: Vec<Vec<(f32, f32)>>,
}

impl Input {
    /// Every figure in every size.
    pub fn all() -> impl Iterator<Item = Self> {
        let sized = |figure| FIGURE_SIZES.into_iter().map(move |size| Self::new(figure, size));
        Figure::ALL.into_iter().flat_map(sized)
    }

    fn new(figure: Figure, size: u32) -> Self {
        let shape = figure.shape(size);
        let pixels = |units: i32| (units + UNITS / 2) as f32 / UNITS as f32;
        let contours = shape.contours.iter();
        let points = contours.clone().map(|contour| {
            let points = contour.iter().map(|&(x, y)| SubPoint::from_units(x, y));
            points.collect::<Result<_, _>>().unwrap()
        });
        let contours = contours.map(|contour| contour.iter().map(|&(x, y)| (pixels(x), pixels(y))).collect());
        Self {
            figure,
            size: size as usize,
            points: points.collect(),
            contours: contours.collect(),
        }
    }
}

/// Someone who fills masks.
pub struct Rasterizer {
    pub name: &'static str,
    pub fill: fn(&Input) -> Vec<u8>,
}

/// All of them: one entry each.
pub const RASTERIZERS: &[Rasterizer] = &[
    Rasterizer {
        name: "zrow signed_area",
        fill: |input| zrow(&SignedArea, input),
    },
    Rasterizer {
        name: "zrow inside_area",
        fill: |input| zrow(&InsideArea, input),
    },
    Rasterizer {
        name: "zeno",
        fill: zeno,
    },
    Rasterizer {
        name: "ab_glyph_rasterizer",
        fill: ab_glyph_rasterizer,
    },
    Rasterizer {
        name: "tiny_skia",
        fill: tiny_skia,
    },
    Rasterizer {
        name: "raqote",
        fill: raqote,
    },
];

/// The row memory of an exact method: a cell more than the mask has columns.
fn zrow<T: CoverageMethod>(method: &T, input: &Input) -> Vec<u8> {
    match input.size {
        0..=16 => zrow_on::<T, 17>(method, input),
        17..=48 => zrow_on::<T, 49>(method, input),
        _ => zrow_on::<T, 201>(method, input),
    }
}

/// A table for the triangle and the star, one for the letter, or one for the ring.
fn zrow_on<T: CoverageMethod, const CELLS: usize>(method: &T, input: &Input) -> Vec<u8> {
    match input.points.iter().map(Vec::len).sum() {
        0..=8 => zrow_in::<T, CELLS, 8>(method, input),
        9..=64 => zrow_in::<T, CELLS, 64>(method, input),
        _ => zrow_in::<T, CELLS, 256>(method, input),
    }
}

fn zrow_in<T: CoverageMethod, const CELLS: usize, const EDGES: usize>(method: &T, input: &Input) -> Vec<u8> {
    // No figure has more than two contours, and one without points has no edges.
    let mut contours = [[].as_slice(); 2];
    for (contour, points) in contours.iter_mut().zip(&input.points) {
        *contour = points;
    }
    let mut polygon = AntialiasedPolygon::<EDGES, EDGES>::empty();
    polygon.set_up(&contours, FillRule::NonZero).unwrap();
    let size = input.size;
    let window = Window {
        left: 0,
        top: 0,
        right: size as i32,
        bottom: size as i32,
    };
    let mut memory = [T::Cell::default(); CELLS];
    let mut mask = vec![0; size * size];
    polygon
        .cover(method, &window, &mut memory, |span, coverage| {
            let first = span.y as usize * size + span.start as usize;
            match span.end - span.start {
                // Most spans along an edge, and too short for a call.
                1 => mask[first] = coverage,
                width => mask[first..first + width as usize].fill(coverage),
            }
            Ok::<_, TooSmall>(())
        })
        .unwrap();
    mask
}

fn zeno(input: &Input) -> Vec<u8> {
    use zeno::{Command, Mask, Vector};
    let commands: Vec<Command> = input
        .contours
        .iter()
        .flat_map(|contour| {
            let lines = contour
                .iter()
                .skip(1)
                .map(|(x, y)| Command::LineTo(Vector::new(*x, *y)));
            let (x, y) = contour[0];
            std::iter::once(Command::MoveTo(Vector::new(x, y)))
                .chain(lines)
                .chain([Command::Close])
        })
        .collect();
    let mut mask = vec![0; input.size * input.size];
    Mask::new(commands.as_slice())
        .size(input.size as u32, input.size as u32)
        .render_into(&mut mask, None);
    mask
}

fn ab_glyph_rasterizer(input: &Input) -> Vec<u8> {
    use ab_glyph_rasterizer::{Rasterizer, point};
    let mut rasterizer = Rasterizer::new(input.size, input.size);
    for contour in &input.contours {
        for ((x0, y0), (x1, y1)) in contour.iter().zip(contour.iter().cycle().skip(1)) {
            rasterizer.draw_line(point(*x0, *y0), point(*x1, *y1));
        }
    }
    let mut mask = vec![0; input.size * input.size];
    rasterizer.for_each_pixel(|index, coverage| mask[index] = (coverage * 255.0 + 0.5) as u8);
    mask
}

fn tiny_skia(input: &Input) -> Vec<u8> {
    use tiny_skia::{FillRule, Mask, PathBuilder, Transform};
    let mut builder = PathBuilder::new();
    for contour in &input.contours {
        builder.move_to(contour[0].0, contour[0].1);
        contour.iter().skip(1).for_each(|(x, y)| builder.line_to(*x, *y));
        builder.close();
    }
    let mut mask = Mask::new(input.size as u32, input.size as u32).unwrap();
    mask.fill_path(
        &builder.finish().unwrap(),
        FillRule::Winding,
        true,
        Transform::identity(),
    );
    mask.data().to_vec()
}

fn raqote(input: &Input) -> Vec<u8> {
    use raqote::{DrawOptions, DrawTarget, PathBuilder, SolidSource, Source};
    let mut builder = PathBuilder::new();
    for contour in &input.contours {
        builder.move_to(contour[0].0, contour[0].1);
        contour.iter().skip(1).for_each(|(x, y)| builder.line_to(*x, *y));
        builder.close();
    }
    // It has no masks of its own: the alpha of a picture is one.
    let mut target = DrawTarget::new(input.size as i32, input.size as i32);
    let white = Source::Solid(SolidSource {
        r: 255,
        g: 255,
        b: 255,
        a: 255,
    });
    target.fill(&builder.finish(), &white, &DrawOptions::new());
    target.get_data().iter().map(|pixel| (pixel >> 24) as u8).collect()
}
