//! The error of every table with a fixed capacity: it says how much would have been enough.

use core::fmt::{self, Display};

/// The tables whose capacity is a const parameter.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Table {
    /// Edges of a polygon.
    Edges,
    /// Edges of a polygon that cross one row.
    ActiveEdges,
    /// Places where edges of a polygon cross one row.
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
}

/// A table is too small. What was prepared before is as it was, and the same input fits a table of `needed` entries.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TableFull {
    /// The table that is too small.
    pub table: Table,
    /// The capacity that would do, exactly.
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
        })
    }
}

impl Display for TableFull {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            formatter,
            "the table of {} is too small: {} are needed",
            self.table, self.needed
        )
    }
}

impl core::error::Error for TableFull {}
