// Runs the firmware of the Raspberry Pi Pico and prints what goes over its wires, a line each:
//
//   node run.mjs PROGRAM FRAMES [TRANSFER]
//
//   command 2a       a byte to the display while its data/command pin is low
//   data 00ef...     bytes while that pin is high
//   says ...         a line from the firmware's UART0
//
// The transfer of that number of the DMA's channel 0 stops half-way and never ends.
// The button is held down once FRAMES frames of a scene have been reported, until a frame of the next scene is. It ends when its
// output is closed. rp2040js takes no time for a transfer on the SPI bus: here each takes as many cycles as its bits do.

import { readFileSync, writeSync } from 'node:fs';
import { ConsoleLogger, GPIOPinState, LogLevel, RP2040 } from 'rp2040js';
import { ROM_END, answer, install } from './boot_rom.mjs';
import { correctCarries } from './carries.mjs';
import { stall } from './stall.mjs';

const FLASH = 0x10000000;
/** The vector table lies behind the second stage of the boot loader. */
const VECTOR_TABLE = FLASH + 0x100;
const CYCLE_NANOS = 8;
const [DATA_NOT_COMMAND, SELECT, BUTTON] = [16, 17, 12];

const [program, frames, transfer] = process.argv.slice(2);

/** Puts the segments of an ELF file where its program headers say. */
function load(rp2040, elf) {
  const [headers, size, count] = [elf.readUInt32LE(28), elf.readUInt16LE(42), elf.readUInt16LE(44)];
  for (let header = headers; header < headers + size * count; header += size) {
    const [type, offset, , address, length] = [0, 4, 8, 12, 16].map((field) => elf.readUInt32LE(header + field));
    if (type === 1 && length > 0) rp2040.flash.set(elf.subarray(offset, offset + length), address - FLASH);
  }
}

/** Prints a line; ends the program where nobody listens any more. */
function print(line) {
  const bytes = Buffer.from(line + '\n');
  for (let done = 0; done < bytes.length; ) {
    try {
      done += writeSync(1, bytes, done);
    } catch (error) {
      if (error.code === 'EPIPE') process.exit(0);
      if (error.code !== 'EAGAIN') throw error;
    }
  }
}

/** Collects the bytes of the display as long as they are of one kind. */
function listen(rp2040) {
  const { clock, gpio } = rp2040;
  const spi = rp2040.spi[0];
  let [kind, bytes] = ['', []];
  const flush = () => {
    if (bytes.length > 0) print(`${kind} ${Buffer.from(bytes).toString('hex')}`);
    bytes = [];
  };
  const sent = clock.createAlarm(() => spi.completeTransmit(0));
  spi.onTransmit = (value) => {
    sent.schedule((spi.dataBits * 1e9) / spi.clockFrequency);
    // A panel that is not selected does not listen.
    if (gpio[SELECT].value !== GPIOPinState.Low) return;
    const now = gpio[DATA_NOT_COMMAND].value === GPIOPinState.High ? 'data' : 'command';
    if (now !== kind) flush();
    kind = now;
    if (spi.dataBits > 8) bytes.push(value >> 8);
    bytes.push(value & 0xff);
  };
  let line = '';
  gpio[BUTTON].setInputValue(true);
  rp2040.uart[0].onByte = (byte) => {
    if (byte !== 10) {
      line += String.fromCharCode(byte);
      return;
    }
    flush();
    print(`says ${line}`);
    const reported = / frame (\d+):/.exec(line);
    gpio[BUTTON].setInputValue(!reported || Number(reported[1]) + 1 < Number(frames));
    line = '';
  };
}

const rp2040 = new RP2040();
// What is less than a warning would go between the lines for the host.
rp2040.logger = new ConsoleLogger(LogLevel.Warn);
const { core, clock } = rp2040;
install(rp2040);
correctCarries(core);
load(rp2040, readFileSync(program));
listen(rp2040);
if (transfer !== undefined) stall(rp2040.dma, Number(transfer));
rp2040.onBreak = () => {
  print('says stopped at a breakpoint');
  process.exit(1);
};
core.VTOR = VECTOR_TABLE;
core.SP = rp2040.readUint32(VECTOR_TABLE);
core.PC = rp2040.readUint32(VECTOR_TABLE + 4) & ~1;
for (;;) {
  if (core.waiting) clock.tick(clock.nanosToNextAlarm);
  else clock.tick((core.PC < ROM_END ? answer(rp2040) : core.executeInstruction()) * CYCLE_NANOS);
}
