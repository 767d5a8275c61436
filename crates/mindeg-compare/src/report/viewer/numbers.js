"use strict";

// How people read numbers: the rule of mindeg_mesh's `numbers.rs`, which says what it is. Rounds as Rust does,
// halves to the even digit.

/** The short text, or, where the long one says that the value lies half-way, that of the even last digit. */
function evenly(text, long) {
  const [, whole, half] = long.match(/^([^e]*?)(50{19})(?:e.*)?$/) ?? [];
  if (!half || Number(text.split("e")[0].at(-1)) % 2 === 0) return text;
  return whole.replace(/\.$/, "") + (text.match(/e.*/)?.[0] ?? "");
}

const fixed = (value, decimals) => evenly(value.toFixed(decimals), value.toFixed(decimals + 20));

/** At most four significant digits, no trailing zeros. */
function numberText(value) {
  if (!Number.isFinite(value)) return value > 0 ? "∞" : "–";
  if (value === 0) return "0";
  const trimmed = (text) => (text.includes(".") ? text.replace(/\.?0*$/, "") : text);
  const [mantissa, power] = evenly(value.toExponential(3), value.toExponential(23)).split("e");
  return power < -5 || power >= 9
    ? `${trimmed(mantissa)}e${Number(power)}`
    : trimmed(fixed(value, Math.max(0, 3 - power)));
}

/** An angle in degrees: three decimals, and one too small for them as a number. */
function angleText(degrees) {
  const size = Math.abs(degrees);
  return `${size >= 0.1 && size < 1e9 ? fixed(degrees, 3) : numberText(degrees)}°`;
}

/** A share: one decimal, and none where the percent is whole; neither nothing nor all where it is not. */
function percent(share) {
  const value = 100 * share;
  if (!(Math.abs(value) < 1e9) || value === 0) return `${numberText(value)}%`;
  const whole = Math.round(value);
  if (Math.abs(value - whole) < 1e-9 && value >= 0.1) return `${whole}%`;
  if (value < 0.1) return "<0.1%";
  return value > 99.9 && value < 100 ? ">99.9%" : `${fixed(value, 1)}%`;
}
