// Class reports of a thousand students, and of so many that names link to the students' own pages. They run at night,
// because grading so many takes minutes. tests/harness/report/class checks the contents of the pages by day.
import assert from 'node:assert/strict';
import { cp, mkdir, mkdtemp, readdir, rm, stat } from 'node:fs/promises';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';

import { expectAccessible, expectNoOverflow, folder, open, raygrade, startBrowser } from './browser.js';
import { column, heading, panel, shownIds } from './class_report.js';

const project = fileURLToPath(new URL('../..', import.meta.url));

let browser;
let scratch;

before(async () => {
  browser = await startBrowser();
  scratch = await mkdtemp(path.join(folder, 'large-report-'));
});

after(async () => {
  await browser?.close();
  if (scratch) await rm(scratch, { recursive: true });
});

/** Grades this many copies of the sample submissions, ada-0, ben-2, …, and returns the path of the report. */
async function gradeCopies(count) {
  // Without the programs that run until a limit stops them, because each takes that long.
  const endless = ['hostile', '2024', 'oskar', 'quentin', 's07', 's19', 'nadia'];
  const names = (await readdir(path.join(project, 'submissions'))).filter((name) => !endless.includes(name)).sort();
  const many = path.join(scratch, `copies-${count}`);
  for (let i = 0; i < count; ++i) {
    const name = names[i % names.length];
    const to = path.join(many, `${name}-${i}`);
    await mkdir(to, { recursive: true });
    await cp(path.join(project, 'submissions', name, 'ray_cast.cpp'), path.join(to, 'ray_cast.cpp'));
  }
  const out = path.join(scratch, `results-${count}`);
  const { status, stderr } = await raygrade('grade', many, '--assignment', 'a6-2021', '--out', out);
  assert.equal(status, 0, stderr);
  return path.join(out, 'report.html');
}

test('a report on a thousand students is small enough and works', async () => {
  const file = await gradeCopies(1000);
  assert.ok((await stat(file)).size < 15e6);
  const seen = await open(browser, pathToFileURL(file).href);
  await seen.page.getByLabel('Find').fill('-999');
  assert.equal((await shownIds(seen.page)).length, 1);
  await seen.page.locator('#class tbody tr:not([hidden]) a').click();
  assert.ok(await panel(seen.page).isVisible());
  await seen.close();
});

test('in a large class, names link to the students\' own pages, and the filters work', async () => {
  const count = 2001;
  const file = await gradeCopies(count);
  assert.ok((await stat(file)).size < 2e6);
  const seen = await open(browser, pathToFileURL(file).href, { site: pathToFileURL(path.join(path.dirname(file), 'feedback/')).href });
  const { page } = seen;
  assert.equal(await page.locator('article').count(), 0);
  assert.equal(await page.getByRole('button', { name: 'Show these in full' }).count(), 0);
  assert.equal(await page.getByRole('link', { name: 'Each student' }).count(), 0);
  await expectAccessible(page);
  await expectNoOverflow(page);
  await heading(page, 'Points').getByRole('button').click();
  const points = (await column(page, 13)).map(Number).filter((each) => !isNaN(each));
  assert.deepEqual(points, [...points].sort((a, b) => a - b));
  const group = page.locator('#m3 li', { hasText: 'matrix transposed' });
  const named = await group.locator('.who a').allTextContents();
  await group.getByRole('button').click();
  assert.deepEqual((await shownIds(page)).sort(), named.sort());
  await page.getByRole('button', { name: /^Only those with/ }).click();
  await page.getByLabel('Find').fill('-2000');
  const [id] = await shownIds(page);
  const [own] = await Promise.all([
    page.context().waitForEvent('page'), page.locator('#class tbody tr:not([hidden]) a').click()]);
  await own.waitForLoadState();
  assert.ok((await own.locator('body').textContent()).includes(id));
  assert.ok(own.url().endsWith(`feedback/${id}.html`));
  assert.deepEqual(await shownIds(page), [id], 'the filter is as it was');
  await seen.close();
});
