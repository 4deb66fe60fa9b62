//! A fuzz target: an input that is decoded from bytes, and what has to hold for it.

use std::fmt::Debug;

use arbitrary::{Arbitrary, Unstructured};

/// What a target says of an input: nothing, or which property does not hold.
pub type Verdict = anyhow::Result<()>;

/// The input of a target, decoded from bytes.
pub trait Case: for<'a> Arbitrary<'a> + Debug {
    /// Checks the target's properties for this input.
    ///
    /// # Errors
    /// Says which property does not hold.
    fn check(&self) -> Verdict;
}

/// An entry of the [registry](crate::registry).
#[derive(Debug, Copy, Clone)]
pub struct Target {
    /// The module of zrow that is called first, and what of it: `draw.circle`.
    pub name: &'static str,
    /// The public modules of zrow whose functions the target reaches, directly or through a shape, and the families of
    /// algorithms that it calls: `scan`, `scan::Lines`.
    pub modules: &'static [&'static str],
    check: fn(&mut Unstructured<'_>) -> Verdict,
    show: fn(&mut Unstructured<'_>) -> String,
}

impl Target {
    /// The target whose inputs are `C`.
    pub const fn new<C: Case>(name: &'static str, modules: &'static [&'static str]) -> Self {
        Self {
            name,
            modules,
            check: check::<C>,
            show: show::<C>,
        }
    }

    /// Checks the input that these bytes stand for. Bytes that stand for none are right.
    ///
    /// # Errors
    /// Says which property does not hold.
    pub fn check(&self, bytes: &[u8]) -> Verdict {
        (self.check)(&mut Unstructured::new(bytes))
    }

    /// The input that these bytes stand for, in words.
    pub fn show(&self, bytes: &[u8]) -> String {
        (self.show)(&mut Unstructured::new(bytes))
    }
}

fn check<C: Case>(bytes: &mut Unstructured<'_>) -> Verdict {
    match C::arbitrary(bytes) {
        Ok(case) => case.check(),
        Err(_) => Ok(()),
    }
}

fn show<C: Case>(bytes: &mut Unstructured<'_>) -> String {
    match C::arbitrary(bytes) {
        Ok(case) => format!("{case:?}"),
        Err(error) => format!("no input: {error}"),
    }
}
