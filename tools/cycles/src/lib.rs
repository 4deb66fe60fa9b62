//! What executed Thumb instructions cost in cycles, by the tables of Arm's Technical Reference Manuals.
//!
//! The model: memory without wait states, no interrupts. Every instruction has a price of its own; three prices depend on
//! what was executed before or is executed next:
//!
//! - a branch that is taken pays for refilling the pipeline: 2 cycles on a Cortex-M3 and a Cortex-M4 (the manual says 1 to 3, by the
//!   alignment of its target), 1 on a Cortex-M0+;
//! - on a Cortex-M3 and a Cortex-M4 a single load right after a single load or store takes 1 cycle instead of 2, because their addresses and
//!   data overlap;
//! - an instruction that an `IT` block skips takes 1 cycle like most.
//!
//! Left out: wait states of flash (a chip with a cache or a prefetch buffer hides most of them), stalls where a loaded number
//! is the next address, folding of `IT`, and that a division takes 2 to 12 cycles by its numbers (7 here).
//!
//! Sources: Cortex-M3 Technical Reference Manual r2p1, table 3-1; Cortex-M4 Technical Reference Manual r0p1, tables 3-1 and 7-1; Cortex-M0+ Technical Reference Manual r0p1, table
//! 3-1, with the fast multiplier.

#![forbid(unsafe_code)]

/// The processor whose prices count.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Core {
    /// Cortex-M3.
    M3,
    /// Cortex-M4, with or without its floating-point unit.
    M4,
    /// Cortex-M0+ with the multiplier of one cycle and ports of one cycle left out.
    M0Plus,
}

/// What one instruction costs by itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Price {
    /// Cycles, without what a taken branch adds.
    pub cycles: u32,
    /// Whether it is a single load or store, with which the address of a next load overlaps on a Cortex-M3 or a Cortex-M4.
    pub access: Access,
}

/// How an instruction reaches memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Access {
    /// It loads one number.
    Load,
    /// It stores one number.
    Store,
    /// It has no memory access, or several.
    Other,
}

impl Core {
    /// The cycles that a taken branch adds to the price of its instruction.
    pub const fn taken_branch(self) -> u32 {
        match self {
            Self::M3 | Self::M4 => 2,
            Self::M0Plus => 1,
        }
    }

    /// The cycles that a single load saves right after another single access.
    pub const fn overlap(self, before: Access, now: Access) -> u32 {
        match (self, before, now) {
            (Self::M3 | Self::M4, Access::Load | Access::Store, Access::Load) => 1,
            _ => 0,
        }
    }

    /// The price of an instruction, of its first halfword and of the second one, which a 16-bit instruction has not.
    pub const fn price(self, first: u16, second: Option<u16>) -> Price {
        match second {
            None => self.narrow(first),
            Some(second) => self.wide(first, second),
        }
    }

    const fn load(self) -> Price {
        Price {
            cycles: 2,
            access: Access::Load,
        }
    }

    const fn store(self) -> Price {
        let cycles = match self {
            Self::M3 | Self::M4 => 1,
            Self::M0Plus => 2,
        };
        Price {
            cycles,
            access: Access::Store,
        }
    }

    /// Loads or stores of several registers.
    const fn several(registers: u32) -> Price {
        plain(1 + registers)
    }

    const fn narrow(self, code: u16) -> Price {
        let registers = (code & 0xff).count_ones();
        match code >> 11 {
            // LDR (literal); STR and LDR of words, bytes, halfwords with an immediate; relative to SP.
            0b01001 | 0b01101 | 0b01111 | 0b10001 | 0b10011 => self.load(),
            0b01100 | 0b01110 | 0b10000 | 0b10010 => self.store(),
            // Register offsets: bits 9 to 11 are STR, STRH, STRB, then loads.
            0b01010 | 0b01011 => {
                if (code >> 9) & 7 < 3 {
                    self.store()
                } else {
                    self.load()
                }
            }
            // STM, LDM.
            0b11000 | 0b11001 => Self::several(registers),
            0b10110 | 0b10111 => match (code >> 9) & 7 {
                // PUSH with or without LR.
                2 if code >> 11 == 0b10110 => Self::several(registers + ((code >> 8) & 1) as u32),
                // POP with or without PC, which a Cortex-M0+ takes one cycle more for.
                6 if code >> 11 == 0b10111 => {
                    let returns = ((code >> 8) & 1) as u32;
                    let more = match self {
                        Self::M3 | Self::M4 => 0,
                        Self::M0Plus => returns,
                    };
                    Self::several(registers + returns + more)
                }
                _ => plain(1),
            },
            _ => plain(1),
        }
    }

    const fn wide(self, first: u16, second: u16) -> Price {
        let is_branch = first >> 11 == 0b11110 && second >> 15 == 1;
        match self {
            // BL takes 3 with its taken branch, MSR, MRS and barriers 3.
            Self::M0Plus if is_branch && second & 0x5000 == 0x5000 => plain(2),
            Self::M0Plus => plain(3),
            Self::M3 | Self::M4 if is_branch => plain(1),
            Self::M3 | Self::M4 => self.wide_data(first, second),
        }
    }

    /// 32-bit instructions of a Cortex-M3 or a Cortex-M4, but for branches.
    const fn wide_data(self, first: u16, second: u16) -> Price {
        match first >> 9 {
            // LDM, STM, PUSH, POP (bit 6 clear); LDRD, STRD, exclusive accesses, table branches.
            0b111_0100 => {
                if first & 0x40 == 0 {
                    Self::several(second.count_ones())
                } else if first & 0x1f0 == 0x0d0 && second & 0xffe0 == 0xf000 {
                    // TBB, TBH: a load, and a branch that is always taken.
                    plain(2)
                } else if first & 0x120 == 0 {
                    // LDREX, STREX and their like.
                    plain(2)
                } else {
                    plain(3)
                }
            }
            // Single loads and stores: bit 4 says which.
            0b111_1100 => {
                if first & 0x10 == 0 {
                    self.store()
                } else {
                    self.load()
                }
            }
            // Long products and divisions.
            0b111_1101 if first & 0x180 == 0x180 => {
                if matches!(first & 0x70, 0x10 | 0x30) && second & 0xf0 == 0xf0 {
                    plain(7)
                } else {
                    plain(match self {
                        // 3 to 5, by the numbers.
                        Self::M3 => 4,
                        Self::M4 | Self::M0Plus => 1,
                    })
                }
            }
            // MLA and MLS; without an accumulator (15) it is MUL.
            0b111_1101 if first & 0x1f0 == 0x100 && second >> 12 != 15 => plain(match self {
                Self::M3 => 2,
                Self::M4 | Self::M0Plus => 1,
            }),
            // Floating point: loads and stores, several or one.
            0b111_0110 => {
                let words = (second & 0xff) as u32;
                if first & 0x120 == 0x100 {
                    // VLDR, VSTR: 2, of a double 3.
                    plain(2 + ((second >> 8) & 1) as u32)
                } else if first & 0x1e0 == 0x040 {
                    // VMOV of two core registers.
                    plain(2)
                } else {
                    Self::several(words)
                }
            }
            0b111_0111 if first & 0x100 == 0 && second & 0x10 == 0 => floating(first, second),
            _ => plain(1),
        }
    }
}

/// Floating-point arithmetic in single precision.
const fn floating(first: u16, second: u16) -> Price {
    let operation = ((first >> 4) & 0xb, (second >> 6) & 1);
    match operation {
        // VMLA, VMLS, VNMLA, VNMLS and the fused ones.
        (0, _) | (1, _) | (9, _) | (10, _) => plain(3),
        // VDIV.
        (8, 0) => plain(14),
        // VSQRT among what has one operand.
        (11, 1) if first & 0xf == 1 && second & 0x80 == 0x80 => plain(14),
        _ => plain(1),
    }
}

const fn plain(cycles: u32) -> Price {
    Price {
        cycles,
        access: Access::Other,
    }
}

/// Whether a halfword is the first one of a 32-bit instruction.
pub const fn is_wide(first: u16) -> bool {
    first >> 11 >= 0b11101
}

/// Cycles and instructions of what was executed, added up block by block.
///
/// A block is what runs from its first instruction to its last one; where the next block does not begin at its end, a branch
/// was taken.
#[derive(Clone, Debug)]
pub struct Meter {
    core: Core,
    /// Where the next block begins if no branch is taken.
    expected: u64,
    before: Access,
    /// What was executed so far.
    pub total: Total,
}

/// Cycles and instructions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Total {
    /// Estimated cycles.
    pub cycles: u64,
    /// Executed instructions.
    pub instructions: u64,
}

/// Instructions that are executed one after the other.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Block {
    start: u64,
    end: u64,
    first: Access,
    last: Access,
    /// What every instruction and all after it in the block take; 0 behind the last one.
    remaining: Vec<Total>,
}

impl Block {
    /// A block from the address of its first instruction, and the halfwords of each.
    pub fn new(core: Core, start: u64, codes: impl IntoIterator<Item = (u16, Option<u16>)>) -> Self {
        let prices: Vec<_> = codes
            .into_iter()
            .map(|(first, second)| (core.price(first, second), if second.is_some() { 4 } else { 2 }))
            .collect();
        let mut remaining = vec![Total::default(); prices.len() + 1];
        for index in (0..prices.len()).rev() {
            let overlap = match index.checked_sub(1) {
                Some(before) => core.overlap(prices[before].0.access, prices[index].0.access),
                None => 0,
            };
            let after = remaining[index + 1];
            remaining[index] = Total {
                cycles: after.cycles + u64::from(prices[index].0.cycles - overlap),
                instructions: after.instructions + 1,
            };
        }
        let access = |price: Option<&(Price, u64)>| price.map_or(Access::Other, |(price, _)| price.access);
        Self {
            start,
            end: start + prices.iter().map(|(_, bytes)| bytes).sum::<u64>(),
            first: access(prices.first()),
            last: access(prices.last()),
            remaining,
        }
    }

    /// What the block takes behind one of its instructions.
    pub fn behind(&self, index: usize) -> Total {
        self.remaining.get(index + 1).copied().unwrap_or_default()
    }
}

impl Meter {
    /// Nothing was executed yet.
    pub const fn new(core: Core) -> Self {
        Self {
            core,
            expected: 0,
            before: Access::Other,
            total: Total {
                cycles: 0,
                instructions: 0,
            },
        }
    }

    /// Adds a block that is executed now, as a whole.
    pub fn execute(&mut self, block: &Block) {
        let all = block.remaining.first().copied().unwrap_or_default();
        let link = if block.start == self.expected {
            // Never more than the load's own price.
            all.cycles - u64::from(self.core.overlap(self.before, block.first))
        } else {
            all.cycles + u64::from(self.core.taken_branch())
        };
        self.total.cycles += link;
        self.total.instructions += all.instructions;
        (self.expected, self.before) = (block.end, block.last);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cycles(core: Core, code: &[u16]) -> u32 {
        core.price(code[0], code.get(1).copied()).cycles
    }

    /// Encodings by the assembler, prices by the tables of the manuals.
    #[test]
    fn prices_are_those_of_the_manuals() {
        for (name, code, m4, m0) in [
            ("adds r0, r1, r2", &[0x1888][..], 1, Some(1)),
            ("movs r0, #1", &[0x2001], 1, Some(1)),
            ("muls r0, r1", &[0x4348], 1, Some(1)),
            ("bx lr", &[0x4770], 1, Some(1)),
            ("beq .", &[0xd0fe], 1, Some(1)),
            ("nop", &[0xbf00], 1, Some(1)),
            ("ldr r0, [pc, #4]", &[0x4801], 2, Some(2)),
            ("ldr r0, [r1, #4]", &[0x6848], 2, Some(2)),
            ("ldrb r0, [r1, r2]", &[0x5c88], 2, Some(2)),
            ("ldrsh r0, [r1, r2]", &[0x5e88], 2, Some(2)),
            ("ldrh r0, [r1, #2]", &[0x8848], 2, Some(2)),
            ("ldr r0, [sp, #4]", &[0x9801], 2, Some(2)),
            ("str r0, [r1, #4]", &[0x6048], 1, Some(2)),
            ("strh r0, [r1, r2]", &[0x5288], 1, Some(2)),
            ("strb r0, [r1, #1]", &[0x7048], 1, Some(2)),
            ("str r0, [sp, #4]", &[0x9001], 1, Some(2)),
            ("push {r4, r5, lr}", &[0xb530], 4, Some(4)),
            ("pop {r4, r5}", &[0xbc30], 3, Some(3)),
            // With the taken branch 6 on a Cortex-M4 and 6 on a Cortex-M0+: 3 + N for the two registers beside PC, and 1.
            ("pop {r4, r5, pc}", &[0xbd30], 4, Some(5)),
            ("stmia r0!, {r1, r2, r3}", &[0xc00e], 4, Some(4)),
            ("ldmia r0!, {r1, r2}", &[0xc806], 3, Some(3)),
            // With the taken branch 3 on both.
            ("bl .", &[0xf7ff, 0xfffe], 1, Some(2)),
            ("b.w .", &[0xf7ff, 0xbffe], 1, None),
            ("ldr.w r0, [r1, #64]", &[0xf8d1, 0x0040], 2, None),
            ("ldrsb.w r0, [r1, #64]", &[0xf991, 0x0040], 2, None),
            ("str.w r0, [r1, #64]", &[0xf8c1, 0x0040], 1, None),
            ("ldrd r0, r1, [r2]", &[0xe9d2, 0x0100], 3, None),
            ("strd r0, r1, [r2], #8", &[0xe8e2, 0x0102], 3, None),
            ("stmdb sp!, {r4-r11, lr}", &[0xe92d, 0x4ff0], 10, None),
            ("ldmia.w r0, {r1, r2, r8}", &[0xe890, 0x0106], 4, None),
            ("tbb [pc, r0]", &[0xe8df, 0xf000], 2, None),
            ("udiv r0, r1, r2", &[0xfbb1, 0xf0f2], 7, None),
            ("sdiv r0, r1, r2", &[0xfb91, 0xf0f2], 7, None),
            ("umull r0, r1, r2, r3", &[0xfba2, 0x0103], 1, None),
            ("smlal r0, r1, r2, r3", &[0xfbc2, 0x0103], 1, None),
            ("mla r0, r1, r2, r3", &[0xfb01, 0x3002], 1, None),
            ("smulbb r0, r1, r2", &[0xfb11, 0xf002], 1, None),
            ("add.w r0, r1, r2, lsl #3", &[0xeb01, 0x00c2], 1, None),
            ("movw r0, #0x1234", &[0xf241, 0x2034], 1, None),
            ("clz r0, r1", &[0xfab1, 0xf081], 1, None),
            ("vldr s0, [r0]", &[0xed90, 0x0a00], 2, None),
            ("vpush {s16, s17}", &[0xed2d, 0x8a02], 3, None),
            ("vadd.f32 s0, s0, s1", &[0xee30, 0x0a20], 1, None),
            ("vmul.f32 s0, s0, s1", &[0xee20, 0x0a20], 1, None),
            ("vmla.f32 s0, s1, s2", &[0xee00, 0x0a81], 3, None),
            ("vdiv.f32 s0, s0, s1", &[0xee80, 0x0a20], 14, None),
            ("vsqrt.f32 s0, s0", &[0xeeb1, 0x0ac0], 14, None),
            ("vcvt.s32.f32 s0, s0", &[0xeebd, 0x0ac0], 1, None),
        ] {
            assert_eq!(is_wide(code[0]), code.len() == 2, "{name}");
            assert_eq!(cycles(Core::M4, code), m4, "{name} on a Cortex-M4");
            assert!(
                m0.is_none_or(|m0| cycles(Core::M0Plus, code) == m0),
                "{name} on a Cortex-M0+"
            );
        }
    }

    #[test]
    fn a_cortex_m3_has_slower_products() {
        let cycles = |first, second| Core::M3.price(first, Some(second)).cycles;
        // umull, mla, mls, mul, udiv.
        assert_eq!(
            (cycles(0xfba2, 0x0103), cycles(0xfb01, 0x3002), cycles(0xfb01, 0x3012)),
            (4, 2, 2)
        );
        assert_eq!((cycles(0xfb01, 0xf002), cycles(0xfbb1, 0xf0f2)), (1, 7));
    }

    const LDR: (u16, Option<u16>) = (0x6848, None);
    const STR: (u16, Option<u16>) = (0x6048, None);
    const ADD: (u16, Option<u16>) = (0x1888, None);

    #[test]
    fn a_load_after_an_access_takes_one_cycle_on_a_cortex_m4() {
        let all = |core, codes: &[_]| Block::new(core, 0, codes.iter().copied()).remaining[0].cycles;
        assert_eq!(all(Core::M4, &[LDR, LDR, STR, LDR]), 2 + 1 + 1 + 1);
        assert_eq!(all(Core::M4, &[LDR, ADD, LDR]), 2 + 1 + 2);
        assert_eq!(all(Core::M0Plus, &[LDR, LDR]), 4);
    }

    #[test]
    fn blocks_that_follow_each_other_are_as_one() {
        for core in [Core::M3, Core::M4, Core::M0Plus] {
            let codes = [LDR, LDR, ADD, STR, LDR, ADD];
            let mut whole = Meter::new(core);
            whole.execute(&Block::new(core, 0, codes));
            for cut in 1..codes.len() {
                let mut parts = Meter::new(core);
                parts.execute(&Block::new(core, 0, codes[..cut].iter().copied()));
                parts.execute(&Block::new(core, 2 * cut as u64, codes[cut..].iter().copied()));
                assert_eq!(parts.total, whole.total, "{core:?} cut at {cut}");
            }
        }
    }

    #[test]
    fn a_loop_pays_for_each_branch_that_is_taken() {
        // subs, bne: three times around, and out.
        let block = |core| Block::new(core, 0x100, [(0x3801, None), (0xd1fd, None)]);
        for (core, taken) in [(Core::M3, 2), (Core::M4, 2), (Core::M0Plus, 1)] {
            let mut meter = Meter::new(core);
            meter.expected = 0x100;
            for _ in 0..4 {
                meter.execute(&block(core));
            }
            let total = Total {
                cycles: 4 * 2 + 3 * taken,
                instructions: 8,
            };
            assert_eq!(meter.total, total, "{core:?}");
        }
    }

    #[test]
    fn what_is_behind_an_instruction_is_without_it() {
        let block = Block::new(Core::M4, 0, [ADD, LDR, STR]);
        assert_eq!(
            block.behind(0),
            Total {
                cycles: 3,
                instructions: 2
            }
        );
        assert_eq!(block.behind(2), Total::default());
    }
}
