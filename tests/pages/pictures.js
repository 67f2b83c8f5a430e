// SPDX-License-Identifier: Apache-2.0
// node tests/pages/pictures.js PROGRAM PACK FOLDER: writes the two pictures of README.md to FOLDER: panel.png shows the panel of PROGRAM
// (canproof), pack.png a page of the evidence pack PACK. NODE_PATH must be the folder of the modules that tests/pages/run has installed.
'use strict';
const { spawn } = require('node:child_process');
const { once } = require('node:events');
const path = require('node:path');
const { pathToFileURL } = require('node:url');
const { chromium } = require('playwright-core');

const [program, pack, folder] = process.argv.slice(2).map((word) => path.resolve(word));

/** Starts the panel of two devices on a free port; returns its process and its address. */
async function startPanel() {
  const child = spawn(program, ['panel', '--port', '0', 'cbx-ao412', 'ax130751']);
  let text = '';
  while (!/http:\/\/\S+/.test(text)) text += (await once(child.stdout, 'data'))[0];
  return { child, url: /http:\/\/\S+/.exec(text)[0] };
}

async function main() {
  const browser = await chromium.launch({ executablePath: '/usr/bin/chromium', args: ['--no-sandbox', '--disable-gpu'] });
  const page = await browser.newPage({ viewport: { width: 1280, height: 800 } });
  const panel = await startPanel();
  await page.goto(panel.url);
  await page.getByRole('slider').first().waitFor();
  await page.screenshot({ path: path.join(folder, 'panel.png') });
  panel.child.kill('SIGTERM');
  await page.goto(pathToFileURL(path.join(pack, 'audit-cbx-ao412.html')).href);
  await page.locator('summary', { hasText: 'Guarding' }).click();
  await page.screenshot({ path: path.join(folder, 'pack.png') });
  await browser.close();
}

main();
