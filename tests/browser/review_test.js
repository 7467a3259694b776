// The review of a class as an instructor uses it: by the keyboard alone, with a mouse, and without scripts.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { mkdir, mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { createInterface } from 'node:readline';
import { after, before, beforeEach, test } from 'node:test';

import { expectAccessible, expectNoOverflow, folder, open, raygrade, screenshot, startBrowser } from './browser.js';

/** Prints question 5 twice: first with these numbers, which are read, and then, in line 6, rightly, for 10 points. */
const twice = (numbers) => `#include <cstdio>
int main() {
  puts("Question 5:\\nV: vec3(${numbers})");
  puts("Question 6:\\na: 1");
  puts("Question 5:\\nV: vec3(0.000000, 0.000000, -1.000000)");
}
`;
const sources = {
  ada: twice('0.5, 0, -1'),
  ben: twice('0.25, 0, -1'),
  cleo: '#include <cstdio>\nint main() { puts("Question 5:\\nV: vec3(0.000000, 0.000000, -1.000000)"); }\n',
};

let browser;
let scratch;
let results;
let running = null;

before(async () => {
  browser = await startBrowser();
  scratch = await mkdtemp(path.join(folder, 'review-'));
  for (const [who, source] of Object.entries(sources)) {
    await mkdir(path.join(scratch, 'class', who), { recursive: true });
    await writeFile(path.join(scratch, 'class', who, 'ray_cast.cpp'), source);
  }
  await mkdir(path.join(scratch, 'class', 'dan'));
});

beforeEach(async () => {
  running?.kill('SIGKILL');
  running = null;
  results = await mkdtemp(path.join(scratch, 'results-'));
  const { status, stderr } = await raygrade('grade', path.join(scratch, 'class'), '--out', results);
  assert.equal(status, 1, stderr);  // dan handed in nothing
});

after(async () => {
  running?.kill('SIGKILL');
  await browser?.close();
  if (scratch) await rm(scratch, { recursive: true });
});

/** raygrade review of the results in the folder; its address. */
async function review(reviewed = results) {
  running = spawn(process.env.RAYGRADE_BINARY, ['review', reviewed, '--by', 'Prof. X'], { stdio: ['ignore', 'pipe', 'ignore'] });
  for await (const line of createInterface({ input: running.stdout })) {
    const found = line.match(/http:\/\/127\.0\.0\.1:\d+\/[0-9a-f]{32}\//);
    if (found) return found[0];
  }
  throw new Error('raygrade review ended without an address');
}

async function points(who) {
  const grades = JSON.parse(await readFile(path.join(results, 'grades.json'), 'utf8'));
  return grades.submissions.find(({ id }) => id === who).points;
}

const left = (page) => page.locator('.steps .facts').innerText();

test('the keyboard is enough to review a class: reread, points, accept, comment, undo', async () => {
  const site = await review();
  const seen = await open(browser, site, { site });
  const { page } = seen;
  const { keyboard } = page;
  // What a page says can be read before its script listens to keys: a key pressed in between would be lost.
  const listening = async (shown) => {
    await shown.waitFor();
    await page.waitForLoadState();
  };
  const arrive = (heading) => listening(page.getByRole('heading', { level: 1, name: heading, exact: true }));
  const told = (text) => listening(page.getByRole('status').filter({ hasText: text }));

  await keyboard.press('j');
  await arrive('ada');
  assert.equal(await left(page), '3 of 3 left to review');
  assert.equal(await page.locator('#reading [name="about"]').inputValue(), '5.V');
  await keyboard.press('r');
  await keyboard.press('ArrowUp');
  assert.equal(await page.locator('#reading [name="lines"]').inputValue(), '5');
  await keyboard.press('ArrowDown');
  await keyboard.press('Shift+ArrowDown');
  assert.equal(await page.locator('#reading [name="lines"]').inputValue(), '6', 'there is no line 7');
  assert.equal(await page.locator('#printout .chosen').innerText().then((text) => text.startsWith('6')), true);
  await keyboard.press('Tab');
  await keyboard.press('Tab');
  await keyboard.type('the last one');  // the letters are no keys here
  await keyboard.press('Enter');
  await told('Read again (question 5, V) for ada');
  assert.ok(Math.abs(await points('ada') - 11.67) < 0.01);

  await keyboard.press('u');
  await told('Undone');
  assert.ok(Math.abs(await points('ada') - 1.67) < 0.01);

  await keyboard.press('o');
  await keyboard.type('4');
  await keyboard.press('Tab');
  await keyboard.type('nearly');
  await keyboard.press('Enter');
  await told('Points given (question 5, V) for ada');
  assert.ok(Math.abs(await points('ada') - 5.67) < 0.01);
  assert.equal(await left(page), '2 of 3 left to review', 'what was doubtful is settled');

  await keyboard.press('n');
  await arrive('ben');
  await keyboard.press('c');
  await keyboard.type('Print each answer once.');
  await keyboard.press('Tab');
  await keyboard.press('Enter');
  await told('Comment added for ben');
  await keyboard.press('a');
  await arrive('dan');
  await told('Accepted for ben');
  await keyboard.press('a');
  await arrive('Review');
  await page.getByText('Nothing is left to review.').waitFor();
  const feedback = await readFile(path.join(results, 'feedback', 'ben.html'), 'utf8');
  assert.match(feedback, /Print each answer once\./);

  await keyboard.press('?');
  await page.getByRole('dialog', { name: 'Keys' }).waitFor();
  await expectAccessible(page, 'the keys');
  await keyboard.press('Escape');
  await page.getByRole('dialog').waitFor({ state: 'hidden' });
  await seen.close();
});

for (const [name, options] of Object.entries({
  1600: { width: 1600 }, '390-dark': { width: 390, height: 844, dark: true } })) {
  test(`the pages are accessible and fit, ${name}`, async () => {
    const site = await review();
    const seen = await open(browser, site, { ...options, site });
    const look = async (what) => {
      await expectAccessible(seen.page, what);
      await expectNoOverflow(seen.page);
      await screenshot(seen.page, `review-${what}-${name}`);
    };
    await look('list');
    await seen.page.getByRole('link', { name: 'ada', exact: true }).first().click();
    await look('student');
    await seen.page.locator('#points [name="points"]').fill('x');
    await seen.page.getByRole('button', { name: 'Give points' }).click();
    await seen.page.getByRole('alert').waitFor();
    await look('refused');
    await seen.page.locator('#points [name="points"]').fill('3');
    await seen.page.locator('#points [name="text"]').fill('half');
    await seen.page.getByRole('button', { name: 'Give points' }).click();
    await seen.page.getByRole('status').waitFor();
    await look('decided');
    await seen.page.goto(`${site}student/2`);
    await seen.page.locator('#reading [name="text"]').fill('the last one');
    await seen.page.getByRole('button', { name: /^For all 2 with this layout/ }).click();
    await seen.page.getByRole('heading', { name: 'Which students?' }).waitFor();
    await look('group');
    await seen.page.goto(`${site}student/4`);
    await look('not-graded');
    await seen.close([/status of 422/]);
  });
}

test('the search narrows the list of students', async () => {
  const site = await review();
  const { page } = await open(browser, site, { site });
  const shown = () => page.locator('table.students tbody tr:visible th').allInnerTexts();
  assert.equal((await shown()).length, 4);
  await page.getByLabel('Search').fill('BEN');
  assert.deepEqual(await shown(), ['ben']);
});

test('the mouse selects lines and removes a student from a group', async () => {
  const site = await review();
  const seen = await open(browser, site, { site });
  const { page } = seen;
  await page.goto(`${site}student/1`);
  await page.locator('#printout #line-4').click();
  await page.locator('#printout #line-6').click({ modifiers: ['Shift'] });
  assert.equal(await page.locator('#reading [name="lines"]').inputValue(), '4-6');
  await page.locator('#printout #line-6').click();
  await page.locator('#reading [name="text"]').fill('the last one');
  await page.getByRole('button', { name: /^For all 2 with this layout/ }).click();
  await page.getByRole('checkbox', { name: 'ada' }).uncheck();
  await page.getByRole('button', { name: /Apply to these students/ }).click();
  await page.getByRole('status').filter({ hasText: 'Read again (question 5, V) for ben.' }).waitFor();
  assert.ok(Math.abs(await points('ada') - 1.67) < 0.01);
  assert.ok(Math.abs(await points('ben') - 11.67) < 0.01);
  await page.getByRole('button', { name: /^Undo/ }).click();
  await page.getByRole('status').filter({ hasText: 'Undone' }).waitFor();
  assert.ok(Math.abs(await points('ben') - 1.67) < 0.01);
  await seen.close();
});

test('the later of two windows reports what the other one changed', async () => {
  const site = await review();
  const seen = await open(browser, site, { site });
  const first = seen.page;
  const second = await first.context().newPage();
  await first.goto(`${site}student/1`);
  await second.goto(`${site}student/1`);
  const give = async (page, given, why) => {
    await page.locator('#points [name="points"]').fill(given);
    await page.locator('#points [name="text"]').fill(why);
    await page.getByRole('button', { name: 'Give points' }).click();
  };
  await give(first, '7', 'from the first');
  await first.getByRole('status').waitFor();
  await give(second, '3', 'from the second');
  await second.getByRole('alert').filter({ hasText: 'ada changed since this page was loaded, so nothing was done' }).waitFor();
  await second.getByText('7 points for question 5, V, by Prof. X').first().waitFor();
  assert.equal(await second.locator('#points [name="text"]').inputValue(), 'from the second', 'what was typed is still there');
  assert.ok(Math.abs(await points('ada') - 8.67) < 0.01);
  await second.getByRole('button', { name: 'Give points' }).click();
  await second.getByRole('status').waitFor();
  assert.ok(Math.abs(await points('ada') - 4.67) < 0.01);
  await seen.close([/status of 409/]);
});

/** Computes V and prints it, and prints a number for t that is too many lines away to be in view with it. */
const computing = `#include <cstdio>
int main() {
  float x = 0.5, z;
  z = -1;
  puts("Question 5:");
  printf("V: %f %f %f\\n", x, 0.0, z);
  for (int i = 0; i < 120; ++i) puts("");
${'  // nothing\n'.repeat(119)}  float t = 1.5;
  puts("Question 6:");
  printf("t: %f\\n", t);
}
`;

test('the source marks the lines that compute the chosen item, by mouse, by keys and without script', async () => {
  const classFolder = path.join(scratch, 'computing');
  await mkdir(path.join(classFolder, 'eva'), { recursive: true });
  await writeFile(path.join(classFolder, 'eva', 'ray_cast.cpp'), computing);
  const graded = path.join(scratch, 'results-computing');
  const { status, stderr } = await raygrade('grade', classFolder, '--out', graded);
  assert.equal(status, 0, stderr);
  const site = await review(graded);
  const seen = await open(browser, site, { site });
  const { page } = seen;
  const framed = () => page.locator('[id^="source-"].chosen i').allInnerTexts();
  const isShown = (line, pane = 'source') => page.locator(`#${pane}-${line}`).evaluate((row) => {
    const [inner, outer] = [row.getBoundingClientRect(), row.parentElement.getBoundingClientRect()];
    return outer.top <= inner.top && inner.bottom <= outer.bottom;
  });
  await page.goto(`${site}student/1`);
  await page.locator('[data-item="6.t"] th').click();
  assert.deepEqual(await framed(), ['127', '129']);
  assert.ok(await isShown(127) && await isShown(129));
  assert.ok(await isShown(124, 'line'), 'the printout too is at the item');
  await page.locator('#reading [name="about"]').selectOption('5.V');
  assert.deepEqual(await framed(), ['3', '4', '6']);
  assert.ok(await isShown(3) && await isShown(6));
  assert.ok(await isShown(2, 'line') && !await isShown(124, 'line'));
  await page.locator('#reading [name="about"]').selectOption('6.hit');
  assert.deepEqual(await framed(), [], 'it was not printed');
  assert.match(await page.locator('#source-4').innerText(), /sets z, printed as 5\.V/);
  await expectAccessible(page, 'the source');
  await seen.close();

  const plain = await open(browser, site, { site, script: false });
  await plain.page.goto(`${site}student/1`);
  await plain.page.locator('[data-item="6.t"]').getByRole('link', { name: 'source line 129' }).click();
  assert.equal(await plain.page.locator(':target').getAttribute('id'), 'source-129');
  await plain.close();
});

test('it also works without script', async () => {
  const site = await review();
  const seen = await open(browser, site, { site, script: false });
  const { page } = seen;
  await page.getByRole('link', { name: /^Start with ada/ }).click();
  await page.locator('#reading [name="text"]').fill('the last one');
  await page.getByRole('button', { name: 'Read it from there' }).click();
  await page.getByRole('status').filter({ hasText: 'Read again (question 5, V) for ada' }).waitFor();
  assert.ok(Math.abs(await points('ada') - 11.67) < 0.01);
  await page.getByRole('button', { name: /^Undo/ }).click();
  await page.getByRole('status').filter({ hasText: 'Undone' }).waitFor();
  await page.getByRole('button', { name: /^Accept/ }).click();
  await page.getByRole('heading', { level: 1, name: 'ben' }).waitFor();
  await seen.close();
});
