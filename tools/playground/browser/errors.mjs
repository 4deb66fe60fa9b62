// What the page says about errors: two ways to the exact area, the library's and the page's own, agree.

import assert from "node:assert/strict";

/** In 1/255 of a pixel: of a coverage that is rounded, and corners of a line that are rounded to 1/256 pixel. */
const ROUNDED = 1;
/** A circle is flattened, at most 1/64 pixel off: 4 of 255, and what is rounded. */
const FLATTENED = 255 / 64 + ROUNDED;
/** Of the pixels of an edge, if none is mixed. */
const UNMIXED = 45;
/** Of the pixels of silhouettes, of which a few have two surfaces at their edges, which are taken for one. */
const SILHOUETTES = 12;

export async function checkErrors(page, url) {
  await page.goto(`${url}#`);
  await page.reload();
  await page.waitForSelector("html[data-ready]");
  let checked = 0;
  const presets = await page.locator("#preset option:not([value=own])").count();
  for (let preset = 0; preset < presets; preset++) {
    await page.selectOption("#preset", String(preset));
    for (const method of ["exact", "inside_area", "none"]) {
      await page.selectOption("#method", method);
      for (const item of await page.locator("#items input:not([value=pot])").all()) {
        await item.check();
        const { title, rms, largest } = await told(page);
        const limit = title === "Circle" ? FLATTENED : ROUNDED;
        if (method !== "none") assert.ok(largest < limit, `${title} of preset ${preset}: ${largest}`);
        else assert.ok(rms > UNMIXED, `${title} of preset ${preset} without antialiasing: ${rms}`);
        checked += 1;
      }
    }
  }
  await page.goto("about:blank");
  await page.goto(`${url}#pot=flat&item=circle,ff8000,0,10:10;20:10`);
  await page.waitForSelector("html[data-ready]");
  await page.locator("#picture").click();
  for (const pot of ["flat", "silhouettes"]) {
    await page.selectOption("#pot", pot);
    assert.equal(await page.locator("#items input:checked").inputValue(), "pot", "a click selects the teapot");
    const { title, rms } = await told(page);
    assert.equal(title, "Teapot");
    assert.ok(pot === "flat" ? rms > UNMIXED : rms < SILHOUETTES, `${pot}: ${rms}`);
    checked += 1;
  }
  await page.selectOption("#pot", "none");
  assert.equal(await page.locator("#items input:checked").inputValue(), "0", "without a teapot an item is selected");
  console.log(`${checked} items: the error that the page computes is as large as the method says`);
}

/** The sentence about the selected item, when it has been computed. */
async function told(page) {
  const text = await page.waitForFunction(() => {
    const element = document.getElementById("error-text");
    const selected = document.querySelector("#items input:checked").value;
    return element.dataset.shown === `${document.documentElement.dataset.picture} ${selected}` && element.textContent;
  });
  const [, title, rms, largest] = /^(.*) on \d+ edge pixels: rms error ([\d.]+), largest ([\d.]+) of/.exec(
    await text.jsonValue(),
  );
  return { title, rms: Number(rms), largest: Number(largest) };
}
