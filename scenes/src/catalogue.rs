//! All scenes, in the order in which a gallery shows them.

use crate::{
    Scene,
    antialiased::AntialiasedStyles,
    arcs::Arcs,
    booleans::Booleans,
    clipping::Clipping,
    cockpit::Cockpit,
    curves::Curves,
    dashboard::Dashboard,
    effects::{AntialiasedPot, EverythingPot, GlazedPot, LacePot, Plain, TurningPot},
    fill_siblings::FillSiblings,
    flight::Flight,
    gem::Gem,
    instruments::{Instruments, Jagged, Replayed},
    line_siblings::LineSiblings,
    multisampled::SmoothTorusAndCube,
    oled::Oled,
    oled_teapot::OledTeapot,
    paints::Paints,
    panes::Panes,
    polygons::Polygons,
    samples::Samples,
    segment_siblings::SegmentSiblings,
    shapes::Shapes,
    standard::{Icosphere, Sc1, Sc2, Sc3, TorusAndCube, TurningCube},
    strokes::Strokes,
    teapots::{GouraudTeapot, TexturedTeapot},
    visibility::{HiddenLineDrawings, ScanLine, VisibilitySiblings},
};

/// Does the same with scenes of different types.
pub trait Visitor {
    /// Takes one scene.
    fn visit<S: Scene>(&mut self);
}

macro_rules! catalogue {
    ($($scene:ty),+ $(,)?) => {
        /// The names of all scenes.
        pub const NAMES: &[&str] = &[$(<$scene as Scene>::NAME),+];

        /// Visits the scene of that name, or every scene.
        pub fn visit(name: Option<&str>, visitor: &mut impl Visitor) {
            $(
                if name.is_none_or(|name| name == <$scene as Scene>::NAME) {
                    visitor.visit::<$scene>();
                }
            )+
        }
    };
}

catalogue![
    Shapes,
    LineSiblings,
    Arcs,
    Clipping,
    SegmentSiblings,
    Polygons,
    Strokes,
    AntialiasedStyles,
    Booleans,
    FillSiblings,
    Paints,
    Samples,
    Curves,
    Cockpit,
    Dashboard,
    Instruments,
    Replayed<Jagged>,
    TexturedTeapot,
    GouraudTeapot,
    AntialiasedPot,
    TurningPot<GlazedPot>,
    TurningPot<LacePot, Plain<LacePot>>,
    TurningPot<EverythingPot>,
    Panes,
    Flight,
    Gem,
    TorusAndCube,
    SmoothTorusAndCube,
    Icosphere,
    TurningCube,
    VisibilitySiblings,
    ScanLine,
    HiddenLineDrawings,
    Sc1,
    Sc2,
    Sc3,
    Oled,
    OledTeapot,
];
