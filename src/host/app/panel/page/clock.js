// SPDX-License-Identifier: Apache-2.0
// The time of the program, shown with a short delay. The page shows each change at the change's own time, so that an
// LED flashes exactly as the device switches it, whatever the timing of the requests.
const delay = 250000;
let ahead = -Infinity;

export function heard(now) {
  const offset = now - performance.now() * 1000;
  // Estimates the program's time from the answer with the shortest delay, because that answer has the smallest error.
  // If the estimate is more than 2 s wrong, as after a suspension of the computer, starts the estimate again.
  ahead = Math.abs(offset - ahead) > 2000000 ? offset : Math.max(offset, ahead - 200);
}

export const shownTime = () => performance.now() * 1000 + ahead - delay;
