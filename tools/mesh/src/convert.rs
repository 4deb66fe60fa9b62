//! From a model to what a module holds: triangles of vertices, equal ones of which are one.

use std::collections::HashMap;

use anyhow::{Context, ensure};

use crate::{
    coordinates,
    edges::edges,
    levels,
    mesh::{Mesh, Options},
    model::{Corner, Face, Model},
    module_parts::rgb565,
    normals::{SmoothNormals, Triangle},
    octahedral,
    quantize::{Positions, quantize},
    texture,
    triangulate::{Triangulated, triangulate},
    vector::{difference, dot, newell, scaled, sum, unit},
};

/// Faces at most: a scene numbers them with 16 bits.
const MOST_FACES: usize = 65_535;
/// Vertices at most: faces name them with 16 bits.
const MOST_VERTICES: usize = 65_536;
/// Distances from a polygon's plane that are not worth a note: positions are rounded by as much.
const FLAT: f64 = 0.5;

/// Converts a model; `files` reads its texture.
///
/// # Errors
/// What the module cannot hold, by the line of the model.
pub fn convert(
    model: &Model,
    options: Options,
    files: &dyn Fn(&str) -> anyhow::Result<Vec<u8>>,
) -> anyhow::Result<Mesh> {
    let positions = quantize(model, options.up, options.size)?;
    let mut converter = Converter {
        model,
        options,
        positions: &positions,
        has_coordinates: model.corners.iter().any(|corner| corner.coordinates.is_some()),
        indices: HashMap::new(),
        mesh: Mesh {
            greatest_error: positions.greatest_error,
            mean_error: positions.mean_error,
            notes: model.notes.clone(),
            ..Mesh::default()
        },
    };
    let triangles = converter.triangles()?;
    converter.weld(&triangles)?;
    converter.note_what_lacks();
    converter.texture(files)?;
    let mut mesh = converter.mesh;
    if options.levels > 0 {
        levels::add(&mut mesh, options.levels);
    }
    if let Some(crease) = options.edges {
        mesh.edges = edges(&mesh.vertices, &mesh.faces, crease);
        if mesh.edges.is_none() {
            mesh.notes
                .push("no edges are written: there are more than 65,535 faces".to_owned());
        }
    }
    Ok(mesh)
}

/// A triangle of a face: its corners as indices of the model's.
struct Piece<'a> {
    face: &'a Face,
    corners: [usize; 3],
    shape: Triangle,
}

/// Position, texture coordinates, normal: vertices are one if all of them are equal.
type Vertex = ([i16; 3], [i16; 2], [i8; 2]);

struct Converter<'a> {
    model: &'a Model,
    options: Options,
    positions: &'a Positions,
    has_coordinates: bool,
    /// The index of each vertex.
    indices: HashMap<Vertex, u16>,
    mesh: Mesh,
}

impl<'a> Converter<'a> {
    /// Cuts all faces into triangles.
    fn triangles(&mut self) -> anyhow::Result<Vec<Piece<'a>>> {
        let model = self.model;
        let mut pieces = Vec::new();
        let (mut bent, mut crossed) = (Worst::default(), Worst::default());
        for face in &model.faces {
            let corners = self.corners_outwards(face);
            let rounded: Vec<[i16; 3]> = corners.iter().map(|&corner| self.rounded(corner)).collect();
            let Triangulated { triangles, is_exact } = triangulate(&rounded);
            self.mesh.dropped += corners.len().saturating_sub(2 + triangles.len());
            crossed.note(!is_exact, 0.0, face);
            let distance = self.distance_from_plane(&corners);
            bent.note(distance > FLAT, distance, face);
            pieces.extend(
                triangles
                    .into_iter()
                    .map(|triangle| self.piece(face, triangle.map(|index| corners[index]))),
            );
            ensure!(
                pieces.len() <= MOST_FACES,
                "{}: here the model has more than {MOST_FACES} triangles: simplify it, or convert it in parts",
                model.place(face)
            );
        }
        ensure!(
            !pieces.is_empty(),
            "{}: no face has an area: choose a greater --size, or export the model again",
            model.file
        );
        if let Some(face) = bent.face {
            self.mesh.notes.push(format!(
                "faces that are not planar: {}, by up to {:.2} units ({}); they are cut into triangles",
                bent.count,
                bent.distance,
                model.place(face)
            ));
        }
        if let Some(face) = crossed.face {
            self.mesh.notes.push(format!(
                "faces whose outlines cross themselves after rounding: {}, first in {}; their triangles may overlap",
                crossed.count,
                model.place(face)
            ));
        }
        Ok(pieces)
    }

    /// The indices of a face's corners in the order in which cross(b - a, c - a) points outwards in zrow's axes: the file's,
    /// reversed, since one axis is mirrored.
    fn corners_outwards(&self, face: &Face) -> Vec<usize> {
        let corners = face.corners.clone();
        corners.clone().take(1).chain(corners.skip(1).rev()).collect()
    }

    fn corner(&self, index: usize) -> Corner {
        self.model.corners[index]
    }

    fn rounded(&self, corner: usize) -> [i16; 3] {
        self.positions.rounded[self.corner(corner).position]
    }

    fn exact(&self, corner: usize) -> [f64; 3] {
        self.positions.exact[self.corner(corner).position]
    }

    fn piece(&self, face: &'a Face, corners: [usize; 3]) -> Piece<'a> {
        Piece {
            face,
            corners,
            shape: Triangle {
                exact: corners.map(|corner| self.exact(corner)),
                rounded: corners.map(|corner| self.rounded(corner)),
            },
        }
    }

    /// How far the corners are from the plane through their centre, before rounding.
    fn distance_from_plane(&self, corners: &[usize]) -> f64 {
        let corners: Vec<_> = corners.iter().map(|&corner| self.exact(corner)).collect();
        let Some(normal) = unit(newell(&corners)).filter(|_| corners.len() > 3) else {
            return 0.0;
        };
        let centre = scaled(corners.iter().copied().fold([0.0; 3], sum), 1.0 / corners.len() as f64);
        let distances = corners
            .iter()
            .map(|&corner| dot(difference(corner, centre), normal).abs());
        distances.fold(0.0, f64::max)
    }

    /// Gives each corner of each triangle its vertex.
    fn weld(&mut self, pieces: &[Piece<'_>]) -> anyhow::Result<()> {
        let smooth = SmoothNormals::of(pieces.iter().map(|piece| &piece.shape));
        for pieces in pieces.chunk_by(|one, other| std::ptr::eq(one.face, other.face)) {
            let coordinates = self.coordinates(pieces[0].face)?;
            for piece in pieces {
                self.add_face(piece, &coordinates, &smooth)
                    .with_context(|| self.model.place(piece.face))?;
            }
        }
        Ok(())
    }

    /// The stored texture coordinates of a face's corners, in the file's order; zeros for corners without any.
    fn coordinates(&self, face: &Face) -> anyhow::Result<Vec<[i16; 2]>> {
        let corners = self.model.corners_of(face);
        let named: Vec<[f64; 2]> = corners
            .iter()
            .filter_map(|corner| Some(self.model.coordinates[corner.coordinates?]))
            .collect();
        let mut stored = coordinates::of_face(&named)
            .with_context(|| self.model.place(face))?
            .into_iter();
        let of_corner = |corner: &Corner| corner.coordinates.and_then(|_| stored.next()).unwrap_or_default();
        Ok(corners.iter().map(of_corner).collect())
    }

    fn add_face(&mut self, piece: &Piece<'_>, coordinates: &[[i16; 2]], smooth: &SmoothNormals) -> anyhow::Result<()> {
        let mut face = [0; 3];
        for (index, vertex) in face.iter_mut().enumerate() {
            let corner = piece.corners[index];
            let normal = if self.options.flat {
                [0, 0]
            } else {
                let normal = self.normal_of_file(corner);
                octahedral::encode(normal.unwrap_or_else(|| smooth.at(&piece.shape, index)))
            };
            let coordinates = coordinates[corner - piece.face.corners.start];
            *vertex = self.vertex(piece.shape.rounded[index], coordinates, normal)?;
        }
        self.mesh.faces.push(face);
        let material = piece.face.material.map(|index| &self.model.materials[index]);
        let color = material.map_or([1.0; 3], |material| material.color);
        self.mesh.colors.push(rgb565(color));
        Ok(())
    }

    /// The normal that a corner names in zrow's axes, unless its length is 0.
    fn normal_of_file(&self, corner: usize) -> Option<[f64; 3]> {
        let index = self.corner(corner).normal?;
        unit(self.options.up.turned(self.model.normals[index]))
    }

    fn vertex(&mut self, position: [i16; 3], coordinates: [i16; 2], normal: [i8; 2]) -> anyhow::Result<u16> {
        let key = (position, coordinates, normal);
        if let Some(&index) = self.indices.get(&key) {
            return Ok(index);
        }
        let index = u16::try_from(self.mesh.vertices.len()).ok().with_context(|| {
            format!("here the model has more than {MOST_VERTICES} vertices: simplify it, or convert it in parts")
        })?;
        self.indices.insert(key, index);
        self.mesh.vertices.push(position);
        if !self.options.flat {
            self.mesh.normals.push(normal);
        }
        if self.has_coordinates {
            self.mesh.coordinates.push(coordinates);
        }
        Ok(index)
    }

    fn note_what_lacks(&mut self) {
        let corners = &self.model.corners;
        let without = corners.iter().filter(|corner| corner.coordinates.is_none()).count();
        if self.has_coordinates && without > 0 {
            let note = format!(
                "corners without texture coordinates, which get those of the texture's upper left corner: {without}"
            );
            self.mesh.notes.push(note);
        }
        let is_zero = |corner: &&Corner| {
            corner
                .normal
                .is_some_and(|index| unit(self.model.normals[index]).is_none())
        };
        let zeros = corners.iter().filter(is_zero).count();
        if zeros > 0 && !self.options.flat {
            let note = format!("corners with a normal of length 0, which is computed instead: {zeros}");
            self.mesh.notes.push(note);
        }
    }

    fn texture(&mut self, files: &dyn Fn(&str) -> anyhow::Result<Vec<u8>>) -> anyhow::Result<()> {
        let pictures = self.model.pictures();
        let Some(&picture) = pictures.first() else {
            return Ok(());
        };
        if let Some(other) = pictures.get(1) {
            anyhow::bail!(
                "{}: {} is a second texture beside {} ({}): a model has one, so put both into one picture",
                other.named_at,
                other.path,
                picture.path,
                picture.named_at
            );
        }
        if !self.has_coordinates {
            let note = format!(
                "{} is not read: the model has no texture coordinates (vt)",
                picture.path
            );
            self.mesh.notes.push(note);
            return Ok(());
        }
        let texture = files(&picture.path)
            .and_then(|bytes| texture::parse(&bytes).with_context(|| picture.path.clone()))
            .with_context(|| picture.named_at.clone())?;
        if texture.has_alpha {
            let note = format!("{} has pixels that are not opaque: they become opaque", picture.path);
            self.mesh.notes.push(note);
        }
        self.mesh.texture = Some(texture);
        Ok(())
    }
}

/// The worst of some faces, and how many there are.
#[derive(Default)]
struct Worst<'a> {
    count: usize,
    distance: f64,
    face: Option<&'a Face>,
}

impl<'a> Worst<'a> {
    fn note(&mut self, is_bad: bool, distance: f64, face: &'a Face) {
        if is_bad {
            self.count += 1;
            if self.face.is_none() || distance > self.distance {
                (self.distance, self.face) = (distance, Some(face));
            }
        }
    }
}
