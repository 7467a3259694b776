// The handout of an assignment, on paper and on a screen.
import assert from 'node:assert/strict';
import { mkdtemp, rm } from 'node:fs/promises';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';

import { expectAccessible, expectNoOverflow, folder, open, raygrade, screenshot, startBrowser, windows } from './browser.js';

let browser;
let scratch;

before(async () => {
  browser = await startBrowser();
  scratch = await mkdtemp(path.join(folder, 'handout-'));
});

after(async () => {
  await browser?.close();
  if (scratch) await rm(scratch, { recursive: true });
});

for (const name of ['a6-2021', 'a6-2024']) {
  test(`${name} is at most two sheets of paper, and fits a phone`, async () => {
    const out = path.join(scratch, name);
    const { status, stderr } = await raygrade('assignment', 'handout', name, '--out', out);
    assert.equal(status, 0, stderr);
    const address = pathToFileURL(path.join(out, 'handout.html')).href;
    for (const window of windows) {
      const seen = await open(browser, address, window);
      await expectAccessible(seen.page);
      await expectNoOverflow(seen.page);
      await screenshot(seen.page, `handout-${name}-${window.name}`);
      for (const format of ['A4', 'Letter']) {
        const pdf = (await seen.page.pdf({ format })).toString('latin1');
        assert.ok((pdf.match(/\/Type \/Page\b/g) ?? []).length <= 2, `${format}: more than two pages`);
      }
      await seen.close();
    }
  });
}
