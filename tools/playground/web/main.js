// Puts the page together: a change of the state draws the picture, and shows everything that depends on it.

import { FARTHEST, KINDS, POT, WIDTH, address, picture, read, select } from "./state.js";
import { start } from "./engine.js";
import { Panel } from "./panel.js";
import { Loupe, around } from "./loupe.js";
import { Scan } from "./scan.js";
import { Controls } from "./controls.js";
import { showCounts, showMemory } from "./report.js";

/** The address is written so long after the last change, in milliseconds: browsers limit how often. */
const QUIET = 200;

class App {
  constructor(engine, data) {
    Object.assign(this, { engine, data });
    this.state = this.named();
    this.panel = new Panel(this);
    this.loupe = new Loupe(this);
    this.scan = new Scan(this);
    this.controls = new Controls(this);
    addEventListener("hashchange", () => {
      if (location.hash.slice(1) !== address(this.state)) this.load(this.named(), false);
    });
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.draw());
    this.draw();
  }

  /** The state that the address names; the first preset where it names none. */
  named() {
    const text = location.hash.slice(1);
    return read(text === "" ? this.data.presets[0].address : text);
  }

  load(state, isWritten = true) {
    this.state = state;
    this.draw();
    if (isWritten) this.writeSoon();
  }

  change(apply) {
    const { state } = this;
    apply(state);
    // The selected item may be gone.
    select(state, state.selected, state.point);
    this.draw();
    this.writeSoon();
  }

  select(item, point) {
    if (item === this.state.selected && point === this.state.point) return;
    this.change((state) => {
      [state.selected, state.point, state.loupe] = [item, point, null];
    });
  }

  movePoint(index, position) {
    this.change((state) => {
      const limited = position.map((pixels) => Math.min(Math.max(pixels, -FARTHEST), FARTHEST));
      state.items[state.selected].points[index] = limited;
      [state.point, state.loupe] = [index, null];
    });
  }

  /** The uppermost item that covers a pixel, the teapot, or nothing. */
  itemAt(column, row) {
    const covers = (item) => this.engine.cover(item)[row * WIDTH + column] > 0;
    const index = this.state.items.findLastIndex((_, item) => covers(item));
    if (index >= 0) return index;
    return this.state.pot !== "none" && covers(POT) ? POT : undefined;
  }

  loupeAround(position) {
    return around(position);
  }

  /** What an item is called. */
  title(item) {
    if (item.kind === POT) return "Teapot";
    return item.kind === "text" ? `Text “${item.text}”` : KINDS.find(([name]) => name === item.kind)[1];
  }

  draw() {
    const failure = document.getElementById("failure");
    failure.textContent = this.engine.draw(this.state) ?? "";
    failure.hidden = failure.textContent === "";
    this.controls.show();
    this.show();
    // For those who wait for it: which picture is shown.
    document.documentElement.dataset.picture = picture(this.state);
  }

  /** Shows what is drawn, and what is known of it. */
  show() {
    this.scan.show();
    this.panel.show(this.scan.rowsDrawn);
    this.panel.place();
    this.loupe.show();
    showMemory(this.engine.footprint());
    showCounts(this);
  }

  writeSoon() {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.write(), QUIET);
  }

  write() {
    history.replaceState(null, "", `#${address(this.state)}`);
  }
}

async function open() {
  const data = JSON.parse(document.getElementById("data").textContent);
  new App(await start(data.program), data);
  document.documentElement.dataset.ready = "true";
}

open().catch((error) => {
  console.error(error);
  const failure = document.getElementById("failure");
  failure.textContent = `The playground cannot start: ${error.message}`;
  failure.hidden = false;
});
