//! The places of a monospaced font's glyphs in the one image that holds them all, by character.
//!
//! A font maps characters to glyphs by embedded-graphics' `GlyphMapping`. Those of its own fonts go through all characters before
//! the wanted one: some 400 instructions for a letter. The mappings of ASCII and of Latin-1, which most programs use, are
//! recognized once for a text, by their addresses and those of their functions, and answered by a subtraction.

use core::ptr;

use embedded_graphics::{
    geometry::{OriginDimensions, Size},
    mono_font::{
        MonoFont,
        mapping::{ASCII, GlyphMapping, ISO_8859_1},
    },
};

/// The characters that a font is known to have, and so the numbers of their glyphs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Mapping {
    /// The font's mapping is embedded-graphics' `mapping::ASCII`.
    Ascii,
    /// The font's mapping is embedded-graphics' `mapping::ISO_8859_1`, which is Latin-1.
    Latin1,
    /// The font has another mapping, or one that was not recognized: it is asked for each character.
    Other,
}

impl Mapping {
    /// A mapping is known to be one of embedded-graphics' if it is where that one is, and has the same functions. It is asked
    /// where the linker kept several copies of either.
    fn of(mapping: &dyn GlyphMapping) -> Self {
        let known: [(&dyn GlyphMapping, _); 2] = [(&ASCII, Self::Ascii), (&ISO_8859_1, Self::Latin1)];
        let found = known.into_iter().find(|&(known, _)| ptr::eq(mapping, known));
        found.map_or(Self::Other, |(_, mapping)| mapping)
    }
}

/// A monospaced font whose glyphs are looked up, one character after another.
pub(in crate::draw) struct FontGlyphs<'f> {
    font: &'f MonoFont<'f>,
    /// Glyphs in a row of the image; 0 where a glyph has no columns, or is wider than the image.
    glyphs_per_row: u32,
    mapping: Mapping,
}

impl<'f> FontGlyphs<'f> {
    /// Looks once for what all glyphs of a font share: its mapping, and the glyphs in a row of its image. Cost: a division.
    pub(in crate::draw) fn of(font: &'f MonoFont<'f>) -> Self {
        let size = font.character_size;
        Self {
            font,
            glyphs_per_row: font.image.size().width.checked_div(size.width).unwrap_or(0),
            mapping: Mapping::of(font.glyph_mapping),
        }
    }

    /// The index of the bit for the first pixel of a character's glyph, in the font's image with its rows padded to
    /// whole bytes. `None` where the image does not have the glyph, or the index is 2^31 or more.
    pub(in crate::draw) fn bit_of(&self, character: char) -> Option<u32> {
        let (column, row) = self.cell(character)?;
        let bit = (row as u32).checked_mul(self.font.image.size().width.checked_next_multiple_of(8)?)?;
        bit.checked_add(column as u32).filter(|bit| bit >> 31 == 0)
    }

    /// The column and the row of the first pixel of a character's glyph in the font's image; `None` where the glyph
    /// does not lie in the image.
    pub(super) fn cell(&self, character: char) -> Option<(usize, usize)> {
        let Size { width, height } = self.font.character_size;
        let index = self.index(character);
        let line = index.checked_div(self.glyphs_per_row)?;
        let column = (index - line * self.glyphs_per_row) * width;
        let row = line.checked_mul(height)?;
        let is_inside = height > 0 && row.checked_add(height)? <= self.font.image.size().height;
        is_inside.then_some((column as usize, row as usize))
    }

    /// The index of a character's glyph, or of the one that stands for characters that the font does not have.
    fn index(&self, character: char) -> u32 {
        let code = u32::from(character);
        match (self.mapping, code) {
            (Mapping::Other, _) => self.font.glyph_mapping.index(character) as u32,
            (_, 0x20..=0x7f) => code - 0x20,
            // Behind the 96 characters of ASCII.
            (Mapping::Latin1, 0xa0..=0xff) => code - 0xa0 + 96,
            _ => u32::from('?') - 0x20,
        }
    }
}

#[cfg(test)]
mod tests {
    use embedded_graphics::mono_font::{ascii::FONT_6X10, mapping};

    use super::*;

    #[test]
    fn known_mappings_are_those_of_embedded_graphics() {
        for (mapping, known) in [(Mapping::Ascii, ASCII), (Mapping::Latin1, ISO_8859_1)] {
            let glyphs = FontGlyphs {
                mapping,
                ..FontGlyphs::of(&FONT_6X10)
            };
            for character in ('\0'..='\u{2000}').chain([char::MAX]) {
                assert_eq!(glyphs.index(character), known.index(character) as u32, "{character:?}");
            }
        }
    }

    #[test]
    fn other_mappings_are_asked() {
        let reversed = |character: char| 0x7f_usize.saturating_sub(character as usize);
        let font = MonoFont {
            glyph_mapping: &reversed,
            ..FONT_6X10
        };
        let glyphs = FontGlyphs::of(&font);
        assert_eq!((glyphs.mapping, glyphs.index('A')), (Mapping::Other, 0x3e));
        for mapping in mapping::Mapping::iter() {
            let of_glyphs = Mapping::of(mapping.glyph_mapping());
            let is_right = match mapping {
                mapping::Mapping::Ascii => of_glyphs != Mapping::Latin1,
                mapping::Mapping::Iso8859_1 => of_glyphs != Mapping::Ascii,
                _ => of_glyphs == Mapping::Other,
            };
            assert!(is_right, "{mapping:?} is taken for {of_glyphs:?}");
        }
    }
}
