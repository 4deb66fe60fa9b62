//! What is kept of the attributes of each vertex, from preparing a frame to drawing it: all of them, or those that are not
//! texture coordinates. These do not change from frame to frame, so that a face of which nothing is cut away can read them from
//! the skin of its model when its first row comes.

use core::{borrow::Borrow, fmt::Debug};

use crate::shade::Attributes;

// Not re-exported: what is kept is said by a wrapper of the look.
/// What a look keeps of the attributes of a vertex: all of them (`()`), or all [but texture coordinates](ButCoordinates).
pub trait StoredAttributes: Debug + 'static {
    /// Whether all attributes are kept, as the vertices of cut faces need them.
    const ARE_ALL: bool;
    /// What is kept of a vertex with attributes of a kind.
    type Of<A: Attributes>: Stored<A>;
}

// Not re-exported.
/// What is kept of a vertex with attributes.
pub trait Stored<A>: Copy + Debug {
    /// What is kept of attributes that are all zero.
    const ZERO: Self;
    /// All attributes of the vertex: where they are kept, or put together.
    type Attributes<'s>: Copy + Borrow<A>
    where
        Self: 's;

    /// What is kept of these attributes.
    fn new(attributes: A) -> Self;

    /// All attributes of the vertex, of which the texture coordinates are those of `all` where they are not kept.
    fn attributes(&self, all: impl Fn() -> A) -> Self::Attributes<'_>;
}

impl StoredAttributes for () {
    const ARE_ALL: bool = true;
    type Of<A: Attributes> = All<A>;
}

/// All attributes of a vertex.
#[derive(Debug, Copy, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct All<A>(A);

impl<A: Attributes> Stored<A> for All<A> {
    const ZERO: Self = Self(A::ZERO);
    type Attributes<'s>
        = &'s A
    where
        Self: 's;

    #[inline(always)]
    fn new(attributes: A) -> Self {
        Self(attributes)
    }

    #[inline(always)]
    fn attributes(&self, _: impl Fn() -> A) -> &A {
        &self.0
    }
}

/// All attributes are kept but texture coordinates, which the skin of a model has.
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ButCoordinates;

impl StoredAttributes for ButCoordinates {
    const ARE_ALL: bool = false;
    type Of<A: Attributes> = Others<A::Others>;
}

/// The attributes of a vertex that are no texture coordinates.
#[derive(Debug, Copy, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Others<T>(T);

impl<A: Attributes> Stored<A> for Others<A::Others> {
    const ZERO: Self = Self(A::NO_OTHERS);
    type Attributes<'s>
        = A
    where
        Self: 's;

    #[inline(always)]
    fn new(attributes: A) -> Self {
        Self(attributes.others())
    }

    #[inline(always)]
    fn attributes(&self, all: impl Fn() -> A) -> A {
        A::with_others(self.0, &all)
    }
}
