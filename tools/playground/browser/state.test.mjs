// The state of the page and its address.

import assert from "node:assert/strict";
import { test } from "node:test";

import { address, picture, read } from "../web/state.js";

test("an address that was written is read as what it was", () => {
  const text =
    "pot=flat&turn=88&tilt=504&method=rooks_4&precision=sub4&rows=4&depth=gray4" +
    "&item=text,ff8000,23.5,10:20.25,42%20km%2Fh%2C%26&item=line,00ff00,3,1:2;3:-4.00390625";
  assert.equal(picture(read(text)), text);
  const looked = `${text}&selected=1&point=1&loupe=12:34`;
  assert.equal(address(read(looked)), looked);
  assert.equal(read(looked).items[0].text, "42 km/h,&");
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
