//! Pictures that faces are covered with: what a texel is, how textures go on beyond their edges, and how a pixel is made of
//! texels.
//!
//! A [`Texture`] is a kind of picture: [`Texels`] of a display's own words, or [`Indexed`] colours of a palette, whose first
//! one may be a hole ([`CutOut`]). Textures repeat, or end in the texels at their edges ([`Clamped`]). A [`Sampler`] makes a
//! pixel of texels: every texture is the plainest one, which takes the nearest texel; [`Bilinear`] mixes four.

mod bilinear;
mod clamped;
mod cut_out;
mod indexed;
mod texels;

pub use bilinear::Bilinear;
pub use clamped::Clamped;
pub use cut_out::CutOut;
pub use indexed::{Indexed, IndexedImage};
pub use texels::Texels;

use crate::{shade::InstructionSet, surface::BandColor};

/// A picture of a sampler's texture.
pub(super) type ImageOf<'a, T> = <<T as Sampler>::Texture as Texture>::Image<'a>;

/// A word of a texture's pictures.
type WordOf<T> = <<T as Texture>::Color as BandColor>::Word;

/// A kind of picture to cover faces with: [`Texels`], [`Indexed`], [`CutOut`], [`Clamped`], or one of the program's own.
///
/// Width and height are powers of two and at most 4,096: 1 << `COLUMN_BITS`, 1 << `ROW_BITS`.
pub trait Texture: 'static {
    /// The colour of the display that the pictures are for.
    type Color: BandColor;
    /// A picture.
    type Image<'a>: Copy;
    /// How many bits the number of a column has.
    const COLUMN_BITS: u32;
    /// How many bits the number of a row has.
    const ROW_BITS: u32;
    /// Whether the texture repeats beyond its edges, as [`column`](Self::column) and [`row`](Self::row) say. One that says
    /// something else in these says `false` here, so that no coordinates wrap from one end of their range to the other one.
    const REPEATS: bool = true;
    /// Whether there may be texels that are holes. Textures without any are drawn faster.
    const HAS_HOLES: bool = true;

    /// The word of a texel, in the machine's byte order; `None` for a hole. Columns and rows are counted from the upper left
    /// texel, modulo width and height. Called at least once a pixel.
    fn texel(image: &Self::Image<'_>, column: u32, row: u32) -> Option<WordOf<Self>>;

    /// How many instructions of a set [`texel`](Self::texel) takes, for
    /// [`Prepared::estimate`](crate::scene::Prepared::estimate).
    #[inline]
    fn instructions(set: InstructionSet) -> u32 {
        set.of([10, 6])
    }

    /// The column of the texture that a column of the plane shows, which the texture covers by repetition if this says nothing
    /// else.
    #[inline(always)]
    fn column(column: i32) -> u32 {
        column as u32 & ((1 << Self::COLUMN_BITS) - 1)
    }

    /// The row of the texture that a row of the plane shows, which the texture covers by repetition if this says nothing else.
    #[inline(always)]
    fn row(row: i32) -> u32 {
        row as u32 & ((1 << Self::ROW_BITS) - 1)
    }
}

/// How a pixel is made of the texels of a texture: every [`Texture`] takes the nearest one, [`Bilinear`] mixes four.
pub trait Sampler: 'static {
    /// The texture.
    type Texture: Texture;
    /// Whether there may be coordinates at which [`sample`](Self::sample) is `None`. Where there are none, faces are drawn
    /// faster.
    const HAS_HOLES: bool = true;

    /// The word at texture coordinates in 1/4,096 of the texture with 16 fractional bits, u to the right, v down; `None` for a
    /// hole.
    fn sample(image: &<Self::Texture as Texture>::Image<'_>, coordinates: [i32; 2]) -> Option<WordOf<Self::Texture>>;

    /// How many instructions of a set [`sample`](Self::sample) takes, for
    /// [`Prepared::estimate`](crate::scene::Prepared::estimate). If this says nothing else, it takes one texel.
    #[inline]
    fn instructions(set: InstructionSet) -> u32 {
        <Self::Texture as Texture>::instructions(set).saturating_add(set.of([18, 9]))
    }
}

impl<T: Texture> Sampler for T {
    type Texture = T;
    const HAS_HOLES: bool = T::HAS_HOLES;

    #[inline(always)]
    fn sample(image: &T::Image<'_>, [u, v]: [i32; 2]) -> Option<WordOf<T>> {
        let column = u >> (COORDINATE_BITS - T::COLUMN_BITS);
        let row = v >> (COORDINATE_BITS - T::ROW_BITS);
        T::texel(image, T::column(column), T::row(row))
    }
}

/// Fractional bits of texture coordinates at a pixel, as parts of the whole texture: 1/4,096 with 16 more bits.
const COORDINATE_BITS: u32 = 28;

/// How far texture coordinates may be off, in 1/4,096 of a texture: 3/8 texel.
pub(super) const fn tolerance<T: Texture>() -> u16 {
    assert!(
        T::COLUMN_BITS <= 12 && T::ROW_BITS <= 12,
        "a texture has at most 4,096 columns and rows"
    );
    let bits = if T::COLUMN_BITS > T::ROW_BITS {
        T::COLUMN_BITS
    } else {
        T::ROW_BITS
    };
    (4096 * 3 / 8) >> bits
}

/// The number of bits of a width or height, which must be a power of two.
const fn bits_of(size: usize) -> u32 {
    assert!(
        size.is_power_of_two(),
        "width and height of a texture must be powers of two"
    );
    size.ilog2()
}
