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
const commit = JSON.parse(fs.readFileSync(path.join(pack, 'manifest.json'), 'utf8')).commit;
const TAGS = ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'wcag22aa', 'best-practice'];
// The rows of a table are generated in one way. axe checks this many of each table, so that the page of 5,000 items
// takes only minutes.
const ROWS = 20;
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
  await page.evaluate((most) => {
    for (const body of document.querySelectorAll('tbody')) [...body.rows].slice(most).forEach((row) => row.remove());
    for (const list of document.querySelectorAll('ul')) [...list.children].slice(most).forEach((item) => item.remove());
  }, ROWS);
}

for (const name of pages) {
  test(`${name}: WCAG 2.2 AA, headings, width`, async () => {
    for (const look of LOOKS) {
      const page = await opened(name, look);
      await shortened(page);
      const at = `${name} at ${look.width} px, ${look.colorScheme}`;
      assert.strictEqual(await page.locator('h1').count(), 1, `${at}: first headings`);
      const wider = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
      assert.ok(wider <= 0, `${at}: ${wider} px wider than the screen`);
      await page.evaluate(axe);
      const found = await page.evaluate((tags) => window.axe.run(document, { runOnly: tags }), TAGS);
      assert.ok(found.passes.length > 5, `${at}: axe has looked at nothing`);
      const told = found.violations.map((one) => `${one.id}: ${one.help}: ${one.nodes[0].html.slice(0, 120)} (${one.nodes.length})`);
      assert.deepStrictEqual(told, [], at);
      await page.context().close();
    }
  });
}

test('each printed sheet shows its commit', async () => {
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'pages-'));
  const page = await opened('hazards.html', LOOKS[0]);
  const pdf = path.join(folder, 'page.pdf');
  await page.pdf({ path: pdf, preferCSSPageSize: true });
  const sheets = execFileSync('pdftotext', ['-layout', pdf, '-'], { encoding: 'utf8' }).split('\f').slice(0, -1);
  fs.rmSync(folder, { recursive: true });
  assert.ok(sheets.length > 1, 'several sheets');
  sheets.forEach((sheet, number) => assert.ok(sheet.includes(commit.slice(0, 12)), `sheet ${number + 1} says its commit`));
});
