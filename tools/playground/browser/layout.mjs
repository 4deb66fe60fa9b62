// The page at the width of a phone and of a desk, light and dark: nothing scrolls sideways, every control has a name.

import assert from "node:assert/strict";
import { join } from "node:path";

const VIEWS = [
  ["phone", 360, 740],
  ["tablet", 800, 1000],
  ["desk", 1366, 900],
];

export async function checkLayout(page, url, folder) {
  for (const scheme of ["light", "dark"]) {
    await page.emulateMedia({ colorScheme: scheme, reducedMotion: "reduce" });
    for (const [name, width, height] of VIEWS) {
      await page.setViewportSize({ width, height });
      await page.goto(`${url}#`);
      await page.reload();
      await page.waitForSelector("html[data-ready]");
      const wide = await page.evaluate(() => document.documentElement.scrollWidth);
      assert.ok(wide <= width, `${width} px: the page is ${wide} px wide`);
      if (folder) await page.screenshot({ path: join(folder, `${name}-${scheme}.png`), fullPage: true });
    }
  }
  const nameless = await page.evaluate(() =>
    [...document.querySelectorAll("button, select, input")]
      .filter((control) => !(control.labels?.length || control.ariaLabel || control.textContent.trim()))
      .map((control) => control.outerHTML),
  );
  assert.deepEqual(nameless, [], "every control has a name");
  console.log("no view scrolls sideways, from 360 px on, and every control has a name");
}
