// Shared by the browser tests: Chromium, pages watched for every error and request, axe, and raygrade.
//
// A test file is <name>_test.js here, for node:test, its name in CMakeLists.txt; ctest sets RAYGRADE_BINARY and
// RAYGRADE_BROWSER_FOLDER, a folder of the build to write into. By hand, after `bash tests/browser/prepare build/browser`:
//   RAYGRADE_BINARY=$PWD/build/raygrade RAYGRADE_BROWSER_FOLDER=$PWD/build/browser node --test tests/browser/report_test.js
// Nothing is skipped: a missing tool is a failure.
//
//   const browser = await startBrowser();              // once a file; after(() => browser.close())
//   const seen = await open(browser, url, { width: 400, dark: true });
//   await seen.page.click('…');                        // Playwright's page
//   await expectAccessible(seen.page);                 // axe, every rule
//   await expectNoOverflow(seen.page);                 // no sideways scrolling
//   await expectWordsApart(seen.page.locator('figure svg'));  // none over another
//   await screenshot(seen.page, 'report-400-dark');    // <build>/browser/screenshots/report-400-dark.png
//   await seen.close();                                // fails when the page had an error, or asked elsewhere
import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { mkdir } from 'node:fs/promises';
import { createRequire } from 'node:module';
import path from 'node:path';
import { promisify } from 'node:util';

/** An environment variable that ctest sets. */
function setting(name) {
  const value = process.env[name];
  assert.ok(value, `${name} is not set; run these tests by ctest, or see the top of tests/browser/browser.js`);
  return path.resolve(value);
}

/** The folder of the build that these tests may write into. */
export const folder = setting('RAYGRADE_BROWSER_FOLDER');
const raygradeBinary = setting('RAYGRADE_BINARY');

// The packages are in the build folder, where an import from here does not find them.
const require = createRequire(path.join(folder, 'package.json'));
const { chromium } = require('playwright-core');
const axe = require('axe-core');

/** Debian's Chromium. Without its own sandbox, which root and containers can't have: it sees no pages but ours. */
export function startBrowser() {
  return chromium.launch({ executablePath: '/usr/bin/chromium-headless-shell', chromiumSandbox: false });
}

/**
 * Opens `url`. Records every error, warning and policy violation from then on, and blocks every request except to `url`
 * itself and below `site` ("http://127.0.0.1:8000/"; without `site`, to no other address).
 * options: width, height, dark, script (false: a browser without JavaScript), site, print (as on paper).
 */
export async function open(browser, url, options = {}) {
  const { width = 1400, height = 1000, dark = false, script = true, site, print = false } = options;
  const context = await browser.newContext({
    viewport: { width, height },
    colorScheme: dark ? 'dark' : 'light',
    javaScriptEnabled: script,
    reducedMotion: 'reduce',
  });
  const problems = [];
  await context.route('**/*', (route) => {
    const asked = route.request().url();
    const allowed = asked.split('#')[0] === url.split('#')[0] || (site !== undefined && asked.startsWith(site));
    if (allowed) return route.continue();
    problems.push(`asked for ${asked}`);
    return route.abort();
  });
  context.setDefaultTimeout(120_000);  // a busy machine takes long for a click in a table of thousands
  const page = await context.newPage();
  page.on('console', (message) => {
    if (['error', 'warning', 'assert'].includes(message.type())) problems.push(`${message.type()}: ${message.text()}`);
  });
  page.on('pageerror', (error) => problems.push(`uncaught: ${error.stack ?? error}`));
  page.on('dialog', (dialog) => {
    problems.push(`dialog: ${dialog.message()}`);
    dialog.dismiss();
  });
  page.on('crash', () => problems.push('the page crashed'));
  if (print) await page.emulateMedia({ media: 'print' });
  await page.goto(url);
  /** Closes it. `expected`: problems that the test has called for, such as an answer 413 to too large a file. */
  const close = async (expected = []) => {
    await context.close();
    const surprises = problems.filter((problem) => !expected.some((pattern) => pattern.test(problem)));
    expectNone(surprises, 'errors of the page, or requests to elsewhere');
  };
  return { page, problems, close };
}

/** Both widths and both themes: what fits depends on the width alone, and colours on the theme. */
export const windows = [
  { name: '400-dark', width: 400, dark: true },
  { name: '1400-light', width: 1400, dark: false },
];

/** Fails with every fault in its message: not every version of Node adds them to a message of the caller's. */
function expectNone(faults, what) {
  assert.ok(faults.length === 0, `${what}: ${faults.join('; ')}`);
}

/** Every rule of axe, best practices too, on the page as it is now. */
export async function expectAccessible(page, what = page.url()) {
  // Without resultTypes axe describes each of the thousands of elements that are right.
  // axe is evaluated and not added as an element, because the page's own policy rightly refuses scripts.
  await page.evaluate(axe.source);
  const result = await page.evaluate(() => globalThis.axe.run(document, { preload: false, resultTypes: ['violations'] }));
  const found = result.violations.map(
    ({ id, help, nodes }) => `${id}: ${help}\n    ${nodes.slice(0, 3).map((node) => `${node.html} ${node.failureSummary}`).join('\n    ')}`);
  expectNone(found, `${what}: what axe found`);
  assert.ok(result.passes.length > 10, `${what}: axe has looked at next to nothing`);
}

/** The page fits its window: nothing but what scrolls by itself is wider. */
export async function expectNoOverflow(page) {
  const { content, shown } = await page.evaluate(() => ({
    content: document.documentElement.scrollWidth,
    shown: document.documentElement.clientWidth,
  }));
  assert.ok(content <= shown, `the page is ${content} pixels wide in a window of ${shown}`);
}

/** In each of these SVG pictures the words are apart and on it, as the browser sets them. */
export async function expectWordsApart(pictures) {
  const seen = await pictures.evaluateAll((all) => all.map((picture) => {
    const { width, height } = picture.viewBox.baseVal;
    const texts = [...picture.querySelectorAll('text')].map((text) => {
      const { x, y, width: wide, height: high } = text.getBBox();
      return { words: text.textContent, left: x, top: y, right: x + wide, bottom: y + high };
    });
    const faults = texts
      .filter(({ left, top, right, bottom }) => !(left >= 0 && top >= 0 && right <= width && bottom <= height && right > left))
      .map(({ words }) => `${words}: is not on the page`);
    texts.forEach((one, i) => texts.slice(0, i).forEach((other) => {
      const apart = one.left >= other.right || other.left >= one.right || one.top >= other.bottom || other.top >= one.bottom;
      if (!apart) faults.push(`${one.words}: over ${other.words}`);
    }));
    return { count: texts.length, faults };
  }));
  assert.ok(seen.length > 0 && seen.every(({ count }) => count > 20), `too few words: ${seen.map(({ count }) => count)}`);
  expectNone(seen.flatMap(({ faults }) => faults), 'words that overlap or leave the picture');
}

/** Into the build folder, for people to look at. `whole`: all of the page, not only what the window shows. */
export async function screenshot(page, name, { whole = true } = {}) {
  const screenshots = path.join(folder, 'screenshots');
  await mkdir(screenshots, { recursive: true });
  await page.screenshot({ path: path.join(screenshots, `${name}.png`), fullPage: whole });
}

/** Runs raygrade; what it printed, and its exit status. What programs print is kept for all tests of the build. */
export async function raygrade(...words) {
  const environment = { ...process.env, XDG_CACHE_HOME: path.join(folder, '../test-cache') };
  try {
    const { stdout, stderr } = await promisify(execFile)(raygradeBinary, words, { env: environment, maxBuffer: 1 << 28 });
    return { status: 0, stdout, stderr };
  } catch (error) {
    if (typeof error.code !== 'number') throw error;
    return { status: error.code, stdout: error.stdout, stderr: error.stderr };
  }
}
