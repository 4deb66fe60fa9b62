// The state of the page and its address.

import assert from "node:assert/strict";
import { test } from "node:test";

import { MOST_BYTES } from "../web/engine.js";
import {
  DEPTHS,
  FARTHEST,
  METHODS,
  MOST_ITEMS,
  MOST_POINTS,
  POTS,
  PRECISIONS,
  address,
  picture,
  read,
  selectedOf,
} from "../web/state.js";

test("an address that was written is read as what it was", () => {
  const text =
    "pot=flat&turn=88&tilt=504&method=rooks_4&precision=sub4&rows=4&depth=gray4" +
    "&item=text,ff8000,23.5,10:20.25,42%20km%2Fh%2C%26&item=line,00ff00,3,1:2;3:-4.00390625";
  assert.equal(picture(read(text)), text);
  const looked = `${text}&selected=1&point=1&loupe=12:34`;
  assert.equal(address(read(looked)), looked);
  assert.equal(read(looked).items[0].text, "42 km/h,&");
});

test("a teapot is selected where an address says so, and where there is nothing else", () => {
  const item = "&item=circle,ff8000,0,10:10;20:10";
  for (const [text, selected, kind] of [
    [`pot=flat${item}&selected=pot`, "pot", "pot"],
    [`pot=none${item}&selected=pot`, 0, "circle"],
    [`pot=flat${item}`, 0, "circle"],
    ["pot=flat&selected=3", "pot", "pot"],
    ["pot=none", 0, undefined],
  ]) {
    const state = read(text);
    assert.equal(state.selected, selected, text);
    assert.equal(selectedOf(state)?.kind, kind, text);
    assert.equal(address(read(address(state))), address(state));
  }
});

test("what cannot be read is left out", () => {
  const state = read(
    "pot=kettle&rows=x&turn=-1&item=&item=line,00ff00,3,1:2&item=blob,000000,0,0:0" +
      "&item=toString,ff0000,0,1:1&item=__proto__,ff0000,0,1:1&item=text,000000,9,1:1,%&=&a&selected=9",
  );
  assert.equal(state.pot, "none");
  assert.deepEqual([state.rows, state.turn, state.selected], [1, 496, 0]);
  assert.deepEqual(
    state.items.map(({ kind, text }) => [kind, text]),
    [["text", ""]],
  );
});

test("positions are kept in 1/256 pixel", () => {
  assert.deepEqual(read("item=line,00ff00,3,1.001:2.3;9999:0").items[0].points, [
    [1, 2.30078125],
    [1280, 0],
  ]);
});

test("the program has room for the longest state", () => {
  const longest = (texts) => texts.toSorted((one, other) => other.length - one.length)[0];
  const named = (choices) => longest(choices.map(([name]) => name));
  const points = Array(MOST_POINTS).fill(Array(2).fill(-FARTHEST + 1 / 256).join(":")).join(";");
  const items = [`even_odd,ff8000,319.99609375,${points}`, `text,ff8000,319.99609375,${points},${"%2C".repeat(24)}`];
  const item = `item=${longest(items)}`;
  const keys = Object.entries({
    pot: named(POTS),
    turn: 496,
    tilt: 504,
    method: named(METHODS),
    precision: named(PRECISIONS),
    rows: 16,
    depth: named(DEPTHS),
  });
  const text = [...keys.map((pair) => pair.join("=")), ...Array(MOST_ITEMS).fill(item)].join("&");
  assert.equal(picture(read(text)), text);
  assert.ok(text.length <= MOST_BYTES, `${text.length} of ${MOST_BYTES} bytes`);
});
