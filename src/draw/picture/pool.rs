//! The pool: one slice of words for all that the items of a picture have beyond their slots.

use crate::draw::{outline::RowMemory, payload::Payload};

/// Two numbers of 16 bits in a word.
pub(super) const fn packed(low: i32, high: i32) -> u32 {
    (low as u32 & 0xffff) | (high as u32) << 16
}

/// Where the words of an item begin, and how many they are, as a slot has them: `None` where 16 bits do not tell it. An item
/// without words has no beginning, and can be told however many words others take.
pub(super) fn position_of(at: usize, words: usize) -> Option<(u16, u16)> {
    if words == 0 {
        return Some((0, 0));
    }
    Some((u16::try_from(at).ok()?, u16::try_from(words).ok()?))
}

/// The words of all items, one item after the other, without gaps.
#[derive(Debug)]
pub struct Pool<'m> {
    words: &'m mut [u32],
    used: usize,
    /// What antialiased items share while they are drawn.
    memory: RowMemory<'m>,
}

impl<'m> Pool<'m> {
    pub(crate) const fn new(words: &'m mut [u32]) -> Self {
        Self {
            words,
            used: 0,
            memory: RowMemory::none(),
        }
    }

    /// Lends the memory of antialiasing.
    pub(crate) fn set_memory(&mut self, memory: RowMemory<'m>) {
        self.memory = memory;
    }

    /// The memory of antialiasing.
    pub(crate) const fn memory(&mut self) -> &mut RowMemory<'m> {
        &mut self.memory
    }

    /// The memory of antialiasing, to be asked.
    pub(crate) const fn memory_ref(&self) -> &RowMemory<'m> {
        &self.memory
    }

    /// The words from one on, and the memory of antialiasing.
    #[inline]
    pub(crate) fn words_and_memory(&mut self, at: impl Into<usize>) -> (&[u32], &mut RowMemory<'m>) {
        let words = self.words.get(at.into()..).unwrap_or_default();
        (words, &mut self.memory)
    }

    /// How many words are taken.
    pub(crate) const fn used(&self) -> usize {
        self.used
    }

    /// Takes all words back.
    pub(crate) const fn clear(&mut self) {
        self.used = 0;
    }

    /// The words of an item from one on, so many of them.
    #[inline]
    pub(crate) fn array<const N: usize>(&mut self, at: u16) -> Option<&mut [u32; N]> {
        self.array_at(at.into())
    }

    /// As many words from an index on, which may lie behind those at which items begin.
    #[inline]
    pub(crate) fn array_at<const N: usize>(&mut self, index: usize) -> Option<&mut [u32; N]> {
        self.words.get_mut(index..)?.first_chunk_mut()
    }

    /// The words of an item.
    #[inline]
    pub(crate) fn slice(&self, at: u16, words: u16) -> &[u32] {
        let at = usize::from(at);
        self.words.get(at..at + usize::from(words)).unwrap_or_default()
    }

    /// The words of an item, to be changed.
    pub(crate) fn slice_mut(&mut self, at: u16, words: u16) -> &mut [u32] {
        let at = usize::from(at);
        self.words.get_mut(at..at + usize::from(words)).unwrap_or_default()
    }

    /// Writes words behind the last one, and takes them; returns where they begin and how many they are, (0, 0) where there are none.
    /// Or says how many the pool would have to have, and takes none.
    pub(crate) fn append<R>(&mut self, write: impl FnOnce(&mut Payload<'_>) -> R) -> Result<(u16, u16, R), usize> {
        let segments = self.memory.most_segments();
        let mut payload = Payload::new(self.words.get_mut(self.used..).unwrap_or_default(), segments);
        let written = write(&mut payload);
        let end = self.used + payload.needed();
        match position_of(self.used, payload.needed()) {
            Some((at, words)) if end <= self.words.len() => {
                self.used = end;
                Ok((at, words, written))
            }
            _ => Err(end),
        }
    }

    /// Gives the words back that were appended last, which are so many.
    pub(crate) const fn undo(&mut self, words: u16) {
        self.used = self.used.saturating_sub(words as usize);
    }

    /// Moves the words that were appended last in the place of as many words of an item.
    pub(crate) fn move_last(&mut self, to: u16, words: u16) {
        let (last, to) = (self.used.saturating_sub(words.into()), usize::from(to));
        for index in 0..usize::from(words) {
            let word = self.words.get(last + index).copied().unwrap_or(0);
            if let Some(room) = self.words.get_mut(to + index) {
                *room = word;
            }
        }
        self.used = last;
    }

    /// Writes the words of an item again, as many as before.
    pub(crate) fn rewrite<R>(&mut self, at: u16, words: u16, write: impl FnOnce(&mut Payload<'_>) -> R) -> R {
        let at = usize::from(at);
        write(&mut Payload::new(
            self.words.get_mut(at..at + usize::from(words)).unwrap_or_default(),
            // They were counted before.
            usize::MAX,
        ))
    }

    /// Gives the words of an item back: those behind them move up.
    pub(crate) fn remove(&mut self, at: u16, words: u16) {
        let (at, words) = (usize::from(at), usize::from(words));
        if let Some(rest) = self.words.get_mut(at..self.used) {
            rest.rotate_left(words.min(rest.len()));
            self.used = self.used.saturating_sub(words);
        }
    }

    /// How many words there are.
    pub(crate) const fn len(&self) -> usize {
        self.words.len()
    }
}

#[cfg(feature = "defmt")]
impl defmt::Format for Pool<'_> {
    fn format(&self, formatter: defmt::Formatter<'_>) {
        defmt::write!(formatter, "Pool of {} words, {} taken", self.len(), self.used());
    }
}
