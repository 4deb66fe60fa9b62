// Corrects rp2040js 1.4.1, which adds the carry to an operand first and takes the sum for the operand: 0x7fffffff becomes a negative
// number, and the overflow flag of a subtraction or an addition with carry is wrong. Comparisons of 64-bit numbers read it.

const [ADCS, SBCS] = [0b0100000101, 0b0100000110];
const SIGN = 0x80000000;

/** Has the core set the overflow flag as the architecture says. */
export function correctCarries(core) {
  const executes = (instruction) => core.readUint16(core.PC - 2) >> 6 === instruction;
  const { substractUpdateFlags, addUpdateFlags } = core;
  core.substractUpdateFlags = (minuend, subtrahend) => {
    const borrowed = subtrahend === SIGN && !core.C && executes(SBCS);
    const difference = substractUpdateFlags.call(core, minuend, subtrahend);
    if (borrowed) core.V = minuend >= SIGN;
    return difference;
  };
  core.addUpdateFlags = (one, other) => {
    const carried = other === SIGN && core.C && executes(ADCS);
    const sum = addUpdateFlags.call(core, one, other);
    if (carried) core.V = one < SIGN;
    return sum;
  };
}
