//! A short list.

use arbitrary::{Arbitrary, Result, Unstructured};

/// Up to `MOST` values.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct List<T, const MOST: usize>(pub Vec<T>);

impl<'a, T: Arbitrary<'a>, const MOST: usize> Arbitrary<'a> for List<T, MOST> {
    fn arbitrary(bytes: &mut Unstructured<'a>) -> Result<Self> {
        let length = bytes.int_in_range(0..=MOST)?;
        (0..length)
            .map(|_| T::arbitrary(bytes))
            .collect::<Result<_>>()
            .map(Self)
    }
}
