// Tests the test tools: each detects what it must detect.
import assert from 'node:assert/strict';
import { mkdtemp, rm, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';

import { expectAccessible, expectNoOverflow, folder, open, startBrowser } from './browser.js';

let browser;
let scratch;

before(async () => {
  browser = await startBrowser();
  scratch = await mkdtemp(path.join(folder, 'pages-'));
});

after(async () => {
  await browser?.close();
  if (scratch) await rm(scratch, { recursive: true });
});

async function openPage(body, head = '') {
  const file = path.join(scratch, 'page.html');
  await writeFile(file, `<!DOCTYPE html><html lang="en"><head><meta charset="utf-8"><title>A page</title>${head}</head>
    <body><main><h1>A page</h1>${body}</main></body></html>`);
  return open(browser, pathToFileURL(file).href);
}

test('a correct page passes', async () => {
  const seen = await openPage('<p>Words.</p><ul><li>one</li></ul><label>Name <input></label>');
  await expectAccessible(seen.page);
  await expectNoOverflow(seen.page);
  await seen.close();
});

test('a request to another site is blocked and reported', async () => {
  const seen = await openPage('<img alt="far" src="http://elsewhere.invalid/a.png">');
  await assert.rejects(() => seen.close(), /asked for http:\/\/elsewhere\.invalid\/a\.png/);
});

test('an error of a script is reported', async () => {
  const seen = await openPage('<script>undefinedFunction()</script>');
  await assert.rejects(() => seen.close(), /undefinedFunction is not defined/);
});

test('a violated policy is reported', async () => {
  const policy = `<meta http-equiv="Content-Security-Policy" content="default-src 'none'">`;
  const seen = await openPage('<p style="color: red">Red?</p>', policy);
  await assert.rejects(() => seen.close(), /Content Security Policy/);
});

test('axe finds a field without a label', async () => {
  const seen = await openPage('<input>');
  await assert.rejects(() => expectAccessible(seen.page), /label/);
  await seen.close();
});

test('a page that is too wide for its window is reported', async () => {
  const seen = await openPage('<pre>' + 'wide '.repeat(1000) + '</pre>');
  await assert.rejects(() => expectNoOverflow(seen.page), /pixels wide in a window of 1400/);
  await seen.close();
});
