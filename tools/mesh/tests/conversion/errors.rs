//! Each error says in which line of which file it is, and what to do.

use png::{BitDepth, ColorType};

use crate::common::{CUBE, OPTIONS, convert, message, obj, png};

/// A triangle with everything: its lines 1 to 9.
const GOOD: &str = "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvn 0 0 1\nusemtl a\nf 1/1/1 2/2/1 3/1/1\n";
const MATERIALS: &[u8] = b"newmtl a\nKd 1 0 0\n";

fn has_all(message: &str, parts: &[&str]) {
    assert!(
        parts.iter().all(|part| message.contains(part)),
        "{message} lacks {parts:?}"
    );
}

#[test]
fn bad_lines_of_an_obj() {
    obj(GOOD, &[("a.mtl", MATERIALS)]).unwrap();
    for (line, bad, part) in [
        (2, "v 0 0", "write v x y z"),
        (2, "v 0 0 0 0 0", "write v x y z"),
        (2, "v 0 0 zero", "\"zero\" is no number"),
        (2, "v 0 nan 0", "from -1e9 to 1e9"),
        (2, "v 0 0 -inf", "from -1e9 to 1e9"),
        (2, "v 1e300 0 0", "in larger units"),
        (2, "v 1e999 0 0", "in larger units"),
        (5, "vt", "write vt u v"),
        (5, "vt 1 2 3 4", "write vt u v"),
        (5, "vt 1,5 0", "is no number"),
        (
            5,
            "vt 17 0",
            "line 9: the texture is repeated more than 15 times over a face",
        ),
        (7, "vn 0 0", "write vn x y z"),
        (7, "vn 0 0 inf", "from -1e9 to 1e9"),
        (9, "f", "a face has 0 corners"),
        (9, "f 1", "a face has 1 corners"),
        (9, "f 1 2", "write at least 3"),
        (9, "f 1 2 4", "v 4 is not there, 3 stand above this line"),
        (9, "f 1 2 0", "write 1 to 3, or -1 to -3"),
        (9, "f 1 2 -4", "v -4 is not there"),
        (9, "f 1 2 99999999999999999999", "is no index of v"),
        (9, "f 1 2 -9223372036854775808", "is not there"),
        (9, "f 1 2 3.0", "is no index of v"),
        (9, "f 1 2 /1", "\"\" is no index of v"),
        (9, "f 1/3 2/1 3/1", "vt 3 is not there"),
        (9, "f 1//2 2//1 3//1", "vn 2 is not there"),
        (4, "f 1 2 2/1", "no vt stands above this line, move them up"),
        (9, "f 1/1/1/1 2 3", "write v/vt/vn"),
        (1, "mtllib", "write mtllib MATERIALS.mtl"),
        (1, "mtllib b.mtl", "b.mtl is missing"),
        (1, "mtllib b c.mtl", "b is missing"),
        (8, "usemtl b", "there is no material \"b\""),
        (4, "vertex 1 2 3", "\"vertex\" is no statement of OBJ"),
        (4, "\u{7}", "is no statement of OBJ"),
        (4, "curv 0 1 1 2", "export the model as polygons"),
    ] {
        let lines = GOOD
            .lines()
            .zip(1..)
            .map(|(good, number)| if number == line { bad } else { good });
        let text = lines.collect::<Vec<_>>().join("\n");
        let message = message(obj(&text, &[("a.mtl", MATERIALS)]));
        // The texture coordinates of a face are bad where it is, not where they are.
        let place = format!("model.obj line {}", if part.starts_with("line 9") { 9 } else { line });
        assert!(
            message.starts_with(&place) && message.contains(part),
            "{bad}: {message}"
        );
    }
    let many = format!("v 0 0 0\nf{}\n", " 1".repeat(100_000));
    has_all(
        &message(obj(&many, &[])),
        &["model.obj line 2", "has 100000 corners", "cut it into several"],
    );
    let word = format!("v 0 0 {}", "9a".repeat(50_000));
    assert!(message(obj(&word, &[])).len() < 200);
    has_all(&message(obj("# a\nv 0 0 \\\n 0 \\\n x\n", &[])), &["model.obj line 2"]);
}

#[test]
fn models_without_faces_or_size() {
    has_all(&message(obj("", &[])), &["model.obj has no faces"]);
    has_all(&message(obj("v 1 1 1\nv 2 2 2\n", &[])), &["export polygons"]);
    has_all(&message(obj("v 0 0 0\nf 1 1 1\n", &[])), &["model.obj is a point"]);
    has_all(
        &message(obj("v 1e-300 0 0\nv 0 1e-300 0\nv 0 0 0\nf 1 2 3\n", &[])),
        &["in smaller units"],
    );
    has_all(
        &message(obj("v 1 0 0\nv 2 0 0\nv 3 0 0\nf 1 2 3\n", &[])),
        &["no face has an area"],
    );
    has_all(
        &message(convert(b"", "model.ply", &[], OPTIONS)),
        &["neither .obj nor .stl"],
    );
}

#[test]
fn models_that_are_too_large() {
    // A grid of 257 x 257 vertices has more than are numbered.
    let mut text = String::new();
    for (x, y) in (0..257 * 257).map(|index| (index % 257, index / 257)) {
        text += &format!("v {x} {y} 0\n");
    }
    let first = |size: usize| (0..size).flat_map(move |y| (0..size).map(move |x| 257 * y + x + 1));
    let face = |corner: usize| format!("f {corner} {} {} \n", corner + 1, corner + 258);
    let faces: String = first(255).map(face).collect();
    let options = zrow_mesh::mesh::Options { size: 256, ..OPTIONS };
    let mesh = convert((text.clone() + &faces).as_bytes(), "a.obj", &[], options).unwrap();
    assert_eq!(mesh.faces.len(), 255 * 255);
    let faces: String = first(256).map(face).collect();
    let error = message(convert((text.clone() + &faces).as_bytes(), "a.obj", &[], options));
    has_all(
        &error,
        &[
            &format!("a.obj line {}: ", 257 * 257 + 65_536),
            "more than 65535 triangles",
        ],
    );
    // Each corner of each face has its own texture coordinates.
    let coordinates: String = (0..65_537)
        .map(|index| format!("vt {} {}\n", index % 256, index / 256))
        .collect();
    let face = |(index, corner): (usize, usize)| {
        let at = |step: usize| (3 * index + step) % 65_537 + 1;
        format!(
            "f {corner}/{} {}/{} {}/{}\n",
            at(0),
            corner + 1,
            at(0),
            corner + 258,
            at(0)
        )
    };
    let scale = |text: &str| text.replace("vt ", "vt 0.0");
    let faces: String = first(255).enumerate().map(face).collect();
    let error = message(convert(
        (text + &scale(&coordinates) + &faces).as_bytes(),
        "a.obj",
        &[],
        options,
    ));
    has_all(
        &error,
        &["a.obj line ", "more than 65536 vertices", "convert it in parts"],
    );
}

#[test]
fn bad_lines_of_materials() {
    for (bad, line, part) in [
        ("newmtl a\nKd 1 0\n", 2, "from 0 to 1"),
        ("newmtl a\n\nKd 255 0 0\n", 3, "255 is no colour"),
        ("newmtl a\nKd -0.1 0 0\n", 2, "from 0 to 1"),
        ("newmtl a\nKd nan 0 0\n", 2, "NaN"),
        ("newmtl a\nKd spectral a.rfl\n", 2, "Kd spectral is not read"),
        ("newmtl a\nKd xyz 1 1 1\n", 2, "Kd xyz is not read"),
        ("Kd 1 0 0\nnewmtl a\n", 1, "write newmtl NAME above it"),
        ("map_Kd a.png\nnewmtl a\n", 1, "write newmtl NAME above it"),
        ("newmtl\n", 1, "newmtl has no name"),
        ("newmtl a\nmap_Kd\n", 2, "map_Kd names no file"),
        (
            "newmtl a\nmap_Kd -s 2 2 1 a.png\n",
            2,
            "options of map_Kd such as \"-s\"",
        ),
        ("newmtl a\nmap_Kd b.png\n", 2, "b.png is missing"),
    ] {
        let message = message(obj(GOOD, &[("a.mtl", bad.as_bytes())]));
        let part = if part == "NaN" { "is no number from" } else { part };
        has_all(&message, &[&format!("a.mtl line {line}"), part]);
    }
}

#[test]
fn bad_textures() {
    let materials = b"newmtl a\nmap_Kd a.png\n";
    let picture = |width: u32, height: u32| {
        png(
            width,
            height,
            ColorType::Grayscale,
            BitDepth::Eight,
            &vec![0; (width * height) as usize],
        )
    };
    let mut short = picture(8, 8);
    short.truncate(50);
    for (bytes, part) in [
        (picture(7, 8), "7 x 8 pixels: scale it to powers of two up to 256"),
        (picture(8, 512), "8 x 512 pixels"),
        (png(1, 1, ColorType::Rgb, BitDepth::Sixteen, &[0; 6]), "save it with 8"),
        (b"GIF89a".to_vec(), "it is no PNG"),
        (Vec::new(), "it is no PNG"),
        (short, "it is no PNG"),
    ] {
        let message = message(obj(GOOD, &[("a.mtl", materials), ("a.png", &bytes)]));
        has_all(&message, &["a.mtl line 2: a.png: ", part]);
    }
    let two = b"newmtl a\nmap_Kd a.png\nnewmtl b\nmap_Kd b.png\n";
    let text = GOOD.to_owned() + "usemtl b\nf 1 2 3\n";
    has_all(
        &message(obj(&text, &[("a.mtl", two)])),
        &[
            "a.mtl line 4: b.png is a second texture beside a.png (a.mtl line 2)",
            "into one picture",
        ],
    );
}

#[test]
fn bad_lines_of_an_stl() {
    let good = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n\
        endloop\nendfacet\nendsolid a\n";
    let stl = |bytes: &[u8]| convert(bytes, "a.stl", &[], OPTIONS);
    let mesh = stl(good.as_bytes()).unwrap();
    for other in [
        good.to_uppercase(),
        format!("\u{feff}{good}"),
        format!("\u{feff} \r\n{}", good.to_uppercase()),
    ] {
        let other = stl(other.as_bytes()).unwrap();
        assert_eq!(
            (other.vertices, other.faces),
            (mesh.vertices.clone(), mesh.faces.clone())
        );
    }
    for (line, bad, part) in [
        (4, "vertex 0 0", "write vertex x y z"),
        (4, "vertex 0 0 inf", "from -1e9 to 1e9"),
        (4, "vortex 0 0 0", "where vertex x y z has to stand"),
        (6, "endloop", "where vertex x y z has to stand"),
        (7, "vertex 0 0 1", "where endloop has to stand"),
        (3, "inner loop", "where outer loop has to stand"),
        (2, "vertex 0 0 0", "where facet or endsolid has to stand"),
        (8, "facet", "where endfacet has to stand"),
        (9, "", "line 8: the file ends within a solid"),
    ] {
        let lines = good
            .lines()
            .zip(1..)
            .map(|(good, number)| if number == line { bad } else { good });
        let message = message(stl(lines.collect::<Vec<_>>().join("\n").as_bytes()));
        let place = format!("a.stl line {}", if bad.is_empty() { 8 } else { line });
        assert!(
            message.starts_with(&place) && message.contains(part),
            "{bad}: {message}"
        );
    }
    has_all(&message(stl(b"")), &["a.stl is no STL: it has 0 bytes"]);
    has_all(&message(stl(b"solid a\nendsolid a\n")), &["a.stl has no faces"]);
    let mut binary = [[0; 80].as_slice(), &2u32.to_le_bytes(), &[0; 100]].concat();
    let truncated = message(stl(&binary[..150]));
    has_all(
        &truncated,
        &["a.stl has 150 bytes, and 184 as a binary STL of 2 facets"],
    );
    binary[80..84].fill(0xff);
    has_all(
        &message(stl(&binary)),
        &["4294967295 facets", "copy or export it again"],
    );
    binary[80..84].copy_from_slice(&2u32.to_le_bytes());
    binary[84 + 50 + 12..][..4].copy_from_slice(&f32::NAN.to_le_bytes());
    has_all(&message(stl(&binary)), &["a.stl facet 2", "\"NaN\" is no number"]);
}

/// The program writes beside the model, ends with an error where it cannot, and says why.
#[test]
fn the_program_writes_a_module_or_says_why_not() {
    let folder = std::env::temp_dir().join(format!("zrow-mesh-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let run = |arguments: &[&str]| {
        let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_zrow-mesh"));
        let output = command.args(arguments).current_dir(&folder).output().unwrap();
        let message = String::from_utf8_lossy(&output.stderr).into_owned();
        (output.status.success(), message)
    };
    std::fs::write(folder.join("my cube.obj"), CUBE).unwrap();
    std::fs::write(folder.join("\u{65e5}.obj"), CUBE).unwrap();
    std::fs::write(folder.join("bad.obj"), "v 0 0 0\nf 1 2 3\n").unwrap();
    for (arguments, part) in [
        (&["none.obj"][..], "pass the path of a model"),
        (&["."], "is no file"),
        (&["bad.obj"], "error: bad.obj line 2: v 2 is not there"),
        (&["my cube.obj", "--size", "0"], "1..=32767"),
        (&["my cube.obj", "--size", "32768"], "1..=32767"),
        (&["my cube.obj", "--name", "a b"], "is no name of a static"),
        (&["\u{65e5}.obj"], "choose one with --name"),
        (&["my cube.obj", "-o", "none/a.rs"], "choose another path"),
    ] {
        let (is_success, message) = run(arguments);
        assert!(!is_success && message.contains(part), "{arguments:?}: {message}");
    }
    let (is_success, message) = run(&["my cube.obj", "--size", "300"]);
    assert!(is_success, "{message}");
    for part in [
        "my cube.rs: MY_CUBE\n",
        "8 vertices, 12 faces, 0 dropped",
        "rounded by up to 0.000 units (0.000 % of the size)",
        "160 bytes of flash",
        "z is negated",
    ] {
        assert!(message.contains(part), "{message}");
    }
    // Again, over what was written; not over anything else.
    assert!(run(&["my cube.obj", "--size", "300"]).0);
    std::fs::write(folder.join("bad.obj"), CUBE).unwrap();
    std::fs::write(folder.join("bad.rs"), "fn main() {}").unwrap();
    let (is_success, message) = run(&["bad.obj"]);
    assert!(
        !is_success && message.contains("was not written by this command"),
        "{message}"
    );
    let source = std::fs::read_to_string(folder.join("my cube.rs")).unwrap();
    assert!(
        source.contains("mesh 'my cube.obj' --size 300\n") && source.contains("[-300, 300, 300],"),
        "{source}"
    );
    let (is_success, message) = run(&["my cube.obj", "-o", "die.rs", "--name", "DIE", "--flat", "--z-up"]);
    assert!(
        is_success && message.contains("z is up") && folder.join("die.rs").exists(),
        "{message}"
    );
    std::fs::remove_dir_all(&folder).unwrap();
}
