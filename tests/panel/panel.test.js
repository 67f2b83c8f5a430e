// SPDX-License-Identifier: Apache-2.0
// Tests the actions and displays of the panel in a real browser. Each wait is for a condition, not for a time. The
// kernel chooses each port.
'use strict';
const assert = require('node:assert/strict');
const { spawn, spawnSync } = require('node:child_process');
const { once } = require('node:events');
const http = require('node:http');
const net = require('node:net');
const { after, before, test } = require('node:test');
const { chromium } = require('playwright-core');
const { lowContrast } = require('./contrast.js');

const canproof = process.env.PROGRAM;
const chromiumOptions = {
  executablePath: '/usr/bin/chromium',
  args: ['--no-sandbox', '--disable-gpu', '--host-resolver-rules=MAP evil.example 127.0.0.1'],
};
const patience = 120000; // milliseconds; reached only with a broken panel

let browser;
let panel;

/** Starts `canproof panel` on a free port. Returns its process, its messages and its open pages. stop() closes these pages first. */
async function startPanel(...words) {
  const child = spawn(canproof, ['panel', '--port', '0', ...words]);
  let notices = '';
  child.stderr.on('data', (data) => { notices += data; });
  const url = await new Promise((resolve, reject) => {
    let text = '';
    child.stdout.on('data', (data) => {
      text += data;
      const found = /http:\/\/\S+/.exec(text);
      if (found) resolve(found[0]);
    });
    child.on('exit', (status) => reject(new Error(`canproof panel ended with ${status}: ${text}`)));
  });
  const ended = new Promise((resolve) => { child.on('exit', (status) => resolve(status)); });
  const says = async (pattern) => {
    while (!pattern.test(notices)) await once(child.stderr, 'data');
    return notices;
  };
  const pages = new Set();
  const stop = async () => {
    for (const close of [...pages]) await close(); // first: a page that polls an ended program reports an error
    child.kill('SIGINT');
    assert.equal(await ended, 0); // Ctrl-C ends the program without an error
  };
  return { child, url, says, pages, stop };
}

/** Opens a page that is connected to the program. An error or a warning on its console fails the test. */
async function openPage(t, options = {}, program = panel) {
  const context = await browser.newContext({ viewport: { width: 1440, height: 900 }, ...options });
  const page = await context.newPage();
  page.setDefaultTimeout(patience);
  const complaints = [];
  page.on('console', (message) => { if (['error', 'warning'].includes(message.type())) complaints.push(message.text()); });
  page.on('pageerror', (error) => complaints.push(error.message));
  const close = async () => {
    if (!program.pages.delete(close)) return;
    const heard = [...complaints]; // copied first: closing a page interrupts its requests, which the page reports as errors
    await context.close();
    assert.deepEqual(heard, []);
  };
  program.pages.add(close);
  t.after(close);
  await page.goto(program.url);
  await page.waitForSelector('html[data-ready]');
  return page;
}

const card = (page, device) => page.locator(`[data-device="${device}"]`);
const control = (page, device, signal) => card(page, device).locator(`[data-signal="${signal}"]`);
const lamp = (page, device, label) => card(page, device).locator('.lamp', { hasText: label });

/** Waits until `holds` is true inside the page; checks it once per animation frame. The policy of the page forbids the
    evaluation of strings, which the wait of the driver needs. */
async function until(page, holds) {
  const end = Date.now() + patience;
  while (!await page.evaluate(holds)) {
    assert.ok(Date.now() < end, `never: ${holds}`);
    await page.evaluate(() => new Promise(requestAnimationFrame));
  }
}

/** Calls `act`, which sends a frame from the page. Returns when the program has received the frame. */
async function sends(page, act) {
  const [answer] = await Promise.all([page.waitForResponse((one) => one.url().endsWith('/api/frame')), act()]);
  assert.equal(answer.status(), 200);
}

async function send(page, frame) {
  await page.fill('#frame', frame);
  await sends(page, () => page.click('#send button'));
}

/** Returns the times at which a channel (an input or output) of a device changed, in microseconds of the program's own clock. */
async function changesOf(device, channel) {
  const ask = async (path) => (await fetch(`${panel.url}${path}`)).json();
  const names = (await ask('api/panel')).devices.flatMap((one) => one.channels.map((each) => `${one.name}.${each.name}`));
  const wanted = names.indexOf(`${device}.${channel}`);
  return (await ask('api/state')).changes.filter(([, at]) => at === wanted).map(([time]) => time);
}

/** Waits until the lamp, the emergency and its frame show that channel `number` is past its shutdown limit. */
async function expectShutdown(page, number) {
  await card(page, 'ax188001').locator('.emcy.error', { hasText: `F011h limit exceeded, channel ${number}, positive shutdown` }).waitFor();
  await lamp(page, 'ax188001', 'ERR').locator('.bulb[data-look=lit]').waitFor();
  const row = page.locator('#frames tr.is-EMCY', { hasText: `channel ${number}, positive shutdown` }).first();
  await row.waitFor();
  // AX188001 is node 2. Its manual, 3.2.4: code F011h, register 01h, channel, description 40h.
  assert.match(await row.innerText(), new RegExp(`082\\s+11 F0 01 0${number} 40 00 00 00\\s+EMCY\\s+ax188001`));
}

before(async () => {
  panel = await startPanel();
  browser = await chromium.launch(chromiumOptions);
});
after(async () => {
  await panel?.stop();
  await browser?.close();
});

test('a temperature dragged past the shutdown limit is shown by lamp, emergency and frame', async (t) => {
  const page = await openPage(t);
  assert.equal(await lamp(page, 'ax188001', 'ERR').locator('.words').innerText(), 'off');
  await send(page, '602#2B30400100000000'); // 4030h:1 error react delay: none
  const slider = control(page, 'ax188001', 'tc1_celsius').locator('input[type=range]');
  await slider.scrollIntoViewIfNeeded();
  const box = await slider.boundingBox();
  const at = (celsius) => box.x + 9 + (box.width - 18) * (celsius + 270) / 2090; // −270 … 1820 °C
  await page.mouse.move(at(25), box.y + box.height / 2);
  await page.mouse.down();
  for (const celsius of [100, 200, 400, 600]) await page.mouse.move(at(celsius), box.y + box.height / 2);
  await page.mouse.up();
  await expectShutdown(page, 1);
  assert.ok(Math.abs(Number(await slider.inputValue()) - 600) <= 20);
  // The measured value of the device follows the slider.
  await until(page, () => /^(58\d|59\d|60\d|61\d)\s°C$/.test(document.querySelector('[data-device=ax188001] .gauge .figure').textContent));
  await control(page, 'ax188001', 'tc1_celsius').locator('input[type=number]').fill('25');
  await page.keyboard.press('Enter');
  await lamp(page, 'ax188001', 'ERR').locator('.bulb[data-look=dark]').waitFor();
});

test('a temperature is set past the shutdown limit with the keyboard alone, and the focus is always visible', async (t) => {
  const page = await openPage(t);
  const focus = () => page.evaluate(() => {
    const at = document.activeElement;
    return { id: at.id, signal: at.type === 'range' ? at.closest('[data-signal]')?.dataset.signal : '', outline: getComputedStyle(at).outlineStyle, named: at.getAttribute('aria-label') || at.labels?.[0]?.textContent || at.textContent || '' };
  });
  const tabTo = async (wanted, key = 'Tab') => {
    for (let i = 0; i < 150; i += 1) {
      await page.keyboard.press(key);
      const at = await focus();
      assert.notEqual(at.outline, 'none', `focus is not seen at ${JSON.stringify(at)}`);
      assert.notEqual(at.named.trim(), '', `no name at ${JSON.stringify(at)}`);
      if (wanted(at)) return;
    }
    assert.fail('not reached by Tab');
  };
  await page.keyboard.press('Tab'); // the link to the main content
  await page.keyboard.press('Enter');
  await tabTo((at) => at.id === 'frame');
  await page.keyboard.type('602#2B30400200000000'); // 4030h:2 error react delay: none
  await sends(page, () => page.keyboard.press('Enter'));
  await tabTo((at) => at.signal === 'tc2_celsius', 'Shift+Tab');
  for (let i = 0; i < 3; i += 1) await page.keyboard.press('PageUp'); // each step is a tenth of the range
  await expectShutdown(page, 2);
  assert.match(await page.evaluate(() => document.activeElement.getAttribute('aria-valuetext')), /°C$/);
  assert.match(await page.evaluate(() => document.getElementById(document.activeElement.getAttribute('aria-describedby')).textContent), /shutdown limit 250/);
  await page.keyboard.press('Home');
  await card(page, 'ax188001').locator('.emcy', { hasText: 'negative warning' }).or(card(page, 'ax188001').locator('.emcy:not(.error)')).first().waitFor();
});

test('a button starts one device by NMT, and its LED and its output are shown as the device sets them', async (t) => {
  const page = await openPage(t);
  const status = lamp(page, 'cbx-ao412', 'S');
  await status.locator('.words', { hasText: 'blinking' }).waitFor();
  for (const look of ['lit', 'dark', 'lit']) await status.locator(`.bulb[data-look=${look}]`).waitFor();
  // Pre-operational: 200 ms on, 200 ms off (CAN-CBX-AO412, Tables 5 and 7). The times are those of the device, because
  // the browser may be late.
  const times = (await changesOf('cbx-ao412', 'led_s')).slice(-3);
  assert.deepEqual(times.slice(1).map((time, i) => time - times[i]), [200000, 200000]);
  await card(page, 'cbx-ao412').getByRole('button', { name: 'Start, cbx-ao412' }).click();
  await card(page, 'cbx-ao412').locator('.state', { hasText: /^operational$/ }).waitFor();
  await page.locator('#frames tr.is-NMT', { hasText: 'cbx-ao412: start' }).first().waitFor();
  await status.locator('.words', { hasText: /^on$/ }).waitFor();
  assert.equal(await card(page, 'ax130751').locator('.state').innerText(), 'pre-operational');
  await send(page, '603#2B116401B33E0000'); // 5.0 V at output 1, from the manual (7.10.2.3)
  await card(page, 'cbx-ao412').locator('.gauge', { hasText: 'Output 1' }).locator('.figure', { hasText: /^5\.00/ }).waitFor();
});

test('a dragged horizon sets the pitch of the machine, and the measured angle is shown', async (t) => {
  const page = await openPage(t);
  const horizon = card(page, 'ax060805').locator('.attitude');
  await horizon.scrollIntoViewIfNeeded();
  const box = await horizon.boundingBox();
  const middle = { x: box.x + box.width / 2, y: box.y + box.height / 2 };
  await page.mouse.move(middle.x, middle.y);
  await page.mouse.down();
  await page.mouse.move(middle.x, middle.y + box.height * 0.15, { steps: 4 }); // the drawing is 200 units high, so this is 30 degrees
  await page.mouse.up();
  await until(page, () => Math.abs(Number(document.querySelector('[data-signal=pitch] input[type=number]').value) - 30) <= 2);
  await until(page, () => Math.abs(Number(document.querySelector('[data-device=ax060805] .gauge .figure').textContent) - 30) <= 3);
});

test('a value set on one page is shown on another page and is in stimuli.csv', async (t) => {
  const one = await openPage(t);
  const other = await openPage(t);
  const box = control(one, 'ax130751', 'supply').locator('input[type=number]');
  await box.fill('13.5');
  await box.press('Enter');
  await until(other, () => document.querySelector('[data-device=ax130751] [data-signal=supply] input[type=number]').value === '13.5');
  const csv = await (await fetch(`${panel.url}stimuli.csv`)).text();
  assert.match(csv, /^\d+\.\d{6},ax130751\.supply,13\.5$/m);
});

test('lost frames are shown, and without a loss the field is hidden', async (t) => {
  const page = await openPage(t);
  assert.equal(await page.locator('#bus-lost-field').isVisible(), false);
  await page.route('**/api/state*', async (route) => {
    const response = await route.fetch();
    const state = await response.json();
    state.bus.lost = 1204; // lost frames, as the SocketCAN bus reports them
    state.bus.missed = 7;
    await route.fulfill({ response, json: state });
  });
  await page.locator('#bus-lost', { hasText: '1204 to the log, 7 to the devices' }).waitFor();
  await page.unrouteAll({ behavior: 'ignoreErrors' });
});

test('a lag of the simulation is shown, and without a lag the field is hidden', async (t) => {
  const page = await openPage(t);
  await page.route('**/api/state*', async (route) => {
    const response = await route.fetch();
    const state = await response.json();
    state.bus.lag_us = 12345678;
    await route.fulfill({ response, json: state });
  });
  await page.locator('#bus-lag', { hasText: /^12\.3 s$/ }).waitFor();
  await page.unrouteAll({ behavior: 'ignoreErrors' });
  await page.locator('#bus-lag-field').waitFor({ state: 'hidden' });
});

test('a socketcand client and the page are on the same bus', async (t) => {
  const served = await startPanel('cbx-ao412@3', '--bus', 'socketcand:127.0.0.1:0');
  t.after(served.stop);
  const port = Number(/socketcand listens at port (\d+)/.exec(await served.says(/listens at port \d+/))[1]);
  const client = net.connect(port, '127.0.0.1');
  t.after(() => client.destroy());
  let heard = '';
  client.on('data', (data) => { heard += data; });
  const hears = async (pattern) => { while (!pattern.test(heard)) await once(client, 'data'); };
  await hears(/< hi >/);
  client.write('< open can0 >< rawmode >');
  await hears(/< ok >.*< ok >/s);
  const page = await openPage(t, {}, served);
  client.write('< send 603 8 40 0 10 0 0 0 0 0 >'); // CAN-CBX-AO412 manual, 7.9.2: request for the device type, and its answer
  await hears(/< frame 583 \S+ 4300100091010800 >/i);
  await page.locator('#frames tr', { hasText: '43 00 10 00 91 01 08 00' }).waitFor();
  await send(page, '603#4001100000000000');
  await page.locator('#message', { hasText: 'Sent 603#4001100000000000.' }).waitFor();
  await hears(/< frame 583 \S+ 4F01100000000000 >/i);
});

test('a refused frame is shown with a message that names its identifier', async (t) => {
  const context = await browser.newContext();
  t.after(() => context.close());
  const page = await context.newPage();
  page.setDefaultTimeout(patience);
  await page.goto(panel.url);
  await page.waitForSelector('html[data-ready]');
  await page.fill('#frame', '900#00');
  await page.click('#send button');
  await page.locator('#message.wrong', { hasText: '900' }).waitFor();
});

test('no element is wider than the screen, from a small phone to a wide desktop', async (t) => {
  const page = await openPage(t);
  for (const summary of await page.locator('summary').all()) await summary.click();
  for (const [width, height] of [[320, 640], [390, 844], [768, 1024], [1920, 1080]]) {
    await page.setViewportSize({ width, height });
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), width);
    assert.deepEqual(await page.evaluate(() => [...document.querySelectorAll('.device *, .log > header *, .bar *')]
      .filter((one) => !one.closest('.visually-hidden, .attitude') && one.getBoundingClientRect().right > innerWidth + 0.5)
      .map((one) => `${one.tagName} ${one.className} ${one.textContent}`)), [], `${width} wide`);
  }
});

test('every text has enough contrast, light and dark', async (t) => {
  const page = await openPage(t);
  for (const summary of await page.locator('summary').all()) await summary.click();
  for (const [colorScheme, background] of [['light', 'rgb(236, 238, 236)'], ['dark', 'rgb(18, 22, 24)']]) {
    await page.emulateMedia({ colorScheme });
    assert.equal(await page.evaluate(() => getComputedStyle(document.body).backgroundColor), background);
    const { texts, faint } = await page.evaluate(lowContrast);
    assert.ok(texts > 100);
    assert.deepEqual(faint, [], colorScheme); // WCAG 2.1, 1.4.3
  }
});

test('with reduced motion, the LED pattern is written instead of flashing', async (t) => {
  const page = await openPage(t, { reducedMotion: 'reduce' });
  await page.getByRole('group', { name: 'NMT, all nodes' }).getByRole('button', { name: 'Pre-op' }).click();
  const status = lamp(page, 'cbx-ao412', 'S');
  await status.locator('.words', { hasText: 'blinking' }).waitFor();
  await status.locator('.bulb[data-look=pattern]').waitFor();
  const looks = await status.locator('.bulb').evaluate((bulb) => new Promise((resolve) => {
    const seen = new Set();
    let frames = 0;
    const look = () => {
      seen.add(bulb.dataset.look);
      frames += 1;
      if (frames < 60) requestAnimationFrame(look);
      else resolve([...seen]);
    };
    look();
  }));
  assert.deepEqual(looks, ['pattern']);
});

test('a page of another site can neither read the state nor send a frame', async (t) => {
  const evil = http.createServer((_, answer) => answer.setHeader('Content-Type', 'text/html').end('<!doctype html><title>evil</title>'));
  await new Promise((resolve) => { evil.listen(0, '127.0.0.1', resolve); });
  const context = await browser.newContext();
  t.after(async () => {
    await context.close();
    evil.close();
  });
  const page = await context.newPage();
  await page.goto(`http://127.0.0.1:${evil.address().port}/`);
  const outcomes = await page.evaluate(async (url) => {
    const body = JSON.stringify({ frame: '000#0202' });
    const attempt = async (options) => {
      try {
        const answer = await fetch(`${url}api/frame`, { method: 'POST', body, ...options });
        return `read ${answer.type} ${answer.status}`;
      } catch {
        return 'refused';
      }
    };
    const read = await fetch(`${url}api/state`).then(() => 'read', () => 'refused');
    return [await attempt({ headers: { 'Content-Type': 'application/json' } }), await attempt({ mode: 'no-cors', headers: { 'Content-Type': 'text/plain' } }), read];
  }, panel.url);
  assert.deepEqual(outcomes, ['refused', 'refused', 'refused']);
  // DNS rebinding: the name of another site leads to the address of the panel. The panel must refuse this name.
  const rebound = await page.goto(panel.url.replace('127.0.0.1', 'evil.example'));
  assert.equal(rebound.status(), 403);
  const state = await (await fetch(`${panel.url}api/state`)).json();
  assert.deepEqual(state.frames.filter((frame) => frame.data === '0202'), []);
});

test('wrong options are reported, with status 2', () => {
  for (const [words, said] of [[['--port', '99999'], '--port'], [['nothing'], 'nothing'], [['--port', new URL(panel.url).port], 'cannot listen at 127.0.0.1:'], [['--bus', 'carrier-pigeon'], 'carrier-pigeon']]) {
    const run = spawnSync(canproof, ['panel', ...words], { encoding: 'utf8' });
    assert.equal(run.status, 2, words.join(' '));
    assert.ok(run.stderr.includes(said) || run.stdout.includes(said), run.stderr + run.stdout);
  }
});
