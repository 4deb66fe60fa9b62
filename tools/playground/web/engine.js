// The library as WebAssembly: texts and numbers go in, bytes come out of its memory.

import { POT, WIDTH, HEIGHT, picture } from "./state.js";
import { contour } from "./exact.js";

/** The most bytes of a state that the program has room for: `ADDRESS` in wasm/src/border.rs. */
export const MOST_BYTES = 8192;

/** Starts the program, which the page holds compressed, as base64. */
export async function start(base64) {
  const compressed = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
  const stream = new Blob([compressed]).stream().pipeThrough(new DecompressionStream("gzip"));
  const bytes = await new Response(stream).arrayBuffer();
  const { instance } = await WebAssembly.instantiate(bytes, {});
  return new Engine(instance.exports);
}

class Engine {
  constructor(exports) {
    this.exports = exports;
    this.encoder = new TextEncoder();
  }

  /** Draws a state; returns why not, or null. */
  draw(state) {
    const text = this.encoder.encode(picture(state));
    if (text.length > MOST_BYTES) return "The items have a longer text than the playground has memory for.";
    new Uint8Array(this.exports.memory.buffer, this.exports.address_buffer(), text.length).set(text);
    return this.exports.draw(text.length) === 0
      ? null
      : "An item has more edges than the playground has memory for.";
  }

  /** Red, green, blue and opacity of each pixel. */
  pixels() {
    return new Uint8ClampedArray(this.exports.memory.buffer, this.exports.pixel_buffer(), 4 * WIDTH * HEIGHT);
  }

  /** The coverage of each pixel by an item, or by the teapot. */
  cover(item) {
    if (item === POT) this.exports.cover_pot();
    else this.exports.cover(item);
    return new Uint8Array(this.exports.memory.buffer, this.exports.mask_buffer(), WIDTH * HEIGHT);
  }

  /** The edges of an item, in pixels, as it is drawn; of the teapot those between what faces the viewer and what does not. */
  edges(item) {
    if (item === POT) return contour(this.edgesOf(this.exports.pot_edges()));
    return this.edgesOf(this.exports.edges(item));
  }

  /** So many edges of the buffer. */
  edgesOf(count) {
    const numbers = new Int32Array(this.exports.memory.buffer, this.exports.edge_buffer(), 4 * count);
    return Array.from({ length: count }, (_, edge) =>
      Array.from(numbers.subarray(4 * edge, 4 * edge + 4), (units) => units / 256),
    );
  }

  /** Bytes of the band, the coverage of a row, the depths of a row, a frame buffer and a depth buffer. */
  footprint() {
    const [band, coverageRow, depthRow, frameBuffer, depthBuffer] = [0, 1, 2, 3, 4].map((which) =>
      this.exports.bytes(which),
    );
    return { band, coverageRow, depthRow, frameBuffer, depthBuffer };
  }
}
