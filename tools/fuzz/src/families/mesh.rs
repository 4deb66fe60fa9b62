//! `zrow::scene`: faces that name vertices.

use anyhow::ensure;
use arbitrary::Arbitrary;
use zrow::{
    geometry::InputError,
    scene::{FacePlanes, FaceSet},
};

use crate::{
    target::{Case, Verdict},
    values::List,
};

/// A face set, some of whose faces name vertices that are not there.
#[derive(Debug, Arbitrary)]
pub struct FaceSetCase {
    vertices: List<[i16; 3], 5>,
    faces: List<[Index; 3], 6>,
}

/// Of a vertex: a few, or any.
#[derive(Debug, Copy, Clone, Arbitrary)]
enum Index {
    First,
    Small(u8),
    Any(u16),
}

impl Index {
    const fn get(self) -> u16 {
        match self {
            Self::First => 0,
            Self::Small(index) => (index % 6) as u16,
            Self::Any(index) => index,
        }
    }
}

impl Case for FaceSetCase {
    fn check(&self) -> Verdict {
        let vertices = &self.vertices.0;
        let faces: Vec<_> = self.faces.0.iter().map(|face| face.map(Index::get)).collect();
        let largest = |face: &[u16; 3]| face.iter().copied().max().unwrap_or(0);
        let wrong = faces
            .iter()
            .position(|face| usize::from(largest(face)) >= vertices.len());
        match (FaceSet::new(vertices, &faces), wrong) {
            (Ok(set), None) => {
                ensure!(set.vertices() == vertices && set.faces() == faces, "another face set");
                let mut table = vec![[0; 4]; faces.len()];
                let planes = FacePlanes::find_in(&set, &mut table)?;
                ensure!(planes.table().len() == faces.len(), "planes of other faces");
            }
            (Err(error), Some(face)) => {
                let vertex = largest(&faces[face]);
                ensure!(
                    error == InputError::IndexOutOfRange { face, vertex },
                    "{error}, which is face {face}"
                );
            }
            (found, expected) => anyhow::bail!("{found:?}, where face {expected:?} is wrong"),
        }
        Ok(())
    }
}
