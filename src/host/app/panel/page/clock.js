// The program's time, shown a moment late: changes come with their own times and are played at these, so that an LED
// flashes as the device switches it, however the requests come.
const delay = 250000;
let ahead = -Infinity;

export function heard(now) {
  const offset = now - performance.now() * 1000;
  // The quickest answer is the nearest to the truth; a computer that slept starts anew.
  ahead = Math.abs(offset - ahead) > 2000000 ? offset : Math.max(offset, ahead - 200);
}

export const shownTime = () => performance.now() * 1000 + ahead - delay;
