// The form: what is chosen in it becomes the state, and the state is shown in it.

import {
  DEPTHS,
  FARTHEST,
  HEIGHT,
  KINDS,
  LARGEST,
  METHODS,
  MOST_ITEMS,
  MOST_POINTS,
  POT,
  POTS,
  PRECISIONS,
  ROWS,
  WIDTH,
  isPolygon,
  neededPoints,
  picture,
  printable,
  read,
  rowsTitle,
  snapped,
} from "./state.js";

const element = (id) => document.getElementById(id);

function option(value, text) {
  const option = document.createElement("option");
  option.value = value;
  option.textContent = text;
  return option;
}

/** What a new item of a kind is. */
function newItem(kind) {
  const [x, y] = [WIDTH / 2, HEIGHT / 2];
  const points = {
    polygon: [
      [x, y - 40],
      [x + 35, y + 30],
      [x - 35, y + 30],
    ],
    even_odd: [
      [x - 40, y - 40],
      [x + 40, y - 40],
      [x - 40, y + 40],
      [x + 40, y + 40],
    ],
    line: [
      [x - 60, y + 20],
      [x + 60, y - 20],
    ],
    circle: [
      [x, y],
      [x + 40, y],
    ],
    text: [[x - 60, y]],
  }[kind];
  return { kind, color: "f4f4ec", size: { line: 4, text: 30 }[kind] ?? 0, points, text: kind === "text" ? "Text" : "" };
}

/** Whether two states show the same, however it is drawn. */
const hasSameThings = (one, { method, precision, rows, depth, ...other }) =>
  picture({ ...one, method, precision, rows, depth }) === picture({ ...other, method, precision, rows, depth });

/** All controls beside the panel. */
export class Controls {
  constructor(app) {
    this.app = app;
    element("preset").replaceChildren(
      ...app.data.presets.map(({ title }, index) => option(index, title)),
      option("own", "Your own"),
    );
    element("preset").addEventListener("change", ({ target }) => {
      const preset = app.data.presets[target.value];
      if (preset) app.load(read(preset.address));
    });
    this.choice("method", METHODS);
    this.choice("precision", PRECISIONS);
    this.choice("depth", DEPTHS);
    this.choice("pot", POTS);
    this.choice(
      "rows",
      ROWS.map((rows) => [rows, rowsTitle(rows)]),
      Number,
    );
    for (const id of ["turn", "tilt"])
      this.input(id, (state, { value }) => {
        state[id] = Number(value);
      });
    element("kind").replaceChildren(...KINDS.map(([name, title]) => option(name, title)));
    this.itemInputs();
    this.itemButtons();
    element("copy").addEventListener("click", () => this.copy());
  }

  choice(id, choices, convert = String) {
    element(id).replaceChildren(...choices.map(([name, title]) => option(name, title)));
    element(id).addEventListener("change", ({ target }) =>
      this.app.change((state) => {
        state[id] = convert(target.value);
      }),
    );
  }

  input(id, apply) {
    element(id).addEventListener("input", ({ target }) => this.app.change((state) => apply(state, target)));
  }

  itemInputs() {
    const ofItem = (id, apply) =>
      this.input(id, (state, target) => {
        const item = state.items[state.selected];
        if (item) apply(item, target.value, state);
      });
    // Any number may stand there, whatever the step of the buttons: it goes to the nearest 1/256 pixel. What is no number is "".
    const ofNumber = (id, low, high, apply) =>
      ofItem(id, (item, value, state) => {
        if (value !== "") apply(item, Math.min(Math.max(snapped(Number(value)), low), high), state);
      });
    ofItem("color", (item, value) => {
      item.color = value.slice(1);
    });
    ofNumber("size", 0, LARGEST, (item, pixels) => {
      item.size = pixels;
    });
    ofItem("text", (item, value) => {
      item.text = printable(value);
    });
    ["x", "y"].forEach((id, axis) =>
      ofNumber(id, -FARTHEST, FARTHEST, (item, pixels, state) => {
        item.points[state.point][axis] = pixels;
      }),
    );
  }

  itemButtons() {
    const { app } = this;
    const button = (id, apply) => element(id).addEventListener("click", () => app.change(apply));
    button("add", (state) => {
      if (state.items.length === MOST_ITEMS) return;
      state.items.push(newItem(element("kind").value));
      [state.selected, state.point, state.loupe] = [state.items.length - 1, 0, null];
    });
    button("remove", (state) => {
      state.items.splice(state.selected, 1);
      state.point = 0;
    });
    button("add-point", (state) => {
      const { points } = state.items[state.selected];
      if (points.length === MOST_POINTS) return;
      const [from, to] = [points[state.point], points[(state.point + 1) % points.length]];
      points.splice(
        state.point + 1,
        0,
        from.map((pixels, axis) => snapped((pixels + to[axis]) / 2)),
      );
      state.point += 1;
    });
    button("remove-point", (state) => {
      const { kind, points } = state.items[state.selected];
      if (points.length === neededPoints(kind)) return;
      points.splice(state.point, 1);
      state.point = Math.min(state.point, points.length - 1);
    });
  }

  async copy() {
    this.app.write();
    try {
      await navigator.clipboard.writeText(location.href);
      element("copied").textContent = "Copied.";
    } catch {
      element("copied").textContent = "The address of this page is the link.";
    }
  }

  show() {
    const { state, data } = this.app;
    const preset = data.presets.findIndex(({ address }) => hasSameThings(read(address), state));
    element("preset").value = preset < 0 ? "own" : preset;
    for (const id of ["method", "precision", "depth", "pot", "rows", "turn", "tilt"]) element(id).value = state[id];
    for (const id of ["turn", "tilt"]) element(id).disabled = state.pot === "none";
    this.showItems();
    this.showItem();
    element("copied").textContent = "";
  }

  showItems() {
    const { app } = this,
      { state } = app,
      list = element("items");
    const entry = (item, value) => {
      const label = document.createElement("label"),
        radio = document.createElement("input"),
        swatch = document.createElement("span");
      Object.assign(radio, { type: "radio", name: "item", value, checked: value === state.selected });
      radio.addEventListener("change", () => app.select(value, 0));
      swatch.className = "swatch";
      // The teapot has many colours.
      if (item.color) swatch.style.background = `#${item.color}`;
      else swatch.style.visibility = "hidden";
      label.append(radio, swatch, app.title(item));
      return label;
    };
    const entries = state.items.map(entry);
    if (state.pot !== "none") entries.unshift(entry({ kind: POT }, POT));
    const hasFocus = list.contains(document.activeElement);
    list.replaceChildren(...entries);
    if (hasFocus) list.querySelector("input:checked")?.focus();
    element("add").disabled = state.items.length === MOST_ITEMS;
    element("remove").disabled = !state.items[state.selected];
  }

  showItem() {
    const { state } = this.app,
      item = state.items[state.selected];
    element("item").hidden = !item;
    if (!item) return;
    const set = (id, value) => {
      if (element(id) !== document.activeElement || element(id).type === "color") element(id).value = value;
    };
    set("color", `#${item.color}`);
    set("size", item.size);
    set("text", item.text);
    set("x", item.points[state.point][0]);
    set("y", item.points[state.point][1]);
    element("size-label").textContent = item.kind === "text" ? "Size, px" : "Width, px";
    element("point-label").textContent = `Point ${state.point + 1}, x`;
    const show = (id, isShown) => {
      element(id).closest(".field, .bar").hidden = !isShown;
    };
    show("size", item.kind === "line" || item.kind === "text");
    show("text", item.kind === "text");
    show("polygon-bar", isPolygon(item));
    element("add-point").disabled = item.points.length === MOST_POINTS;
    element("remove-point").disabled = item.points.length === neededPoints(item.kind);
  }
}
