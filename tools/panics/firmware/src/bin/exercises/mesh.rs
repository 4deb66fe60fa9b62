use zrow::scene::FaceSet;
use zrow_panics_firmware::{any, keep};

use crate::foreign::eq;

pub const EXERCISES: &[fn()] = &[face_set];

#[inline(never)]
fn face_set() {
    keep(FaceSet::new(any(), any()));
    keep(FaceSet::vertices(any()));
    keep(FaceSet::faces(any()));
    eq::<FaceSet<'_>>();
}
