// What the picture takes: bytes of memory, and what was counted on the chip.

import { HEIGHT, METHODS, POTS, read, rowsTitle, writeItem } from "./state.js";

const number = (value) => Math.round(value).toLocaleString("en");

/** A row of a table, whose first cell is its head. */
function tableRow(cells) {
  const row = document.createElement("tr");
  cells.forEach((text, index) => {
    const cell = document.createElement(index === 0 ? "th" : "td");
    if (index === 0) cell.scope = "row";
    cell.textContent = text;
    row.append(cell);
  });
  return row;
}

/** The memory of rows beside that of buffers of the whole panel. */
export function showMemory({ band, coverageRow, depthRow, frameBuffer, depthBuffer }) {
  const rows = band + coverageRow + depthRow,
    buffers = frameBuffer + depthBuffer + coverageRow;
  document.getElementById("memory-text").textContent =
    rows < buffers
      ? `${number(rows)} bytes instead of ${number(buffers)}: ${(buffers / rows).toFixed(rows * 10 < buffers ? 0 : 1)} times less.`
      : `${number(rows)} bytes: with a band of the whole panel, nothing is saved.`;
  const bars = document.getElementById("memory-bars");
  bars.replaceChildren(
    ...[
      ["Rows", rows],
      ["Buffers", buffers],
    ].flatMap(([title, bytes]) => {
      const [label, bar] = ["span", "span"].map((name) => document.createElement(name));
      label.textContent = title;
      bar.className = `bytes ${title.toLowerCase()}`;
      bar.style.width = `${Math.max((100 * bytes) / Math.max(rows, buffers), 0.4)}%`;
      return [label, bar];
    }),
  );
  document
    .querySelector("#memory-table tbody")
    .replaceChildren(
      tableRow(["Colours", number(band), number(frameBuffer)]),
      tableRow(["Depths", number(depthRow), number(depthBuffer)]),
      tableRow(["Coverage", number(coverageRow), number(coverageRow)]),
      tableRow(["All", number(rows), number(buffers)]),
    );
}

/** The counts of what a scene of the list has as it is here. */
export function showCounts(app) {
  const { state, data } = app,
    { figures, chip, counted } = data.counts;
  const rowsCounted = heightCounted(data, state.rows);
  const figure = (count, name) => figures[`${count}.${name}.${rowsCounted}`];
  const empty = figure(data.emptyCount, "draw");
  const method = METHODS.find(([name]) => name === state.method)[1];
  document.getElementById("counts-text").textContent =
    `A frame of RGB565 in bands of ${rowsTitle(rowsCounted)}, items by “${method}”, drawn anew in each band, counted on ` +
    `${chip} on ${counted}. Cycles are estimated. An item that no scene of the list has was not counted.`;
  const less = (whole) => whole?.map((count, index) => count - empty[index]);
  const rows = [["An empty frame", empty]];
  if (state.pot !== "none") {
    rows.push([`Teapot, ${POTS.find(([name]) => name === state.pot)[1]}`, less(figure(data.potCount, state.pot))]);
  }
  rows.push(...state.items.map((item) => [app.title(item), less(figure(nameOf(data, item), state.method))]));
  const all =
    rows.every(([, counts]) => counts) &&
    rows.map(([, counts]) => counts).reduce((sum, counts) => sum.map((one, index) => one + counts[index]));
  rows.push(["All", all]);
  document
    .querySelector("#counts-table tbody")
    .replaceChildren(
      ...rows.map(([title, counts]) => tableRow([title, ...(counts ? counts.map(number) : ["–", "–"])])),
    );
}

/** The largest height of bands that was counted and is not larger than a height; 0 stands for all rows. */
function heightCounted({ countedRows }, rows) {
  const height = (rows) => rows || HEIGHT;
  return countedRows.reduce((best, other) =>
    height(other) <= height(rows) && height(other) > height(best) ? other : best,
  );
}

/** What an item is called in the counts, if a scene of the list has it. */
function nameOf(data, item) {
  const written = writeItem(item);
  for (const { address, counts } of data.presets) {
    const index = read(address).items.findIndex((other) => writeItem(other) === written);
    if (index >= 0) return counts[index];
  }
  return undefined;
}
