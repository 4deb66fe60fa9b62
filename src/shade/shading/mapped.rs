//! Attributes of which two are the texture coordinates of a vertex: the same numbers in every frame.
//!
//! A frame that cuts no face reads them from the skin of the model when a face begins, instead of keeping a copy of them for
//! each vertex. All else is that of the attributes without.

use core::{fmt::Debug, marker::PhantomData, num::Wrapping};

use crate::{
    clip::convex::CutAttributes,
    shade::{
        InstructionSet,
        shading::{
            attributes::{AttributeInstructions, Attributes, PlaneSource, Planes, Run},
            perspective::Perspective,
        },
    },
};

/// Attributes `A` whose first two are texture coordinates, and `T` the others.
#[derive(Debug, Copy, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Mapped<A, T>(pub A, PhantomData<T>);

impl<A, T> Mapped<A, T> {
    /// These attributes.
    #[inline(always)]
    pub(super) fn new(attributes: A) -> Self {
        Self(attributes, PhantomData)
    }

    fn inner([a, b, c]: [&Self; 3]) -> [&A; 3] {
        [&a.0, &b.0, &c.0]
    }
}

/// Some attributes, which follow the texture coordinates of a vertex in attributes `A`.
pub trait AfterCoordinates<A>: Copy + Debug {
    /// Zeros.
    const ZERO: Self;

    /// Those of these attributes.
    fn of(attributes: A) -> Self;

    /// These attributes after the texture coordinates of others.
    fn after_those_of(self, attributes: A) -> A;
}

impl<const STEP: i32> AfterCoordinates<Perspective<2, STEP>> for () {
    const ZERO: Self = ();

    #[inline(always)]
    fn of(_: Perspective<2, STEP>) -> Self {}

    #[inline(always)]
    fn after_those_of(self, attributes: Perspective<2, STEP>) -> Perspective<2, STEP> {
        attributes
    }
}

impl<const STEP: i32> AfterCoordinates<Perspective<3, STEP>> for [i16; 1] {
    const ZERO: Self = [0];

    #[inline(always)]
    fn of(Perspective([_, _, third]): Perspective<3, STEP>) -> Self {
        [third]
    }

    #[inline(always)]
    fn after_those_of(self, Perspective([u, v, _]): Perspective<3, STEP>) -> Perspective<3, STEP> {
        let [third] = self;
        Perspective([u, v, third])
    }
}

impl<A: Attributes, T: AfterCoordinates<A>> Attributes for Mapped<A, T> {
    const ZERO: Self = Self(A::ZERO, PhantomData);
}

impl<A: CutAttributes, T: Copy> CutAttributes for Mapped<A, T> {
    const NEED_DEPTH: bool = A::NEED_DEPTH;

    fn between(from: &Self, to: &Self, ways: [u64; 2], depths: [u64; 2]) -> Self {
        Self::new(A::between(&from.0, &to.0, ways, depths))
    }
}

impl<A: Planes, T: AfterCoordinates<A>> Planes for Mapped<A, T> {
    type Values = A::Values;
    type Planes = A::Planes;
    type Dividends = A::Dividends;
    type Tolerance = A::Tolerance;
    type Others = T;
    const EXACT: A::Tolerance = A::EXACT;
    const VARY: bool = A::VARY;
    const STEP: i32 = A::STEP;
    const NO_PLANES: A::Planes = A::NO_PLANES;
    const NO_OTHERS: T = T::ZERO;

    #[inline(always)]
    fn others(self) -> T {
        T::of(self.0)
    }

    #[inline(always)]
    fn with_others(others: T, all: &impl Fn() -> Self) -> Self {
        Self::new(others.after_those_of(all().0))
    }

    #[inline(always)]
    fn set_up(planes: &mut A::Planes, corners: [&Self; 3], face: &impl PlaneSource, tolerance: A::Tolerance) {
        A::set_up(planes, Self::inner(corners), face, tolerance);
    }

    #[inline]
    fn instructions(set: InstructionSet) -> AttributeInstructions {
        A::instructions(set)
    }

    #[inline]
    fn are_nearly_even(corners: [&Self; 3], depths: [u32; 3], tolerance: A::Tolerance) -> bool {
        A::are_nearly_even(Self::inner(corners), depths, tolerance)
    }

    #[inline(always)]
    fn are_even(planes: &A::Planes) -> bool {
        A::are_even(planes)
    }

    #[inline(always)]
    fn even_run(planes: &A::Planes, column: i32, end: i32, row: i32) -> Run<A::Values> {
        A::even_run(planes, column, end, row)
    }

    #[inline(always)]
    fn dividends(planes: &A::Planes, column: i32, row: i32) -> A::Dividends {
        A::dividends(planes, column, row)
    }

    #[inline(always)]
    fn divided(planes: &A::Planes, dividends: &A::Dividends, depth: Wrapping<u32>, at: [i32; 2]) -> A::Values {
        A::divided(planes, dividends, depth, at)
    }

    #[inline(always)]
    fn divided_run(
        planes: &A::Planes,
        dividends: &mut A::Dividends,
        values: &A::Values,
        columns: i32,
        depth: Wrapping<u32>,
    ) -> [A::Values; 2] {
        A::divided_run(planes, dividends, values, columns, depth)
    }

    #[inline(always)]
    fn step(values: &mut A::Values, per_column: &A::Values) {
        A::step(values, per_column);
    }

    #[inline(always)]
    fn step_by(values: &mut A::Values, per_column: &A::Values, columns: i32) {
        A::step_by(values, per_column, columns);
    }

    #[inline(always)]
    fn clamp(values: &mut A::Values, corners: [&Self; 3]) {
        A::clamp(values, Self::inner(corners));
    }
}
