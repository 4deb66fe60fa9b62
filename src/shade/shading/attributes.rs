//! What varies over a face: numbers of its vertices, and their planes on the screen.

use core::{
    fmt::Debug,
    num::{NonZeroU64, Wrapping},
};

use crate::{
    clip::convex::CutAttributes,
    geometry::{ScreenPlane, quotient_nearest},
    shade::InstructionSet,
};

/// What a vertex has beside its position, which varies over faces: nothing (`()`), some 16-bit numbers (`[i16; N]`), which vary
/// evenly on the screen, numbers that vary evenly in space ([`Perspective`](crate::shade::Perspective)), or a pair of these.
/// A pair is divided by the depth as often as that of both which is divided more often.
///
/// Memory: 2 bytes a number for each vertex (none for the texture coordinates of the library's shadings, where no face is cut),
/// and 12 for each active face.
pub trait Attributes: Copy + Debug + Planes {
    /// No attributes, or zeros.
    const ZERO: Self;
}

// Not re-exported: what a face keeps of its attributes is the library's own.
/// How attributes are interpolated over a face.
pub trait Planes: CutAttributes {
    /// The attributes at a pixel, each with 16 fractional bits; half a unit is added to those that vary evenly on the screen,
    /// so that their upper 16 bits are the nearest whole number.
    type Values: Copy + Debug;
    /// What an active face keeps of the attributes of its corners.
    type Planes: Copy + Debug;
    /// The numbers at a pixel of a face that is not [even](Self::are_even) that are divided by its depth there.
    type Dividends: Copy + Debug;
    /// How far attributes that vary evenly in space may be off, in units of each.
    type Tolerance: Copy;
    /// The attributes of a vertex without the texture coordinates that its skin has.
    type Others: Copy + Debug;
    /// No tolerance.
    const EXACT: Self::Tolerance;
    /// Whether there are any attributes.
    const VARY: bool;
    /// Attributes of faces that are not [even](Self::are_even) are divided at each column of the picture that is a multiple of
    /// this, a power of two up to 16.
    const STEP: i32;
    /// The planes of a slot that has no face.
    const NO_PLANES: Self::Planes;
    /// Zeros.
    const NO_OTHERS: Self::Others;

    /// The attributes without texture coordinates.
    fn others(self) -> Self::Others;

    /// The attributes of a vertex whose texture coordinates are those of `all`, and whose others are these.
    fn with_others(others: Self::Others, all: &impl Fn() -> Self) -> Self;

    /// Sets the planes of a face up in the slot that keeps them; returned they would be copied. Attributes that vary evenly in
    /// space may be wrong by `tolerance` units.
    fn set_up(planes: &mut Self::Planes, corners: [&Self; 3], face: &impl PlaneSource, tolerance: Self::Tolerance);

    /// How many instructions of a set attributes take.
    fn instructions(set: InstructionSet) -> AttributeInstructions;

    /// Whether attributes of the corners of a face that is seen in perspective step evenly along its spans: the depths of the
    /// corners are 32-bit fractions.
    #[inline]
    fn are_nearly_even(_corners: [&Self; 3], _depths: [u32; 3], _tolerance: Self::Tolerance) -> bool {
        true
    }

    /// Whether the attributes step evenly along whole spans of the face.
    fn are_even(planes: &Self::Planes) -> bool;

    /// The attributes of a face that are [even](Self::are_even) from a column of a row on, up to the end of the span.
    fn even_run(planes: &Self::Planes, column: i32, end: i32, row: i32) -> Run<Self::Values>;

    /// The dividends of a face that is not even, at a column of a row.
    fn dividends(planes: &Self::Planes, column: i32, row: i32) -> Self::Dividends;

    /// The attributes of a face that is not even, at the pixel of a column and a row that has these dividends and this depth.
    fn divided(planes: &Self::Planes, dividends: &Self::Dividends, depth: Wrapping<u32>, at: [i32; 2]) -> Self::Values;

    /// What attributes gain from pixel to pixel of a run of up to 16 columns, and what they are at its end, where `depth` is
    /// the face's depth, from those at its start. Takes the dividends from the start to the end.
    fn divided_run(
        planes: &Self::Planes,
        dividends: &mut Self::Dividends,
        values: &Self::Values,
        columns: i32,
        depth: Wrapping<u32>,
    ) -> [Self::Values; 2];

    /// Takes attributes to the next pixel of a run.
    fn step(values: &mut Self::Values, per_column: &Self::Values);

    /// Takes attributes over so many pixels of a run.
    fn step_by(values: &mut Self::Values, per_column: &Self::Values, columns: i32);

    /// Limits attributes to those of the corners of a face, for pixels beside it.
    fn clamp(values: &mut Self::Values, corners: [&Self; 3]);
}

/// How many instructions attributes take beside those that a face without takes.
#[derive(Debug, Copy, Clone, Default)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct AttributeInstructions {
    /// Of a face, whose planes are set up.
    pub face: u32,
    /// Of a row of a face.
    pub span: u32,
    /// Of a pixel.
    pub pixel: u32,
    /// What a face takes beside that where attributes are divided by the depth: the face, a row and a pixel of it.
    pub divided: [u32; 3],
}

/// Attributes along some pixels of a row, which step evenly.
#[derive(Debug, Copy, Clone)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Run<V> {
    /// The attributes at the first pixel.
    pub values: V,
    /// What they gain from pixel to pixel.
    pub per_column: V,
    /// The column after the last one.
    pub end: i32,
}

/// A face whose attributes are set up: the planes through its corners.
pub trait PlaneSource {
    /// The plane through three numbers below 2^15 in size, one a corner, with 16 fractional bits.
    fn plane(&self, corners: [i32; 3]) -> ScreenPlane;

    /// The depths of the corners, as 32-bit fractions.
    fn depths(&self) -> [u32; 3];
}

impl Attributes for () {
    const ZERO: Self = ();
}

impl CutAttributes for () {
    const NEED_DEPTH: bool = false;

    #[inline]
    fn between((): &(), (): &(), _: [u64; 2], _: [u64; 2]) {}
}

impl Planes for () {
    type Values = ();
    type Planes = ();
    type Dividends = ();
    type Tolerance = ();
    type Others = ();
    const EXACT: () = ();
    const VARY: bool = false;
    const STEP: i32 = 16;
    const NO_PLANES: () = ();
    const NO_OTHERS: () = ();

    #[inline]
    fn others(self) {}

    #[inline]
    fn with_others((): (), _: &impl Fn()) {}

    #[inline]
    fn instructions(_: InstructionSet) -> AttributeInstructions {
        AttributeInstructions::default()
    }

    #[inline]
    fn set_up((): &mut (), _: [&(); 3], _: &impl PlaneSource, (): ()) {}

    #[inline]
    fn are_even((): &()) -> bool {
        true
    }

    #[inline]
    fn even_run((): &(), _: i32, end: i32, _: i32) -> Run<()> {
        Run {
            values: (),
            per_column: (),
            end,
        }
    }

    #[inline]
    fn dividends((): &(), _: i32, _: i32) {}

    #[inline]
    fn divided((): &(), (): &(), _: Wrapping<u32>, _: [i32; 2]) {}

    #[inline]
    fn divided_run((): &(), (): &mut (), (): &(), _: i32, _: Wrapping<u32>) -> [(); 2] {
        [(), ()]
    }

    #[inline]
    fn step((): &mut (), (): &()) {}

    #[inline]
    fn step_by((): &mut (), (): &(), _: i32) {}

    #[inline]
    fn clamp((): &mut (), _: [&(); 3]) {}
}

impl<const N: usize> Attributes for [i16; N] {
    const ZERO: Self = [0; N];
}

impl<const N: usize> CutAttributes for [i16; N] {
    const NEED_DEPTH: bool = false;

    #[inline(never)]
    fn between(from: &Self, to: &Self, [part, rest]: [u64; 2], _: [u64; 2]) -> Self {
        // The ends are on two sides of a plane, and a depth is not 0.
        let Some(whole) = NonZeroU64::new(part + rest) else {
            return *from;
        };
        // So that a product with a change, which is below 2^16, fits 64 bits; what is cut off changes no attribute by 2^-29.
        let shift = 18u32.saturating_sub(whole.leading_zeros());
        let (part, whole) = (part >> shift, whole.get() >> shift);
        let mut cut = *from;
        for (from, to) in cut.iter_mut().zip(to) {
            let change = (i64::from(*to) - i64::from(*from)) * part as i64;
            let rounded = NonZeroU64::new(whole).map_or(0, |whole| quotient_nearest(change, whole));
            *from = (i64::from(*from) + rounded) as i16;
        }
        cut
    }
}

impl<const N: usize> Planes for [i16; N] {
    type Values = [i32; N];
    type Planes = [ScreenPlane; N];
    type Dividends = ();
    type Tolerance = u16;
    type Others = Self;
    const EXACT: u16 = 0;
    const VARY: bool = true;
    const STEP: i32 = 16;
    const NO_PLANES: [ScreenPlane; N] = [ScreenPlane::ZERO; N];
    const NO_OTHERS: Self = [0; N];

    #[inline]
    fn others(self) -> Self {
        self
    }

    #[inline]
    fn with_others(others: Self, _: &impl Fn() -> Self) -> Self {
        others
    }

    #[inline]
    fn instructions(set: InstructionSet) -> AttributeInstructions {
        let number = N as u32;
        AttributeInstructions {
            face: number * set.of([207, 82]),
            span: number * set.of([3, 8]),
            pixel: number * set.of([4, 2]),
            divided: [0; 3],
        }
    }

    #[inline]
    fn set_up(planes: &mut [ScreenPlane; N], [a, b, c]: [&Self; 3], face: &impl PlaneSource, _: u16) {
        let corners = a.iter().zip(b).zip(c);
        for (plane, ((a, b), c)) in planes.iter_mut().zip(corners) {
            *plane = face.plane([(*a).into(), (*b).into(), (*c).into()]);
            // Half a unit, so that the upper 16 bits are the nearest whole number.
            plane.origin += 1 << 15;
        }
    }

    #[inline]
    fn are_even(_: &[ScreenPlane; N]) -> bool {
        true
    }

    #[inline(always)]
    fn even_run(planes: &[ScreenPlane; N], column: i32, end: i32, row: i32) -> Run<[i32; N]> {
        let mut run = Run {
            values: [0; N],
            per_column: [0; N],
            end,
        };
        let numbers = run.values.iter_mut().zip(&mut run.per_column);
        for ((value, per_column), plane) in numbers.zip(planes) {
            *value = plane.at(column, row).0 as i32;
            *per_column = plane.per_column.0 as i32;
        }
        run
    }

    #[inline]
    fn dividends(_: &[ScreenPlane; N], _: i32, _: i32) {}

    #[inline]
    fn divided(planes: &[ScreenPlane; N], (): &(), _: Wrapping<u32>, [column, row]: [i32; 2]) -> [i32; N] {
        Self::even_run(planes, column, column, row).values
    }

    #[inline]
    fn divided_run(
        planes: &[ScreenPlane; N],
        (): &mut (),
        values: &[i32; N],
        columns: i32,
        _: Wrapping<u32>,
    ) -> [[i32; N]; 2] {
        even_gain::<Self>(planes, values, columns)
    }

    #[inline]
    fn step(values: &mut [i32; N], per_column: &[i32; N]) {
        for (value, gain) in values.iter_mut().zip(per_column) {
            *value = (Wrapping(*value) + Wrapping(*gain)).0;
        }
    }

    #[inline]
    fn step_by(values: &mut [i32; N], per_column: &[i32; N], columns: i32) {
        for (value, gain) in values.iter_mut().zip(per_column) {
            *value = (Wrapping(*value) + Wrapping(*gain) * Wrapping(columns)).0;
        }
    }

    fn clamp(values: &mut [i32; N], corners: [&Self; 3]) {
        clamp(values, corners, 1 << 15);
    }
}

/// Limits numbers with 16 fractional bits to those of three corners, to which so much is added.
pub(super) fn clamp<const N: usize>(values: &mut [i32; N], [a, b, c]: [&[i16; N]; 3], added: i32) {
    for (value, ((a, b), c)) in values.iter_mut().zip(a.iter().zip(b).zip(c)) {
        let [least, most] = [*a.min(b).min(c), *a.max(b).max(c)].map(|number| (i32::from(number) << 16) + added);
        *value = (*value).max(least).min(most);
    }
}

impl<A: Attributes, B: Attributes> Attributes for (A, B) {
    const ZERO: Self = (A::ZERO, B::ZERO);
}

impl<A: CutAttributes, B: CutAttributes> CutAttributes for (A, B) {
    const NEED_DEPTH: bool = A::NEED_DEPTH || B::NEED_DEPTH;

    fn between(from: &Self, to: &Self, ways: [u64; 2], depths: [u64; 2]) -> Self {
        (
            A::between(&from.0, &to.0, ways, depths),
            B::between(&from.1, &to.1, ways, depths),
        )
    }
}

impl<A: Planes, B: Planes> Planes for (A, B) {
    type Values = (A::Values, B::Values);
    type Planes = (A::Planes, B::Planes);
    type Dividends = (A::Dividends, B::Dividends);
    type Tolerance = (A::Tolerance, B::Tolerance);
    type Others = (A::Others, B::Others);
    const EXACT: Self::Tolerance = (A::EXACT, B::EXACT);
    const VARY: bool = A::VARY || B::VARY;
    const STEP: i32 = if A::STEP < B::STEP { A::STEP } else { B::STEP };
    const NO_PLANES: Self::Planes = (A::NO_PLANES, B::NO_PLANES);
    const NO_OTHERS: Self::Others = (A::NO_OTHERS, B::NO_OTHERS);

    #[inline]
    fn others(self) -> Self::Others {
        (self.0.others(), self.1.others())
    }

    #[inline(always)]
    fn with_others((first, second): Self::Others, all: &impl Fn() -> Self) -> Self {
        (A::with_others(first, &|| all().0), B::with_others(second, &|| all().1))
    }

    #[inline]
    fn instructions(set: InstructionSet) -> AttributeInstructions {
        let (first, second) = (A::instructions(set), B::instructions(set));
        let [face, span, pixel] = first.divided;
        let [second_face, second_span, second_pixel] = second.divided;
        AttributeInstructions {
            face: first.face + second.face,
            span: first.span + second.span,
            pixel: first.pixel + second.pixel,
            divided: [face + second_face, span + second_span, pixel + second_pixel],
        }
    }

    #[inline]
    fn are_nearly_even([a, b, c]: [&Self; 3], depths: [u32; 3], (first, second): Self::Tolerance) -> bool {
        A::are_nearly_even([&a.0, &b.0, &c.0], depths, first) && B::are_nearly_even([&a.1, &b.1, &c.1], depths, second)
    }

    #[inline]
    fn set_up(
        planes: &mut Self::Planes,
        [a, b, c]: [&Self; 3],
        face: &impl PlaneSource,
        (first, second): Self::Tolerance,
    ) {
        A::set_up(&mut planes.0, [&a.0, &b.0, &c.0], face, first);
        B::set_up(&mut planes.1, [&a.1, &b.1, &c.1], face, second);
    }

    #[inline]
    fn are_even((first, second): &Self::Planes) -> bool {
        A::are_even(first) && B::are_even(second)
    }

    #[inline(always)]
    fn even_run((first, second): &Self::Planes, column: i32, end: i32, row: i32) -> Run<Self::Values> {
        both(
            A::even_run(first, column, end, row),
            B::even_run(second, column, end, row),
        )
    }

    #[inline(always)]
    fn dividends((first, second): &Self::Planes, column: i32, row: i32) -> Self::Dividends {
        (A::dividends(first, column, row), B::dividends(second, column, row))
    }

    #[inline(always)]
    fn divided(
        (first, second): &Self::Planes,
        dividends: &Self::Dividends,
        depth: Wrapping<u32>,
        at: [i32; 2],
    ) -> Self::Values {
        (
            divided::<A>(first, &dividends.0, depth, at),
            divided::<B>(second, &dividends.1, depth, at),
        )
    }

    #[inline(always)]
    fn divided_run(
        (first, second): &Self::Planes,
        dividends: &mut Self::Dividends,
        values: &Self::Values,
        columns: i32,
        depth: Wrapping<u32>,
    ) -> [Self::Values; 2] {
        let [first_gain, first_end] = divided_run::<A>(first, &mut dividends.0, &values.0, columns, depth);
        let [second_gain, second_end] = divided_run::<B>(second, &mut dividends.1, &values.1, columns, depth);
        [(first_gain, second_gain), (first_end, second_end)]
    }

    #[inline(always)]
    fn step(values: &mut Self::Values, per_column: &Self::Values) {
        A::step(&mut values.0, &per_column.0);
        B::step(&mut values.1, &per_column.1);
    }

    #[inline(always)]
    fn step_by(values: &mut Self::Values, per_column: &Self::Values, columns: i32) {
        A::step_by(&mut values.0, &per_column.0, columns);
        B::step_by(&mut values.1, &per_column.1, columns);
    }

    fn clamp(values: &mut Self::Values, [a, b, c]: [&Self; 3]) {
        A::clamp(&mut values.0, [&a.0, &b.0, &c.0]);
        B::clamp(&mut values.1, [&a.1, &b.1, &c.1]);
    }
}

/// [`Planes::divided`] of one of a pair of attributes, which may be even where the other is not.
#[inline]
fn divided<A: Planes>(
    planes: &A::Planes,
    dividends: &A::Dividends,
    depth: Wrapping<u32>,
    [column, row]: [i32; 2],
) -> A::Values {
    if A::are_even(planes) {
        A::even_run(planes, column, column, row).values
    } else {
        A::divided(planes, dividends, depth, [column, row])
    }
}

/// [`Planes::divided_run`] of one of a pair of attributes, which may be even where the other is not.
#[inline]
fn divided_run<A: Planes>(
    planes: &A::Planes,
    dividends: &mut A::Dividends,
    values: &A::Values,
    columns: i32,
    depth: Wrapping<u32>,
) -> [A::Values; 2] {
    if A::are_even(planes) {
        even_gain::<A>(planes, values, columns)
    } else {
        A::divided_run(planes, dividends, values, columns, depth)
    }
}

/// What even attributes gain from pixel to pixel, and what they are so many columns on.
#[inline]
fn even_gain<A: Planes>(planes: &A::Planes, values: &A::Values, columns: i32) -> [A::Values; 2] {
    let per_column = A::even_run(planes, 0, 0, 0).per_column;
    let mut there = *values;
    A::step_by(&mut there, &per_column, columns);
    [per_column, there]
}

/// The run of a pair of attributes, as far as both of them reach.
#[inline(always)]
fn both<A: Copy, B: Copy>(first: Run<A>, second: Run<B>) -> Run<(A, B)> {
    Run {
        values: (first.values, second.values),
        per_column: (first.per_column, second.per_column),
        end: first.end.min(second.end),
    }
}
