//! The error of memory that the caller lends and that is too small: it says how much would have been enough.

use core::fmt::{self, Display};

/// What memory is lent for: tables, whose capacity is a const parameter, and slices.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Table {
    /// Edges of a polygon.
    Edges,
    /// Edges of a polygon that cross one row.
    ActiveEdges,
    /// Crossings of a row with edges of a polygon.
    Crossings,
    /// Transformed vertices of a scene.
    Vertices,
    /// Visible faces of a scene.
    Faces,
    /// Faces of a scene that cross one row.
    ActiveFaces,
    /// Rows of a scene's viewport.
    Rows,
    /// Spans that a seed fill has still to search.
    Searches,
    /// Corners of a clipped polygon.
    Corners,
    /// Sides of a convex window that a polygon is cut at.
    WindowSides,
    /// Vertices of polygons that are clipped against each other: corners, and points where edges meet.
    ContourVertices,
    /// Items of a picture: a slice of slots.
    Items,
    /// Words of the pool that the items of a picture share: a slice.
    PictureWords,
    /// Words of a band, or of each sample of its pixels: a slice.
    Words,
    /// Sums of the samples of a band's pixels: a slice.
    Sums,
    /// Depths of a row of a scene: a slice.
    Depths,
    /// Cells of the row memory of antialiasing: a slice.
    Cells,
    /// Colours of a model, one for each of its faces: a slice.
    Colors,
}

impl Table {
    const fn is_slice(self) -> bool {
        matches!(
            self,
            Self::Items | Self::PictureWords | Self::Words | Self::Sums | Self::Depths | Self::Cells | Self::Colors
        )
    }
}

/// Memory that the caller lends is too small. What was prepared before is as it was, and the input fits a table or slice of
/// `needed` entries.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TooSmall {
    /// The table or slice that is too small.
    pub table: Table,
    /// How many entries would do.
    pub needed: usize,
}

impl Display for Table {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Self::Edges => "edges",
            Self::ActiveEdges => "active edges",
            Self::Crossings => "crossings",
            Self::Vertices => "vertices",
            Self::Faces => "faces",
            Self::ActiveFaces => "active faces",
            Self::Rows => "rows",
            Self::Searches => "searches",
            Self::Corners => "corners",
            Self::WindowSides => "window sides",
            Self::ContourVertices => "contour vertices",
            Self::Items => "item slots",
            Self::PictureWords => "picture words",
            Self::Words => "words",
            Self::Sums => "sums",
            Self::Depths => "depths",
            Self::Cells => "row memory cells",
            Self::Colors => "colours",
        })
    }
}

impl Display for TooSmall {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { table, needed } = self;
        let (memory, remedy) = if table.is_slice() {
            ("slice", "pass a longer one")
        } else {
            ("table", "raise its capacity")
        };
        write!(
            formatter,
            "the {memory} of {table} is too small: {needed} are needed, {remedy}"
        )
    }
}

impl core::error::Error for TooSmall {}
