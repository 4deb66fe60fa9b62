//! Fonts of the scenes, as zrow's converter wrote them: DejaVu Sans, whose licence (Bitstream Vera, changes in the public
//! domain) each module holds.

mod dejavu_sans_12;
mod dejavu_sans_16;
mod dejavu_sans_24;
mod dejavu_sans_bold_36;
mod dejavu_sans_outlines;

pub use dejavu_sans_12::DEJAVU_SANS_12;
pub use dejavu_sans_16::DEJAVU_SANS_16;
pub use dejavu_sans_24::DEJAVU_SANS_24;
pub use dejavu_sans_bold_36::DEJAVU_SANS_BOLD_36;
pub use dejavu_sans_outlines::DEJAVU_SANS_OUTLINES;
