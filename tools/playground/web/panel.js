// The panel: the picture, and on it the points of the selected item, which are buttons.

import { WIDTH, HEIGHT, snapped } from "./state.js";

/** Units of 1/256 pixel to which a point is dragged. */
const DRAG_STEP = 64;
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

/** The direction of an arrow key, or undefined. */
export const direction = (event) => (event.ctrlKey || event.altKey || event.metaKey ? undefined : ARROWS[event.key]);

/** The buttons of the points, and what the pointer does on the picture. */
export class Panel {
  constructor(app) {
    this.app = app;
    this.element = document.getElementById("panel");
    this.canvas = document.getElementById("picture");
    this.handles = document.getElementById("handles");
    this.context = this.canvas.getContext("2d");
    this.canvas.addEventListener("pointerdown", (event) => this.press(event));
  }

  /** Shows the first rows of the picture; the others dimmed. */
  show(rows) {
    const image = new ImageData(new Uint8ClampedArray(this.app.engine.pixels()), WIDTH, HEIGHT);
    for (let index = 4 * WIDTH * rows + 3; index < image.data.length; index += 4) image.data[index] = 48;
    this.context.putImageData(image, 0, 0);
  }

  /** Puts the buttons where the points of the selected item are. */
  place() {
    const { state } = this.app,
      item = state.items[state.selected],
      points = item?.points ?? [];
    while (this.handles.children.length > points.length) this.handles.lastChild.remove();
    while (this.handles.children.length < points.length) this.handles.append(this.handle(this.handles.children.length));
    points.forEach(([x, y], index) => {
      const handle = this.handles.children[index];
      handle.style.left = `${(100 * (x + 0.5)) / WIDTH}%`;
      handle.style.top = `${(100 * (y + 0.5)) / HEIGHT}%`;
      handle.setAttribute("aria-label", `${this.app.title(item)}, point ${index + 1} of ${points.length}: ${x}, ${y}`);
      handle.classList.toggle("selected", index === state.point);
    });
  }

  handle(index) {
    const handle = document.createElement("button");
    handle.type = "button";
    handle.className = "handle";
    handle.addEventListener("focus", () => this.app.select(this.app.state.selected, index));
    handle.addEventListener("pointerdown", (event) => {
      handle.setPointerCapture(event.pointerId);
      handle.focus();
      event.preventDefault();
    });
    handle.addEventListener("pointermove", (event) => {
      if (handle.hasPointerCapture(event.pointerId)) this.drag(index, event);
    });
    handle.addEventListener("keydown", (event) => this.key(index, event));
    return handle;
  }

  drag(index, event) {
    const step = event.shiftKey ? 1 : DRAG_STEP;
    this.app.movePoint(
      index,
      this.position(event).map((pixels) => snapped((Math.round((pixels * 256) / step) * step) / 256)),
    );
  }

  key(index, event) {
    const way = direction(event);
    if (!way) return;
    event.preventDefault();
    const { state } = this.app,
      step = event.shiftKey ? 16 : Number(document.getElementById("move").value);
    const point = state.items[state.selected].points[index];
    this.app.movePoint(
      index,
      point.map((pixels, axis) => pixels + (way[axis] * step) / 256),
    );
  }

  /** Where the pointer is, in pixels of the panel. */
  position(event) {
    const box = this.canvas.getBoundingClientRect();
    return [
      ((event.clientX - box.left) / box.width) * WIDTH - 0.5,
      ((event.clientY - box.top) / box.height) * HEIGHT - 0.5,
    ];
  }

  /** A click selects what is on top there, an item or the teapot, or moves the loupe; dragging turns the teapot. */
  press(event) {
    const { app } = this,
      start = this.position(event),
      { turn, tilt } = app.state;
    const [column, row] = start.map(Math.round);
    const item = app.itemAt(column, row);
    if (item !== undefined) app.select(item, 0);
    app.change((state) => {
      state.loupe = app.loupeAround([column, row]);
    });
    if (typeof item === "number" || app.state.pot === "none") return;
    this.canvas.setPointerCapture(event.pointerId);
    const move = (moved) => {
      const [x, y] = this.position(moved);
      app.change((state) => {
        state.turn = (((turn - Math.round(x - start[0])) % 512) + 512) % 512;
        state.tilt = (((tilt - Math.round(y - start[1])) % 512) + 512) % 512;
      });
    };
    this.canvas.addEventListener("pointermove", move);
    const release = () => this.canvas.removeEventListener("pointermove", move);
    for (const end of ["pointerup", "pointercancel"]) this.canvas.addEventListener(end, release, { once: true });
  }
}
