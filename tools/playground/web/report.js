// What the picture takes: bytes of memory, and what was counted on the chip.

import { METHODS, POTS, read, writeItem } from "./state.js";

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
  const rows = band + coverageRow + depthRow, buffers = frameBuffer + depthBuffer + coverageRow;
  document.getElementById("memory-text").textContent = rows < buffers
    ? `${number(rows)} bytes instead of ${number(buffers)}: ${(buffers / rows).toFixed(rows * 10 < buffers ? 0 : 1)} times less.`
    : `${number(rows)} bytes: with a band of the whole panel, nothing is saved.`;
  const bars = document.getElementById("memory-bars");
  bars.replaceChildren(...[["rows", rows], ["buffers", buffers]].map(([name, bytes]) => {
    const bar = document.createElement("div");
    bar.className = `memory-bar ${name}`;
    bar.style.width = `${Math.max((100 * bytes) / Math.max(rows, buffers), 0.4)}%`;
    return bar;
  }));
  document.querySelector("#memory-table tbody").replaceChildren(
    tableRow(["Colours", number(band), number(frameBuffer)]),
    tableRow(["Depths", number(depthRow), number(depthBuffer)]),
    tableRow(["Coverage", number(coverageRow), number(coverageRow)]),
    tableRow(["All", number(rows), number(buffers)]),
  );
}

/** The counts of what stands in a preset as it is here. */
export function showCounts(app) {
  const { state, data } = app, { counts } = data;
  const method = METHODS.find(([name]) => name === state.method)[1];
  document.getElementById("counts-text").textContent =
    `Counted on ${counts.chip} on ${counts.counted}, in bands of one row of RGB565, preparing included: ${method}. ` +
    "Items that are not as a scene of the list has them were not counted.";
  const rows = state.items.map((item) => {
    const counted = countOf(app, item);
    return tableRow([app.title(item), ...(counted ? counted.map(number) : ["–", "–"])]);
  });
  if (state.pot !== "none") {
    const counted = counts.figures[`playground.pot.${state.pot}`];
    const look = POTS.find(([name]) => name === state.pot)[1];
    rows.unshift(tableRow([`Teapot, ${look}`, ...(counted ? counted.map(number) : ["–", "–"])]));
  }
  if (rows.length === 0) rows.push(tableRow(["Nothing", "", ""]));
  document.querySelector("#counts-table tbody").replaceChildren(...rows);
}

/** Instructions and cycles of an item, if a preset has it. */
function countOf(app, item) {
  const written = writeItem(item);
  for (const [preset, { address }] of app.data.presets.entries()) {
    const index = read(address).items.findIndex((other) => writeItem(other) === written);
    if (index >= 0) return app.data.counts.figures[`playground.${preset}.${index}.${app.state.method}`];
  }
  return undefined;
}
