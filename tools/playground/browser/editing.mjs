// A point is dragged by the mouse and moved by the keyboard; the picture and the address follow.

import assert from "node:assert/strict";

/** Longer than the page waits before it writes the address. */
const WRITTEN = 400;

export async function checkEditing(page, url, checksum) {
  await page.goto(`${url}#`);
  await page.reload();
  await page.waitForSelector("html[data-ready]");
  const preset = await shown(page, checksum);
  await page.getByRole("radio", { name: "Line" }).check();
  const handle = page.getByRole("button", { name: /^Line, point 1 of 2/ });
  await handle.scrollIntoViewIfNeeded();

  const box = await handle.boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 20, y - 30, { steps: 5 });
  await page.mouse.up();
  const dragged = await changed(page, checksum, preset, "dragging");

  await handle.focus();
  await page.keyboard.press("ArrowRight");
  const moved = await changed(page, checksum, dragged, "an arrow key");
  const [before, after] = [dragged, moved].map(({ hash }) => Number(/item=line,[^,]*,[^,]*,(-?[\d.]+):/.exec(hash)[1]));
  assert.equal(after - before, 1, "an arrow key moves by a pixel");
  await page.keyboard.press("ArrowLeft");
  assert.deepEqual(await settled(page, checksum), dragged, "the way back shows what was there");
  await page.keyboard.press("Shift+ArrowDown");
  await changed(page, checksum, dragged, "an arrow key with Shift");

  // The address alone brings the picture back.
  const last = await shown(page, checksum);
  await page.goto("about:blank");
  await page.goto(`${url}${last.hash}`);
  await page.waitForSelector("html[data-ready]");
  assert.deepEqual(await shown(page, checksum), last, "the address brings the picture back");

  await checkScan(page, checksum, last);
  await checkNumbers(page, url, checksum);
  console.log("points are dragged and moved by keys, the address follows, and the scan ends with the picture");
}

/** Numbers that are typed go to the nearest 1/256 pixel, whatever the step of the buttons; without a number, nothing changes. */
async function checkNumbers(page, url, checksum) {
  await page.goto("about:blank");
  await page.goto(`${url}#item=text,f4f4ec,200,20:200,Text`);
  await page.waitForSelector("html[data-ready]");
  const item = async () => /item=([^&]*)/.exec((await settled(page, checksum)).hash)[1];
  for (const [id, typed, expected] of [
    ["#x", "120.1", "text,f4f4ec,200,120.1015625:200,Text"],
    ["#y", "-3.3", "text,f4f4ec,200,120.1015625:-3.30078125,Text"],
    ["#y", "5000", "text,f4f4ec,200,120.1015625:1280,Text"],
    ["#size", "199", "text,f4f4ec,199,120.1015625:1280,Text"],
    ["#size", "", "text,f4f4ec,199,120.1015625:1280,Text"],
    ["#size", "400", "text,f4f4ec,320,120.1015625:1280,Text"],
    ["#x", "", "text,f4f4ec,320,120.1015625:1280,Text"],
    ["#text", "", "text,f4f4ec,320,120.1015625:1280,"],
  ]) {
    await page.locator(id).fill(typed);
    assert.equal(await item(), expected, `${typed} in ${id}`);
  }
}

/** The scan shows a part of the picture, and in the end all of it. */
async function checkScan(page, checksum, whole) {
  await page.getByRole("button", { name: "Next band" }).click();
  const label = page.locator("#band-number");
  assert.equal(await label.textContent(), "1 of 320");
  assert.notEqual((await shown(page, checksum)).sum, whole.sum, "a scan shows a part of the picture");
  await page.getByLabel("Band:").fill("200");
  assert.equal(await label.textContent(), "200 of 320");
  await page.getByRole("button", { name: "Play the scan" }).click();
  await page.waitForFunction(() => document.getElementById("band-number").textContent === "320 of 320", null, {
    timeout: 20_000,
  });
  await page.waitForFunction(() => document.getElementById("play").textContent === "Play the scan");
  assert.deepEqual(await shown(page, checksum), whole, "the scan ends with the picture");
}

const shown = async (page, checksum) => ({ sum: await checksum(page), hash: new URL(page.url()).hash });

async function settled(page, checksum) {
  await page.waitForTimeout(WRITTEN);
  return shown(page, checksum);
}

/** Fails where neither the picture nor the address has changed. */
async function changed(page, checksum, before, by) {
  const after = await settled(page, checksum);
  assert.notEqual(after.sum, before.sum, `${by} changes the picture`);
  assert.notEqual(after.hash, before.hash, `${by} changes the address`);
  return after;
}
