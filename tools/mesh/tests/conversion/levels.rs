//! Levels of detail: closed meshes stay closed, faces keep their side, seams and borders their place; whatever the mesh is.

use std::{
    collections::{BTreeSet, HashMap},
    f64::consts::TAU,
    fmt::Write,
    time::Instant,
};

use zrow::scene::FaceSet;
use zrow_mesh::{
    level::{Level, pick_from},
    levels,
    mesh::{Mesh, Options},
    module::{self, Origin},
    octahedral::decode,
};

use crate::common::{OPTIONS, Random, convert, cross, obj};

mod pebble;

/// Six levels at most, of a size of 1,000.
const LEVELS: Options = Options {
    size: 1_000,
    levels: 6,
    ..OPTIONS
};

/// A surface of rows of points, each closed, and the rows closed too where they go round: as many as are asked for.
fn rows(rows: usize, columns: usize, is_closed: bool, point: impl Fn(usize, usize) -> [f64; 3]) -> String {
    let mut text = String::new();
    for row in 0..rows {
        for column in 0..columns {
            let [x, y, z] = point(row, column);
            writeln!(text, "v {x} {y} {z}").unwrap();
        }
    }
    let index = |row: usize, column: usize| row % rows * columns + column % columns + 1;
    for row in 0..if is_closed { rows } else { rows - 1 } {
        for column in 0..columns {
            let [a, b] = [index(row, column), index(row, column + 1)];
            let [c, d] = [index(row + 1, column + 1), index(row + 1, column)];
            writeln!(text, "f {a} {b} {c} {d}").unwrap();
        }
    }
    text
}

/// A torus with bumps: 24 times 40 points.
fn torus() -> String {
    rows(40, 24, true, |row, column| {
        let (around, tube) = (TAU * row as f64 / 40.0, TAU * column as f64 / 24.0);
        let thick = 0.4 + 0.03 * (3.0 * around).sin() * (2.0 * tube).cos();
        let radius = 1.0 + thick * tube.cos();
        [radius * around.cos(), thick * tube.sin(), radius * around.sin()]
    })
}

/// A ball of 23 circles of 32 points, and both poles.
fn ball() -> String {
    let mut text = rows(23, 32, false, |row, column| {
        let (height, around) = (TAU / 2.0 * (row + 1) as f64 / 24.0, TAU * column as f64 / 32.0);
        [height.sin() * around.cos(), height.cos(), height.sin() * around.sin()]
    });
    text += "v 0 1 0\nv 0 -1 0\n";
    for column in 0..32 {
        let next = (column + 1) % 32;
        let (top, bottom) = (23 * 32 + 1, 23 * 32 + 2);
        writeln!(text, "f {top} {} {}", next + 1, column + 1).unwrap();
        writeln!(text, "f {bottom} {} {}", 22 * 32 + column + 1, 22 * 32 + next + 1).unwrap();
    }
    text
}

/// The positions of a face.
fn positions(mesh: &Mesh, face: [u16; 3]) -> [[i64; 3]; 3] {
    face.map(|vertex| mesh.vertices[usize::from(vertex)].map(i64::from))
}

/// How often each edge is passed from one position to the other.
fn edges(mesh: &Mesh, faces: &[[u16; 3]]) -> HashMap<[[i64; 3]; 2], usize> {
    let mut edges = HashMap::new();
    for &face in faces {
        let [a, b, c] = positions(mesh, face);
        for edge in [[a, b], [b, c], [c, a]] {
            *edges.entry(edge).or_default() += 1;
        }
    }
    edges
}

/// Whether each edge has a face on both sides, and no other.
fn is_closed(mesh: &Mesh, faces: &[[u16; 3]]) -> bool {
    let edges = edges(mesh, faces);
    edges
        .iter()
        .all(|(&[from, to], &times)| times == 1 && edges.get(&[to, from]) == Some(&1))
}

/// Points less edges, and faces: 2 for a ball, 0 for a torus.
fn euler(mesh: &Mesh, faces: &[[u16; 3]]) -> i64 {
    let points: BTreeSet<_> = faces.iter().flat_map(|&face| positions(mesh, face)).collect();
    points.len() as i64 - edges(mesh, faces).len() as i64 / 2 + faces.len() as i64
}

/// The greatest distance of a vertex from faces, each of which is cut into many points.
fn sampled_error(mesh: &Mesh, faces: &[[u16; 3]]) -> f64 {
    const STEPS: i64 = 12;
    let mut points = Vec::new();
    for &face in faces {
        let [a, b, c] = positions(mesh, face);
        for one in 0..=STEPS {
            for other in 0..=STEPS - one {
                let part = |axis: usize| a[axis] * (STEPS - one - other) + b[axis] * one + c[axis] * other;
                points.push([0, 1, 2].map(|axis| part(axis) as f64 / STEPS as f64));
            }
        }
    }
    let to = |vertex: [f64; 3], point: &[f64; 3]| (0..3).map(|axis| (vertex[axis] - point[axis]).powi(2)).sum::<f64>();
    let nearest = |vertex: &[i16; 3]| {
        let vertex = vertex.map(f64::from);
        points
            .iter()
            .map(|point| to(vertex, point))
            .fold(f64::INFINITY, f64::min)
    };
    mesh.vertices.iter().map(nearest).fold(0.0, f64::max).sqrt()
}

/// What is true of each level of each mesh.
fn check(mesh: &Mesh) {
    let mut before: (usize, usize) = (mesh.vertices.len(), mesh.faces.len());
    for level in &mesh.levels {
        let Level {
            vertices,
            faces,
            colors,
            ..
        } = level;
        let set = FaceSet::new(&mesh.vertices[..*vertices], faces);
        assert!(set.is_ok() && *vertices <= before.0);
        assert!(faces.len() * 10 <= before.1 * 9 && colors.len() == faces.len());
        assert!(level.mean_error <= level.greatest_error && level.greatest_error.is_finite());
        before = (*vertices, faces.len());
    }
}

#[test]
fn closed_meshes_stay_closed() {
    // An even net of triangles within a ball of radius 1 with N faces is off by 4.84 / N (half the square of the radius around
    // a face), and within the tube by about 10.6 / N. Points that are chosen out of given ones are less even.
    for (text, expected, even) in [(torus(), 0, 10_600.0), (ball(), 2, 4_840.0)] {
        let mesh = convert(text.as_bytes(), "model.obj", &[], LEVELS).unwrap();
        check(&mesh);
        assert!(is_closed(&mesh, &mesh.faces) && euler(&mesh, &mesh.faces) == expected);
        assert!(mesh.levels.len() >= 5, "{}", mesh.levels.len());
        let mut before = mesh.faces.len();
        for level in &mesh.levels {
            assert!(is_closed(&mesh, &level.faces), "{} faces", level.faces.len());
            assert_eq!(euler(&mesh, &level.faces), expected);
            // Two faces at a time.
            assert!(level.faces.len() == before / 2 || level.faces.len() + 1 == before / 2);
            before = level.faces.len();
            let sampled = sampled_error(&mesh, &level.faces);
            assert!(
                (-1e-9..30.0).contains(&(sampled - level.greatest_error)),
                "{sampled} {}",
                level.greatest_error
            );
            let even = even / level.faces.len() as f64;
            let error = level.greatest_error;
            assert!(error <= 3.5 * even, "{error}, not {even}, of {before} faces");
        }
    }
}

#[test]
fn no_face_of_a_ball_turns_over() {
    let mesh = convert(ball().as_bytes(), "model.obj", &[], LEVELS).unwrap();
    for level in &mesh.levels {
        for &face in &level.faces {
            let corners = positions(&mesh, face);
            let normal = cross(corners);
            let outwards: i64 = (0..3)
                .map(|axis| normal[axis] * (corners[0][axis] + corners[1][axis] + corners[2][axis]))
                .sum();
            assert!(outwards > 0, "{corners:?} of {} faces", level.faces.len());
        }
    }
}

/// A box of sides of 8 x 8 squares, each with a part of the texture of its own, and sharp edges: `vt` of the side's own place.
fn charted_box() -> String {
    let mut text = String::new();
    let mut corners = 0;
    for axis in 0..3 {
        for sign in [-1, 1] {
            let number = 2 * axis + usize::from(sign > 0);
            for row in 0..8 {
                for column in 0..8 {
                    let square = [[0, 0], [1, 0], [1, 1], [0, 1]];
                    let turned = |index: usize| square[if sign > 0 { index } else { 3 - index }];
                    let mut face = String::from("f");
                    for [right, up] in [0, 1, 2, 3].map(turned) {
                        let [s, t] = [column + right, row + up].map(|steps| f64::from(steps) / 8.0);
                        let mut point = [0.0; 3];
                        point[axis] = f64::from(sign);
                        point[(axis + 1) % 3] = 2.0 * s - 1.0;
                        point[(axis + 2) % 3] = 2.0 * t - 1.0;
                        let mut normal = [0; 3];
                        normal[axis] = sign;
                        let ([x, y, z], [nx, ny, nz]) = (point, normal);
                        writeln!(text, "v {x} {y} {z}\nvn {nx} {ny} {nz}").unwrap();
                        writeln!(text, "vt {} {}", (number as f64 + s) / 8.0, t / 2.0).unwrap();
                        corners += 1;
                        write!(face, " {corners}/{corners}/{corners}").unwrap();
                    }
                    writeln!(text, "{face}").unwrap();
                }
            }
        }
    }
    text
}

/// Sides are planes over which texture coordinates are linear: nothing is lost until each has two faces, and no vertex has the
/// coordinates or the normal of another side.
#[test]
fn seams_keep_their_texture_coordinates_and_normals() {
    let mesh = convert(charted_box().as_bytes(), "model.obj", &[], LEVELS).unwrap();
    check(&mesh);
    assert_eq!(mesh.faces.len(), 768);
    assert_eq!(mesh.levels.last().map(|level| level.faces.len()), Some(12));
    let map = |vertex: u16| {
        let vertex = usize::from(vertex);
        let ([u, v], normal) = (mesh.coordinates[vertex], decode(mesh.normals[vertex]));
        let axis = (0..3).find(|&axis| normal[axis].abs() > 0.9).unwrap();
        let position = mesh.vertices[vertex].map(f64::from);
        // The side that the coordinates are of, and where in it, by zrow's mirrored z.
        let side = (2 * axis + usize::from((normal[axis] > 0.0) != (axis == 2))) as f64;
        let part = |axis: usize| (position[axis] * if axis == 2 { -1.0 } else { 1.0 } / 1_000.0 + 1.0) / 2.0;
        let exact = [
            (side + part((axis + 1) % 3)) / 8.0 * 4_096.0,
            4_096.0 - part((axis + 2) % 3) / 2.0 * 4_096.0,
        ];
        (
            axis,
            normal.map(f64::round),
            (f64::from(u) - exact[0]).abs().max((f64::from(v) - exact[1]).abs()),
        )
    };
    for level in &mesh.levels {
        assert!(is_closed(&mesh, &level.faces) && level.greatest_error < 1e-9);
        for &face in &level.faces {
            let normal = cross(positions(&mesh, face));
            for vertex in face {
                let (axis, side, error) = map(vertex);
                assert!(error <= 1.0, "{error} of {face:?}");
                // The face lies in the side that its vertices are of, and is seen from outside.
                assert!(
                    (0..3).all(|other| (normal[other] != 0) == (other == axis)),
                    "{normal:?}"
                );
                assert!(normal[axis] as f64 * side[axis] > 0.0);
            }
        }
    }
}

/// A tube that is thicker in places, open at both ends, with a texture once around it: the seam runs along one side.
#[test]
fn a_tube_keeps_its_seam_and_its_ends() {
    const ROWS: usize = 24;
    const COLUMNS: usize = 20;
    let mut text = String::new();
    for row in 0..=ROWS {
        let radius = 0.5 + 0.1 * (row as f64 * 0.7).sin();
        for column in 0..=COLUMNS {
            let around = TAU * (column % COLUMNS) as f64 / COLUMNS as f64;
            let (x, y, z) = (
                radius * around.cos(),
                2.0 * row as f64 / ROWS as f64 - 1.0,
                radius * around.sin(),
            );
            let (u, v) = (column as f64 / COLUMNS as f64, row as f64 / ROWS as f64);
            writeln!(text, "v {x} {y} {z}\nvt {u} {v}").unwrap();
        }
    }
    for row in 0..ROWS {
        for column in 0..COLUMNS {
            let at = |row: usize, column: usize| row * (COLUMNS + 1) + column + 1;
            let corners = [
                at(row, column),
                at(row + 1, column),
                at(row + 1, column + 1),
                at(row, column + 1),
            ];
            let corners = corners.map(|corner| format!("{corner}/{corner}"));
            writeln!(text, "f {}", corners.join(" ")).unwrap();
        }
    }
    let mesh = convert(text.as_bytes(), "model.obj", &[], LEVELS).unwrap();
    check(&mesh);
    assert!(mesh.levels.len() >= 4 && mesh.levels.last().unwrap().faces.len() < 60);
    let coordinates = |vertex: u16| mesh.coordinates[usize::from(vertex)].map(i32::from);
    for level in &mesh.levels {
        for &face in &level.faces {
            let around = face.map(|vertex| coordinates(vertex)[0]);
            let width = around.iter().max().unwrap() - around.iter().min().unwrap();
            assert!(width < 2_500, "a face over {width} of 4,096");
            for vertex in face {
                let [x, y, z] = mesh.vertices[usize::from(vertex)].map(f64::from);
                let angle = (-z).atan2(x).rem_euclid(TAU) / TAU * 4_096.0;
                let [u, v] = coordinates(vertex).map(f64::from);
                let (beside, along) = ((u - angle).rem_euclid(4_096.0), v - (1.0 - y / 1_000.0) * 2_048.0);
                assert!(
                    beside.min(4_096.0 - beside) < 4.0 && along.abs() < 4.0,
                    "{u} {angle} {along}"
                );
            }
        }
        // What has a face on one side alone is an end.
        let edges = edges(&mesh, &level.faces);
        let is_end = |&[from, to]: &[[i64; 3]; 2]| from[1] == to[1] && from[1].abs() == 1_000;
        let ends: Vec<_> = edges
            .keys()
            .filter(|&&[from, to]| !edges.contains_key(&[to, from]))
            .collect();
        assert!(
            ends.len() >= 6 && ends.into_iter().all(is_end),
            "{} faces",
            level.faces.len()
        );
        assert!(edges.values().all(|&times| times == 1));
    }
}

/// Rings as thin as a triangle, which could be pinched where three edges go round without a face between them.
#[test]
fn thin_rings_are_not_pinched() {
    for (around, columns) in [(3, 3), (5, 3), (12, 3), (20, 4), (4, 12)] {
        let text = rows(around, columns, true, |row, column| {
            let (turn, tube) = (TAU * row as f64 / around as f64, TAU * column as f64 / columns as f64);
            let radius = 1.0 + 0.4 * tube.cos();
            [radius * turn.cos(), 0.4 * tube.sin(), radius * turn.sin()]
        });
        let mesh = convert(text.as_bytes(), "model.obj", &[], LEVELS).unwrap();
        check(&mesh);
        assert_eq!(mesh.levels.is_empty(), around * columns < 10, "{around} {columns}");
        for level in &mesh.levels {
            assert!(
                is_closed(&mesh, &level.faces),
                "{} of {around} x {columns}",
                level.faces.len()
            );
            assert_eq!(euler(&mesh, &level.faces), 0);
        }
    }
}

/// Twice the areas of colours, seen along z.
fn areas(mesh: &Mesh, faces: &[[u16; 3]], colors: &[[u8; 3]]) -> HashMap<[u8; 3], i64> {
    let mut areas = HashMap::new();
    for (&face, &color) in faces.iter().zip(colors) {
        let area = cross(positions(mesh, face))[2];
        assert!(area < 0, "a face of the plane is turned over");
        *areas.entry(color).or_default() += area;
    }
    areas
}

/// A plane with a border, a hole and two colours whose line is crooked.
#[test]
fn borders_and_colors_keep_their_areas() {
    let mut text = String::from("mtllib a.mtl\n");
    for row in 0..=20 {
        for column in 0..=20 {
            writeln!(text, "v {} {} 0", column - 10, row - 10).unwrap();
        }
    }
    for row in 0..20 {
        for column in 0..20 {
            if (8..12).contains(&row) && (4..9).contains(&column) {
                continue;
            }
            let is_red = if row < 10 { column < 12 } else { column < 15 };
            let [a, d] = [row, row + 1].map(|row| row * 21 + column + 1);
            writeln!(
                text,
                "usemtl {}\nf {a} {} {} {d}",
                if is_red { "red" } else { "blue" },
                a + 1,
                d + 1
            )
            .unwrap();
        }
    }
    let materials = b"newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n";
    let mesh = convert(text.as_bytes(), "model.obj", &[("a.mtl", materials)], LEVELS).unwrap();
    check(&mesh);
    let expected = areas(&mesh, &mesh.faces, &mesh.colors);
    assert!(expected.len() == 2 && mesh.levels.len() >= 4);
    // Twelve corners of colours and borders can be joined by some 30 faces; fewer have to give something up.
    let exact: Vec<_> = mesh.levels.iter().filter(|level| level.faces.len() >= 40).collect();
    for level in &exact {
        let found = areas(&mesh, &level.faces, &level.colors);
        assert_eq!(found, expected, "{} faces", level.faces.len());
        assert!(level.greatest_error < 1e-9);
    }
    assert!(exact.len() >= 4);
}

#[test]
fn without_levels_nothing_changes_and_a_tetrahedron_has_none() {
    let plain = obj(&torus(), &[]).unwrap();
    let leveled = convert(torus().as_bytes(), "model.obj", &[], Options { levels: 2, ..OPTIONS }).unwrap();
    assert!(plain.levels.is_empty() && leveled.levels.len() == 2);
    // The finest mesh has the same faces, of vertices in another order.
    let faces = |mesh: &Mesh| mesh.faces.iter().map(|&face| positions(mesh, face)).collect::<Vec<_>>();
    assert_eq!(faces(&plain), faces(&leveled));
    // A face fewer would be doubled.
    let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    let tetrahedron = convert(text.as_bytes(), "model.obj", &[], LEVELS).unwrap();
    assert!(tetrahedron.levels.is_empty());
    let is_said = |note: &String| note.starts_with("level 1 and coarser ones are left out");
    assert!(tetrahedron.notes.iter().any(is_said), "{:?}", tetrahedron.notes);
}

/// Any faces between few points: edges of many faces, faces with a point twice, points that fans share.
#[test]
fn any_faces_give_levels_of_theirs() {
    let mut random = Random(0x1234_5678);
    for case in 0..400 {
        let count = 3 + random.below(40);
        let vertices: Vec<[i16; 3]> = (0..count).map(|_| [0; 3].map(|_| random.below(9) as i16 - 4)).collect();
        let faces: Vec<[u16; 3]> = (0..1 + random.below(200))
            .map(|_| [0; 3].map(|_| random.below(count) as u16))
            .collect();
        let colors: Vec<[u8; 3]> = faces.iter().map(|_| [random.below(2) as u8; 3]).collect();
        let mut mesh = Mesh {
            normals: vec![[0, 0]; count],
            vertices,
            faces,
            colors,
            ..Mesh::default()
        };
        levels::add(&mut mesh, 8);
        check(&mesh);
        // No border is new: what has no face on the other side had none before.
        let before = edges(&mesh, &mesh.faces);
        let is_whole = |[from, to]: &[[i64; 3]; 2], edges: &HashMap<_, usize>| edges.contains_key(&[*to, *from]);
        if before.keys().all(|edge| is_whole(edge, &before)) {
            for level in &mesh.levels {
                let edges = edges(&mesh, &level.faces);
                assert!(edges.keys().all(|edge| is_whole(edge, &edges)), "case {case}");
            }
        }
    }
}

/// A hub of 10,000 faces, and a plane of 28,800.
#[test]
fn large_meshes_take_a_moment() {
    let start = Instant::now();
    let rim = |index: u32| {
        let angle = TAU * f64::from(index) / 10_000.0;
        [(angle.cos() * 30_000.0) as i16, (angle.sin() * 30_000.0) as i16, 0]
    };
    let mut mesh = Mesh {
        vertices: (0..10_000).map(rim).chain([[0, 0, 900]]).collect(),
        faces: (0..10_000).map(|index| [index, (index + 1) % 10_000, 10_000]).collect(),
        colors: vec![[0; 3]; 10_000],
        ..Mesh::default()
    };
    levels::add(&mut mesh, 4);
    check(&mesh);
    let mut mesh = Mesh {
        vertices: (0..121 * 121)
            .map(|index: i32| {
                [index % 121 * 100, index / 121 * 100, index * 7 % 13].map(|coordinate| coordinate as i16)
            })
            .collect(),
        faces: (0..120u16 * 120)
            .flat_map(|square| {
                let a = square / 120 * 121 + square % 120;
                [[a, a + 1, a + 122], [a, a + 122, a + 121]]
            })
            .collect(),
        colors: vec![[0; 3]; 28_800],
        ..Mesh::default()
    };
    levels::add(&mut mesh, 4);
    check(&mesh);
    assert!(mesh.levels.len() == 4 && mesh.levels[3].greatest_error < 13.0);
    assert!(start.elapsed().as_secs() < 30, "{:?}", start.elapsed());
}

#[test]
fn the_checked_in_levels_are_what_is_converted_today() {
    let options = Options {
        size: 512,
        levels: 2,
        ..OPTIONS
    };
    let mesh = convert(include_bytes!("levels/pebble.obj"), "pebble.obj", &[], options).unwrap();
    let origin = Origin {
        file: "pebble.obj",
        name: None,
    };
    let module = module::write(&mesh, options, "PEBBLE", origin);
    assert!(
        module.source == include_str!("levels/pebble.rs"),
        "convert it again: the command stands in its head"
    );
    let sets = [pebble::PEBBLE_LEVEL_1, pebble::PEBBLE_LEVEL_2];
    assert_eq!(mesh.levels.len(), sets.len());
    for (set, level) in sets.iter().zip(&mesh.levels) {
        assert_eq!(set.faces(), level.faces);
        assert_eq!(set.vertices(), &mesh.vertices[..level.vertices]);
    }
    let bytes = size_of_val(pebble::PEBBLE.vertices())
        + size_of_val(pebble::PEBBLE.faces())
        + size_of_val(&pebble::PEBBLE_COLORS)
        + size_of_val(&pebble::PEBBLE_NORMALS)
        + sets.iter().map(|set| size_of_val(set.faces())).sum::<usize>()
        + size_of_val(&pebble::PEBBLE_LEVEL_1_COLORS)
        + size_of_val(&pebble::PEBBLE_LEVEL_2_COLORS);
    assert_eq!(module.bytes, bytes);
}

#[test]
fn a_level_is_picked_where_its_error_is_half_a_pixel() {
    assert_eq!([0.0, 1.0, 3.3].map(|error| pick_from(error, 160)), [0, 320, 1_056]);
    assert_eq!(pick_from(1e12, 160), u32::MAX);
}
