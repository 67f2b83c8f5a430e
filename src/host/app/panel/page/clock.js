// SPDX-License-Identifier: Apache-2.0
// The program's time, shown with a short delay. Changes have their own times and are shown at these, so that an LED
// flashes as the device switches it, independent of the timing of the requests.
const delay = 250000;
let ahead = -Infinity;

export function heard(now) {
  const offset = now - performance.now() * 1000;
  // The fastest answer has the smallest error. After a suspension of the computer, the estimate starts again.
  ahead = Math.abs(offset - ahead) > 2000000 ? offset : Math.max(offset, ahead - 200);
}

export const shownTime = () => performance.now() * 1000 + ahead - delay;
