//! Fog: curves and distances against floating point, and what is seen in front of it, in it and behind it.

use embedded_graphics::{
    pixelcolor::{Rgb565, Rgb888},
    prelude::*,
};
use fixed::types::{I16F16, U0F16};
use proptest::prelude::*;
use zrow::{
    band::{Band, BandColor},
    scene::{Camera, Deep, FaceSet, Fine, Look, Memory, Model, Pose, Rotation},
    shade::{
        ChannelColor, DirectionalLight, Fog, Foggy, Gouraud, GouraudSkin, Lambert, LitTextured, LitTexturedSkin,
        Perspective, Shading, Texels, Textured, TexturedSkin,
    },
};

use crate::common::meshes::Mesh;
use crate::common::{cases, config};
use crate::numbered_scene::area;
use crate::same_looks::Careful;
use crate::shaded_scene::{SIZE, SmallMemory, TEXELS, UNTOUCHED, camera_in_units, words};
use crate::shading_bands::WordOf;
use crate::snapped_faces::at;

/// Curves that tell each two steps beside each other apart, together.
static CURVES: [[u8; 64]; 2] = {
    let mut curves = [[0; 64]; 2];
    let mut step = 0;
    while step < 64 {
        curves[0][step] = (step / 2) as u8;
        curves[1][step] = (step as u8).div_ceil(2);
        step += 1;
    }
    curves
};

fn fog<C>(color: C, start: f64, end: f64, curve: &[u8; 64]) -> Fog<'_, C> {
    Fog {
        color,
        start: I16F16::saturating_from_num(start),
        end: I16F16::saturating_from_num(end),
        curve,
    }
}

/// Curves are the formulas that their docs state, rounded to the nearest of 33 steps.
#[test]
fn curves_are_their_formulas() {
    for step in 0..64 {
        let way = step as f64 / 63.0;
        let linear = 32.0 * way;
        assert!((f64::from(Fog::LINEAR[step]) - linear).abs() <= 0.5, "{step}");
        let exponential = 32.0 * (1.0 - (-4.0 * way).exp());
        let drawn = f64::from(Fog::EXPONENTIAL[step]);
        assert!((drawn - exponential).abs() <= 0.5 || step == 63, "{step}: {drawn}");
    }
    for curve in [Fog::LINEAR, Fog::EXPONENTIAL] {
        assert_eq!([curve[0], curve[63]], [0, 32]);
        assert!(curve.is_sorted());
    }
}

/// Each distance has the fog of its step of the curve; too much is all.
#[test]
fn fragments_have_the_fog_of_their_distance() {
    let mut curve: [u8; 64] = core::array::from_fn(|step| (step * 7 % 33) as u8);
    (curve[9], curve[63]) = (255, 33);
    let (color, own) = (Rgb888::new(250, 0, 77), Rgb888::new(3, 255, 77));
    let fog = fog(color, 0.0, 1.0, &curve);
    let skin: (&[Rgb888], _) = (&[], fog);
    for distance in i16::MIN..=i16::MAX {
        for fraction in [0, 1, 0xffff] {
            let value = i32::from(distance) << 16 | fraction;
            let word = Foggy::<Rgb888>::fragment(&skin, own.into_storage(), &((), [value])).unwrap();
            let step = (i32::from(distance).div_euclid(8)).clamp(0, 63);
            let factor = u32::from(curve[step as usize]).min(32);
            let mixed = |own: u8, fog: u8| ((u32::from(own) * (32 - factor) + u32::from(fog) * factor) / 32) as u8;
            let expected = Rgb888::new(mixed(3, 250), mixed(255, 0), 77);
            assert_eq!(word, expected.into_storage(), "{distance}");
        }
    }
}

/// The distance of a vertex from the start of a fog, in 1/512 of the way to its end.
fn distance(fog: Fog<'_, Rgb888>, pose: &Pose, camera: &Camera, vertex: [i16; 3]) -> i16 {
    let skin: (&[Rgb888], _) = (&[], fog);
    let uniforms = Foggy::<Rgb888>::uniforms(&skin, pose, camera);
    let ((), Perspective([distance])) = Foggy::<Rgb888>::vertex(&skin, &uniforms, 0, vertex.map(i32::from));
    distance
}

fn rotation() -> impl Strategy<Value = Rotation> {
    any::<[u16; 3]>().prop_map(|angles| {
        let [a, b, c] = angles.map(U0F16::from_bits);
        Rotation::about_z(a)
            .then(&Rotation::about_x(b))
            .then(&Rotation::about_y(c))
    })
}

fn any_pose() -> impl Strategy<Value = Pose> {
    (rotation(), any::<[i32; 3]>()).prop_map(|(rotation, bits)| Pose::new(rotation, bits.map(I16F16::from_bits)))
}

fn any_distance() -> impl Strategy<Value = i32> {
    prop_oneof![
        3 => (0i32..8_000).prop_map(|units| units << 16),
        1 => any::<i32>(),
        1 => prop::sample::select(vec![i32::MIN, i32::MIN + 1, -1, 0, 1, i32::MAX]),
    ]
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// The z coordinate of a vertex before a camera.
fn depth(pose: &Pose, camera: &Pose, vertex: [i16; 3]) -> f64 {
    let matrix = |pose: &Pose| {
        pose.rotation
            .matrix()
            .map(|row| row.map(|element| element.to_num::<f64>()))
    };
    let (model, eye) = (matrix(pose), matrix(camera));
    let vertex = vertex.map(f64::from);
    let from_camera = [0, 1, 2].map(|axis| {
        dot(model[axis], vertex) + pose.translation[axis].to_num::<f64>() - camera.translation[axis].to_num::<f64>()
    });
    dot(from_camera, [eye[0][2], eye[1][2], eye[2][2]])
}

proptest! {
    #![proptest_config(config(cases(5_000, 300_000)))]

    /// The distance of a vertex is rounded down to 1/512 of the way; what is farther from the start than 63 ways is as far as
    /// that. A matrix of the view has 14 fractional bits.
    #[test]
    fn vertices_have_their_distances(
        model in any_pose(),
        eye in any_pose(),
        vertex in any::<[i16; 3]>(),
        size in 0u32..16,
        start in any_distance(),
        end in any_distance(),
    ) {
        let camera = camera_in_units().with_pose(eye);
        let vertex = vertex.map(|axis| axis >> size);
        let [start, end] = [start, end].map(I16F16::from_bits);
        let fog = Fog { color: Rgb888::WHITE, start, end, curve: Fog::LINEAR };
        let found = f64::from(distance(fog, &model, &camera, vertex)) / 512.0;
        let way = (end.to_num::<f64>() - start.to_num::<f64>()).max(1.0);
        let error = 0.01 + vertex.map(|axis| f64::from(axis).abs() / 32_768.0).iter().sum::<f64>();
        let distance = |error: f64| {
            let beyond = depth(&model, &eye, vertex) - start.to_num::<f64>() + error;
            (beyond / way).clamp(-63.0, 63.0)
        };
        // Start and end are rounded to 1/4,096 unit; the farther away, the more that is.
        let of_way = 1.0 / 512.0 + distance(0.0).abs() / (1_024.0 * way);
        prop_assert!(
            (distance(-error) - of_way..=distance(error) + of_way).contains(&found),
            "{found}, not {}, {fog:?}", distance(0.0)
        );
    }
}

/// A face much farther away than the end of a fog is the fog's, also where no number of 16 bits says how far.
#[test]
fn the_farthest_faces_are_all_fog() {
    let vertices = [
        [-32_000, -32_000, 32_767],
        [0, 32_000, 32_767],
        [32_000, -32_000, 32_767],
    ];
    let mesh = FaceSet::new(&vertices, &[[0, 1, 2]]).unwrap();
    let camera = camera_in_units().with_pose(Pose::new(Rotation::IDENTITY, at(0, 0, -32_768)));
    let pose = Pose::new(Rotation::IDENTITY, at(0, 0, 32_767));
    for (start, way) in (-8..8).flat_map(|start| (1..1_400).step_by(3).map(move |way| (start * 4_096, way))) {
        let fog = fog(
            Rgb888::WHITE,
            f64::from(start),
            f64::from(start) + f64::from(way) + 0.3,
            Fog::LINEAR,
        );
        if start + way < 32_000 {
            let far = distance(fog, &pose, &camera, [0, 0, 32_767]);
            assert!(far > 512, "{far} from {start} on, way of {way}");
            let models = [Model::<Foggy<Rgb888>>::with_skin(mesh, (&[Rgb888::BLACK][..], fog))
                .unwrap()
                .with_pose(pose)];
            let mut memory = Box::new(SmallMemory::<Foggy<Rgb888>>::new());
            let words = words(&mut memory.prepare(&camera, &models).unwrap(), area(121, 79));
            let seen = words.into_iter().filter(|&word| word != UNTOUCHED);
            assert_eq!(
                seen.filter(|&word| word != 0xff_ffff).count(),
                0,
                "from {start} on, way of {way}"
            );
        }
    }
}

/// A quadrangle in space: a corner, and two sides.
type Quad = [[i16; 3]; 3];

/// How far away the plane of a quadrangle is at a pixel; `None` beside the quadrangle.
fn along_ray([corner, a, b]: Quad, [x, y]: [f64; 2]) -> Option<f64> {
    let [corner, a, b] = [corner, a, b].map(|vector| vector.map(f64::from));
    let ray = [(x - 60.0) / 64.0, (39.0 - y) / 64.0, 1.0];
    let cross = |u: [f64; 3], v: [f64; 3]| [1, 2, 0].map(|i| u[i] * v[(i + 1) % 3] - u[(i + 1) % 3] * v[i]);
    let volume = dot(ray, cross(a, b));
    let [s, t] = [dot(ray, cross(b, corner)) / volume, dot(ray, cross(corner, a)) / volume];
    let distance = dot(corner, cross(a, b)) / volume;
    let inside = distance > 128.0 && [s, t].iter().all(|part| (0.0..=1.0).contains(part));
    inside.then_some(distance)
}

/// Draws a black quadrangle in a white fog, with both curves. Where distances are divided, the step of each pixel is that of a
/// distance within 1/64 of the way from the exact one, beside what a quarter of a pixel is. Returns how many were compared.
fn check_quad<L: Look<Color = Rgb888, Shading = Foggy<Rgb888>>>(quad: Quad, start: f64, way: f64) -> usize {
    let [corner, a, b] = quad;
    let plus = |u: [i16; 3], v: [i16; 3]| [u[0] + v[0], u[1] + v[1], u[2] + v[2]];
    let vertices = vec![corner, plus(corner, a), plus(plus(corner, a), b), plus(corner, b)];
    let mesh = Mesh::new(vertices, vec![[0, 1, 2], [0, 2, 3]]).two_sided();
    let camera = camera_in_units();
    let mut memory = Box::new(SmallMemory::<L>::new());
    let mut compared = 0;
    for curve in &CURVES {
        let skin = (&[Rgb888::BLACK; 4][..], fog(Rgb888::WHITE, start, start + way, curve));
        let models = [Model::<Foggy<Rgb888>>::with_skin(mesh.face_set(), skin).unwrap()];
        let words = words(
            &mut memory.prepare(&camera, &models).unwrap(),
            camera.viewport().to_rectangle(),
        );
        for (x, y) in (0..8).flat_map(|column| (0..79).map(move |row| (16 * column, row))) {
            let at = |right: f64, down: f64| along_ray(quad, [f64::from(x) + right, f64::from(y) + down]);
            let around = [
                at(0.25, 0.0),
                at(-0.25, 0.0),
                at(0.0, 0.25),
                at(0.0, -0.25),
                at(0.0, 0.0),
            ];
            let Some(around) = around.into_iter().collect::<Option<Vec<_>>>() else {
                continue;
            };
            let level = |distance: f64| {
                let step = ((distance - start) / way * 64.0).floor().clamp(0.0, 63.0);
                255 * u32::from(curve[step as usize]) / 32
            };
            let (least, most) = around.iter().fold((f64::MAX, 0.0), |(least, most), distance| {
                (distance.min(least), distance.max(most))
            });
            let drawn = words[(y * SIZE[0] + x) as usize] & 0xff;
            let levels = level(least - way / 64.0)..=level(most + way / 64.0);
            assert!(
                levels.contains(&drawn),
                "{x}, {y}: {drawn}, not {levels:?}, {around:?}, {start}, {way} of {quad:?}"
            );
            compared += 1;
        }
    }
    compared
}

proptest! {
    #![proptest_config(config(cases(100, 3_000)))]

    /// Quadrangles in any directions, also such as the near plane and the guard band cut.
    #[test]
    fn distances_vary_in_perspective(
        corner in [-900i16..900, -900i16..900, -600i16..1_600],
        sides in prop::array::uniform2(prop::array::uniform3(-3_000i16..3_000)),
        start in 0.0..3_000.0f64,
        way in 300.0..4_000.0f64,
    ) {
        check_quad::<Foggy<Rgb888>>([corner, sides[0], sides[1]], start, way);
        check_quad::<Fine<Foggy<Rgb888>>>([corner, sides[0], sides[1]], start, way);
        check_quad::<Fine<Deep<Foggy<Rgb888>>>>([corner, sides[0], sides[1]], start, way);
    }

    /// No fog of any numbers panics; the least way from start to end is one unit.
    #[test]
    fn any_fog_is_drawn(
        start in any_distance(),
        end in any_distance(),
        curve in prop::array::uniform32(any::<[u8; 2]>()),
        corner in [-900i16..900, -900i16..900, -600i16..1_600],
        sides in prop::array::uniform2(prop::array::uniform3(-3_000i16..3_000)),
        model in any_pose(),
    ) {
        let curve: Vec<u8> = curve.concat();
        let curve: &[u8; 64] = curve[..].try_into().unwrap();
        let [start, end] = [start, end].map(I16F16::from_bits);
        let fog = Fog { color: Rgb888::WHITE, start, end, curve };
        let [vertex, a, b] = [corner, sides[0], sides[1]];
        let mesh = Mesh::new(vec![vertex, a, b], vec![[0, 1, 2]]).two_sided();
        for pose in [Pose::IDENTITY, model] {
            let skin = (&[Rgb888::BLACK; 2][..], fog);
            let model = Model::<Foggy<Rgb888>>::with_skin(mesh.face_set(), skin).unwrap();
            let models = [model.with_pose(pose)];
            let mut memory = Box::new(SmallMemory::<Foggy<Rgb888>>::new());
            let drawn = words(&mut memory.prepare(&camera_in_units(), &models).unwrap(), area(121, 79));
            let greatest = curve.iter().map(|&fog| u32::from(fog.min(32)) * 255 / 32).max().unwrap();
            let of_curve = |word: &u32| *word == UNTOUCHED || word & 0xff <= greatest;
            prop_assert!(drawn.iter().all(of_curve));
        }
    }
}

/// The comparison sees a floor from before the camera to far away, in fog of all kinds.
#[test]
fn a_floor_goes_into_the_fog() {
    let floor = [[-4_000, -300, -500], [8_000, 0, 0], [0, 0, 9_000]];
    for (start, way) in [(0.0, 1_000.0), (1_000.0, 500.0), (500.0, 8_000.0)] {
        let compared = check_quad::<Foggy<Rgb888>>(floor, start, way);
        assert!(compared > 300, "{compared}");
    }
}

/// The words of a scene of one model, on black.
fn picture<'a, L: Look<Color: RgbColor>>(mesh: &'a Mesh, skin: <L::Shading as Shading>::Skin<'a>) -> Vec<WordOf<L>> {
    let camera = camera_in_units();
    let area = camera.viewport().to_rectangle();
    let mut memory = Box::new(Memory::<L, 64, 16, 128, 79, 16>::new());
    let mut words = vec![L::Color::BLACK.to_word(); (area.size.width * area.size.height) as usize];
    let models = [Model::<L::Shading>::with_skin(mesh.face_set(), skin).unwrap()];
    memory
        .prepare(&camera, &models)
        .unwrap()
        .draw(&mut Band::<L::Color>::new(area, &mut words).unwrap());
    words
}

/// In front of a fog each pixel is what it is without one, behind its end each has the fog's colour.
fn check_ends<'a, L, F>(mesh: &'a Mesh, skin: <L::Shading as Shading>::Skin<'a>, color: L::Color)
where
    L: Look<Color: RgbColor>,
    F: Look<Color = L::Color, Shading = Foggy<L::Shading>>,
    L::Shading: Shading<Color: ChannelColor>,
    WordOf<L>: PartialEq,
{
    let black = L::Color::BLACK.to_word();
    let own = picture::<L>(mesh, skin);
    assert!(own.iter().filter(|&&word| word != black).count() > 2_000);
    for curve in [Fog::LINEAR, Fog::EXPONENTIAL] {
        let before = picture::<F>(mesh, (skin, fog(color, 3_000.0, 4_000.0, curve)));
        assert!(before == own, "before the fog");
        // Start behind the end: as thick as can be one unit behind the start.
        for (start, end) in [
            (100.0, 600.0),
            (-20_000.0, -9_000.0),
            (500.0, 400.0),
            (-32_768.0, -32_768.0),
        ] {
            let behind = picture::<F>(mesh, (skin, fog(color, start, end, curve)));
            let expected = own
                .iter()
                .map(|&word| if word == black { black } else { color.to_word() });
            assert!(behind.into_iter().eq(expected), "behind the fog from {start} to {end}");
        }
    }
}

#[test]
fn fog_keeps_what_is_before_it_and_hides_what_is_behind() {
    // From 700 to 2,500 units away.
    let vertices = vec![
        [-600, -400, 700],
        [-1_500, 1_400, 2_500],
        [1_500, 1_300, 2_400],
        [600, -400, 800],
    ];
    let mesh = Mesh::new(vertices, vec![[0, 1, 2], [0, 2, 3]]);
    let colors = [Rgb565::RED, Rgb565::new(3, 50, 9), Rgb565::WHITE, Rgb565::YELLOW];
    let normals = [[0, 0], [127, 0], [0, -127], [60, 60]];
    let coordinates = [[0, 0], [9_000, 0], [9_000, 9_000], [0, 9_000]];
    let lights = Lambert {
        ambient: U0F16::from_num(0.7),
        lights: [DirectionalLight::from_direction([0, 0, -1].map(I16F16::from_num), U0F16::from_num(0.2)).unwrap()],
        points: [],
    };
    let (flat, color) = ([Rgb888::RED, Rgb888::new(3, 50, 9)], Rgb565::new(9, 60, 1));
    check_ends::<Rgb888, Foggy<Rgb888>>(&mesh, &flat, Rgb888::new(9, 60, 1));
    check_ends::<Gouraud<Rgb565>, Foggy<Gouraud<Rgb565>>>(
        &mesh,
        GouraudSkin {
            colors: &colors,
            normals: &normals,
            lights,
        },
        color,
    );
    check_ends::<Textured<Texels<Rgb565, 16, 16>>, Foggy<Textured<Texels<Rgb565, 16, 16>>>>(
        &mesh,
        TexturedSkin {
            image: &TEXELS,
            coordinates: &coordinates,
        },
        color,
    );
    let skin = LitTexturedSkin {
        image: &TEXELS,
        coordinates: &coordinates,
        normals: &normals,
        lights,
    };
    type Lit = LitTextured<Texels<Rgb565, 16, 16>>;
    check_ends::<Lit, Foggy<Lit>>(&mesh, skin, color);
    check_ends::<Careful<Lit>, Careful<Foggy<Lit>>>(&mesh, skin, color);
}
