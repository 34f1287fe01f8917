"use strict";
// Scales, ticks and numbers.

const TIME_STEPS = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 30, 60, 120, 300, 600, 1200, 1800, 3600, 7200, 14400, 43200, 86400];

/** The smallest of 1, 2, 5 times a power of ten from `least` on. */
function roundStep(least) {
  const power = 10 ** Math.floor(Math.log10(least));
  return [1, 2, 5, 10].map((factor) => factor * power).find((step) => step >= least * (1 - 1e-9));
}

function multiples(low, high, step) {
  const found = [];
  for (let i = Math.ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; ++i) found.push(i * step);
  return found;
}

function linearTicks(low, high, most) {
  return multiples(low, high, roundStep((high - low) / most));
}

/** Powers of ten, with twice and five times of them where there are few, every second one where there are many. */
function logTicks(low, high) {
  const factors = high / low > 2000 ? [1] : [1, 2, 5];
  const step = high / low > 1e7 ? 2 : 1;
  const found = [];
  for (let power = step * Math.floor(Math.log10(low) / step); power <= Math.log10(high); power += step) {
    for (const factor of factors) found.push(factor * 10 ** power);
  }
  return found.filter((tick) => tick >= low && tick <= high);
}

function timeTicks(low, high, most) {
  const least = (high - low) / most;
  return multiples(low, high, TIME_STEPS.find((step) => step >= least) || roundStep(least));
}

function timeText(seconds, span) {
  if (span < 300) return `${+seconds.toFixed(1)}`;
  const whole = Math.round(seconds);
  const [hours, minutes, rest] = [Math.floor(whole / 3600), Math.floor(whole / 60) % 60, whole % 60];
  const two = (part) => String(part).padStart(2, "0");
  return hours > 0 ? `${hours}:${two(minutes)}:${two(rest)}` : `${minutes}:${two(rest)}`;
}

/** What the first part of such a text counts. */
const timeUnit = (span) => (span < 300 ? "s" : span < 3600 ? "min" : "h");

/** A tick without zeros that say nothing. */
const tickText = (value) => (value >= 1e5 ? value.toExponential(0).replace("+", "") : `${+value.toPrecision(6)}`);

function lengthText(metres) {
  if (metres >= 1000) return `${metres / 1000} km`;
  return metres >= 1 ? `${metres} m` : `${+(100 * metres).toPrecision(3)} cm`;
}

/** A value to be read, or a dash where there is none. */
function valueText(value, digits = 2) {
  return value === null || value === undefined ? "–" : value.toFixed(digits);
}

function quantile(values, fraction) {
  const ordered = Float64Array.from(values).sort();
  return ordered[Math.round(fraction * (ordered.length - 1))];
}

/** The first index whose time is not before `time`. */
function firstFrom(times, time) {
  let [low, high] = [0, times.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (times[middle] < time) low = middle + 1; else high = middle;
  }
  return low;
}

/** The index of the time nearest to `time`, -1 where that is over `longest` seconds off. */
function nearest(times, time, longest) {
  const after = firstFrom(times, time);
  const best = after > 0 && (after === times.length || time - times[after - 1] < times[after] - time) ? after - 1 : after;
  return best < times.length && Math.abs(times[best] - time) <= longest ? best : -1;
}

/** From which pause on a line is broken: several times the usual one [s]. */
function longestPause(times) {
  if (times.length < 3) return 1;
  const pauses = [];
  const stride = Math.max(1, Math.floor(times.length / 500));
  for (let i = 1; i < times.length; i += stride) pauses.push(times[i] - times[i - 1]);
  return Math.max(1, 5 * quantile(pauses, 0.5));
}
