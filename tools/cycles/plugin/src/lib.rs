//! A plugin for QEMU: writes a line with instructions and estimated cycles for each marked stretch of a program.
//!
//! `-plugin file=libzrow_cycles_plugin.so,core=m4,output=FILE`; `core=m3` and `core=m0plus` for other prices. A stretch begins behind the
//! instruction with the code [`BEGIN`] and ends before the one with the code [`END`], both hints that every core takes for
//! `nop`. QEMU tells the plugin of each block of code that it translates, once, and of each run of it.
//!
//! The functions of QEMU's header `qemu-plugin.h` are declared here as version 1 of the interface has them (QEMU 4.2 to 8.1),
//! because distributions do not package it.

use std::{
    ffi::{CStr, c_char, c_int, c_uint, c_void},
    fs::File,
    io::Write,
    sync::Mutex,
};

use zrow_cycles::{Block, Core, Meter, Total};

/// The hint that a stretch begins behind.
pub const BEGIN: u16 = 0xbf60;
/// The hint that a stretch ends before.
pub const END: u16 = 0xbf70;

/// The version of the interface.
#[unsafe(no_mangle)]
pub static qemu_plugin_version: c_int = 1;

type Id = u64;

/// A block of code that is being translated.
#[repr(C)]
pub struct TranslationBlock(c_void);

/// An instruction of a block that is being translated.
#[repr(C)]
pub struct Instruction(c_void);

type OnTranslation = extern "C" fn(Id, *mut TranslationBlock);
type OnExecution = extern "C" fn(c_uint, *mut c_void);

/// The callback reads no register.
const NO_REGISTERS: c_int = 0;

unsafe extern "C" {
    fn qemu_plugin_register_vcpu_tb_trans_cb(id: Id, callback: OnTranslation);
    fn qemu_plugin_register_vcpu_tb_exec_cb(
        block: *mut TranslationBlock,
        callback: OnExecution,
        flags: c_int,
        data: *mut c_void,
    );
    fn qemu_plugin_register_vcpu_insn_exec_cb(
        instruction: *mut Instruction,
        callback: OnExecution,
        flags: c_int,
        data: *mut c_void,
    );
    fn qemu_plugin_tb_n_insns(block: *const TranslationBlock) -> usize;
    fn qemu_plugin_tb_vaddr(block: *const TranslationBlock) -> u64;
    fn qemu_plugin_tb_get_insn(block: *const TranslationBlock, index: usize) -> *mut Instruction;
    fn qemu_plugin_insn_data(instruction: *const Instruction) -> *const c_void;
    fn qemu_plugin_insn_size(instruction: *const Instruction) -> usize;
}

/// What the plugin knows while the program runs.
struct State {
    core: Core,
    meter: Meter,
    /// The total at the begin of the stretch.
    begin: Total,
    output: File,
}

static STATE: Mutex<Option<State>> = Mutex::new(None);

/// A hint that begins or ends a stretch.
struct Mark {
    is_begin: bool,
    /// What its block takes behind it, which was added when the block began.
    behind: Total,
}

/// Called by QEMU when it loads the plugin.
///
/// # Safety
///
/// `arguments` has to point to `count` strings.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn qemu_plugin_install(
    id: Id,
    _info: *const c_void,
    count: c_int,
    arguments: *const *const c_char,
) -> c_int {
    let (mut core, mut output) = (None, None);
    for index in 0..usize::try_from(count).unwrap_or(0) {
        // SAFETY: the caller has that many strings.
        let argument = unsafe { CStr::from_ptr(*arguments.add(index)) }.to_string_lossy();
        match argument.split_once('=') {
            Some(("core", "m3")) => core = Some(Core::M3),
            Some(("core", "m4")) => core = Some(Core::M4),
            Some(("core", "m0plus")) => core = Some(Core::M0Plus),
            Some(("output", path)) => output = File::create(path).ok(),
            _ => eprintln!("the plugin has no argument {argument}"),
        }
    }
    let (Some(core), Some(output)) = (core, output) else {
        eprintln!("the plugin needs core=m3, core=m4 or core=m0plus, and output=FILE that can be written");
        return -1;
    };
    if let Ok(mut state) = STATE.lock() {
        *state = Some(State {
            core,
            meter: Meter::new(core),
            begin: Total::default(),
            output,
        });
    }
    // SAFETY: the identifier is the one that QEMU gave, and the callback has the type it expects.
    unsafe { qemu_plugin_register_vcpu_tb_trans_cb(id, translated) };
    0
}

/// Prices a block once, and has QEMU tell of each of its runs.
extern "C" fn translated(_id: Id, translation: *mut TranslationBlock) {
    let Some(core) = STATE.lock().ok().and_then(|state| Some(state.as_ref()?.core)) else {
        return;
    };
    // SAFETY: QEMU's block lives as long as this call.
    let (count, start) = unsafe { (qemu_plugin_tb_n_insns(translation), qemu_plugin_tb_vaddr(translation)) };
    // SAFETY: as above, and the index is below the number of instructions.
    let instructions: Vec<_> = (0..count)
        .map(|index| unsafe { qemu_plugin_tb_get_insn(translation, index) })
        .collect();
    let codes: Vec<_> = instructions.iter().map(|instruction| code(*instruction)).collect();
    // QEMU may run a block as long as it lives, so it is never freed; a program has some thousands.
    let block: &'static Block = Box::leak(Box::new(Block::new(core, start, codes.iter().copied())));
    // SAFETY: the data lives for ever, and the callback takes it for what it is.
    unsafe {
        qemu_plugin_register_vcpu_tb_exec_cb(
            translation,
            executed,
            NO_REGISTERS,
            std::ptr::from_ref(block) as *mut c_void,
        );
    }
    for (index, (instruction, code)) in instructions.iter().zip(&codes).enumerate() {
        let is_begin = code.0 == BEGIN;
        if is_begin || code.0 == END {
            let behind = block.behind(index);
            let mark: &'static Mark = Box::leak(Box::new(Mark { is_begin, behind }));
            // SAFETY: as above.
            unsafe {
                qemu_plugin_register_vcpu_insn_exec_cb(
                    *instruction,
                    marked,
                    NO_REGISTERS,
                    std::ptr::from_ref(mark) as *mut c_void,
                );
            }
        }
    }
}

/// The halfwords of an instruction; the second one of a 32-bit instruction only.
fn code(instruction: *const Instruction) -> (u16, Option<u16>) {
    // SAFETY: QEMU's instruction lives as long as the call that it comes from, and has as many bytes as it says.
    let bytes = unsafe {
        std::slice::from_raw_parts(
            qemu_plugin_insn_data(instruction).cast::<u8>(),
            qemu_plugin_insn_size(instruction),
        )
    };
    let halfword = |index: usize| {
        let pair = bytes.get(2 * index..2 * index + 2)?;
        Some(u16::from_le_bytes([pair[0], pair[1]]))
    };
    (halfword(0).unwrap_or(0), halfword(1))
}

/// A block runs.
extern "C" fn executed(_cpu: c_uint, data: *mut c_void) {
    // SAFETY: it was registered with a block that lives for ever.
    let block = unsafe { &*data.cast::<Block>() };
    if let Ok(mut state) = STATE.lock()
        && let Some(state) = state.as_mut()
    {
        state.meter.execute(block);
    }
}

/// A mark runs.
extern "C" fn marked(_cpu: c_uint, data: *mut c_void) {
    // SAFETY: it was registered with a mark that lives for ever.
    let mark = unsafe { &*data.cast::<Mark>() };
    if let Ok(mut state) = STATE.lock()
        && let Some(state) = state.as_mut()
    {
        let now = Total {
            cycles: state.meter.total.cycles - mark.behind.cycles,
            instructions: state.meter.total.instructions - mark.behind.instructions,
        };
        if mark.is_begin {
            state.begin = now;
        } else {
            // The mark at the end is not part of the stretch.
            let (cycles, instructions) = (
                now.cycles - state.begin.cycles - 1,
                now.instructions - state.begin.instructions - 1,
            );
            if let Err(error) = writeln!(state.output, "{instructions} {cycles}") {
                eprintln!("the plugin cannot write: {error}");
            }
        }
    }
}
