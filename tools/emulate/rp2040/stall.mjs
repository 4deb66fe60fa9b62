// A fault of the hardware: a transfer of the DMA that never ends.

/** Channels that are being aborted; a bit each, which the hardware clears. */
const CHAN_ABORT = 0x444;

/**
 * Stops channel 0 half-way in the transfer of a number, counted from 1: it stays busy until the firmware aborts it. rp2040js
 * does that at once, but does not let the register be read, in which firmware waits for it.
 */
export function stall(dma, number) {
  const [channel] = dma.channels;
  const { start, scheduleTransfer } = channel;
  const { readUint32 } = dma;
  let started = 0;
  channel.start = () => {
    started += 1;
    start.call(channel);
  };
  channel.scheduleTransfer = () => {
    const isStalled = started === number && 2 * channel.transCount <= channel.transCountReload;
    if (!isStalled) scheduleTransfer.call(channel);
  };
  dma.readUint32 = (offset) => (offset === CHAN_ABORT ? 0 : readUint32.call(dma, offset));
}
