// SPDX-License-Identifier: Apache-2.0
// Formats numbers with their units.
const signs = { degC: '°C', deg: '°', uV: 'µV', Ohm: 'Ω' };

export const unitSign = (unit) => signs[unit] ?? unit;

/** Returns the number of decimals with which a thousandth of the range is visible. */
export function digitsFor(low, high) {
  const span = Math.abs(high - low);
  if (!Number.isFinite(span) || span === 0) return 3;
  return Math.min(4, Math.max(0, 3 - Math.floor(Math.log10(span))));
}

export function numberText(value, digits) {
  if (value === null || value === undefined) return '–';
  const text = value.toFixed(digits).replace('-', '−');
  return /^−0(\.0*)?$/.test(text) ? text.slice(1) : text;
}

export function valueText(value, digits, unit) {
  const sign = unitSign(unit ?? '');
  return value === null ? 'not measured' : `${numberText(value, digits)}${sign ? '\u202f' + sign : ''}`;
}

export const seconds = (us) => (us / 1e6).toFixed(3);

/** Returns the step of a slider: 1, 2 or 5 times a power of ten, about 1/200 of the range. */
export function sliderStep(low, high) {
  const wanted = (high - low) / 200;
  const power = 10 ** Math.floor(Math.log10(wanted));
  return [1, 2, 5, 10].map((n) => n * power).find((step) => step >= wanted * 0.999);
}
