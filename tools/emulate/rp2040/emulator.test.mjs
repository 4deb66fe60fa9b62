// What is corrected in rp2040js, and what stands in for the boot ROM: `npm test` in this folder.

import assert from 'node:assert/strict';
import test from 'node:test';
import { RP2040 } from 'rp2040js';
import { answer, install } from './boot_rom.mjs';
import { correctCarries } from './carries.mjs';
import { stall } from './stall.mjs';

const RAM = 0x20000000;
const EDGES = [0, 1, 2, 0x7ffffffe, 0x7fffffff, 0x80000000, 0x80000001, 0xfffffffe, 0xffffffff];

/** A core at an instruction in RAM. */
function coreAt(instruction) {
  const rp2040 = new RP2040();
  correctCarries(rp2040.core);
  rp2040.writeUint16(RAM, instruction);
  return rp2040.core;
}

/** Executes an instruction on r0 and r1 for all edges and both carries, and compares result and flags with exact numbers. */
function compare(instruction, combine) {
  const core = coreAt(instruction);
  for (const one of EDGES) {
    for (const other of EDGES) {
      for (const carry of [false, true]) {
        core.PC = RAM;
        core.C = carry;
        [core.registers[0], core.registers[1]] = [one, other];
        core.executeInstruction();
        const exact = combine(one, other, Number(carry));
        const signed = combine(one | 0, other | 0, Number(carry));
        const name = `${one} with ${other}, carry ${carry}`;
        assert.equal(core.registers[0], exact.result >>> 0, name);
        assert.equal(core.C, exact.carry, `C of ${name}`);
        assert.equal(core.V, signed.result !== (signed.result | 0), `V of ${name}`);
        assert.equal(core.N, (exact.result | 0) < 0, `N of ${name}`);
        assert.equal(core.Z, exact.result >>> 0 === 0, `Z of ${name}`);
      }
    }
  }
}

test('a subtraction with carry has the flags of the architecture', () => {
  // sbcs r0, r1
  compare(0x4188, (one, other, carry) => {
    const result = one - other - (1 - carry);
    return { result, carry: result >= 0 };
  });
});

test('an addition with carry has the flags of the architecture', () => {
  // adcs r0, r1
  compare(0x4148, (one, other, carry) => {
    const result = one + other + carry;
    return { result, carry: result > 0xffffffff };
  });
});

test('a comparison is left as it is', () => {
  // cmp r0, r1
  const core = coreAt(0x4288);
  [core.PC, core.C, core.registers[0], core.registers[1]] = [RAM, false, 1, 0x80000000];
  core.executeInstruction();
  assert.deepEqual([core.N, core.Z, core.C, core.V], [true, false, false, true]);
});

/** Looks a function of the boot ROM up by its letters and calls it; returns r0. */
function call(rp2040, letters, ...operands) {
  const { core } = rp2040;
  const go = (address, ...values) => {
    values.forEach((value, index) => (core.registers[index] = value));
    core.LR = RAM | 1;
    core.PC = address & ~1;
    assert.ok(answer(rp2040) > 0);
    assert.equal(core.PC, RAM);
    return core.registers[0];
  };
  const code = letters.charCodeAt(0) | (letters.charCodeAt(1) << 8);
  return go(go(rp2040.readUint16(0x18), rp2040.readUint16(0x14), code), ...operands);
}

test('the boot ROM fills, copies and counts leading zeros', () => {
  const rp2040 = new RP2040();
  install(rp2040);
  const bytes = (address) => [0, 1, 2, 3, 4].map((offset) => rp2040.readUint8(address + offset));
  assert.equal(call(rp2040, 'MS', RAM + 1, 0x1ab, 3), RAM + 1);
  assert.deepEqual(bytes(RAM), [0, 0xab, 0xab, 0xab, 0]);
  call(rp2040, 'MC', RAM + 101, RAM + 1, 2);
  assert.deepEqual(bytes(RAM + 100), [0, 0xab, 0xab, 0, 0]);
  assert.equal(call(rp2040, 'L3', 0), 32);
  assert.equal(call(rp2040, 'L3', 0x10000), 15);
  assert.throws(() => call(rp2040, 'P3', 1), /P3/);
});

test('the second transfer stops half-way, and the third ends', () => {
  const rp2040 = new RP2040();
  const channel = rp2040.dma.channels[0];
  stall(rp2040.dma, 2);
  const [WORDS, ALWAYS, HALF_WORDS, INCREMENT, ENABLED] = [8, 0x3f << 15, 1 << 2, 3 << 4, 1];
  for (const [transfer, words, isBusy] of [[1, 8, false], [2, 4, true], [3, 8, false]]) {
    const target = RAM + 0x100 * transfer;
    for (let word = 0; word < WORDS; word += 1) rp2040.writeUint16(RAM + 2 * word, 1 + word);
    channel.writeUint32(0x0, RAM);
    channel.writeUint32(0x4, target);
    channel.writeUint32(0x8, WORDS);
    channel.writeUint32(0xc, ALWAYS | HALF_WORDS | INCREMENT | ENABLED);
    for (let tick = 0; tick < 100; tick += 1) rp2040.clock.tick(1);
    const written = Array.from({ length: WORDS }, (_, word) => rp2040.readUint16(target + 2 * word));
    assert.equal(written.filter((word) => word > 0).length, words, `transfer ${transfer}`);
    assert.equal(Boolean(channel.active), isBusy, `transfer ${transfer}`);
    rp2040.dma.writeUint32(0x444, 1);
    assert.equal(rp2040.dma.readUint32(0x444), 0);
    assert.ok(!channel.active);
  }
});
