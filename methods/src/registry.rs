//! The registry: every algorithm of a family is entered once, and whoever shows, counts, checks or describes the family
//! reads it from here.
//!
//! A family is a macro and a table. The macro calls another macro with `[name] [item of zrow]` of each algorithm, so that
//! each reader writes the call once; the table has what people read. The first algorithm is the default; those that are
//! `exact` give its result, and `differing` ones what their documentation says. A method of antialiasing is a
//! `sample_pattern` where it implements that trait, so that its samples may carry a colour each.

/// What people read of an algorithm.
#[derive(Debug, Clone, Copy)]
pub struct Algorithm {
    /// Its name in tables and in the reports of the chips.
    pub name: &'static str,
    /// What it is called in zrow, with generic parameters.
    pub item: &'static str,
    /// Author and year, or what it is where nobody claims it.
    pub source: &'static str,
    /// When to take it.
    pub take_it: &'static str,
    /// For which inputs the algorithm has to give the result of its family's default, the first entry.
    pub agrees: Agrees,
}

/// For which inputs an algorithm has to give the result of its family's default.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Agrees {
    /// For every input.
    Always,
    /// For coordinates as displays have them; `Algorithm::source` says up to where.
    OnDisplays,
    /// For none: its own documentation says what it gives.
    No,
}

macro_rules! agrees {
    (exact) => {
        Agrees::Always
    };
    (exact_on_displays) => {
        Agrees::OnDisplays
    };
    (differing) => {
        Agrees::No
    };
    (sample_pattern) => {
        Agrees::No
    };
}

/// Defines a family: `name: item, where it agrees, source, when to take it`. The first argument is a dollar sign. With
/// `sample_patterns: name`, a second macro of that name passes on only the entries that are marked as `sample_pattern`.
macro_rules! family {
    (
        $dollar:tt
        $(#[$doc:meta])*
        $family:ident, $table:ident, sample_patterns: $patterns:ident {
            $($name:ident: [$($item:tt)+], $agrees:ident, $source:literal, $take_it:literal;)+
        }
    ) => {
        family! { $dollar
            $(#[$doc])*
            $family, $table {
                $($name: [$($item)+], $agrees, $source, $take_it;)+
            }
        }

        /// The methods of antialiasing whose samples may carry a colour each.
        ///
        /// Calls a macro with `[name] [item]` of each.
        #[macro_export]
        macro_rules! $patterns {
            ($dollar with:ident) => {
                $crate::keep_sample_patterns! { $dollar with, [], $($agrees [$name] [$($item)+])+ }
            };
        }
    };
    (
        $dollar:tt
        $(#[$doc:meta])*
        $family:ident, $table:ident {
            $($name:ident: [$($item:tt)+], $agrees:ident, $source:literal, $take_it:literal;)+
        }
    ) => {
        $(#[$doc])*
        ///
        /// Calls a macro with `[name] [item]` of each.
        #[macro_export]
        macro_rules! $family {
            ($dollar with:ident) => {
                $dollar with! { $([$name] [$($item)+])+ }
            };
        }

        $(#[$doc])*
        pub const $table: &[Algorithm] = &[
            $(Algorithm {
                name: stringify!($name),
                item: stringify!($($item)+),
                source: $source,
                take_it: $take_it,
                agrees: agrees!($agrees),
            }),+
        ];
    };
}

/// Calls a macro with the entries that are marked as `sample_pattern`, taking one entry off the list at a time.
#[doc(hidden)]
#[macro_export]
macro_rules! keep_sample_patterns {
    ($with:ident, [$($kept:tt)+],) => {
        $with! { $($kept)+ }
    };
    ($with:ident, [$($kept:tt)*], sample_pattern $name:tt $item:tt $($rest:tt)*) => {
        $crate::keep_sample_patterns! { $with, [$($kept)* $name $item], $($rest)* }
    };
    ($with:ident, [$($kept:tt)*], $other:ident $name:tt $item:tt $($rest:tt)*) => {
        $crate::keep_sample_patterns! { $with, [$($kept)*], $($rest)* }
    };
}

family! { $
    /// Lines one pixel wide: `fn(start, end, &window)` gives pixels.
    lines, LINES {
        bresenham: [zrow::scan::Lines::bresenham], exact,
            "Bresenham 1965, entered as Kuzmin 1995", "always";
        bresenham_runs: [zrow::scan::Lines::bresenham_runs], exact,
            "Bresenham 1985; Stephenson and Litow 2000",
            "where runs are long and filling them is cheap: a band does, for shallow lines";
        double_step: [zrow::scan::Lines::double_step], exact,
            "Wu and Rokne 1987: two pixels a decision", "where a decision is dear beside a pixel";
        midpoint: [zrow::scan::Lines::midpoint], exact,
            "Pitteway 1967; Van Aken and Novak 1985", "as the pattern for other curves";
        dda_fixed: [zrow::scan::Lines::dda_fixed], differing,
            "16.16 fixed point; the same pixels up to 181 steps", "where something else is stepped in 16.16 anyway";
        dda: [zrow::scan::Lines::dda], exact_on_displays,
            "Newman and Sproull 1979, in `f32`; the same pixels up to 1,365 steps", "to compare";
        slope_intercept: [zrow::scan::Lines::slope_intercept], differing,
            "`y = m x + b` in `f32`; the same pixels up to coordinates of 1,023, but for ties",
            "to see what the others save";
        supercover: [zrow::scan::Lines::supercover], differing,
            "Amanatides and Woo 1987: every cell that is touched", "for line of sight and collision on a grid";
    }
}

family! { $
    /// Thin circles: `fn(center, radius, &window)` gives pixels or an error.
    circles, CIRCLES {
        bresenham_circle: [zrow::scan::Conics::bresenham_circle], exact,
            "Bresenham 1977", "for the thin 8-connected circle";
        midpoint_circle: [zrow::scan::Conics::midpoint_circle], exact,
            "Pitteway 1967; Van Aken and Novak 1985", "as the pattern for other curves";
        square_root_circle: [zrow::scan::Conics::square_root_circle], exact,
            "the equation, with an exact root", "to check the others, and for single pixels";
        parametric_circle: [zrow::scan::Conics::parametric_circle], differing,
            "Rogers 1985: a rotation by a fixed angle; at most 0.72 pixel off",
            "for points at equal steps of the angle";
    }
}

family! { $
    /// Thin ellipses: `fn(center, radii, &window)` gives pixels or an error.
    ellipses, ELLIPSES {
        midpoint_ellipse: [zrow::scan::Conics::midpoint_ellipse], exact,
            "Pitteway 1967; Van Aken 1984", "as the pattern for other curves";
        square_root_ellipse: [zrow::scan::Conics::square_root_ellipse], exact,
            "the equation, with an exact root", "to check the others, and for single pixels";
        parametric_ellipse: [zrow::scan::Conics::parametric_ellipse], differing,
            "Rogers 1985: a rotation by a fixed angle; at most 0.72 pixel off",
            "for points at equal steps of the parameter";
    }
}

family! { $
    /// Flattening of Bézier curves: `fn(&curve, tolerance)` gives the ends of lines.
    curves, CURVES {
        adaptive_forward_difference: [zrow::scan::Bezier::adaptive_forward_difference], exact,
            "Lien, Shantz and Pratt 1987", "fewest lines, no table";
        de_casteljau: [zrow::scan::Bezier::de_casteljau], exact,
            "de Casteljau 1959; Lane and Riesenfeld 1980; the same lines", "to see the textbook's way";
        uniform_subdivision: [zrow::scan::Bezier::uniform_subdivision], differing,
            "Wang 1984; a third more lines", "when their number must be known first, or curves bend evenly";
    }
}

family! { $
    /// Polygon fills through a table of `N`: `fn::<_, _, N>(contours, rule, &window, emit)`.
    polygon_fills, POLYGON_FILLS {
        scanline_polygon: [zrow::scan::Polygons::scanline], exact,
            "Wylie et al. 1967", "always";
        naive_scanline: [zrow::scan::Polygons::naive_scanline], exact,
            "its baseline", "where RAM counts: 8 bytes a crossing of one row";
    }
}

family! { $
    /// Where a point lies: `fn(contours, rule, &point)`; `brute_force_fill` fills a polygon by asking for each pixel.
    point_tests, POINT_TESTS {
        winding_number: [zrow::scan::Polygons::winding_number], exact,
            "Hormann and Agathos 2001",
            "where there is no memory for a table; the point test by itself always";
        quadrant_arc_length: [zrow::scan::Polygons::quadrant_arc_length], exact,
            "Weiler 1994", "where edges are short as seen from the point";
        crossing_number: [zrow::scan::Polygons::crossing_number], exact,
            "Shimrat 1962; Franklin 1970; Haines 1994", "to see the textbook's way";
        merged_crossings: [zrow::scan::Polygons::merged_crossings], exact,
            "Hearn and Baker 1986", "to see that merging agrees with the vertex rule";
    }
}

family! { $
    /// Triangle fills: `fn(vertices, &window, emit)`; the default fills one as a polygon.
    triangles, TRIANGLES {
        hierarchical_triangle: [zrow::scan::Polygons::hierarchical_triangle], exact,
            "Greene 1996; McCormack and McNamara 2000", "where blocks are skipped for another reason too";
        incremental_edge_triangle: [zrow::scan::Polygons::incremental_edge_triangle], exact,
            "Pineda 1988", "for a few pixels: no division";
        edge_function_triangle: [zrow::scan::Polygons::edge_function_triangle], exact,
            "Pineda 1988", "where pixels are asked for out of order";
        barycentric_triangle: [zrow::scan::Polygons::barycentric_triangle], exact,
            "Möbius 1827", "where the coordinates are wanted too";
    }
}

family! { $
    /// Attributes of triangles and convex polygons: `fn(corners, &window, emit)`, each corner with its attributes.
    interpolations, INTERPOLATIONS {
        plane_interpolation: [zrow::scan::Polygons::plane_interpolation], exact,
            "Fuchs et al. 1985; Pineda 1988", "always: what scenes shade with";
        barycentric_interpolation: [zrow::scan::Polygons::barycentric_interpolation], differing,
            "Möbius 1827; within one unit", "where single pixels are asked for, to the nearest unit";
        edge_and_span_interpolation: [zrow::scan::Polygons::edge_and_span_interpolation], differing,
            "Gouraud 1971; within two units in triangles", "to see why quadrangles are drawn as triangles: it depends on how they are turned";
    }
}

family! { $
    /// Triangle fills in homogeneous coordinates: `fn(corners, &camera, &window, emit)`.
    homogeneous_triangles, HOMOGENEOUS_TRIANGLES {
        homogeneous_triangle: [zrow::scan::Polygons::homogeneous_triangle], exact,
            "Olano and Greer 1997: no clipping, no division", "to see what clipping is for: faces around the eye are no special case";
    }
}

family! { $
    /// Segments against an upright window: `fn(from, to, &window)`.
    segments, SEGMENTS {
        liang_barsky: [zrow::clip::Segments::liang_barsky], exact,
            "Liang and Barsky 1984", "by default";
        cohen_sutherland: [zrow::clip::Segments::cohen_sutherland], exact,
            "Cohen and Sutherland 1967", "where flash counts";
        nicholl_lee_nicholl: [zrow::clip::Segments::nicholl_lee_nicholl], exact,
            "Nicholl, Lee and Nicholl 1987", "to see how areas of the plane decide";
        midpoint_subdivision: [zrow::clip::Segments::midpoint_subdivision], exact,
            "Sproull and Sutherland 1968", "where nothing multiplies";
    }
}

family! { $
    /// Segments against a convex window: `fn(from, to, &window)`.
    convex_segments, CONVEX_SEGMENTS {
        cyrus_beck: [zrow::clip::Segments::cyrus_beck], exact,
            "Cyrus and Beck 1978", "for a convex window that is not upright, or several";
    }
}

family! { $
    /// Segments in space against what a camera sees: `fn(from, to, &matrix)`.
    space_segments, SPACE_SEGMENTS {
        homogeneous_liang_barsky: [zrow::clip::Segments::homogeneous_liang_barsky], exact,
            "Liang and Barsky 1984, in four dimensions", "by default";
        homogeneous_cohen_sutherland: [zrow::clip::Segments::homogeneous_cohen_sutherland], exact,
            "Cohen and Sutherland 1967; Blinn and Newell 1978: outcodes of six bits",
            "where most segments are inside or on one side";
        eye_space: [zrow::clip::Segments::eye_space], exact,
            "Sutherland and Hodgman 1974; planes as Gribb and Hartmann 2001",
            "to see that homogeneous clipping is clipping in space";
    }
}

family! { $
    /// Segments in space against a convex volume: `fn(from, to, &planes)`.
    volume_segments, VOLUME_SEGMENTS {
        cyrus_beck_in_space: [zrow::clip::Segments::cyrus_beck_in_space], exact,
            "Cyrus and Beck 1978", "for planes that bound something else: a room, a portal";
    }
}

family! { $
    /// Faces in space against what a camera sees: `fn(&matrix, &face)` gives the corners of a polygon in clip coordinates.
    space_polygons, SPACE_POLYGONS {
        sutherland_hodgman: [zrow::clip::ClipMatrix::sutherland_hodgman], exact,
            "Sutherland and Hodgman 1974; homogeneous as Blinn and Newell 1978", "a face with its attributes, before the division";
        sutherland_hodgman_in_eye_space: [zrow::clip::ClipMatrix::sutherland_hodgman_in_eye_space], differing,
            "Sutherland and Hodgman 1974; corners rounded in space", "where distances are wanted in space";
    }
}

family! { $
    /// Polygons against a convex window: `fn::<CORNERS, SIDES>(&window, polygon)`.
    convex_polygons, CONVEX_POLYGONS {
        sutherland_hodgman_2d: [zrow::geometry::ConvexWindow::sutherland_hodgman_2d], exact,
            "Sutherland and Hodgman 1974", "polygons against a convex window";
    }
}

family! { $
    /// Whole shapes against a window of pixels: `fn(shape, &window)` says how much of it is visible.
    shapes_in_window, SHAPES_IN_WINDOW {
        circle_against_window: [zrow::clip::Classification::circle_against_window], differing,
            "outcodes, then the nearest and the farthest pixel", "before drawing circles that may not be visible";
        rectangle_against_window: [zrow::clip::Classification::rectangle_against_window], differing,
            "outcodes of two corners", "before drawing what is dearer than its box";
    }
}

family! { $
    /// Polygons against polygons: `fn(&mut clipper, subject, clip, operation)` keeps the result in a `Clipper`.
    booleans, BOOLEANS {
        greiner_hormann: [zrow::clip::Clipper::greiner_hormann], exact,
            "Greiner and Hormann 1998; Foster, Hormann and Popa 2019",
            "intersection, union, difference of any two polygons with holes";
        weiler_atherton: [zrow::clip::Clipper::weiler_atherton], exact,
            "Weiler and Atherton 1977; the same contours",
            "to see each intersection decided without the ones before it";
    }
}

family! { $
    /// Methods of antialiasing by coverage.
    coverage_methods, COVERAGE_METHODS, sample_patterns: sample_patterns {
        signed_area: [zrow::coverage::SignedArea], differing,
            "T3: Turner 2000; Levien 2016", "one contour that does not cross itself: the default for 2D";
        inside_area: [zrow::coverage::InsideArea], differing,
            "T4: sides of the inside by a sweep line (Bentley and Ottmann 1979)", "everything else";
        centre_sample: [zrow::coverage::CentreSample], differing,
            "T0: the centre of the pixel", "edges along pixel boundaries";
        rooks_4: [zrow::coverage::Rooks<4>], sample_pattern,
            "T1: the 4x pattern of Direct3D", "where samples carry more than coverage, such as depth";
        rooks_8: [zrow::coverage::Rooks<8>], sample_pattern,
            "T1b: Kallio 2007", "half the memory of sub-scanlines";
        rooks_16: [zrow::coverage::Rooks<16>], sample_pattern,
            "T1b: Kallio 2007", "to compare";
        sub_scanlines_4: [zrow::coverage::SubScanlines<4>], differing,
            "T2: Catmull 1984", "to compare";
        sub_scanlines_16: [zrow::coverage::SubScanlines<16>], differing,
            "Catmull 1984", "to compare";
        grid_2: [zrow::coverage::Grid<2>], sample_pattern,
            "2 x 2 samples", "the textbook's baseline";
        grid_4: [zrow::coverage::Grid<4>], sample_pattern,
            "4 x 4 samples", "the textbook's baseline";
        grid_8: [zrow::coverage::Grid<8>], differing,
            "8 x 8 samples", "the textbook's baseline";
        grid_16: [zrow::coverage::Grid<16>], differing,
            "16 x 16 samples", "the textbook's baseline";
        grid_4_bartlett: [zrow::coverage::Grid<4, zrow::coverage::Bartlett>], differing,
            "Crow 1981: samples weighted as a pyramid", "to compare";
        grid_8_bartlett: [zrow::coverage::Grid<8, zrow::coverage::Bartlett>], differing,
            "Crow 1981: samples weighted as a pyramid", "to compare";
        grid_16_bartlett: [zrow::coverage::Grid<16, zrow::coverage::Bartlett>], differing,
            "Crow 1981: samples weighted as a pyramid", "to compare";
        grid_4_gaussian: [zrow::coverage::Grid<4, zrow::coverage::Gaussian>], differing,
            "Crow 1981: samples weighted as a bell", "to compare";
        grid_8_gaussian: [zrow::coverage::Grid<8, zrow::coverage::Gaussian>], differing,
            "Crow 1981: samples weighted as a bell", "to compare";
        grid_16_gaussian: [zrow::coverage::Grid<16, zrow::coverage::Gaussian>], differing,
            "Crow 1981: samples weighted as a bell", "to compare";
    }
}

/// Every family, by the name of its macro.
pub const FAMILIES: &[(&str, &[Algorithm])] = &[
    ("lines", LINES),
    ("circles", CIRCLES),
    ("ellipses", ELLIPSES),
    ("curves", CURVES),
    ("polygon_fills", POLYGON_FILLS),
    ("point_tests", POINT_TESTS),
    ("triangles", TRIANGLES),
    ("interpolations", INTERPOLATIONS),
    ("homogeneous_triangles", HOMOGENEOUS_TRIANGLES),
    ("segments", SEGMENTS),
    ("convex_segments", CONVEX_SEGMENTS),
    ("space_segments", SPACE_SEGMENTS),
    ("volume_segments", VOLUME_SEGMENTS),
    ("space_polygons", SPACE_POLYGONS),
    ("convex_polygons", CONVEX_POLYGONS),
    ("shapes_in_window", SHAPES_IN_WINDOW),
    ("booleans", BOOLEANS),
    ("coverage_methods", COVERAGE_METHODS),
];
