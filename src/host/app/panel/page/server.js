// SPDX-License-Identifier: Apache-2.0
// The requests of the page to the program.
let report = () => {};
export const onMessage = (listener) => { report = listener; };
export const message = (text, wrong = false) => report(text, wrong);

async function post(path, body) {
  try {
    const answer = await fetch(path, { method: 'POST', headers: { 'Content-Type': 'application/json' }, body: JSON.stringify(body) });
    if (answer.ok) return true;
    message((await answer.json()).error, true);
  } catch {
    message('The program does not answer; check that canproof is still running.', true);
  }
  return false;
}

export const sendFrame = (frame) => post('/api/frame', { frame });

const waiting = new Map();

/** Sends the newest value of a signal, one request at a time, because a drag produces many values. */
export async function stimulate(device, signal, value) {
  const key = `${device}.${signal}`;
  const busy = waiting.has(key);
  waiting.set(key, value);
  if (busy) return;
  while (waiting.has(key)) {
    const next = waiting.get(key);
    await post('/api/stimulus', { device, signal, value: next });
    if (waiting.get(key) === next) waiting.delete(key);
  }
}

/** Returns whether a value of that signal is still being sent. */
export const isWaiting = (device, signal) => waiting.has(`${device}.${signal}`);

export async function get(path) {
  const answer = await fetch(path, { cache: 'no-store' });
  if (!answer.ok) throw new Error(`${path}: ${answer.status}`);
  return answer.json();
}
