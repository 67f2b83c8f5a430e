// Numbers as an engineer writes them.
const signs = { degC: '°C', deg: '°', uV: 'µV', Ohm: 'Ω' };

export const unitSign = (unit) => signs[unit] ?? unit;

/** So many digits that a thousandth of the range shows. */
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

/** The step of a slider: 1, 2 or 5 times a power of ten, about a two-hundredth of the range. */
export function sliderStep(low, high) {
  const wanted = (high - low) / 200;
  const power = 10 ** Math.floor(Math.log10(wanted));
  return [1, 2, 5, 10].map((n) => n * power).find((step) => step >= wanted * 0.999);
}
