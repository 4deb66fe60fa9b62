// The state of the playground, and how it stands in the address behind the `#`. The same text goes to the Rust code, which
// reads it by itself: tools/playground/scene/src/address.rs says what is in it.

export const WIDTH = 240;
export const HEIGHT = 320;
/** Units of a pixel: positions are kept in 1/256 pixel. */
export const UNITS = 256;
/** What stands for the teapot where an item is selected. */
export const POT = "pot";
export const MOST_ITEMS = 12;
export const MOST_POINTS = 16;

export const METHODS = [
  ["none", "None: all or nothing"],
  ["rooks_4", "4 samples, n-rooks"],
  ["rooks_16", "16 samples, n-rooks"],
  ["grid_4", "16 samples, grid of 4 × 4"],
  ["sub_scanlines_4", "4 sub-scanlines, exact in x"],
  ["signed_area", "Exact area, no crossings"],
  ["inside_area", "Exact area, with crossings"],
  ["exact", "Exact area, cheaper of both"],
];
export const PRECISIONS = [
  ["whole", "whole pixels"],
  ["sub4", "1/16 px (Sub4)"],
  ["sub8", "1/256 px (Sub8)"],
];
export const DEPTHS = [
  ["rgb888", "RGB888"],
  ["rgb565", "RGB565"],
  ["dithered_rgb565", "RGB565, dithered"],
  ["gray4", "16 greys, dithered"],
  ["binary", "black and white, dithered"],
];
export const POTS = [
  ["none", "none"],
  ["flat", "a colour a face"],
  ["flat_lit", "lit, flat shading"],
  ["gouraud", "lit, Gouraud shading"],
  ["silhouettes", "Gouraud, smooth silhouettes"],
  ["textured", "lit and textured"],
  ["translucent", "translucent"],
  ["foggy", "in a fog"],
];
export const KINDS = [
  ["polygon", "Polygon"],
  ["even_odd", "Polygon, even-odd"],
  ["line", "Line"],
  ["circle", "Circle"],
  ["text", "Text"],
];
/** Rows of a band; 0 stands for all. */
export const ROWS = [1, 2, 3, 4, 6, 8, 12, 16, 0];

/** What a height of bands is called. */
export const rowsTitle = (rows) => (rows === 0 ? `all ${HEIGHT} rows` : rows === 1 ? "1 row" : `${rows} rows`);

const NEEDED_POINTS = { polygon: 3, even_odd: 3, line: 2, circle: 2, text: 1 };
/** The farthest coordinate of a point, in pixels. */
export const FARTHEST = 1280;
/** The largest width of a line and size of a text, in pixels. */
export const LARGEST = 320;

const names = (choices) => choices.map(([name]) => name);
const clamp = (value, low, high) => Math.min(Math.max(value, low), high);

/** A number of pixels as it is kept: a multiple of 1/256. */
export const snapped = (pixels) => Math.round(pixels * UNITS) / UNITS;

/** The least points that an item of a kind has. */
export const neededPoints = (kind) => NEEDED_POINTS[kind];

/** Whether an item is a polygon, whose points can be added and removed. */
export const isPolygon = (item) => item.kind === "polygon" || item.kind === "even_odd";

export function emptyState() {
  return {
    pot: "none",
    turn: 496,
    tilt: 504,
    method: "exact",
    precision: "sub8",
    rows: 1,
    depth: "rgb565",
    items: [],
    // What the picture does not depend on: the selected item (or the teapot) and point, and the upper left pixel of the loupe.
    selected: 0,
    point: 0,
    loupe: null,
  };
}

/** Reads a state; what cannot be read is left out. */
export function read(address) {
  const state = emptyState();
  for (const pair of address.split("&")) {
    const at = pair.indexOf("=");
    if (at > 0) set(state, pair.slice(0, at), pair.slice(at + 1));
  }
  return select(state, state.selected, state.point);
}

/** Selects an item or the teapot, and a point, or the nearest that there is. */
export function select(state, selected, point) {
  const { items } = state,
    hasPot = state.pot !== "none";
  const isPot = hasPot && (selected === POT || items.length === 0);
  const index = selected === POT ? 0 : clamp(selected, 0, Math.max(items.length - 1, 0));
  state.selected = isPot ? POT : index;
  state.point = clamp(point, 0, Math.max((items[state.selected]?.points.length ?? 1) - 1, 0));
  return state;
}

/** What is selected: an item, the teapot, or nothing. */
export function selectedOf(state) {
  if (state.selected === POT) return { kind: POT };
  return state.items[state.selected];
}

function set(state, key, value) {
  const choose = (choices) => {
    if (names(choices).includes(value)) state[key] = value;
  };
  const whole = (most, apply) => {
    if (/^\d{1,9}$/.test(value)) state[key] = apply(Number(value), most);
  };
  switch (key) {
    case "pot":
      return choose(POTS);
    case "method":
      return choose(METHODS);
    case "precision":
      return choose(PRECISIONS);
    case "depth":
      return choose(DEPTHS);
    case "turn":
    case "tilt":
      return whole(512, (number, turn) => number % turn);
    case "rows":
      return whole(16, Math.min);
    case "selected":
      if (value === POT) state.selected = POT;
      return whole(MOST_ITEMS - 1, Math.min);
    case "point":
      return whole(MOST_POINTS - 1, Math.min);
    case "loupe": {
      const position = readPoint(value);
      if (position) state.loupe = position.map(Math.round);
      return;
    }
    case "item": {
      const item = readItem(value);
      if (item && state.items.length < MOST_ITEMS) state.items.push(item);
    }
  }
}

function readItem(value) {
  const [kind, color, size, points = "", text = ""] = value.split(",");
  if (!Object.hasOwn(NEEDED_POINTS, kind) || !/^[0-9a-f]{6}$/i.test(color) || !isDecimal(size)) return null;
  const read = points.split(";").map(readPoint).filter(Boolean).slice(0, MOST_POINTS);
  if (read.length < NEEDED_POINTS[kind]) return null;
  return {
    kind,
    color: color.toLowerCase(),
    size: clamp(snapped(Number(size)), 0, LARGEST),
    points: read,
    text: decode(text),
  };
}

const isDecimal = (text) => /^-?\d{1,4}(\.\d{0,8})?$/.test(text ?? "");

function readPoint(text) {
  const [x, y] = text.split(":");
  return isDecimal(x) && isDecimal(y)
    ? [x, y].map((number) => clamp(snapped(Number(number)), -FARTHEST, FARTHEST))
    : null;
}

function decode(text) {
  try {
    return printable(decodeURIComponent(text));
  } catch {
    return "";
  }
}

/** The letters of a text that the font has. */
export const printable = (text) => text.replace(/[^ -~]/g, "?").slice(0, 24);

/** The text that names the picture: what goes to the Rust code. */
export function picture(state) {
  const { pot, turn, tilt, method, precision, rows, depth } = state;
  const pairs = Object.entries({ pot, turn, tilt, method, precision, rows, depth }).map((pair) => pair.join("="));
  return [...pairs, ...state.items.map((item) => `item=${writeItem(item)}`)].join("&");
}

/** The text that stands in the address: the picture, and what is looked at. */
export function address(state) {
  const looked = [`selected=${state.selected}`, `point=${state.point}`];
  if (state.loupe) looked.push(`loupe=${state.loupe.join(":")}`);
  return [picture(state), ...looked].join("&");
}

export function writeItem({ kind, color, size, points, text }) {
  const parts = [kind, color, size, points.map((point) => point.join(":")).join(";")];
  // A comma and an ampersand would end the text.
  if (kind === "text") parts.push(encodeURIComponent(text));
  return parts.join(",");
}
