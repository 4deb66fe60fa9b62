// The exact areas of the page, against areas that are known and against plain counting of points.

import assert from "node:assert/strict";
import { test } from "node:test";

import { areaOf, circleArea, contour, contourEdges, errors, lineCorners, polygonArea } from "../web/exact.js";

/** Random numbers from 0 to 1: a generator of Park and Miller. */
function random(seed) {
  let state = seed;
  return () => (state = (state * 48271) % 2147483647) / 2147483647;
}

const near = (actual, expected, tolerance, message) =>
  assert.ok(Math.abs(actual - expected) <= tolerance, `${message}: ${actual}, not ${expected}`);

/** The part of a pixel that lies inside, by points on a fine grid. */
function counted(isInside, column, row, points = 100) {
  let count = 0;
  for (let index = 0; index < points * points; index++) {
    const [x, y] = [index % points, Math.floor(index / points)].map((step) => (step + 0.5) / points - 0.5);
    if (isInside(column + x, row + y)) count += 1;
  }
  return count / (points * points);
}

/** How often a contour winds around a point, by its angles. */
function winding(points, x, y) {
  let turned = 0;
  for (const [x0, y0, x1, y1] of contourEdges(points)) {
    const [ax, ay, bx, by] = [x0 - x, y0 - y, x1 - x, y1 - y];
    turned += Math.atan2(ax * by - ay * bx, ax * bx + ay * by);
  }
  return Math.round(turned / (2 * Math.PI));
}

test("half of the pixel in which a bow tie crosses itself is inside", () => {
  const bowTie = {
    kind: "polygon",
    points: [
      [1.5, 1.5],
      [8.5, 1.5],
      [1.5, 8.5],
      [8.5, 8.5],
    ],
  };
  near(areaOf(bowTie)(5, 5), 0.5, 1e-12, "the crossing");
});

test("polygons have the areas that counting finds, by both rules", () => {
  const next = random(20261129);
  for (let round = 0; round < 40; round++) {
    const points = Array.from({ length: 3 + (round % 6) }, () => [next() * 5, next() * 5]);
    for (const isEvenOdd of [false, true]) {
      const isInside = (x, y) => (isEvenOdd ? winding(points, x, y) % 2 !== 0 : winding(points, x, y) !== 0);
      const [column, row] = [Math.floor(next() * 5), Math.floor(next() * 5)];
      near(
        polygonArea(contourEdges(points), isEvenOdd, column, row),
        counted(isInside, column, row),
        0.012,
        `round ${round}`,
      );
    }
  }
});

test("level edges within a pixel are seen, also where no other edge passes through it", () => {
  const area = areaOf(
    {
      kind: "polygon",
      points: [
        [0, 2],
        [9, 2],
        [9, 5.25],
        [0, 5.25],
      ],
    },
    [],
  );
  for (const [column, row, expected] of [
    [4, 2, 0.5],
    [0, 2, 0.25],
    [4, 3, 1],
    [4, 5, 0.75],
    [4, 6, 0],
    [9, 5, 0.375],
    [10, 3, 0],
  ]) {
    near(area(column, row), expected, 1e-12, `pixel ${column}, ${row}`);
  }
});

test("circles have the areas that counting finds, and add up to pi times the square of the radius", () => {
  const next = random(7);
  for (let round = 0; round < 40; round++) {
    const [x, y, radius] = [next() * 4, next() * 4, 0.1 + next() * 4];
    const [column, row] = [Math.floor(next() * 8) - 2, Math.floor(next() * 8) - 2];
    const isInside = (px, py) => Math.hypot(px - x, py - y) < radius;
    near(circleArea([x, y], radius, column, row), counted(isInside, column, row), 0.012, `round ${round}`);
    let sum = 0;
    for (let index = 0; index < 400; index++)
      sum += circleArea([x, y], radius, (index % 20) - 8, Math.floor(index / 20) - 8);
    near(sum, Math.PI * radius * radius, 1e-9, `sum of round ${round}`);
  }
});

test("a line is as large as its length times its width", () => {
  const corners = lineCorners(
    [
      [2.25, 3.5],
      [17, 9.75],
    ],
    3,
  );
  const area = areaOf({
    kind: "line",
    points: [
      [2.25, 3.5],
      [17, 9.75],
    ],
    size: 3,
  });
  let sum = 0;
  for (let index = 0; index < 400; index++) sum += area(index % 20, Math.floor(index / 20));
  near(sum, 3 * Math.hypot(14.75, 6.25), 1e-9, "the sum");
  assert.equal(corners.length, 4);
});

test("errors are those of the edge pixels", () => {
  // Exactly: 128, 255, 127.5 of 255; the mask is half a step too high in the first and one too low in the last.
  const area = (column) => [127.5 / 255, 1, 127.5 / 255, 0][column];
  const { rms, largest, count } = errors([128, 255, 126.5, 0], area, 4, 1);
  assert.equal(count, 2);
  near(largest, 1, 1e-9, "the largest");
  near(rms, Math.sqrt((0.25 + 1) / 2), 1e-9, "the rms");
});

test("the contour of faces has no edge that two of them share", () => {
  const next = random(11);
  for (let round = 0; round < 50; round++) {
    // A fan around a point, with one face missing, and a face by itself that lies twice over it.
    const middle = [next() * 4, next() * 4];
    const rim = Array.from({ length: 7 }, (_, index) => {
      const angle = (index / 7) * 2 * Math.PI;
      return [middle[0] + (1 + next()) * Math.cos(angle), middle[1] + (1 + next()) * Math.sin(angle)];
    });
    const faces = rim.slice(1).map((to, index) => [middle, rim[index], to]);
    const alone = [
      [0, 0],
      [5, 1],
      [1, 5],
    ];
    const edges = [...faces, alone, alone].flatMap(contourEdges),
      left = contour(edges);
    assert.equal(left.length, 6 + 2 + 3 + 3);
    for (let row = 0; row < 5; row++) {
      for (let column = 0; column < 5; column++) {
        near(polygonArea(left, false, column, row), polygonArea(edges, false, column, row), 1e-12, "area");
      }
    }
  }
});
