// Stands in for the boot ROM of the RP2040, which rp2040js does not bring along.
//
// A program finds a function of the ROM by two letters: the halfword at 0x18 is the address of a function that searches the
// table at which the halfword at 0x14 points. Here each of these functions is an address alone. When the core gets there,
// `answer` does the work and says how many cycles it takes: as many as code would that moves 16 bytes with `ldm` and `stm`, and
// for the leading zeros as many as five halvings of the word take at 4 cycles each. The addresses have no other meaning.

const SEARCH = 0x100;
const FUNCTIONS = { MS: 0x110, S4: 0x110, MC: 0x120, C4: 0x120, L3: 0x130 };

/** Every address of the ROM is below. */
export const ROM_END = 0x4000;

/** Writes the two halfwords. */
export function install(rp2040) {
  rp2040.bootrom[0x14 / 4] = 0x0200;
  rp2040.bootrom[0x18 / 4] = SEARCH | 1;
}

/** Does what the function at the program counter does, returns to its caller, and says how many cycles that took. */
export function answer(rp2040) {
  const { core } = rp2040;
  const [first, second, length] = core.registers;
  const at = core.PC;
  core.PC = core.LR & ~1;
  switch (at) {
    case SEARCH: {
      const letters = String.fromCharCode(second & 0xff, second >> 8);
      if (!(letters in FUNCTIONS)) throw new Error(`the program asks for ${letters}, which the boot ROM here has not`);
      core.registers[0] = FUNCTIONS[letters] | 1;
      return 100;
    }
    case FUNCTIONS.MS:
      for (let i = 0; i < length; i++) rp2040.writeUint8(first + i, second & 0xff);
      return 12 + Math.ceil(length / 16) * 8;
    case FUNCTIONS.MC:
      for (let i = 0; i < length; i++) rp2040.writeUint8(first + i, rp2040.readUint8(second + i));
      return 12 + Math.ceil(length / 16) * 13;
    case FUNCTIONS.L3:
      core.registers[0] = Math.clz32(first);
      return 20;
    default:
      throw new Error(`the program went to 0x${at.toString(16)} in the boot ROM`);
  }
}
