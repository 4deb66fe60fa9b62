//! The tables of a font in which characters and pairs of glyphs are found, by binary search.

/// The index of a character's glyph, in ranges of characters that follow each other and have glyphs that follow each other: the
/// first character, how many there are, and the index of the first one's glyph, in ascending order.
pub(super) fn index_in_ranges(ranges: &[(char, u16, u16)], character: char) -> Option<u16> {
    let behind = ranges.partition_point(|&(first, ..)| first <= character);
    let &(first, count, glyph) = ranges.get(behind.checked_sub(1)?)?;
    let offset = u32::from(character).checked_sub(first.into())?;
    if offset >= u32::from(count) {
        return None;
    }
    glyph.checked_add(offset as u16)
}

/// What is added to the advance of a glyph before another one, in pairs that are sorted by the left and then by the right
/// glyph; 0 for a pair that is not among them.
pub(super) fn kerning_between(pairs: &[(u16, u16, i16)], left: u16, right: u16) -> i32 {
    let found = pairs.binary_search_by_key(&(left, right), |&(left, right, _)| (left, right));
    let pair = found.ok().and_then(|index| pairs.get(index));
    pair.map_or(0, |&(.., adjustment)| adjustment.into())
}
