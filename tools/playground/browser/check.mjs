// Opens the playground in a headless Chromium and checks it: a task comes in as JSON, and what is wrong makes it fail.

import assert from "node:assert/strict";
import { mkdtemp, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { text } from "node:stream/consumers";
import { pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

import { checkEditing } from "./editing.mjs";
import { checkErrors } from "./errors.mjs";
import { checkLayout } from "./layout.mjs";

const ARGUMENTS = [
  "--headless",
  "--no-sandbox",
  "--disable-gpu",
  "--disable-quic",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
];

const task = JSON.parse(await text(process.stdin));
const url = pathToFileURL(task.page).href;
const profile = await mkdtemp(join(tmpdir(), "zrow-playground-"));
const browser = await chromium.launchPersistentContext(profile, {
  executablePath: task.chromium,
  args: ARGUMENTS,
  headless: true,
  viewport: { width: 1280, height: 900 },
});
try {
  const page = await browser.newPage();
  const complaints = [];
  page.on("pageerror", (error) => complaints.push(error.message));
  page.on("console", (message) => {
    if (message.type() === "error") complaints.push(message.text());
  });
  page.on("request", (request) => {
    if (!/^(file|data|blob):/.test(request.url())) complaints.push(`asks for ${request.url()}`);
  });
  await checkCanvas(page, complaints);
  await checkEditing(page, url, checksum);
  await checkErrors(page, url);
  await checkLayout(page, url, task.screenshots);
  assert.deepEqual(complaints, [], "the page complains");
} finally {
  await browser.close();
  await rm(profile, { recursive: true, force: true });
}

/** The canvas has the simulator's pixels in every state. */
async function checkCanvas(page, complaints) {
  await page.goto(url);
  await page.waitForSelector("html[data-ready]").catch(() => {
    throw new Error(`the page does not start: ${complaints.join("; ")}`);
  });
  for (const { address, checksum: expected } of task.states) {
    await page.evaluate((hash) => {
      location.hash = hash;
    }, address);
    await page.waitForFunction((text) => document.documentElement.dataset.picture === text, address);
    assert.equal(await checksum(page), expected, `the canvas differs from the simulator's picture: ${address}`);
  }
  console.log(`${task.states.length} states: the canvas has the simulator's pixels`);
}

/** FNV-1a over red, green and blue of each pixel of the canvas. */
function checksum(page) {
  return page.evaluate(() => {
    const canvas = document.getElementById("picture");
    const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
    let sum = 0x811c9dc5;
    data.forEach((byte, index) => {
      if (index % 4 !== 3) sum = Math.imul(sum ^ byte, 0x01000193) >>> 0;
    });
    return sum;
  });
}
