//! The meshes of the standard scenes, as constants in flash. A length of 1 is 512 units.

use embedded_graphics::pixelcolor::Rgb565;
use zrow::scene::FaceSet;

include!(concat!(env!("OUT_DIR"), "/meshes.rs"));

/// The torus about z and a cube within it; they interpenetrate.
pub static TORUS_AND_CUBE: FaceSet = face_set(&TORUS_AND_CUBE_VERTICES, &TORUS_AND_CUBE_FACES);
/// An icosahedron whose faces are cut into four, twice, on a sphere of radius 1.4.
pub static ICOSPHERE: FaceSet = face_set(&ICOSPHERE_VERTICES, &ICOSPHERE_FACES);
/// A cube of half size 1.
pub static CUBE: FaceSet = face_set(&CUBE_VERTICES, &CUBE_FACES);

/// The compiler checks the indices.
pub(crate) const fn face_set<'a>(vertices: &'a [[i16; 3]], faces: &'a [[u16; 3]]) -> FaceSet<'a> {
    match FaceSet::new(vertices, faces) {
        Ok(faces) => faces,
        Err(_) => panic!("a face names a vertex that is not there"),
    }
}
