//! How much flash and static RAM a linked program takes.

use std::{fs, ops::Range, path::Path};

use anyhow::Context;
use object::{Object, ObjectSection, SectionFlags, SectionKind, elf};

/// A section of a program that is in the memory of the chip.
struct Section {
    name: String,
    address: u64,
    size: u64,
    /// Whether the program brings its bytes along; those of others are zeros, or nobody sets them.
    has_bytes: bool,
}

/// Bytes of the memories of a chip.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sizes {
    /// Code, constants, and what variables are set to at the start.
    pub flash: u64,
    /// Variables that live as long as the program, among them the futures of its tasks, and code that runs in RAM. What is
    /// left is the stack.
    pub statics: u64,
}

impl Sizes {
    /// Reads them off a linked program, whose chip has RAM at these addresses.
    ///
    /// # Errors
    /// The file cannot be read, or is no ELF file.
    pub fn of_program(program: &Path, ram: &Range<u64>) -> anyhow::Result<Self> {
        let bytes = fs::read(program).with_context(|| format!("cannot read {}", program.display()))?;
        let file = object::File::parse(&*bytes).with_context(|| format!("{} is no program", program.display()))?;
        let allocated = file.sections().filter(|section| match section.flags() {
            SectionFlags::Elf { sh_flags, .. } => sh_flags.contains(elf::SHF_ALLOC),
            _ => false,
        });
        let sections: Vec<Section> = allocated
            .map(|section| Section {
                name: section.name().unwrap_or_default().to_owned(),
                address: section.address(),
                size: section.size(),
                has_bytes: section.kind() != SectionKind::UninitializedData,
            })
            .collect();
        Ok(Self::of_sections(&sections, ram))
    }

    /// A section `.stack` is all that is left of the RAM. esp-hal has sections without bytes outside the RAM, which only keep
    /// addresses free.
    fn of_sections(sections: &[Section], ram: &Range<u64>) -> Self {
        let sum = |is_counted: &dyn Fn(&Section) -> bool| {
            let counted = sections.iter().filter(|section| is_counted(section));
            counted.map(|section| section.size).sum()
        };
        Self {
            flash: sum(&|section| section.has_bytes),
            statics: sum(&|section| ram.contains(&section.address) && section.name != ".stack"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn section(name: &str, address: u64, size: u64, has_bytes: bool) -> Section {
        Section {
            name: name.to_owned(),
            address,
            size,
            has_bytes,
        }
    }

    /// Initial values are in both memories.
    #[test]
    fn a_cortex_m_has_text_data_and_bss() {
        let sections = [
            section(".vector_table", 0, 0x100, true),
            section(".text", 0x100, 3_000, true),
            section(".rodata", 0x1000, 500, true),
            section(".data", 0x2000_0000, 24, true),
            section(".bss", 0x2000_0018, 700, false),
            section(".uninit", 0x2000_0400, 1024, false),
        ];
        let expected = Sizes {
            flash: 256 + 3_000 + 500 + 24,
            statics: 24 + 700 + 1024,
        };
        assert_eq!(Sizes::of_sections(&sections, &(0x2000_0000..0x2000_1000)), expected);
    }

    /// The RAM of code and of data is the same at two addresses, and what code takes is kept free among the data.
    #[test]
    fn an_esp32_has_code_in_ram_and_a_section_for_its_stack() {
        let sections = [
            section(".rwtext", 0x4038_0000, 400, true),
            section(".rwdata_dummy", 0x3fc8_0000, 400, false),
            section(".data", 0x3fc8_0190, 30, true),
            section(".bss", 0x3fc8_0200, 2_000, false),
            section(".stack", 0x3fc8_1000, 300_000, false),
            section(".rotext_dummy", 0x4200_0020, 65_536, false),
            section(".text", 0x4201_0020, 9_000, true),
        ];
        let expected = Sizes {
            flash: 400 + 30 + 9_000,
            statics: 400 + 30 + 2_000,
        };
        assert_eq!(Sizes::of_sections(&sections, &(0x3fc8_0000..0x3fcc_e400)), expected);
    }
}
