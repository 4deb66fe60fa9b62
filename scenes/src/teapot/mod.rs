//! The Utah teapot of Newell's 32 bicubic patches, tessellated by the compiler: nothing of it runs on the device.
//!
//! x is to the right, where the spout is, y up and z away from the viewer, and faces look outwards. One of Newell's units
//! is 160 of the mesh: it reaches from -514 to 514 in x, from -252 to 252 in y and from -320 to 320 in z, and the origin is
//! the middle of that box. Newell left the pot open between rim and lid, at the tip of the spout and where handle and spout
//! end inside the body.
//!
//! Vertices are shared wherever patches of a part meet, but where a texture's coordinates differ: along one meridian of the
//! body and one of the lid, which a texture goes around twice, and at the two poles, which have a vertex for each of their
//! four patches. Handle and spout need no such seam, as their two sides mirror each other. So the mesh of 4 by 4 cells a
//! patch has 560 vertices, of which 530 positions differ within their part.

mod cubic_walk;
mod face_shade;
mod grid;
mod mesh;
mod octahedral;
pub mod parts;
mod patch_walk;
pub mod patches;
mod vector;

use embedded_graphics::pixelcolor::Rgb565;
use zrow::scene::{FacePlanes, FaceSet};

use crate::meshes::face_set;
use mesh::{Mesh, face_count, tessellate, vertex_count};

macro_rules! teapots {
    ($($cells:literal: $mesh:ident, $doc:literal, $faces:ident, $normals:ident, $coordinates:ident, $colors:ident,
        $face_normals:ident, $neighbours:ident, $planes:ident;)+) => {$(
        const $mesh: Mesh<{ vertex_count($cells) }, { face_count($cells) }> = tessellate($cells);

        #[doc = $doc]
        pub static $faces: FaceSet = {
            static POSITIONS: [[i16; 3]; vertex_count($cells)] = $mesh.positions;
            static FACES: [[u16; 3]; face_count($cells)] = $mesh.faces;
            face_set(&POSITIONS, &FACES)
        };
        #[doc = concat!(
            "The outward normal of the surface at each vertex of [`", stringify!($faces), "`], octahedral: x and y of its ",
            "point on |x| + |y| + |z| = 127, and where z is negative, 127 - |y| and 127 - |x| with the signs of x and y."
        )]
        pub static $normals: [[i8; 2]; vertex_count($cells)] = $mesh.normals;
        #[doc = concat!(
            "Where each vertex of [`", stringify!($faces), "`] is in a texture, in 1/4096 of its size: u around its part and ",
            "v down or along it. A side of the texture is about 6.28 of Newell's units long on every part."
        )]
        pub static $coordinates: [[i16; 2]; vertex_count($cells)] = $mesh.coordinates;
        #[doc = concat!(
            "A colour for each face of [`", stringify!($faces), "`]: one for each part, in a light from the upper left that ",
            "turns with the pot."
        )]
        pub static $colors: [Rgb565; face_count($cells)] = $mesh.colors;
        #[doc = concat!(
            "The direction in which each face of [`", stringify!($faces), "`] looks, as a point of the octahedron ",
            "|x| + |y| + |z| = 127: x and y, where z is negative folded outwards over the edges of the square."
        )]
        pub static $face_normals: [[i8; 2]; face_count($cells)] = $mesh.face_normals;
        #[doc = concat!(
            "The faces of [`", stringify!($faces), "`] on the other sides of the edges of each face, from its first vertex to the ",
            "second, to the third, and back."
        )]
        pub static $neighbours: [[u16; 3]; face_count($cells)] = FaceSet::find_neighbours(&$mesh.faces);
        #[doc = concat!("The plane of each face of [`", stringify!($faces), "`].")]
        pub static $planes: [[i16; 4]; face_count($cells)] = FacePlanes::find(&$mesh.positions, &$mesh.faces);
    )+};
}

teapots! {
    4: FINE, "The teapot of 4 by 4 cells a patch: 560 vertices and 992 faces.",
        TEAPOT, TEAPOT_NORMALS, TEAPOT_COORDINATES, TEAPOT_COLORS, TEAPOT_FACE_NORMALS,
        TEAPOT_NEIGHBOURS, TEAPOT_PLANES;
    2: COARSE, "The teapot of 2 by 2 cells a patch, for a small display: 156 vertices and 240 faces.",
        SMALL_TEAPOT, SMALL_TEAPOT_NORMALS, SMALL_TEAPOT_COORDINATES, SMALL_TEAPOT_COLORS,
        SMALL_TEAPOT_FACE_NORMALS, SMALL_TEAPOT_NEIGHBOURS, SMALL_TEAPOT_PLANES;
}
