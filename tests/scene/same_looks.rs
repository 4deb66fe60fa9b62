//! Looks that have the same types and constants, whatever their names are.

use std::any::type_name;

use zrow::scene::{Counted, Deep, Fine, Look, OnePass, Unhurried, Whole};

/// Looks of which all types are those of a look `L`.
pub trait SameTypes<L: Look>:
    Look<
        Color = L::Color,
        Shading = L::Shading,
        Precision = L::Precision,
        Depth = L::Depth,
        Counting = L::Counting,
        Silhouettes = L::Silhouettes,
        Visibility = L::Visibility,
    >
{
}

impl<L: Look, Same> SameTypes<L> for Same where
    Same: Look<
            Color = L::Color,
            Shading = L::Shading,
            Precision = L::Precision,
            Depth = L::Depth,
            Counting = L::Counting,
            Silhouettes = L::Silhouettes,
            Visibility = L::Visibility,
        >
{
}

/// A look of which all types and constants are those of another: it draws the same, because nothing else of a look says what is
/// drawn. What it keeps of attributes says only whether faces read some of them from their skin.
pub fn assert_same_items<L: Look, Same: SameTypes<L>>() {
    fn constants<L: Look>() -> [bool; 6] {
        [
            L::CLIPS,
            L::DRAWS_IN_PASSES,
            L::HURRIES,
            L::IS_ORTHOGRAPHIC,
            L::DRAWS_BACKS,
            L::IS_MULTISAMPLED,
        ]
    }
    assert_eq!(constants::<L>(), constants::<Same>(), "{}", type_name::<L>());
}

/// A look of a shading without cuts, passes and shortcuts, which counts.
pub type Careful<H> = Whole<OnePass<Unhurried<Counted<Fine<Deep<H>>>>>>;
