//! The words of an item, as they are written and read.

use crate::surface::PixelWord;

/// Where an item writes its words. What finds no room is counted.
#[derive(Debug)]
pub struct Payload<'m> {
    room: &'m mut [u32],
    needed: usize,
    /// How many segments of antialiased edges there is memory for in a row.
    segments: usize,
}

impl<'m> Payload<'m> {
    /// A payload that writes into these words, for a picture that has memory for so many segments in a row.
    pub(crate) const fn new(room: &'m mut [u32], segments: usize) -> Self {
        Self {
            room,
            needed: 0,
            segments,
        }
    }
}

impl Payload<'_> {
    /// A payload without room, to count words.
    pub(crate) fn counting(segments: usize) -> Self {
        Self::new(&mut [], segments)
    }

    /// How many segments of antialiased edges there is memory for in a row: an outline that could have more counts them.
    pub(crate) const fn segments(&self) -> usize {
        self.segments
    }

    /// How many words were written or found no room.
    pub(crate) const fn needed(&self) -> usize {
        self.needed
    }

    /// Whether every word found room.
    pub(crate) const fn is_complete(&self) -> bool {
        self.needed <= self.room.len()
    }

    /// The word at an index; 0 where it found no room.
    #[inline]
    pub(crate) fn get(&self, index: usize) -> u32 {
        self.room.get(index).copied().unwrap_or(0)
    }

    /// Writes a word again that was written before, where it found room.
    pub(crate) fn set(&mut self, index: usize, word: u32) {
        if let Some(written) = self.room.get_mut(index) {
            *written = word;
        }
    }

    /// Takes back all words from an index on.
    pub(crate) const fn truncate(&mut self, index: usize) {
        self.needed = index;
    }

    /// The words from an index on that found room.
    pub(crate) fn written_from(&self, index: usize) -> &[u32] {
        let end = self.needed.min(self.room.len());
        self.room.get(index..end).unwrap_or_default()
    }

    /// The words from an index on that found room, to be changed.
    pub(crate) fn written_from_mut(&mut self, index: usize) -> &mut [u32] {
        let end = self.needed.min(self.room.len());
        self.room.get_mut(index..end).unwrap_or_default()
    }

    #[inline]
    pub(crate) fn push(&mut self, word: u32) {
        if let Some(free) = self.room.get_mut(self.needed) {
            *free = word;
        }
        self.needed += 1;
    }

    pub(crate) fn push_all(&mut self, words: &[u32]) {
        for word in words {
            self.push(*word);
        }
    }

    /// A coordinate.
    pub(crate) fn push_signed(&mut self, number: i32) {
        self.push(number as u32);
    }

    /// A colour's word.
    pub(crate) fn push_pixel<W: PixelWord>(&mut self, word: W) {
        self.push(word.repeated());
    }

    /// A colour's word, or that there is none.
    pub(crate) fn push_optional_pixel<W: PixelWord>(&mut self, word: Option<W>) {
        self.push(word.is_some().into());
        self.push_pixel(word.unwrap_or(W::ZERO));
    }
}

#[cfg(feature = "defmt")]
impl defmt::Format for Payload<'_> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "Payload of {} words", self.needed());
    }
}

/// Reads what a [`Payload`] was given, in the same order.
#[derive(Debug)]
pub(crate) struct Reader<'w> {
    words: &'w [u32],
}

impl<'w> Reader<'w> {
    pub(crate) const fn new(words: &'w [u32]) -> Self {
        Self { words }
    }

    /// The next word; 0 behind the last one.
    #[inline]
    pub(crate) fn next(&mut self) -> u32 {
        let Some((first, rest)) = self.words.split_first() else {
            return 0;
        };
        self.words = rest;
        *first
    }

    pub(crate) fn next_signed(&mut self) -> i32 {
        self.next() as i32
    }

    pub(crate) fn next_pixel<W: PixelWord>(&mut self) -> W {
        W::from_repeated(self.next())
    }

    pub(crate) fn next_optional_pixel<W: PixelWord>(&mut self) -> Option<W> {
        let is_some = self.next() != 0;
        let word = self.next_pixel();
        is_some.then_some(word)
    }

    /// The words that were not read.
    pub(crate) const fn rest(self) -> &'w [u32] {
        self.words
    }
}
