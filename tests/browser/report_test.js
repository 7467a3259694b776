// The class report that the real raygrade writes for the sample class, as an instructor uses it.
import assert from 'node:assert/strict';
import { mkdir, mkdtemp, readdir, rm, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';

import { expectAccessible, expectNoOverflow, expectWordsApart, folder, open, raygrade, screenshot, startBrowser, windows } from './browser.js';
import { column, heading, panel, shownIds } from './class_report.js';

const project = fileURLToPath(new URL('../..', import.meta.url));
const hostileId = '<img src=x onerror=alert(1)>';
const hostileOutput = '</code><script>alert(2)</script>';

let browser;
let scratch;
let report;

/** The sample class, and one whose name and output are markup. */
async function gradeClass() {
  const names = await readdir(path.join(project, 'submissions'));
  const students = names.filter((name) => name !== 'hostile' && name !== '2024').sort();
  const evil = path.join(scratch, hostileId);
  await mkdir(evil);
  await writeFile(path.join(evil, 'ray_cast.cpp'), `#include <cstdio>
    #warning </pre><img src=y>
    int main() { std::puts("Question 5:\\nV = (9, 9, 9)"); std::fputs("${hostileOutput}", stderr); }`);
  const out = path.join(scratch, 'results');
  const paths = [...students.map((name) => path.join(project, 'submissions', name)), evil];
  const { status, stderr } = await raygrade('grade', ...paths, '--assignment', 'a6-2021', '--out', out);
  assert.equal(status, 0, stderr);
  return { out, count: paths.length };
}

before(async () => {
  browser = await startBrowser();
  scratch = await mkdtemp(path.join(folder, 'report-'));
  report = await gradeClass();
  report.url = pathToFileURL(path.join(report.out, 'report.html')).href;
});

after(async () => {
  await browser?.close();
  if (scratch) await rm(scratch, { recursive: true });
});

test('every student is in the table, and markup in a name is shown as text', async () => {
  const seen = await open(browser, report.url);
  const ids = await shownIds(seen.page);
  assert.equal(ids.length, report.count);
  assert.ok(ids.includes(hostileId));
  assert.equal(await seen.page.locator('img').count(), 0);
  await seen.page.getByRole('link', { name: hostileId, exact: true }).first().click();
  const sheet = await panel(seen.page).textContent();
  assert.ok(sheet.includes(hostileOutput), 'what the program said');
  assert.ok(sheet.includes('</pre><img src=y>'), 'what the compiler said');
  await seen.close();
});

test('a heading sorts by its column, and a second click reverses the order', async () => {
  const seen = await open(browser, report.url);
  const points = async () => (await column(seen.page, 13)).map(Number);
  const given = await shownIds(seen.page);
  await heading(seen.page, 'Points').getByRole('button').click();
  assert.equal(await heading(seen.page, 'Points').getAttribute('aria-sort'), 'ascending');
  const ascending = await points();
  assert.ok(new Set(ascending).size > 5);
  assert.deepEqual(ascending, [...ascending].sort((a, b) => a - b));
  await heading(seen.page, 'Points').getByRole('button').click();
  assert.equal(await heading(seen.page, 'Points').getAttribute('aria-sort'), 'descending');
  assert.deepEqual(await points(), [...ascending].reverse().sort((a, b) => b - a));
  await heading(seen.page, 'Id').getByRole('button').click();
  assert.equal(await heading(seen.page, 'Points').getAttribute('aria-sort'), null);
  const ids = await shownIds(seen.page);
  assert.deepEqual([...ids].sort(), [...given].sort(), 'nobody is lost');
  assert.ok(ids.indexOf('s02') < ids.indexOf('s10'));
  assert.ok(ids.indexOf('ada') < ids.indexOf('zoë'));
  await seen.close();
});

test('the filters narrow the table together and show how many students are left', async () => {
  const seen = await open(browser, report.url);
  const { page } = seen;
  await page.getByLabel('Find').fill('ZO');
  assert.deepEqual(await shownIds(page), ['zoë']);
  assert.equal(await page.getByRole('status').textContent(), `1 of ${report.count} shown`);
  await page.getByLabel('Find').fill('');
  await page.getByLabel('Outcome').selectOption('compile_error');
  assert.deepEqual(await shownIds(page), ['mateo', 's13']);
  await page.getByLabel('Outcome').selectOption('');
  await page.getByLabel('Lost points in').selectOption('5');
  const lost = await column(page, 7);
  assert.ok(lost.length > 2 && lost.length < report.count);
  assert.ok(lost.every((points) => Number(points) < 10), lost.join());
  await page.getByLabel('only to review').check();
  assert.deepEqual(await shownIds(page), []);
  await page.getByLabel('only to review').uncheck();
  await page.getByLabel('Lost points in').selectOption('');
  assert.equal((await shownIds(page)).length, report.count);
  await seen.close();
});

test('searching for or clicking a mistake, bar, tile or outcome shows only its students', async () => {
  const seen = await open(browser, report.url);
  const { page } = seen;
  await page.getByLabel('Find').fill('matrix transposed');
  assert.deepEqual(await shownIds(page), ['ivan', 's20']);
  await page.locator('#m3 li', { hasText: 'matrix transposed' }).getByRole('button').click();
  assert.deepEqual(await shownIds(page), ['ivan', 's20']);
  assert.equal(await page.getByLabel('Find').inputValue(), '');
  await page.getByRole('button', { name: /^Only those with/ }).click();
  assert.equal((await shownIds(page)).length, report.count);
  await page.locator('.outcomes a[data-outcome="compile_error"]').click();
  assert.deepEqual(await shownIds(page), ['mateo', 's13']);
  await page.locator('.tiles a[data-filter="review"]').click();
  const flags = await page.locator('#class tbody tr:not([hidden]) td.flags').allTextContents();
  assert.equal(String(flags.length), await page.locator('.tiles a[data-filter="review"]').textContent());
  await page.locator('.distribution a').first().click();
  const points = await column(page, 13);
  assert.ok(points.length > 0 && points.every((each) => Number(each) < 10), points.join());
  await page.locator('.tiles a[data-filter="all"]').click();
  assert.equal((await shownIds(page)).length, report.count);
  await seen.close();
});

test('the table of students begins within the first two screens', async () => {
  const seen = await open(browser, report.url);
  const top = await seen.page.locator('#students').evaluate((one) => one.getBoundingClientRect().top + window.scrollY);
  assert.ok(top < 2000, `${top} pixels down`);
  await seen.close();
});

test('a student opens in a panel with printed and right answers, the picture and the next student', async () => {
  const seen = await open(browser, report.url);
  const { page } = seen;
  await page.locator('#class').getByRole('link', { name: 'ben', exact: true }).click();
  assert.equal(await panel(page).getByRole('heading', { level: 3 }).textContent(), 'ben');
  const row = panel(page).locator('tr', { hasText: '3.41421' }).first();
  assert.match(await row.textContent(), /^t3\.41421 line 230\.585786wrong0 of 1\.67$/);
  assert.ok((await panel(page).textContent()).includes('Start with question 6'));
  assert.ok(await panel(page).locator('figure svg').isVisible());
  await page.getByRole('button', { name: 'Next' }).click();
  assert.equal(await panel(page).getByRole('heading', { level: 3 }).textContent(), 'carla');
  assert.equal(await panel(page).locator('article').count(), 1, 'ben is back in his place');
  await page.getByRole('button', { name: 'Close' }).click();
  assert.equal(await panel(page).count(), 0);
  assert.equal(await page.locator('#each article').count(), report.count);
  await seen.close();
});

test('the output and the source are folded until a link to a line opens them', async () => {
  const seen = await open(browser, report.url);
  const { page } = seen;
  await page.locator('#class').getByRole('link', { name: 'bea', exact: true }).click();
  const output = panel(page).locator('details.listed').first();
  const source = panel(page).locator('details.listed').last();
  assert.equal(await output.locator('pre').isVisible(), false);
  const link = panel(page).locator('.answers').getByRole('link', { name: /^line \d+$/ }).first();
  const number = (await link.textContent()).slice('line '.length);
  await link.click();
  assert.ok(await output.locator('pre').isVisible());
  assert.match(await output.locator('span:target').textContent(), new RegExp(`^${number}.*1\\.P_VCS right\\s*$`));
  assert.equal(await source.locator('pre').isVisible(), false);
  await panel(page).locator('code').getByRole('link', { name: /^line/ }).first().click();
  assert.match(await source.locator('span:target').textContent(), /printed as a constant\s*$/);
  assert.ok((await source.locator('pre').textContent()).includes('#include'));
  await expectAccessible(page, 'with output and source');
  await seen.close();
});

test('the labels of the pictures do not overlap and stay inside', async () => {
  const seen = await open(browser, report.url);
  for (const who of ['ben', 'jin', 's09']) {
    await seen.page.locator('#class').getByRole('link', { name: who, exact: true }).click();
    await expectWordsApart(panel(seen.page).locator('figure svg'));
    await seen.page.getByRole('button', { name: 'Close' }).click();
  }
  await seen.close();
});

test('the report works with only the keyboard', async () => {
  const seen = await open(browser, report.url);
  const { page } = seen;
  const focused = () => page.evaluate(() => document.activeElement.textContent || document.activeElement.id);
  const tabTo = async (what) => {
    for (let i = 0; i < 400; ++i) {
      await page.keyboard.press('Tab');
      if ((await focused()) === what) return;
    }
    assert.fail(`Tab never came to ${what}`);
  };
  await tabTo('find');
  await page.keyboard.type('s0');
  assert.equal((await shownIds(page)).length, 9);
  await tabTo('Points');
  await page.keyboard.press('Enter');
  assert.equal(await heading(page, 'Points').getAttribute('aria-sort'), 'ascending');
  const [first, second] = await shownIds(page);
  await tabTo(first);
  await page.keyboard.press('Enter');
  assert.equal(await panel(page).getByRole('heading', { level: 3 }).textContent(), first);
  await tabTo('Next →');
  await page.keyboard.press('Enter');
  assert.equal(await panel(page).getByRole('heading', { level: 3 }).textContent(), second);
  await page.keyboard.press('Escape');
  assert.equal(await panel(page).count(), 0);
  // The page moves the focus after the browser has told that the panel is closed.
  await page.waitForFunction((id) => document.activeElement.textContent === id, second);
  await seen.close();
});

test('a mistake lists the students who made it', async () => {
  const seen = await open(browser, report.url);
  const group = seen.page.locator('#m3 li', { hasText: 'matrix transposed' });
  assert.ok((await group.textContent()).includes('ivan, s20'));
  await group.getByRole('link', { name: 's20' }).click();
  assert.equal(await panel(seen.page).getByRole('heading', { level: 3 }).textContent(), 's20');
  await seen.close();
});

for (const { name: size, ...window } of windows) {
  const name = `report-${size}`;
  test(`${name}: accessible, and it fits`, async () => {
    const seen = await open(browser, report.url, window);
    await expectAccessible(seen.page);
    await expectNoOverflow(seen.page);
    await screenshot(seen.page, name);
    await seen.page.locator('#class').getByRole('link', { name: 's09', exact: true }).click();
    await expectAccessible(seen.page, `${name}, with a student open`);
    await expectNoOverflow(seen.page);
    await screenshot(seen.page, `${name}-student`, { whole: false });
    await seen.close();
  });
}

test('without its script the report has the same content', async () => {
  const seen = await open(browser, report.url, { script: false });
  const { page } = seen;
  assert.equal(await page.locator('#class tbody tr').count(), report.count);
  assert.equal(await page.locator('#filter').isVisible(), false, 'no controls that do nothing');
  const ben = page.locator('#each details', { hasText: 'far root' }).first();
  assert.equal(await ben.locator('article').isVisible(), false);
  await ben.locator('summary').first().click();
  assert.ok(await ben.locator('article').isVisible());
  await expectNoOverflow(page);
  await seen.close();
});

test('on paper there are no controls, and the students in the table are printed in full', async () => {
  const seen = await open(browser, report.url, { width: 800 });
  const { page } = seen;
  await page.getByLabel('Find').fill('s0');
  await page.getByRole('button', { name: 'Show these in full' }).click();
  await page.emulateMedia({ media: 'print' });
  assert.equal(await page.locator('#filter').isVisible(), false);
  assert.equal(await page.locator('#each article:visible').count(), 9);
  assert.ok(await page.locator('#class').isVisible());
  await expectNoOverflow(page);
  await screenshot(page, 'report-paper');
  const pdf = await page.pdf({ format: 'A4' });
  assert.ok((pdf.toString('latin1').match(/\/Type \/Page\b/g) ?? []).length >= 10, 'each of the nine on a page of its own');
  await seen.close();
});

test('on paper an open student is the only content', async () => {
  const seen = await open(browser, `${report.url}#s3`, { width: 800 });
  await seen.page.emulateMedia({ media: 'print' });
  assert.ok(await seen.page.locator('#s3').isVisible());
  assert.equal(await seen.page.locator('main').isVisible(), false);
  await screenshot(seen.page, 'report-paper-student');
  await seen.close();
});
