// The exact area of an outline in a pixel, in double precision: independent of how the library computes it. The error of a
// method is the difference between its coverage and this.
//
// A pixel is the square of side 1 around its centre, which has whole coordinates.

/** The edges of a closed contour, each from one point to the next. */
export const contourEdges = (points) => points.map((to, index) => [...points.at(index - 1), ...to]);

/** The edges of faces, clockwise, without those that two faces share: each of them goes one way and the other. */
export function contour(edges) {
  const left = new Map();
  for (const edge of edges) {
    const [x0, y0, x1, y1] = edge,
      back = [x1, y1, x0, y0].join();
    if (left.get(back)?.length) left.get(back).pop();
    else left.set(edge.join(), [...(left.get(edge.join()) ?? []), edge]);
  }
  return [...left.values()].flat();
}

/** The corners of the rectangle around a line of some width. */
export function lineCorners([[x0, y0], [x1, y1]], width) {
  const length = Math.hypot(x1 - x0, y1 - y0);
  if (length === 0) return [];
  const nx = ((-(y1 - y0) / length) * width) / 2,
    ny = (((x1 - x0) / length) * width) / 2;
  return [
    [x0 + nx, y0 + ny],
    [x1 + nx, y1 + ny],
    [x1 - nx, y1 - ny],
    [x0 - nx, y0 - ny],
  ];
}

/**
 * The part of a pixel that lies inside of edges [x0, y0, x1, y1].
 *
 * Between neighbouring heights at which an edge begins or ends, two edges cross, or one passes a side of the pixel, what lies
 * inside is a row of trapezoids: their mean widths are the widths half-way down, and the winding number tells which count.
 */
export function polygonArea(edges, isEvenOdd, column, row) {
  const [left, top] = [column - 0.5, row - 0.5],
    [right, bottom] = [left + 1, top + 1];
  const inRow = edges.filter(([, y0, , y1]) => Math.max(y0, y1) > top && Math.min(y0, y1) < bottom);
  const inPixel = inRow.filter(([x0, , x1]) => Math.max(x0, x1) >= left && Math.min(x0, x1) <= right);
  if (inPixel.length === 0) return insideLength(inRow, isEvenOdd, row, left, right);
  const heights = eventHeights(inPixel, [left, right], top, bottom);
  let area = 0;
  for (let index = 1; index < heights.length; index++) {
    const height = heights[index] - heights[index - 1];
    if (height > 0)
      area += height * insideLength(inRow, isEvenOdd, (heights[index] + heights[index - 1]) / 2, left, right);
  }
  return area;
}

const xAt = ([x0, y0, x1, y1], y) => x0 + ((y - y0) * (x1 - x0)) / (y1 - y0);

function eventHeights(edges, sides, top, bottom) {
  const heights = [top, bottom];
  const add = (y) => {
    if (y > top && y < bottom) heights.push(y);
  };
  edges.forEach((edge, index) => {
    const [x0, y0, x1, y1] = edge;
    add(y0);
    add(y1);
    if (x0 !== x1) for (const side of sides) add(y0 + ((side - x0) * (y1 - y0)) / (x1 - x0));
    for (const other of edges.slice(index + 1)) add(crossingHeight(edge, other));
  });
  return heights.sort((one, other) => one - other);
}

/** The height at which the lines through two edges cross; not a number where they are parallel. */
function crossingHeight([ax, ay, bx, by], [cx, cy, dx, dy]) {
  const across = (bx - ax) * (dy - cy) - (by - ay) * (dx - cx);
  const along = ((cx - ax) * (dy - cy) - (cy - ay) * (dx - cx)) / across;
  return ay + along * (by - ay);
}

/** How much of the level line at a height, between both sides, lies inside. */
function insideLength(edges, isEvenOdd, y, left, right) {
  const crossings = [];
  for (const edge of edges) {
    const [, y0, , y1] = edge;
    if (y0 <= y !== y1 <= y) crossings.push([xAt(edge, y), y0 < y1 ? 1 : -1]);
  }
  crossings.sort(([one], [other]) => one - other);
  let [winding, length] = [0, 0];
  crossings.forEach(([x, turn], index) => {
    winding += turn;
    if (isEvenOdd ? winding % 2 !== 0 : winding !== 0) {
      const end = crossings[index + 1]?.[0] ?? x;
      length += Math.max(Math.min(end, right) - Math.max(x, left), 0);
    }
  });
  return length;
}

/** The part of a pixel that lies inside of a circle: the integral of its half-chords, between both sides of the pixel. */
export function circleArea([x, y], radius, column, row) {
  const distance = Math.hypot(column - x, row - y);
  // No pixel reaches further than half its diagonal.
  if (radius === 0 || distance > radius + Math.SQRT1_2) return 0;
  if (distance < radius - Math.SQRT1_2) return 1;
  const [left, right] = [column - 0.5 - x, column + 0.5 - x].map((side) => Math.min(Math.max(side, -radius), radius));
  const [top, bottom] = [row - 0.5 - y, row + 0.5 - y];
  // Where the rim passes the upper or the lower side of the pixel.
  const cuts = [top, bottom]
    .filter((side) => Math.abs(side) < radius)
    .flatMap((side) => {
      const half = Math.sqrt(radius * radius - side * side);
      return [-half, half];
    });
  const ends = [left, ...cuts.filter((cut) => cut > left && cut < right), right].sort((one, other) => one - other);
  let area = 0;
  for (let index = 1; index < ends.length; index++) area += slabArea(radius, ends[index - 1], ends[index], top, bottom);
  return area;
}

/** Of a slab in which the rim passes neither the upper nor the lower side. */
function slabArea(radius, from, to, top, bottom) {
  const middle = (from + to) / 2,
    half = Math.sqrt(Math.max(radius * radius - middle * middle, 0));
  const integral = chordIntegral(radius, to) - chordIntegral(radius, from);
  const upper = -half > top ? -integral : top * (to - from);
  const lower = half < bottom ? integral : bottom * (to - from);
  return Math.max(lower - upper, 0);
}

/** The integral of the half-chord, from the middle on. */
function chordIntegral(radius, x) {
  const ratio = Math.min(Math.max(x / radius, -1), 1);
  return (x * Math.sqrt(Math.max(radius * radius - x * x, 0)) + radius * radius * Math.asin(ratio)) / 2;
}

/** Edges by the rows of pixels that they pass through. */
function byRows(edges) {
  const rows = new Map();
  for (const edge of edges) {
    const [, y0, , y1] = edge;
    for (let row = Math.round(Math.min(y0, y1)); row <= Math.round(Math.max(y0, y1)); row++) {
      if (!rows.has(row)) rows.set(row, []);
      rows.get(row).push(edge);
    }
  }
  return rows;
}

/** A function of column and row that gives the exact area of an item; `drawn` are the edges of a text or of the teapot. */
export function areaOf(item, drawn) {
  if (item.kind === "circle") {
    const [[x0, y0], [x1, y1]] = item.points;
    const radius = Math.hypot(x1 - x0, y1 - y0);
    return (column, row) => circleArea([x0, y0], radius, column, row);
  }
  const edges = edgesOf(item, drawn);
  const rows = byRows(edges);
  return (column, row) => (!rows.has(row) ? 0 : polygonArea(rows.get(row), item.kind === "even_odd", column, row));
}

/** The edges of an item that is no circle; `drawn` are those of a text or of the teapot. */
export function edgesOf(item, drawn) {
  if (!item.points || item.kind === "text") return drawn;
  return contourEdges(item.kind === "line" ? lineCorners(item.points, item.size) : item.points);
}

/** The rms and the largest error of a mask, in 1/255 of a pixel, over the pixels that an edge passes through or that differ. */
export function errors(mask, area, width, height) {
  let [sum, count, largest] = [0, 0, 0];
  for (let row = 0; row < height; row++) {
    for (let column = 0; column < width; column++) {
      const exact = 255 * area(column, row),
        error = Math.abs(mask[row * width + column] - exact);
      if ((exact > 1e-6 && exact < 255 - 1e-6) || error > 1e-6) {
        sum += error * error;
        count += 1;
        largest = Math.max(largest, error);
      }
    }
  }
  return { rms: Math.sqrt(sum / Math.max(count, 1)), largest, count };
}
