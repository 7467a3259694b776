// The self-check page as a student uses it: with a mouse, with only the keyboard, with and without scripts.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { mkdtemp, rm, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { createInterface } from 'node:readline';
import { after, before, test } from 'node:test';

import { expectAccessible, expectNoOverflow, folder, open, screenshot, startBrowser } from './browser.js';

const program = (more = '') => `#include <cstdio>
int main() { puts("Question 5:\\nV: vec3(0.000000, 0.000000, -1.000000)"); }
${more}`;
const patience = 120_000;

let browser;
let scratch;
const running = new Set();  // servers that still run, e.g. after a failed test

before(async () => {
  browser = await startBrowser();
  scratch = await mkdtemp(path.join(folder, 'serve-'));
  await writeFile(path.join(scratch, 'ray_cast.cpp'), program());
});

after(async () => {
  for (const server of running) server.kill('SIGKILL');
  await browser?.close();
  if (scratch) await rm(scratch, { recursive: true });
});

/** raygrade serve at a free port, with a state of its own; stop() ends it. */
async function serve(...words) {
  const state = await mkdtemp(path.join(scratch, 'state-'));
  const start = async () => {
    const server = spawn(process.env.RAYGRADE_BINARY,
      ['serve', '--assignment', 'a6-2021', '--port', '0', '--state', state, ...words],
      { env: { ...process.env, XDG_CACHE_HOME: path.join(folder, 'cache') }, stdio: ['ignore', 'pipe', 'ignore'] });
    for await (const line of createInterface({ input: server.stdout })) {
      const found = line.match(/http:\/\/127\.0\.0\.1:\d+\//);
      if (found) return { server, site: found[0] };
    }
    throw new Error('raygrade serve ended without an address');
  };
  const { server, site } = await start();
  running.add(server);
  const stop = () => new Promise((resolve) => {
    server.on('exit', () => {
      running.delete(server);
      resolve();
    });
    server.kill('SIGTERM');
  });
  return { site, stop };
}

/** Waits for the student's page with the points of `program`. */
async function expectResult(page) {
  await page.waitForURL(/\/result\/[0-9a-f]{32}$/);
  await page.getByRole('link', { name: 'Check another program' }).waitFor({ timeout: patience });
  assert.match(await page.locator('body').innerText(), /\b10 of 100/);
}

test('a dark browser gets dark and accessible pages', async () => {
  const { site, stop } = await serve();
  const seen = await open(browser, site, { width: 400, dark: true, site });
  assert.equal(await seen.page.evaluate(() => getComputedStyle(document.body).backgroundColor), 'rgb(21, 24, 27)');
  await expectAccessible(seen.page);
  await screenshot(seen.page, 'serve-form-400-dark');
  await seen.close();
  await stop();
});

for (const width of [400, 1400]) {
  test(`a file is uploaded and its verdicts are shown, ${width} pixels wide`, async () => {
    const { site, stop } = await serve();
    const seen = await open(browser, site, { width, site });
    await expectAccessible(seen.page);
    await expectNoOverflow(seen.page);
    await screenshot(seen.page, `serve-form-${width}`);
    await seen.page.getByLabel('Your ray_cast.cpp', { exact: true }).setInputFiles(path.join(scratch, 'ray_cast.cpp'));
    await seen.page.getByRole('button', { name: 'Check this file' }).click();
    await expectResult(seen.page);
    await expectAccessible(seen.page);
    await expectNoOverflow(seen.page);
    await screenshot(seen.page, `serve-result-${width}`);
    await seen.page.getByRole('link', { name: 'Check another program' }).click();
    await seen.page.getByLabel('Your ray_cast.cpp', { exact: true }).waitFor();
    await seen.close();
    await stop();
  });

  test(`the waiting room tells the place in the queue, ${width} pixels wide`, async () => {
    const { site, stop } = await serve('-j', '1');
    const seen = await open(browser, site, { width, site });
    const send = async (source) => {
      await seen.page.goto(site);
      await seen.page.getByLabel('The text of your ray_cast.cpp').fill(source);
      await seen.page.getByRole('button', { name: 'Check this text' }).click();
      await seen.page.waitForURL(/\/result\//);
    };
    for (const i of [1, 2, 3]) await send(`#include <unistd.h>\nint main() { sleep(9); return ${width} + ${i}; }`);
    await seen.page.getByText(/number \d of \d in the queue|the next one/).waitFor({ timeout: patience });
    await expectAccessible(seen.page);
    await expectNoOverflow(seen.page);
    await screenshot(seen.page, `serve-waiting-${width}`);
    await seen.close();
    await stop();
  });
}

test('the keyboard is enough to paste a program, read its result and go back', async () => {
  const { site, stop } = await serve();
  const seen = await open(browser, site, { site });
  const { keyboard } = seen.page;
  const focused = () => seen.page.evaluate(() => document.activeElement.textContent || document.activeElement.name);
  for (let i = 0; i < 10 && (await seen.page.evaluate(() => document.activeElement.tagName)) !== 'TEXTAREA'; ++i)
    await keyboard.press('Tab');
  await keyboard.insertText(program());
  await keyboard.press('Tab');
  assert.equal(await focused(), 'Check this text');
  const outline = await seen.page.evaluate(() => getComputedStyle(document.activeElement).outlineStyle);
  assert.equal(outline, 'solid', 'where the focus is can be seen');
  await keyboard.press('Enter');
  await expectResult(seen.page);
  await keyboard.press('Tab');
  assert.equal(await focused(), 'Check another program');
  await keyboard.press('Enter');
  await seen.page.getByLabel('Your ray_cast.cpp', { exact: true }).waitFor();
  await seen.close();
  await stop();
});

test('a refusal is explained, and the typed text is kept', async () => {
  const { site, stop } = await serve();
  const seen = await open(browser, site, { site });
  await seen.page.getByLabel('The text of your ray_cast.cpp').fill(program('// first'));
  await seen.page.getByRole('button', { name: 'Check this text' }).click();
  await seen.page.waitForURL(/\/result\//);
  const first = seen.page.url();
  await seen.page.goto(site);
  await seen.page.getByLabel('The text of your ray_cast.cpp').fill('%PDF-1.4 // second');
  await seen.page.getByRole('button', { name: 'Check this text' }).click();
  await seen.page.getByRole('alert').filter({ hasText: 'is a PDF' }).waitFor();
  assert.match(await seen.page.getByLabel('The text of your ray_cast.cpp').inputValue(), /second/);
  await seen.page.route('**/check', (route) => route.fulfill({ status: 429, contentType: 'text/html', body: 'by a proxy' }), { times: 1 });
  await seen.page.getByRole('button', { name: 'Check this text' }).click();
  await seen.page.getByRole('alert').filter({ hasText: 'again in a minute' }).waitFor();
  assert.equal(seen.page.url(), site);
  await expectAccessible(seen.page);
  await screenshot(seen.page, 'serve-refused-1400');
  await writeFile(path.join(scratch, 'huge.cpp'), 'x'.repeat((1 << 20) + 1));
  await seen.page.getByLabel('Your ray_cast.cpp', { exact: true }).setInputFiles(path.join(scratch, 'huge.cpp'));
  await seen.page.getByRole('button', { name: 'Check this file' }).click();
  await seen.page.getByRole('alert').filter({ hasText: 'larger than 1 MiB' }).waitFor();
  await seen.page.goto(first);
  await expectResult(seen.page);
  await seen.close([/status of 400/, /status of 429/]);
  await stop();
});

test('it also works without script', async () => {
  const { site, stop } = await serve();
  const seen = await open(browser, site, { site, script: false });
  await seen.page.getByLabel('Your ray_cast.cpp', { exact: true }).setInputFiles(path.join(scratch, 'ray_cast.cpp'));
  await seen.page.getByRole('button', { name: 'Check this file' }).click();
  await expectResult(seen.page);
  await seen.close();
  await stop();
});

test('a missing result has its own page', async () => {
  const { site, stop } = await serve();
  const seen = await open(browser, site, { site });
  await seen.page.goto(`${site}result/${'0'.repeat(32)}`);
  await seen.page.getByRole('heading', { name: 'No result here' }).waitFor();
  await expectAccessible(seen.page);
  await seen.page.getByRole('link', { name: 'Back to the form' }).click();
  await seen.page.getByLabel('Your ray_cast.cpp', { exact: true }).waitFor();
  await seen.close([/status of 404/]);
  await stop();
});
