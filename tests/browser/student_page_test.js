// The page that a student gets: as feedback in a class, and from a check of the student's own program.
import assert from 'node:assert/strict';
import { mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';

import { expectAccessible, expectNoOverflow, expectWordsApart, folder, open, raygrade, screenshot, startBrowser, windows } from './browser.js';

const project = fileURLToPath(new URL('../..', import.meta.url));
const sample = (who) => path.join(project, 'submissions', who, 'ray_cast.cpp');

let browser;
let scratch;

before(async () => {
  browser = await startBrowser();
  scratch = await mkdtemp(path.join(folder, 'student-'));
});

after(async () => {
  await browser?.close();
  if (scratch) await rm(scratch, { recursive: true });
});

/** The page of a check; its address. */
async function check(source, name) {
  const file = path.join(scratch, `${name}.html`);
  const { status, stderr } = await raygrade('check', source, '--assignment', 'a6-2021', '--html', file);
  assert.equal(status, 0, stderr);
  return pathToFileURL(file).href;
}

test('it says where to start, with a link', async () => {
  const seen = await open(browser, await check(sample('jin'), 'jin'));
  const { page } = seen;
  const link = page.getByRole('link', { name: 'Start with question 1' });
  await link.focus();
  await page.keyboard.press('Enter');
  assert.match(page.url(), /#q1$/);
  const first = await page.locator('#q1').textContent();
  assert.ok(first.includes('start here') && first.includes('integer division'));
  assert.ok((await page.locator('#q4').textContent()).includes('fix question 1 and this one will be right too'));
  assert.equal(await page.locator('#q2').count(), 0, 'nothing to say of what is right');
  assert.ok(await page.locator('figure svg').isVisible());
  await seen.close();
});

test('a named line is a link to that line of the output, with the answer that was read', async () => {
  const seen = await open(browser, await check(sample('jin'), 'lines'));
  const { page } = seen;
  const link = page.locator('#q1').getByRole('link', { name: /^line \d+$/ }).first();
  const number = (await link.textContent()).slice('line '.length);
  await link.click();
  const line = page.locator(`#o${number}`);
  assert.ok(await line.evaluate((one) => one.matches(':target')));
  assert.match(await line.textContent(), new RegExp(`^${number}.*1\\.P_VCS wrong\\s*$`));
  await seen.close();
});

test('the labels of the picture do not overlap and stay inside', async () => {
  for (const who of ['jin', 'ben', 's09']) {
    const seen = await open(browser, await check(sample(who), `words-${who}`));
    await expectWordsApart(seen.page.locator('figure svg'));
    await seen.close();
  }
});

test('on a phone the picture keeps its size and scrolls sideways in its frame', async () => {
  const seen = await open(browser, await check(sample('jin'), 'phone'), { width: 390 });
  const picture = seen.page.locator('figure svg');
  const { drawn, own } = await picture.evaluate((svg) => ({ drawn: svg.getBoundingClientRect().width, own: svg.viewBox.baseVal.width }));
  assert.equal(drawn, own);
  const hint = () => seen.page.locator('figure').evaluate((figure) => getComputedStyle(figure, '::before').content);
  assert.match(await hint(), /sideways/);
  await seen.page.setViewportSize({ width: own + 40, height: 800 });
  assert.equal(await hint(), 'none', 'all of it is in view');
  await seen.page.setViewportSize({ width: 390, height: 800 });
  await expectNoOverflow(seen.page);
  await expectAccessible(seen.page);
  await seen.close();
});

test('the compiler\'s messages are shown by line, with that line, and in full', async () => {
  const seen = await open(browser, await check(sample('mateo'), 'mateo'));
  const { page } = seen;
  assert.match(await page.locator('.lines li').first().textContent(), /^Line 19 error expected/);
  const line = (await readFile(sample('mateo'), 'utf8')).split('\n')[18].trim();
  assert.equal(await page.locator('.lines li pre').first().textContent(), line);
  assert.equal(await page.locator('details pre').isVisible(), false);
  await page.getByText('Full compiler output').click();
  assert.match(await page.locator('details pre').textContent(), /ray_cast\.cpp:19:/);
  await seen.close();
});

test('markup that a program prints is shown as text', async () => {
  const source = path.join(scratch, 'ray_cast.cpp');
  const evil = '</code><script>alert(1)</script><img src=x onerror=alert(2)>';
  await writeFile(source, `#include <cstdio>\nint main() { std::puts("Question 5:\\nV = ${evil}"); std::fputs("${evil}", stderr); }`);
  const seen = await open(browser, await check(source, 'evil'));
  assert.ok((await seen.page.locator('main').textContent()).split(evil).length > 1);
  assert.equal(await seen.page.locator('img, script').count(), 0);
  await seen.close();
});

test('a file that is not raygrade\'s is left unchanged, and a page is replaced', async () => {
  const file = path.join(scratch, 'mine.html');
  await writeFile(file, '<!DOCTYPE html>\n<p>My own page.');
  const refused = await raygrade('check', sample('ada'), '--assignment', 'a6-2021', '--html', file);
  assert.equal(refused.status, 2);
  assert.match(refused.stderr, /mine\.html exists and is not a page of raygrade/);
  assert.equal(await readFile(file, 'utf8'), '<!DOCTYPE html>\n<p>My own page.');
  const first = await readFile(fileURLToPath(await check(sample('ada'), 'again')), 'utf8');
  const second = await readFile(fileURLToPath(await check(sample('ben'), 'again')), 'utf8');
  assert.notEqual(first, second);
});

for (const who of ['jin', 'nadia', 'mateo', 'ada']) {
  for (const { name: size, ...window } of windows) {
    const name = `student-${who}-${size}`;
    test(`${name}: accessible, and it fits`, async () => {
      const seen = await open(browser, await check(sample(who), name), window);
      await expectAccessible(seen.page);
      await expectNoOverflow(seen.page);
      await screenshot(seen.page, name);
      await seen.close();
    });
  }
}

test('on paper no grid contains unbreakable parts, and a heading stays with its text', async () => {
  const seen = await open(browser, await check(sample('dmitri'), 'grid'), { width: 800, print: true });
  const { page } = seen;
  const style = (selector, name) =>
    page.locator(selector).first().evaluate((found, of) => getComputedStyle(found)[of], name);
  assert.equal(await style('.question.follow dl', 'display'), 'block');
  assert.equal(await style('.question', 'breakInside'), 'avoid');
  for (const kept of ['h2', '.question .tags', 'h2 + .facts', '.listing > span'])
    assert.equal(await style(kept, 'breakAfter'), 'avoid', kept);
  await seen.close();
});

test('on paper it is dark on light and fits', async () => {
  const seen = await open(browser, await check(sample('jin'), 'paper'), { width: 800, dark: true, print: true });
  const colours = await seen.page.evaluate(() => {
    const { backgroundColor, color } = getComputedStyle(document.body);
    return [backgroundColor, color];
  });
  assert.deepEqual(colours, ['rgb(255, 255, 255)', 'rgb(34, 34, 34)']);
  await expectNoOverflow(seen.page);
  await screenshot(seen.page, 'student-paper');
  await seen.close();
});
