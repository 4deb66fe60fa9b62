//! Fonts of the scenes, as zrow's converter wrote them: DejaVu Sans, whose licence (Bitstream Vera, changes in the public
//! domain) each module holds.

mod dejavu_sans_16;
mod dejavu_sans_24;

pub use dejavu_sans_16::DEJAVU_SANS_16;
pub use dejavu_sans_24::DEJAVU_SANS_24;
