// SPDX-License-Identifier: Apache-2.0
// Checks every page of an evidence pack with axe-core and prints it.
'use strict';

const { execFileSync } = require('node:child_process');
const assert = require('node:assert');
const fs = require('node:fs');
const os = require('node:os');
const path = require('node:path');
const test = require('node:test');
const { chromium } = require('playwright-core');

const pack = process.env.PACK;
const axe = fs.readFileSync(require.resolve('axe-core/axe.min.js'), 'utf8');
const pages = fs.readdirSync(pack).filter((name) => name.endsWith('.html'));
const manifest = JSON.parse(fs.readFileSync(path.join(pack, 'manifest.json'), 'utf8'));
const sizeOf = (name) => fs.statSync(path.join(pack, name)).size;
const largest = (names) => names.reduce((one, other) => (sizeOf(other) > sizeOf(one) ? other : one));
// The pages of sources are generated in one way, and so are those of the devices' audits: axe checks the largest of each.
const sources = Object.keys(manifest.sha256).filter((name) => name.startsWith('source/'));
const audits = pages.filter((name) => name.startsWith('audit-'));
const checkedByAxe = (name) => !audits.includes(name) || name === largest(audits);
const MOST_SHEETS = 60; // of the audit of one device
const TAGS = ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'wcag22aa', 'best-practice'];
// The rows of a table are generated in one way. axe checks this many of each table, so that the page of 5,000 items
// takes only minutes. Where a page has many tables of one kind, in `details`, these have fewer rows.
const ROWS = 20;
const ROWS_OF_DETAILS = 2;
const LOOKS = [
  { width: 1280, height: 900, colorScheme: 'light' },
  { width: 390, height: 844, colorScheme: 'dark' },
];

let browser;
test.before(async () => {
  browser = await chromium.launch({ executablePath: '/usr/bin/chromium', args: ['--no-sandbox'] });
});
test.after(() => browser.close());

async function opened(name, look) {
  const context = await browser.newContext({ viewport: { width: look.width, height: look.height }, colorScheme: look.colorScheme });
  const page = await context.newPage();
  await page.goto(`file://${path.join(pack, name)}`);
  return page;
}

async function shortened(page) {
  await page.evaluate(([most, few]) => {
    for (const part of document.querySelectorAll('details')) part.open = true;
    for (const body of document.querySelectorAll('tbody')) {
      [...body.rows].slice(body.closest('details') ? few : most).forEach((row) => row.remove());
    }
    for (const list of document.querySelectorAll('ul, ol')) [...list.children].slice(most).forEach((item) => item.remove());
  }, [ROWS, ROWS_OF_DETAILS]);
}

for (const name of [...pages, largest(sources)]) {
  test(`${name}: WCAG 2.2 AA, headings, width`, async () => {
    for (const look of LOOKS) {
      const page = await opened(name, look);
      await shortened(page);
      const at = `${name} at ${look.width} px, ${look.colorScheme}`;
      assert.strictEqual(await page.locator('h1').count(), 1, `${at}: first headings`);
      const wider = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
      assert.ok(wider <= 0, `${at}: ${wider} px wider than the screen`);
      if (!checkedByAxe(name)) {
        await page.context().close();
        continue;
      }
      await page.evaluate(axe);
      const found = await page.evaluate((tags) => window.axe.run(document, { runOnly: tags }), TAGS);
      assert.ok(found.passes.length > 5, `${at}: axe has looked at nothing`);
      const told = found.violations.map((one) => `${one.id}: ${one.help}: ${one.nodes[0].html.slice(0, 120)} (${one.nodes.length})`);
      assert.deepStrictEqual(told, [], at);
      await page.context().close();
    }
  });
}

async function printed(name) {
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'pages-'));
  const page = await opened(name, LOOKS[0]);
  const pdf = path.join(folder, 'page.pdf');
  await page.pdf({ path: pdf, preferCSSPageSize: true });
  const sheets = execFileSync('pdftotext', [pdf, '-'], { encoding: 'utf8' }).split('\f').slice(0, -1);
  fs.rmSync(folder, { recursive: true });
  await page.context().close();
  return sheets;
}

for (const [name, title] of [['hazards.html', 'Hazards'], [largest(audits), 'Audit of ']]) {
  test(`each printed sheet of ${name} shows title, commit and date`, async () => {
    const sheets = await printed(name);
    assert.ok(sheets.length > 1, 'several sheets');
    for (const [at, sheet] of sheets.entries()) {
      for (const word of [title, manifest.commit.slice(0, 12), manifest.date]) assert.ok(sheet.includes(word), `sheet ${at + 1} says ${word}`);
    }
    if (audits.includes(name)) {
      assert.ok(sheets.length < MOST_SHEETS, `${sheets.length} sheets`);
      const ids = new Set(fs.readFileSync(path.join(pack, name), 'utf8').match(/(?<=<code id=")[^"]+/g));
      const bare = (words) => words.replace(/[\s-]/g, ''); // a printed id can be divided at a hyphen
      const text = bare(sheets.join(''));
      assert.ok(ids.size > 10, 'several items');
      for (const id of ids) assert.ok(text.includes(bare(id)), `${id} is printed`);
    }
  });
}

test('words, kinds and states filter the items of a device', async () => {
  const page = await opened(largest(audits), LOOKS[0]);
  const rows = page.locator('tbody tr:visible');
  assert.strictEqual(await rows.count(), 0, 'services are closed at first');
  const id = await page.locator('tbody code[id]').first().getAttribute('id');
  await page.getByRole('searchbox').fill(id);
  assert.ok((await rows.allTextContents()).every((text) => text.includes(id)), 'a searched word');
  assert.ok((await rows.count()) >= 1, 'a search opens what it finds');
  await page.getByRole('searchbox').fill('');
  await page.getByLabel('Kind').selectOption('table');
  const kinds = await page.locator('tbody tr:visible .kind').allTextContents();
  assert.ok(kinds.length > 1 && kinds.every((kind) => kind === 'table'), `a chosen kind: ${kinds}`);
  await page.getByLabel('State').selectOption('failed');
  const states = await page.locator('tbody tr:visible td .state').allTextContents();
  assert.ok(states.every((state) => state.endsWith('failed')), `a chosen state: ${states}`);
  await page.context().close();
});

test('an item of the audit is reached by its address, and its code and test by their links', async () => {
  const name = largest(audits);
  const context = await browser.newContext();
  const page = await context.newPage();
  await page.goto(`file://${path.join(pack, name)}`);
  const id = await page.locator('tr', { has: page.locator('a[href*="_test.cpp.html#L"]') }).locator('code[id]').last().getAttribute('id');
  await page.goto(`file://${path.join(pack, name)}#${id}`);
  const row = page.locator('tr', { has: page.locator(`[id="${id}"]`) });
  assert.ok(await row.isVisible(), `${id} is visible`);
  await row.locator('a[href*="_test.cpp.html#L"]').first().click();
  assert.match(await page.locator('li:target').textContent(), /\b(TEST|TEST_F|TEST_P|RC_GTEST_PROP|RC_GTEST_FIXTURE_PROP)\(/);
  await page.locator('li:target a', { hasText: id }).click();
  assert.ok(page.url().endsWith(`${name}#${id}`), `the test leads back to ${id}`);
  await context.close();
});
