// The loupe: some pixels magnified 16 times, and beside them the error of their coverage as a heat map.

import { POT, WIDTH, HEIGHT, picture, selectedOf } from "./state.js";
import { areaOf, edgesOf, errors } from "./exact.js";
import { direction } from "./panel.js";

const ZOOM = 16;
export const LOUPE_COLUMNS = 20;
export const LOUPE_ROWS = 16;
/** All pixels are looked through so long after the last change, in milliseconds. */
const CALM = 120;
const MIDDLE = [LOUPE_COLUMNS / 2, LOUPE_ROWS / 2];
/** An error of this many 1/255 has the strongest colour. */
const STRONGEST = 127;

/** What the error of an item is measured against, where it is not the shape itself. */
const MEASURED = { text: "its flattened outline", [POT]: "all faces that are turned to the viewer" };

/** The uppermost end of edges; the middle of the panel without edges. */
const uppermost = (edges) =>
  edges.reduce(([x, y], [x0, y0]) => (y0 < y ? [x0, y0] : [x, y]), edges[0]?.slice(0, 2) ?? [WIDTH / 2, HEIGHT / 2]);

/** A number with three digits. */
const digits = (number) => (number === 0 ? "0" : number >= 100 ? number.toFixed(0) : number.toPrecision(3));

/** A colour of the style sheet, in light or dark as the page is. */
function color(name) {
  const probe = document.getElementById("scale");
  probe.style.accentColor = `var(${name})`;
  return getComputedStyle(probe).accentColor;
}

/** The upper left pixel of a loupe around a position, all of it on the panel. */
export function around([x, y]) {
  const clamp = (first, most) => Math.min(Math.max(Math.round(first), 0), most);
  return [clamp(x - LOUPE_COLUMNS / 2, WIDTH - LOUPE_COLUMNS), clamp(y - LOUPE_ROWS / 2, HEIGHT - LOUPE_ROWS)];
}

/** The strength and the direction of a colour: the logarithm of the error, so that small ones are seen. */
const strength = (error) => Math.sign(error) * Math.min(Math.log2(1 + Math.abs(error)) / Math.log2(1 + STRONGEST), 1);

function mixed(error, colors) {
  const amount = strength(error),
    to = amount < 0 ? colors.less : colors.more;
  return `color-mix(in oklab, ${to} ${Math.round(100 * Math.abs(amount))}%, ${colors.none})`;
}

/** Both canvases of the loupe and the sentence below them. */
export class Loupe {
  constructor(app) {
    this.app = app;
    this.picture = document.getElementById("loupe");
    this.heat = document.getElementById("heat");
    /** The pixel under the pointer, counted from the upper left one of the loupe; otherwise the one in the middle. */
    this.pixel = MIDDLE;
    for (const canvas of [this.picture, this.heat]) {
      canvas.addEventListener("pointermove", (event) => this.point(this.pixelAt(canvas, event)));
      canvas.addEventListener("pointerleave", () => this.point(MIDDLE));
    }
    this.picture.addEventListener("keydown", (event) => {
      const way = direction(event);
      if (!way) return;
      event.preventDefault();
      const step = event.shiftKey ? 8 : 1,
        corner = this.corner();
      app.change((state) => {
        state.loupe = this.inside(corner.map((first, axis) => first + way[axis] * step));
      });
    });
  }

  pixelAt(canvas, event) {
    const box = canvas.getBoundingClientRect();
    const index = (at, size, count) => Math.min(Math.max(Math.floor((at / size) * count), 0), count - 1);
    return [
      index(event.clientX - box.left, box.width, LOUPE_COLUMNS),
      index(event.clientY - box.top, box.height, LOUPE_ROWS),
    ];
  }

  point(pixel) {
    if (pixel.join() === this.pixel.join()) return;
    this.pixel = pixel;
    this.show();
  }

  inside([x, y]) {
    return around([x + LOUPE_COLUMNS / 2, y + LOUPE_ROWS / 2]);
  }

  /** The upper left pixel: where the loupe was put, or around the selected point. */
  corner() {
    const { state, engine } = this.app;
    if (state.loupe) return this.inside(state.loupe);
    if (state.selected === POT) return around(uppermost(engine.edges(POT)));
    return around(state.items[state.selected]?.points[state.point] ?? [WIDTH / 2, HEIGHT / 2]);
  }

  show() {
    const corner = this.corner(),
      { state, engine } = this.app,
      item = selectedOf(state),
      drawn = item && engine.edges(state.selected);
    const frame = document.getElementById("frame").style;
    [frame.left, frame.top] = [`${(100 * corner[0]) / WIDTH}%`, `${(100 * corner[1]) / HEIGHT}%`];
    [frame.width, frame.height] = [`${(100 * LOUPE_COLUMNS) / WIDTH}%`, `${(100 * LOUPE_ROWS) / HEIGHT}%`];
    this.magnify(corner, item, drawn);
    this.mark(this.picture);
    if (item) this.showError(corner, item, engine.cover(state.selected), drawn);
    else this.clear();
  }

  magnify([left, top], item, drawn) {
    const context = this.picture.getContext("2d"),
      pixels = this.app.engine.pixels();
    this.each(([column, row, x, y]) => {
      const at = 4 * ((top + row) * WIDTH + left + column);
      context.fillStyle = `rgb(${pixels[at]} ${pixels[at + 1]} ${pixels[at + 2]})`;
      context.fillRect(x, y, ZOOM, ZOOM);
    });
    if (item)
      this.outline(context, [left, top], item, drawn, [
        ["#000c", 3],
        ["#fffc", 1],
      ]);
  }

  /** The exact outline, in strokes of a colour and a width one over the other. */
  outline(context, [left, top], item, drawn, strokes) {
    const place = ([x, y]) => [(x + 0.5 - left) * ZOOM, (y + 0.5 - top) * ZOOM];
    const path = new Path2D();
    if (item.kind === "circle") {
      const [[x0, y0], [x1, y1]] = item.points;
      path.arc(...place([x0, y0]), Math.hypot(x1 - x0, y1 - y0) * ZOOM, 0, 2 * Math.PI);
    } else {
      for (const [x0, y0, x1, y1] of edgesOf(item, drawn)) {
        path.moveTo(...place([x0, y0]));
        path.lineTo(...place([x1, y1]));
      }
    }
    for (const [style, width] of strokes) {
      context.strokeStyle = style;
      context.lineWidth = width;
      context.stroke(path);
    }
  }

  showError([left, top], item, mask, drawn) {
    const area = areaOf(item, drawn),
      context = this.heat.getContext("2d"),
      colors = this.colors();
    this.each(([column, row, x, y]) => {
      const at = (top + row) * WIDTH + left + column,
        exact = 255 * area(left + column, top + row);
      context.fillStyle = mixed(mask[at] - exact, colors);
      context.fillRect(x, y, ZOOM, ZOOM);
    });
    this.outline(context, [left, top], item, drawn, [[colors.line, 1]]);
    this.mark(this.heat);
    this.showPixel([left, top], mask, area);
    document.getElementById("heat-text").textContent =
      "Error: coverage less the exact area, in 1/255 of a pixel. Blue is too little, red too much.";
    this.showScale(colors);
    this.tellErrors(item, area);
  }

  /** Looks through all pixels when nothing has changed for a while; what only moves the loupe changes nothing. */
  tellErrors(item, area) {
    const { state, engine } = this.app,
      text = document.getElementById("error-text"),
      shown = `${picture(state)} ${state.selected}`;
    if (text.dataset.shown === shown) return;
    clearTimeout(this.timer);
    this.timer = setTimeout(() => {
      const { rms, largest, count } = errors(engine.cover(state.selected), area, WIDTH, HEIGHT);
      const of = MEASURED[item.kind] ?? "what is drawn in exact arithmetic";
      text.dataset.shown = shown;
      text.textContent =
        `${this.app.title(item)} on ${count} edge pixels: rms error ` +
        `${digits(rms)}, largest ${digits(largest)} of 255, against the exact area of ${of}.`;
    }, CALM);
  }

  showPixel(corner, mask, area) {
    const [column, row] = corner.map((first, axis) => first + this.pixel[axis]);
    const coverage = mask[row * WIDTH + column],
      exact = 255 * area(column, row);
    document.getElementById("pixel-text").textContent =
      `Pixel ${column}, ${row}: coverage ${coverage}, exactly ${exact.toFixed(2)}.`;
  }

  /** A frame around the pixel that is told about. */
  mark(canvas) {
    const context = canvas.getContext("2d"),
      [x, y] = this.pixel.map((index) => index * ZOOM);
    for (const [style, inset] of [
      ["#000", 0.5],
      ["#fff", 1.5],
    ]) {
      context.strokeStyle = style;
      context.lineWidth = 1;
      context.strokeRect(x + inset, y + inset, ZOOM - 2 * inset, ZOOM - 2 * inset);
    }
  }

  clear() {
    clearTimeout(this.timer);
    delete document.getElementById("error-text").dataset.shown;
    document.getElementById("pixel-text").textContent = "";
    this.heat.getContext("2d").clearRect(0, 0, this.heat.width, this.heat.height);
    document.getElementById("heat-text").textContent = "Select an item or the teapot to see the error of its coverage.";
    document.getElementById("error-text").textContent = "";
  }

  colors() {
    return { less: color("--less"), more: color("--more"), none: color("--none"), line: color("--quiet") };
  }

  showScale(colors) {
    const scale = document.getElementById("scale-colors"),
      context = scale.getContext("2d");
    for (let x = 0; x < scale.width; x++) {
      const amount = (2 * x) / (scale.width - 1) - 1;
      const error = Math.sign(amount) * (2 ** (Math.abs(amount) * Math.log2(1 + STRONGEST)) - 1);
      context.fillStyle = mixed(error, colors);
      context.fillRect(x, 0, 1, 1);
    }
  }

  /** Calls with column, row, and the position on the canvas, of each pixel. */
  each(call) {
    for (let row = 0; row < LOUPE_ROWS; row++) {
      for (let column = 0; column < LOUPE_COLUMNS; column++) call([column, row, column * ZOOM, row * ZOOM]);
    }
  }
}
