//! Models as strangers write them, against what can be known of them without the converter.

mod letter;

use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
use png::{BitDepth, ColorType};
use zrow::{
    band::Band,
    fixed::types::{I2F14, I16F16, U0F16},
    scene::{Camera, FaceSet, Memory, Model, Pose, Rotation},
};
use zrow_mesh::{
    mesh::{Mesh, Options},
    module::{self, Origin},
    octahedral::decode,
    quantize::Up,
};

use crate::common::{CUBE, Files, OPTIONS, convert, corners, cross, obj, png, read, volume};

#[test]
fn the_checked_in_module_is_what_is_converted_today() {
    let beside: Files<'_> = &[
        ("letter.mtl", include_bytes!("models/letter.mtl")),
        ("letter.png", include_bytes!("models/letter.png")),
    ];
    let options = Options {
        size: 512,
        edges: Some(30),
        ..OPTIONS
    };
    let mesh = convert(include_bytes!("models/letter.obj"), "letter.obj", beside, options).unwrap();
    let origin = Origin {
        file: "letter.obj",
        name: None,
    };
    let module = module::write(&mesh, options, "LETTER", origin);
    assert!(
        module.source == include_str!("models/letter.rs"),
        "convert it again: the command stands in its head"
    );
    assert_eq!(letter::LETTER.vertices(), mesh.vertices);
    assert_eq!(letter::LETTER.faces(), mesh.faces);
    assert_eq!(letter::LETTER_NORMALS[..], mesh.normals);
    assert_eq!(letter::LETTER_COORDINATES[..], mesh.coordinates);
    assert_eq!(letter::LETTER_TEXTURE.as_flattened(), mesh.texture.unwrap().words);
    let bytes = size_of_val(letter::LETTER.vertices())
        + size_of_val(letter::LETTER.faces())
        + size_of_val(&letter::LETTER_COLORS)
        + size_of_val(&letter::LETTER_NORMALS)
        + size_of_val(&letter::LETTER_COORDINATES)
        + size_of_val(&letter::LETTER_TEXTURE)
        + size_of_val(&letter::LETTER_EDGES);
    assert_eq!(module.bytes, bytes);
    let faces = letter::LETTER.faces().try_into().unwrap();
    let edges = FaceSet::find_edges::<16, 15>(letter::LETTER.vertices(), faces, I2F14::lit("0.866"));
    assert_eq!(edges, Ok(letter::LETTER_EDGES));
}

/// The sum of the faces' areas, each seen along z.
fn twice_area_along_z(mesh: &Mesh) -> i64 {
    mesh.faces.iter().map(|&face| cross(corners(mesh, face))[2]).sum()
}

#[test]
fn a_cube_is_seen_from_outside_and_its_normals_point_outwards() {
    for (up, name) in [(Up::Y, "y"), (Up::Z, "z")] {
        let mesh = convert(CUBE.as_bytes(), "cube.obj", &[], Options { up, ..OPTIONS }).unwrap();
        assert_eq!(
            [mesh.vertices.len(), mesh.faces.len(), mesh.dropped],
            [8, 12, 0],
            "{name}"
        );
        assert_eq!(volume(&mesh), 6 * 200 * 200 * 200, "{name}");
        assert_eq!(mesh.greatest_error, 0.0);
        assert!(FaceSet::new(&mesh.vertices, &mesh.faces).is_ok());
        for &face in &mesh.faces {
            // The origin is the centre: each face points away from it.
            let corners = corners(&mesh, face);
            let normal = cross(corners);
            assert!(
                corners
                    .iter()
                    .all(|corner| (0..3).map(|axis| corner[axis] * normal[axis]).sum::<i64>() > 0)
            );
        }
        for (vertex, &normal) in mesh.vertices.iter().zip(&mesh.normals) {
            for (coordinate, component) in vertex.iter().zip(decode(normal)) {
                // All three faces at a corner count alike, however they are cut.
                let expected = f64::from(*coordinate) / 100.0 / 3f64.sqrt();
                assert!((component - expected).abs() < 0.01, "{vertex:?} {normal:?}");
            }
        }
        assert_eq!(mesh.colors, [[31, 63, 31]; 12]);
        assert!(mesh.coordinates.is_empty() && mesh.texture.is_none() && mesh.notes.is_empty());
    }
}

/// Draws a model from the front, 60 x 60 pixels, and returns the colours at some of them.
fn drawn(mesh: &Mesh, pixels: &[(usize, usize)]) -> Vec<u16> {
    let face_set = FaceSet::new(&mesh.vertices, &mesh.faces).unwrap();
    let colors: Vec<Rgb565> = mesh
        .colors
        .iter()
        .map(|&[red, green, blue]| Rgb565::new(red, green, blue))
        .collect();
    let distance = [I16F16::ZERO, I16F16::ZERO, I16F16::from_num(400)];
    let pose = Pose::new(Rotation::about_x(U0F16::ZERO), distance);
    let models = [Model::new(face_set, &colors).unwrap().with_pose(pose)];
    let area = Rectangle::new(Point::zero(), Size::new(60, 60));
    let camera = Camera::new(area, I16F16::from_num(10)).unwrap();
    let camera = camera.with_focal_length(I16F16::from_num(60)).unwrap();
    let mut memory = Memory::<Rgb565, 64, 64, 60, 60>::new();
    let mut scene = memory.prepare(&camera, &models).unwrap();
    let mut words = vec![0; 60 * 60];
    scene.draw(&mut Band::<Rgb565>::new(area, &mut words).unwrap());
    pixels.iter().map(|&(x, y)| words[60 * y + x]).collect()
}

/// zrow draws the faces that look at the viewer, where the file has them: to the right, upwards, nearer.
#[test]
fn zrow_draws_a_model_as_it_is() {
    let materials = b"newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n";
    let cube = "mtllib a.mtl\nusemtl red\n".to_owned() + &CUBE.replace("f 2 1", "usemtl blue\nf 2 1");
    let convert = |up| {
        let options = Options { up, ..OPTIONS };
        convert(cube.as_bytes(), "a.obj", &[("a.mtl", materials)], options).unwrap()
    };
    // The first face has the greatest z: it is in front with y up, on top with z up.
    assert_eq!(
        drawn(&convert(Up::Y), &[(30, 30), (15, 15), (2, 30)]),
        [0xf800, 0xf800, 0]
    );
    assert_eq!(
        drawn(&convert(Up::Z), &[(30, 30), (15, 15), (2, 30)]),
        [0x001f, 0x001f, 0]
    );
    // A face in the upper right corner, and the back of one in the lower left one.
    let flat = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv -1 0 0\nv -1 -1 0\nv 0 -1 0\nf 1 2 3 4\nf 1 7 6 5\n";
    let pixels = [(35, 25), (25, 35), (25, 25), (35, 35)];
    assert_eq!(drawn(&obj(flat, &[]).unwrap(), &pixels), [0xffff, 0, 0, 0]);
}

/// The corner of a model with three different lengths, in zrow's axes.
#[test]
fn axes_are_those_of_zrow() {
    let text = "v 1 2 4\nv 0 0 0\nv 1 0 0\nf 1 2 3\n";
    for (up, expected) in [(Up::Y, [25, 50, -100]), (Up::Z, [25, 100, 50])] {
        let mesh = convert(text.as_bytes(), "a.obj", &[], Options { up, ..OPTIONS }).unwrap();
        assert_eq!(mesh.vertices[usize::from(mesh.faces[0][0])], expected);
    }
}

#[test]
fn without_normals_none_are_written() {
    let options = Options { flat: true, ..OPTIONS };
    let mesh = convert(CUBE.as_bytes(), "cube.obj", &[], options).unwrap();
    assert!(mesh.normals.is_empty() && mesh.vertices.len() == 8);
    let origin = Origin {
        file: "a `cube`.obj",
        name: Some("DIE"),
    };
    let module = module::write(&mesh, options, "DIE", origin);
    for part in [
        "mesh 'a cube.obj' --size 100 --flat --name DIE\n",
        "pub static DIE: FaceSet",
        "pub static DIE_COLORS: [Rgb565; 12] = [Rgb565::new(31, 63, 31); 12];\n",
    ] {
        assert!(module.source.contains(part), "{}", module.source);
    }
    assert!(!module.source.contains("DIE_NORMALS"));
    // Two faces look along each axis, to both sides: the front one is that with z below 0.
    let mut normals: Vec<_> = mesh.face_normals(&mesh.faces).collect();
    normals.sort();
    let axes = [[-127, 0], [0, -127], [0, 0], [0, 127], [127, 0], [127, 127]];
    assert_eq!(normals, axes.map(|axis| [axis; 2]).concat());
    assert!(module.source.contains("pub static DIE_FACE_NORMALS: [[i8; 2]; 12] = ["));
    assert_eq!(module.bytes, 8 * 6 + 12 * (6 + 2 + 2));
}

/// Windows' line ends, a line that goes on, comments, negative indices, colours of vertices, lines and points, names.
#[test]
fn a_strangers_file_is_read() {
    let plain = "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 2 2 2\nf 4 3 2 1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n";
    let strange = "# made by hand\\\r\no pyramid\r\n\r\nv 0 0 0 1.0\r\nv\t4 0 0 \r\n  v 4 4 0 0.1 0.2 0.3\r\nv 0 4.0e0 -0\r\n\
        s off\r\ng base\r\nf -1 -2 \\\r\n -3 -4\r\nv 2 2 2\r\nl 1 2\r\np 1\r\nf 1/ 2// -1 # the rest\r\n\
        f 2 3 5\r\nf 3 4 5\r\nf 4 1 5";
    let (plain, strange) = (obj(plain, &[]).unwrap(), obj(strange, &[]).unwrap());
    assert_eq!(plain.vertices, strange.vertices);
    assert_eq!(plain.faces, strange.faces);
    assert_eq!(plain.normals, strange.normals);
    assert_eq!(volume(&plain), 6 * 100 * 100 * 50 / 3);
    assert_eq!(plain.notes, [""; 0]);
    assert_eq!(
        strange.notes,
        [
            "lines and points that are skipped: 2",
            "vertices with colours, which are skipped: 1"
        ]
    );
}

#[test]
fn a_concave_face_has_its_area() {
    // A comb in the plane z = 0, then the same in one that lies askew; its area by the shoelace formula.
    let points = [
        [0, 0],
        [100, 0],
        [100, 60],
        [80, 60],
        [80, 20],
        [60, 20],
        [60, 90],
        [40, 90],
        [40, 20],
        [0, 50],
    ];
    let next = points.iter().cycle().skip(1);
    let shoelace: i64 = points.iter().zip(next).map(|(a, b)| a[0] * b[1] - a[1] * b[0]).sum();
    for slope in [0, 1] {
        let mut text = String::new();
        for [x, y] in points {
            text += &format!("v {x} {y} {}\n", slope * (x - y));
        }
        let mesh = obj(&(text + "f 1 2 3 4 5 6 7 8 9 10\n"), &[]).unwrap();
        assert_eq!(mesh.faces.len(), 8);
        assert!(mesh.faces.iter().all(|&face| cross(corners(&mesh, face))[2] < 0));
        // Seen from the front, where the file's z points to.
        assert_eq!(twice_area_along_z(&mesh), -shoelace, "{slope}");
        assert!(mesh.notes.is_empty());
    }
}

#[test]
fn normals_of_the_file_split_vertices_and_zero_ones_are_computed() {
    let text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 5\nvn 0 3 4\nvn 0 0 0\nf 1//1 2//1 3//1\nf 1//2 3//2 4//3\n";
    let mesh = obj(text, &[]).unwrap();
    assert_eq!([mesh.vertices.len(), mesh.faces.len()], [6, 2]);
    let normal = |position: [i16; 3], face: usize| {
        let corners = mesh.faces[face].map(usize::from);
        let index = corners
            .into_iter()
            .find(|&index| mesh.vertices[index] == position)
            .unwrap();
        decode(mesh.normals[index])
    };
    let near =
        |found: [f64; 3], expected: [f64; 3]| found.iter().zip(expected).all(|(one, two)| (one - two).abs() < 0.01);
    assert!(near(normal([0, 0, 0], 0), [0.0, 0.0, -1.0]));
    assert!(near(normal([0, 0, 0], 1), [0.0, 0.6, -0.8]));
    assert!(near(normal([0, 100, 0], 1), [0.0, 0.0, -1.0]));
    assert_eq!(
        mesh.notes,
        ["corners with a normal of length 0, which is computed instead: 1"]
    );
}

#[test]
fn texture_coordinates_split_vertices_and_v_is_down() {
    let text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 20 20.5\nvt 21 20.5\nvt 20.25 18\n\
        f 1/1 2/2 3/3\nf 1/4 3/5 4/6\nf 1/1 2/2 3/3\n";
    let mesh = obj(text, &[]).unwrap();
    let at = |face: usize| mesh.faces[face].map(|index| mesh.coordinates[usize::from(index)]);
    assert_eq!(mesh.vertices.len(), 6);
    assert_eq!(at(0), [[0, 4_096], [4_096, 0], [4_096, 4_096]]);
    assert_eq!(mesh.faces[0], mesh.faces[2]);
    // By 20 repeats back to the right, and by 20 on downwards.
    let stored = |u: f64, v: f64| [(u * 4_096.0) as i16, (v * 4_096.0) as i16];
    assert_eq!(at(1), [stored(0.0, 0.5), stored(0.25, 3.0), stored(1.0, 0.5)]);
}

/// Only the corners that the note counts get those of the upper left corner, and others of their face keep their own.
#[test]
fn corners_without_texture_coordinates_are_those_of_the_note() {
    let text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 20 20.5\nvt 21 20.5\n\
        f 1/1 2/2 3\nf 1/3 3/4 4\nf 1 2 3\n";
    let mesh = obj(text, &[]).unwrap();
    let at = |face: usize| mesh.faces[face].map(|index| mesh.coordinates[usize::from(index)]);
    assert_eq!(at(0), [[0, 4_096], [0, 0], [4_096, 4_096]]);
    // By 20 repeats back to the right, and by 20 on downwards, but for the corner without any.
    assert_eq!(at(1), [[0, 2_048], [0, 0], [4_096, 2_048]]);
    assert_eq!(at(2), [[0, 0]; 3]);
    assert_eq!(
        mesh.notes,
        ["corners without texture coordinates, which get those of the texture's upper left corner: 5"]
    );
}

#[test]
fn materials_give_colors_and_one_texture() {
    let materials = b"# two\nnewmtl dark red\nKd 0.5 0 0\nNs 10\nnewmtl map\r\nmap_Kd pictures\\a b.png\n";
    let text = "mtllib lib/my materials.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\n\
        usemtl dark red\nf 1 2 3\nusemtl map\nf 1/1 2/2 3/3\n";
    let picture = png(
        2,
        1,
        ColorType::Rgba,
        BitDepth::Eight,
        &[255, 0, 0, 255, 0, 255, 255, 0],
    );
    let beside: Files<'_> = &[("lib/my materials.mtl", materials), ("lib/pictures/a b.png", &picture)];
    let mesh = obj(text, beside).unwrap();
    assert_eq!(mesh.colors, [[16, 0, 0], [31, 63, 31]]);
    let texture = mesh.texture.unwrap();
    assert_eq!([texture.width, texture.height], [2, 1]);
    assert_eq!(texture.words, [0xf800, 0x07ff]);
    assert_eq!(
        mesh.notes,
        [
            "corners without texture coordinates, which get those of the texture's upper left corner: 3",
            "lib/pictures/a b.png has pixels that are not opaque: they become opaque"
        ]
    );
    // A texture that no face has is not read.
    let without = obj(&text.replace("usemtl map\n", ""), &beside[..1]).unwrap();
    assert!(without.texture.is_none());
}

#[test]
fn all_kinds_of_8_bit_pictures_are_read() {
    let kinds: [(ColorType, &[u8], [u16; 2]); 5] = [
        (ColorType::Grayscale, &[0, 255], [0, 0xffff]),
        (ColorType::GrayscaleAlpha, &[0, 255, 128, 255], [0, 0x8410]),
        (ColorType::Rgb, &[8, 4, 8, 0, 0, 255], [0x0821, 0x001f]),
        (ColorType::Rgba, &[0, 255, 0, 255, 255, 255, 255, 255], [0x07e0, 0xffff]),
        (ColorType::Indexed, &[1, 3], [0x07e0, 0xffff]),
    ];
    for (color, bytes, words) in kinds {
        let picture = png(2, 1, color, BitDepth::Eight, bytes);
        let texture = zrow_mesh::texture::parse(&picture).unwrap();
        assert_eq!(texture.words, words, "{color:?}");
        assert!(!texture.has_alpha);
    }
    let bits = png(8, 1, ColorType::Grayscale, BitDepth::One, &[0b1010_0001]);
    let words = zrow_mesh::texture::parse(&bits).unwrap().words;
    assert_eq!(
        words.iter().map(|&word| word & 1).collect::<Vec<_>>(),
        [1, 0, 1, 0, 0, 0, 0, 1]
    );
}

#[test]
fn a_model_is_rounded_and_faces_without_area_are_dropped() {
    // The second triangle is 1/4 unit high.
    let text = "v 0 0 0\nv 10.04 0 0\nv 0 5 0\nv 10.04 0.025 0\nv 5000 0 0\nf 1 2 3\nf 1 2 4\nf 1 1 2\nf 1 2 2 3\n";
    let mesh = obj(text, &[]).unwrap();
    assert_eq!([mesh.faces.len(), mesh.dropped], [2, 3]);
    // 5 / 10.04 * 100 is 49.80; the corner of the dropped triangle moves by 0.249.
    assert!((mesh.greatest_error - 0.249).abs() < 0.001, "{}", mesh.greatest_error);
    assert!(
        (mesh.mean_error - (0.2 + 0.249) / 4.0).abs() < 0.001,
        "{}",
        mesh.mean_error
    );
}

#[test]
fn a_face_that_is_not_planar_is_named() {
    let text = "v 0 0 0\nv 1 0 0\nv 1 1 0.2\nv 0 1 0\nf 1 2 3 4\n";
    let mesh = obj(text, &[]).unwrap();
    assert_eq!(mesh.faces.len(), 2);
    // Corners of a square that are 0 and 20 units high, alternately half of it above and below the plane through the mean: 5
    // / |n|.
    let expected = 5.0 / (1.0f64 + 2.0 * 0.01).sqrt();
    assert_eq!(
        mesh.notes,
        [format!(
            "faces that are not planar: 1, by up to {expected:.2} units (model.obj line 5); they are cut into triangles"
        )]
    );
    let crossing = obj("v 0 0 0\nv 3 0 0\nv 1 2 0\nv 3 3 0\nf 1 2 3 4\n", &[]).unwrap();
    assert!(crossing.notes[0].contains("cross themselves"), "{:?}", crossing.notes);
}

/// A cube as an STL of text, and as a binary one whose title begins with "solid", too.
#[test]
fn stl_of_text_and_binary_give_one_module() {
    let cube = read(CUBE.as_bytes(), "cube.obj", &[]).unwrap();
    let mut text = "solid cube\n".to_owned();
    let mut binary = [b"solid cube".as_slice(), &[0; 70], &12u32.to_le_bytes()].concat();
    for face in &cube.faces {
        let corners: Vec<[f64; 3]> = cube
            .corners_of(face)
            .iter()
            .map(|corner| cube.positions[corner.position])
            .collect();
        for triangle in [[0, 1, 2], [0, 2, 3]] {
            text += "  facet normal 0 0 0\n    outer loop\n";
            binary.extend([0; 12]);
            for [x, y, z] in triangle.map(|index| corners[index].map(|number| number / 3.0 + 0.1)) {
                let single = [x, y, z].map(|number| number as f32);
                text += &format!("      vertex {} {:e} {}\r\n", single[0], single[1], single[2]);
                binary.extend(single.iter().flat_map(|number| number.to_le_bytes()));
            }
            text += "    endloop\n  endfacet\n";
            binary.extend([0; 2]);
        }
    }
    text += "endsolid cube\n";
    let options = Options { up: Up::Z, ..OPTIONS };
    let origin = Origin {
        file: "cube.stl",
        name: None,
    };
    let [text, binary] = [text.as_bytes(), &binary].map(|bytes| convert(bytes, "cube.stl", &[], options).unwrap());
    assert_eq!([text.vertices.len(), text.faces.len()], [8, 12]);
    assert!(volume(&text) > 0);
    let [text, binary] = [text, binary].map(|mesh| module::write(&mesh, options, "CUBE", origin).source);
    assert_eq!(text, binary);
    assert!(text.contains("mesh cube.stl --size 100 --z-up\n"), "{text}");
}
