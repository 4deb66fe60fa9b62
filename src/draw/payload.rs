//! The pool: one slice of words for all that the items of a picture have beyond their slots.

use crate::surface::PixelWord;

/// The words of all items, one item after the other, without gaps.
#[derive(Debug)]
pub struct Pool<'m> {
    words: &'m mut [u32],
    used: usize,
}

impl<'m> Pool<'m> {
    pub(crate) const fn new(words: &'m mut [u32]) -> Self {
        Self { words, used: 0 }
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
    #[inline(always)]
    pub(crate) fn array<const N: usize>(&mut self, at: u16) -> Option<&mut [u32; N]> {
        self.words.get_mut(usize::from(at)..)?.first_chunk_mut()
    }

    /// The words of an item.
    #[inline(always)]
    pub(crate) fn slice(&self, at: u16, words: u16) -> &[u32] {
        let at = usize::from(at);
        self.words.get(at..at + usize::from(words)).unwrap_or_default()
    }

    /// Writes words behind the last one, and takes them. Or says how many the pool would have to have, and takes none.
    pub(crate) fn append<R>(&mut self, write: impl FnOnce(&mut Payload<'_>) -> R) -> Result<(u16, u16, R), usize> {
        let mut payload = Payload {
            room: self.words.get_mut(self.used..).unwrap_or_default(),
            needed: 0,
        };
        let written = write(&mut payload);
        let end = self.used + payload.needed;
        match (u16::try_from(self.used), u16::try_from(payload.needed)) {
            (Ok(at), Ok(words)) if end <= self.words.len() => {
                self.used = end;
                Ok((at, words, written))
            }
            _ => Err(end),
        }
    }

    /// Writes the words of an item again, as many as before.
    pub(crate) fn rewrite<R>(&mut self, at: u16, words: u16, write: impl FnOnce(&mut Payload<'_>) -> R) -> R {
        let at = usize::from(at);
        write(&mut Payload {
            room: self.words.get_mut(at..at + usize::from(words)).unwrap_or_default(),
            needed: 0,
        })
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

/// Where an item writes its words. What finds no room is counted.
#[derive(Debug)]
pub struct Payload<'m> {
    room: &'m mut [u32],
    needed: usize,
}

impl Payload<'_> {
    /// A payload without room, to count words.
    pub(crate) fn counting() -> Self {
        Self {
            room: &mut [],
            needed: 0,
        }
    }

    /// How many words were written or found no room.
    pub(crate) const fn needed(&self) -> usize {
        self.needed
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
