//! The same shapes into a mask of 8 bits a pixel: zrow's exact tiers and four other rasterizers, each from its corners on,
//! with whatever it allocates as its interface demands.

use std::{f32::consts::TAU, hint::black_box};

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use zrow::{
    band::BufferTooSmall,
    coverage::{Coverage, InsideArea, SignedArea},
    draw::{AntialiasedPolygon, FillRule},
    geometry::{Sub8, SubPoint, Window},
};

/// Contours in pixels from the corner of the mask.
type Contours = Vec<Vec<(f32, f32)>>;

/// Edges of a shape, at most.
const EDGES: usize = 256;

/// A shape in a mask of `size` pixels.
fn shapes(size: f32) -> [(&'static str, Contours); 4] {
    let regular = |radius: f32, corners: usize, step: usize| -> Vec<(f32, f32)> {
        let corner = |index: usize| {
            let angle = (index * step) as f32 / corners as f32 * TAU - TAU / 4.0;
            let place = |part: f32| ((size * (0.5 + radius * part)) * 256.0).round() / 256.0;
            (place(angle.cos()), place(angle.sin()))
        };
        (0..corners).map(corner).collect()
    };
    let scaled = |corners: &[(f32, f32)]| -> Vec<(f32, f32)> {
        let place = |part: f32| (part * size / 48.0 * 256.0).round() / 256.0;
        corners.iter().map(|(x, y)| (place(*x), place(*y))).collect()
    };
    let mut hole = regular(0.3, 96, 1);
    hole.reverse();
    // A letter with a round belly and a stem.
    let mut belly: Vec<(f32, f32)> = regular(0.2, 32, 1);
    belly.reverse();
    let glyph = vec![
        scaled(&[
            (8.3, 4.1),
            (15.2, 4.1),
            (15.2, 18.0),
            (20.5, 13.3),
            (29.4, 13.2),
            (37.0, 18.1),
            (40.3, 27.4),
            (37.6, 37.2),
            (30.1, 43.0),
            (20.6, 42.4),
            (15.2, 38.0),
            (15.2, 42.3),
            (8.3, 42.3),
        ]),
        belly,
    ];
    [
        ("triangle", vec![scaled(&[(3.3, 2.1), (44.2, 17.7), (12.6, 45.4)])]),
        ("ring", vec![regular(0.45, 128, 1), hole]),
        ("star", vec![regular(0.458, 7, 3)]),
        ("glyph", glyph),
    ]
}

fn zrow<T: Coverage>(tier: &T, contours: &Contours, size: usize) -> Vec<u8> {
    let points: Vec<Vec<SubPoint<Sub8>>> = contours
        .iter()
        .map(|contour| {
            let point = |(x, y): &(f32, f32)| SubPoint::from_units((x * 256.0) as i32 - 128, (y * 256.0) as i32 - 128);
            contour.iter().map(|corner| point(corner).unwrap()).collect()
        })
        .collect();
    let slices: Vec<&[SubPoint<Sub8>]> = points.iter().map(Vec::as_slice).collect();
    let polygon = AntialiasedPolygon::<EDGES, EDGES>::prepare(slices.as_slice(), FillRule::NonZero).unwrap();
    let window = Window {
        left: 0,
        top: 0,
        right: size as i32,
        bottom: size as i32,
    };
    let mut memory = vec![T::Cell::default(); T::cells(size)];
    let mut mask = vec![0; size * size];
    polygon
        .cover(tier, &window, &mut memory, |span, share| {
            let row = span.y as usize * size;
            mask[row + span.start as usize..row + span.end as usize].fill(share);
            Ok::<_, BufferTooSmall>(())
        })
        .unwrap();
    mask
}

fn zeno(contours: &Contours, size: usize) -> Vec<u8> {
    use zeno::{Command, Mask, Vector};
    let commands: Vec<Command> = contours
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
    let mut mask = vec![0; size * size];
    Mask::new(commands.as_slice())
        .size(size as u32, size as u32)
        .render_into(&mut mask, None);
    mask
}

fn ab_glyph(contours: &Contours, size: usize) -> Vec<u8> {
    use ab_glyph_rasterizer::{Rasterizer, point};
    let mut rasterizer = Rasterizer::new(size, size);
    for contour in contours {
        for ((x0, y0), (x1, y1)) in contour.iter().zip(contour.iter().cycle().skip(1)) {
            rasterizer.draw_line(point(*x0, *y0), point(*x1, *y1));
        }
    }
    let mut mask = vec![0; size * size];
    rasterizer.for_each_pixel(|index, share| mask[index] = (share * 255.0).round() as u8);
    mask
}

fn tiny_skia(contours: &Contours, size: usize) -> Vec<u8> {
    use tiny_skia::{FillRule, Mask, PathBuilder, Transform};
    let mut builder = PathBuilder::new();
    for contour in contours {
        builder.move_to(contour[0].0, contour[0].1);
        contour.iter().skip(1).for_each(|(x, y)| builder.line_to(*x, *y));
        builder.close();
    }
    let mut mask = Mask::new(size as u32, size as u32).unwrap();
    mask.fill_path(
        &builder.finish().unwrap(),
        FillRule::Winding,
        true,
        Transform::identity(),
    );
    mask.data().to_vec()
}

fn raqote(contours: &Contours, size: usize) -> Vec<u8> {
    use raqote::{DrawOptions, DrawTarget, PathBuilder, SolidSource, Source};
    let mut builder = PathBuilder::new();
    for contour in contours {
        builder.move_to(contour[0].0, contour[0].1);
        contour.iter().skip(1).for_each(|(x, y)| builder.line_to(*x, *y));
        builder.close();
    }
    let mut target = DrawTarget::new(size as i32, size as i32);
    let white = Source::Solid(SolidSource {
        r: 255,
        g: 255,
        b: 255,
        a: 255,
    });
    target.fill(&builder.finish(), &white, &DrawOptions::new());
    target.get_data().iter().map(|pixel| (pixel >> 24) as u8).collect()
}

fn coverage(criterion: &mut Criterion) {
    for size in [16, 48, 200] {
        for (name, contours) in shapes(size as f32) {
            let mut group = criterion.benchmark_group(format!("{name}_{size}"));
            let mut bench = |method: &str, fill: &dyn Fn(&Contours, usize) -> Vec<u8>| {
                // All fill the same shape: their sums differ by less than an edge's share.
                let sum: u64 = fill(&contours, size).iter().map(|share| u64::from(*share)).sum();
                assert!(sum > 0, "{method} drew nothing");
                group.bench_function(BenchmarkId::from_parameter(method), |bencher| {
                    bencher.iter(|| fill(black_box(&contours), black_box(size)));
                });
            };
            bench("zrow signed area", &|contours, size| zrow(&SignedArea, contours, size));
            bench("zrow inside area", &|contours, size| zrow(&InsideArea, contours, size));
            bench("zeno", &zeno);
            bench("ab_glyph_rasterizer", &ab_glyph);
            bench("tiny-skia", &tiny_skia);
            bench("raqote", &raqote);
            group.finish();
        }
    }
}

criterion_group!(benches, coverage);
criterion_main!(benches);
