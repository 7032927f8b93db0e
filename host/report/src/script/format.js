// Colours, numbers for people, numbers as they are packed, ranges.
"use strict";
const root = document.documentElement;
const colour = name => getComputedStyle(root).getPropertyValue("--" + name).trim();
const minus = text => text.replaceAll("-", "−");

// A value for people, with as many digits as the data have.
const say = (value, digits = 5) => {
  if (value == null || Number.isNaN(value)) return "–";
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-4 || size >= 1e7)) return minus(value.toExponential(digits - 1).replace(/\.?0+e/, "e").replace("e+", "e"));
  return minus(String(+value.toPrecision(digits)));
};

// A tick, with the decimals that its step needs.
const tick = (value, step) => {
  if (value === 0) return "0";
  let decimals = 0;
  const isWhole = x => Math.round(x) !== 0 && Math.abs(x - Math.round(x)) < 1e-6 * Math.abs(x);
  while (decimals < 9 && !isWhole(step * 10 ** decimals)) decimals++;
  if (decimals > 6 || Math.abs(value) >= 1e7) return say(value, 4);
  return minus(value.toFixed(decimals));
};
const power = value => value == null ? null : value >= 0.01 && value < 1e4 ? String(+value.toPrecision(3)) : say(value, 3);

// Whole multiples of powers of ten from one value to another.
const digits = (min, max) => {
  const values = [];
  for (let power = Math.floor(Math.log10(min)); power <= Math.log10(max); power++) {
    for (let digit = 1; digit < 10; digit++) {
      const value = Number(`${digit}e${power}`);
      if (value >= min && value <= max) values.push(value);
    }
  }
  return values;
};

// Numbers: first, last and count of equal steps, or singles in base 64.
const numbers = code => {
  if (Array.isArray(code)) {
    const [first, last, count] = code;
    return Float64Array.from({ length: count }, (_, i) => count > 1 ? first + (last - first) * i / (count - 1) : first);
  }
  return new Float32Array(Uint8Array.from(atob(code), c => c.charCodeAt(0)).buffer);
};

const extent = (values, from = [Infinity, -Infinity]) => {
  let [low, high] = from;
  for (const value of values) if (Number.isFinite(value)) { low = Math.min(low, value); high = Math.max(high, value); }
  return [low, high];
};

// A range with some air; what is flat, or nothing, gets room on both sides.
const aired = ([low, high], { log, zero }) => {
  if (log) {
    if (!(low > 0) || !(high > 0)) return [0.1, 10];
    const air = Math.max(1.3, (high / low) ** 0.03);
    return [low / air, high * air];
  }
  if (low > high) return [-1, 1];
  if (zero) [low, high] = [Math.min(0, low), Math.max(0, high)];
  const least = 1e-6 * Math.max(Math.abs(low), Math.abs(high));
  const air = high - low > least ? 0.06 * (high - low) : least > 0 ? 5e4 * least : 1;
  return [zero && low === 0 ? 0 : low - air, high + air];
};
