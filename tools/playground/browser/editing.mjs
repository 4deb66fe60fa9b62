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
  console.log("points are dragged and moved by keys, the address follows, and the scan ends with the picture");
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
