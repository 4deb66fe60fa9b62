// The scan: bands go down the panel one after the other, as they are drawn and sent.

import { WIDTH, HEIGHT } from "./state.js";

/** A whole picture takes about so long, in milliseconds. */
const DURATION = 6000;

/** How many bands have been drawn, and the buttons for it. */
export class Scan {
  constructor(app) {
    this.app = app;
    /** The number of bands that are drawn; null for the whole picture. */
    this.drawn = null;
    this.playing = false;
    const on = (name, event, call) => document.getElementById(name).addEventListener(event, call);
    on("play", "click", () => (this.playing ? this.pause() : this.play()));
    on("step", "click", () => this.step());
    on("whole", "click", () => this.stop());
    on("position", "input", ({ target }) => {
      this.playing = false;
      this.drawn = Number(target.value);
      app.show();
    });
  }

  get rows() {
    return this.app.state.rows || HEIGHT;
  }

  get bands() {
    return Math.ceil(HEIGHT / this.rows);
  }

  /** Rows of the picture that are drawn. */
  get rowsDrawn() {
    return this.drawn === null ? HEIGHT : Math.min(this.drawn * this.rows, HEIGHT);
  }

  play() {
    if (this.drawn === null || this.drawn >= this.bands) this.drawn = 0;
    this.playing = true;
    let [start, first] = [null, this.drawn];
    const tick = (now) => {
      if (!this.playing) return;
      start ??= now;
      this.drawn = Math.min(first + Math.floor(((now - start) * this.bands) / DURATION) + 1, this.bands);
      if (this.drawn === this.bands) this.playing = false;
      this.app.show();
      requestAnimationFrame(tick);
    };
    requestAnimationFrame(tick);
  }

  pause() {
    this.playing = false;
    this.show();
  }

  step() {
    this.playing = false;
    this.drawn = this.drawn === null || this.drawn >= this.bands ? 1 : this.drawn + 1;
    this.app.show();
  }

  stop() {
    this.playing = false;
    this.drawn = null;
    this.app.show();
  }

  show() {
    if (this.drawn !== null) this.drawn = Math.min(this.drawn, this.bands);
    document.getElementById("play").textContent = this.playing ? "Pause" : "Play the scan";
    const position = document.getElementById("position");
    position.max = this.bands;
    position.value = this.drawn ?? this.bands;
    document.getElementById("band-number").textContent =
      this.drawn === null ? `all ${this.bands}` : `${this.drawn} of ${this.bands}`;
    const top = Math.max(Math.min(this.drawn ?? 1, this.bands) - 1, 0) * this.rows;
    const rows = Math.min(this.rows, HEIGHT - top);
    this.showMarker(top, rows);
    this.showBand(top, rows);
  }

  showMarker(top, rows) {
    const marker = document.getElementById("band");
    marker.hidden = this.drawn === null || this.drawn === 0;
    marker.style.top = `${(100 * top) / HEIGHT}%`;
    marker.style.height = `${(100 * rows) / HEIGHT}%`;
  }

  /** The words of the band, as memory holds them until the next one is drawn. */
  showBand(top, rows) {
    const figure = document.getElementById("band-figure");
    figure.hidden = this.drawn === null || this.drawn === 0 || this.rows === HEIGHT;
    if (figure.hidden) return;
    const canvas = document.getElementById("band-rows"),
      pixels = this.app.engine.pixels();
    canvas.height = rows;
    canvas.style.height = `${Math.max(Math.min(12 * rows, 96), 12)}px`;
    const image = new ImageData(
      new Uint8ClampedArray(pixels.subarray(4 * WIDTH * top, 4 * WIDTH * (top + rows))),
      WIDTH,
      rows,
    );
    canvas.getContext("2d").putImageData(image, 0, 0);
    const last = top + rows - 1,
      { band } = this.app.engine.footprint();
    document.getElementById("band-text").textContent =
      `${last === top ? `Row ${top}` : `Rows ${top} to ${last}`}: all of the picture that is in memory, ${band.toLocaleString("en")} bytes`;
  }
}
