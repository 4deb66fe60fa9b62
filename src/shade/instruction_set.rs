//! The instruction sets for which it is predicted how many instructions a frame takes.

/// An instruction set of small chips, for [`Prepared::estimate`](crate::scene::Prepared::estimate) and its example.
#[derive(Debug, Copy, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum InstructionSet {
    /// ARMv6-M: Cortex-M0, M0+ and M1, without long multiplications and divisions (`thumbv6m`).
    Armv6M,
    /// ARMv7-M and ARMv7E-M: Cortex-M3, M4 and M7 (`thumbv7m`, `thumbv7em`); ARMv8-M Mainline, such as Cortex-M33, is much
    /// alike.
    Armv7M,
}

impl InstructionSet {
    /// The number of two that is counted on this instruction set: on ARMv6-M and on ARMv7-M.
    #[inline]
    pub(crate) const fn of(self, [armv6m, armv7m]: [u32; 2]) -> u32 {
        match self {
            Self::Armv6M => armv6m,
            Self::Armv7M => armv7m,
        }
    }
}
