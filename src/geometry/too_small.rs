//! The error of memory that the caller lends and that is too small: it says how much would have been enough.

use core::fmt::{self, Display};

/// Memory that the caller lends is too small: a table, whose capacity is a const parameter, or a slice. What was prepared
/// before is as it was. The variant says what the memory is for and how many entries would do.
///
/// While a program is written, the number goes into the constant that is too small. One that draws in spare memory fits
/// its work to it:
///
/// ```
/// use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
/// use zrow::{band::Band, geometry::TooSmall};
///
/// let mut spare = [0; 1000];
/// let mut area = Rectangle::new(Point::zero(), Size::new(240, 16));
/// let error = Band::<Rgb565>::new(area, &mut spare).err();
/// assert_eq!(error, Some(TooSmall::Words(3840)));
/// let text = "the slice of words is too small: 3840 are needed, pass a longer one";
/// assert_eq!(error.map(|error| error.to_string()).as_deref(), Some(text));
/// // 240 words a row: four rows fit into a thousand.
/// while let Err(TooSmall::Words(_)) = Band::<Rgb565>::new(area, &mut spare) {
///     area.size.height /= 2;
/// }
/// assert_eq!(area.size.height, 4);
/// ```
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum TooSmall {
    /// Edges of a polygon, or of a mesh.
    Edges(usize),
    /// Edges of a polygon that cross one row.
    ActiveEdges(usize),
    /// Edges that one antialiased item of a picture has in one row: the `SEGMENTS` of an
    /// [`AntialiasingMemory`](crate::draw::AntialiasingMemory).
    Segments(usize),
    /// Crossings of a row with edges of a polygon.
    Crossings(usize),
    /// Transformed vertices of a scene.
    Vertices(usize),
    /// Visible faces of a scene.
    Faces(usize),
    /// Faces of a scene that cross one row.
    ActiveFaces(usize),
    /// Columns of a scene's viewport.
    Columns(usize),
    /// Rows of a scene's viewport.
    Rows(usize),
    /// Spans that a seed fill has still to search.
    Searches(usize),
    /// Corners of a clipped polygon.
    Corners(usize),
    /// Sides of a convex window that a polygon is cut at.
    WindowSides(usize),
    /// Vertices of polygons that are clipped against each other: corners, and points where edges meet.
    ContourVertices(usize),
    /// Items of a picture: a slice of slots.
    Items(usize),
    /// Pixels of a [depth buffer](crate::visible::DepthBuffer).
    Pixels(usize),
    /// Tiles of a window ([`TileBins`](crate::visible::TileBins)).
    Tiles(usize),
    /// Faces in the lists of all tiles of a window.
    TileFaces(usize),
    /// Solids of a scene, one for each model ([`Roberts`](crate::visible::Roberts)).
    Solids(usize),
    /// Planes of the solids of a scene ([`Roberts`](crate::visible::Roberts)).
    Planes(usize),
    /// Words of the pool that the items of a picture share: a slice.
    PictureWords(usize),
    /// Words of a band, or of each sample of its pixels: a slice.
    Words(usize),
    /// Bytes of a [page](crate::band::PagesSink) of eight rows, one for each column: a slice.
    PageBytes(usize),
    /// Sums of the samples of a band's pixels: a slice.
    Sums(usize),
    /// Cells of the row memory of antialiasing: a slice.
    Cells(usize),
    /// Cells of the [`AntialiasingMemory`](crate::draw::AntialiasingMemory) of a picture, which has none where none is lent
    /// ([`Picture::with_antialiasing`](crate::draw::Picture::with_antialiasing)). So many draw a column at a time; one more than the
    /// columns of a band draw all of them at once.
    PictureCells(usize),
    /// Words for the rows behind groups of a picture: a slice
    /// ([`Picture::with_group_rows`](crate::draw::Picture::with_group_rows)).
    GroupWords(usize),
    /// Colours of a model, one for each of its faces: a slice.
    Colors(usize),
    /// Normals of a model, one for each of its vertices or faces: a slice.
    Normals(usize),
    /// Texture coordinates of a model, one pair for each of its vertices: a slice.
    TextureCoordinates(usize),
}

impl TooSmall {
    /// The entries that the memory should have which the error is about: the smallest number with which the call does not fail for it,
    /// and for [`Clipper`](crate::clip::Clipper) one that is enough.
    pub const fn needed(&self) -> usize {
        match *self {
            Self::Edges(needed)
            | Self::ActiveEdges(needed)
            | Self::Segments(needed)
            | Self::Crossings(needed)
            | Self::Vertices(needed)
            | Self::Faces(needed)
            | Self::ActiveFaces(needed)
            | Self::Columns(needed)
            | Self::Rows(needed)
            | Self::Searches(needed)
            | Self::Corners(needed)
            | Self::WindowSides(needed)
            | Self::ContourVertices(needed)
            | Self::Items(needed)
            | Self::Pixels(needed)
            | Self::Tiles(needed)
            | Self::TileFaces(needed)
            | Self::Solids(needed)
            | Self::Planes(needed)
            | Self::PictureWords(needed)
            | Self::Words(needed)
            | Self::PageBytes(needed)
            | Self::Sums(needed)
            | Self::Cells(needed)
            | Self::PictureCells(needed)
            | Self::GroupWords(needed)
            | Self::Colors(needed)
            | Self::Normals(needed)
            | Self::TextureCoordinates(needed) => needed,
        }
    }

    /// Whether the memory is a slice, and not a table.
    const fn is_slice(&self) -> bool {
        matches!(
            self,
            Self::Items(_)
                | Self::PictureWords(_)
                | Self::Words(_)
                | Self::PageBytes(_)
                | Self::Sums(_)
                | Self::Cells(_)
                | Self::GroupWords(_)
                | Self::Colors(_)
                | Self::Normals(_)
                | Self::TextureCoordinates(_)
        )
    }

    /// The name of the entries of the memory that is too small, in the plural, as the error message has it.
    const fn entries(&self) -> &'static str {
        match self {
            Self::Edges(_) => "edges",
            Self::ActiveEdges(_) => "active edges",
            Self::Segments(_) => "segments of antialiased outlines",
            Self::Crossings(_) => "crossings",
            Self::Vertices(_) => "vertices",
            Self::Faces(_) => "faces",
            Self::ActiveFaces(_) => "active faces",
            Self::Columns(_) => "columns",
            Self::Rows(_) => "rows",
            Self::Searches(_) => "searches",
            Self::Corners(_) => "corners",
            Self::WindowSides(_) => "window sides",
            Self::ContourVertices(_) => "contour vertices",
            Self::Items(_) => "item slots",
            Self::Pixels(_) => "pixels",
            Self::Tiles(_) => "tiles",
            Self::TileFaces(_) => "faces in tiles",
            Self::Solids(_) => "solids",
            Self::Planes(_) => "planes",
            Self::PictureWords(_) => "picture words",
            Self::Words(_) => "words",
            Self::PageBytes(_) => "page bytes",
            Self::Sums(_) => "sums",
            Self::Cells(_) => "row memory cells",
            Self::PictureCells(_) => "cells for antialiasing",
            Self::GroupWords(_) => "words for rows behind groups",
            Self::Colors(_) => "colours",
            Self::Normals(_) => "normals",
            Self::TextureCoordinates(_) => "texture coordinates",
        }
    }
}

impl Display for TooSmall {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (entries, needed) = (self.entries(), self.needed());
        let memory = if self.is_slice() { "slice" } else { "table" };
        let remedy = match self {
            Self::Segments(_) => "raise SEGMENTS of the AntialiasingMemory",
            Self::PictureCells(_) => "lend the picture an AntialiasingMemory by with_antialiasing",
            Self::GroupWords(_) => "lend the picture a longer one by with_group_rows",
            _ if self.is_slice() => "pass a longer one",
            _ => "raise its capacity",
        };
        write!(
            formatter,
            "the {memory} of {entries} is too small: {needed} are needed, {remedy}"
        )
    }
}

impl core::error::Error for TooSmall {}
