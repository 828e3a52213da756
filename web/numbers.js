// Numbers as text: binary64 and their neighbours, rationals, numbers x + y√Δ. All of it is exact, by whole numbers.
const bits = new DataView(new ArrayBuffer(8));

export function bits_of(x) {
  bits.setFloat64(0, x);
  return bits.getBigUint64(0);
}
export function of_bits(b) {
  bits.setBigUint64(0, b);
  return bits.getFloat64(0);
}

// next_up is the least binary64 above x, next_down the greatest below.
export function next_up(x) {
  if (x === Infinity || Number.isNaN(x)) return x;
  if (x === 0) return Number.MIN_VALUE;
  return of_bits(bits_of(x) + (x > 0 ? 1n : -1n));
}
export const next_down = x => -next_up(-x);

// hexadecimal writes a binary64 as C's %a does.
export function hexadecimal(x) {
  if (!Number.isFinite(x)) return String(x);
  const b = bits_of(x),
    sign = b >> 63n ? "-" : "";
  const exponent = Number((b >> 52n) & 0x7ffn),
    fraction = b & 0xfffffffffffffn;
  if (exponent === 0 && fraction === 0n) return sign + "0x0p+0";
  const digits = fraction.toString(16).padStart(13, "0").replace(/0+$/, "");
  const power = exponent === 0 ? -1022 : exponent - 1023;
  return `${sign}0x${exponent === 0 ? 0 : 1}${digits ? "." + digits : ""}p${power < 0 ? "" : "+"}${power}`;
}

// fraction_of gives a binary64 as numerator and denominator.
export function fraction_of(x) {
  const b = bits_of(x),
    exponent = Number((b >> 52n) & 0x7ffn),
    fraction = b & 0xfffffffffffffn;
  let numerator = exponent === 0 ? fraction : fraction | (1n << 52n);
  if (x < 0 || Object.is(x, -0)) numerator = -numerator;
  let power = (exponent === 0 ? 1 : exponent) - 1075;
  while (power < 0 && numerator !== 0n && numerator % 2n === 0n) {
    numerator /= 2n;
    ++power;
  }
  if (numerator === 0n) return [0n, 1n];
  return power < 0 ? [numerator, 1n << BigInt(-power)] : [numerator << BigInt(power), 1n];
}

export const greatest_divisor = (a, b) => {
  while (b) [a, b] = [b, a % b];
  return a < 0n ? -a : a;
};

// rational reads "-3/4", "0.125", "1e-3" or a whole number.
export function rational(text) {
  const said = String(text).trim();
  const quotient = /^([+-]?\d+)(?:\/(\d+))?$/.exec(said);
  if (quotient) return reduced(BigInt(quotient[1]), BigInt(quotient[2] ?? 1));
  const decimal = /^([+-]?)(\d*)\.?(\d*)(?:[eE]([+-]?\d+))?$/.exec(said);
  if (!decimal || !(decimal[2] || decimal[3])) return null;
  const power = Number(decimal[4] ?? 0) - decimal[3].length;
  if (Math.abs(power) > 5000) return null;
  const whole = BigInt((decimal[1] || "") + decimal[2] + decimal[3]);
  return power < 0 ? reduced(whole, 10n ** BigInt(-power)) : [whole * 10n ** BigInt(power), 1n];
}

export function reduced(numerator, denominator) {
  if (denominator === 0n) return null;
  if (denominator < 0n) [numerator, denominator] = [-numerator, -denominator];
  const g = greatest_divisor(numerator, denominator) || 1n;
  return [numerator / g, denominator / g];
}

export const rational_text = ([n, d]) => (d === 1n ? `${n}` : `${n}/${d}`).replace("-", "−");

// quadratic_text writes x + y√Δ, with what is 0 or 1 left out.
export function quadratic_text(x, y, delta) {
  const [a, b, c] = [x, y, delta].map(rational);
  if (b[0] === 0n || c[0] === 0n) return rational_text(a);
  if (c[0] === c[1]) return rational_text(reduced(a[0] * b[1] + b[0] * a[1], a[1] * b[1]));
  const root = c[1] === 1n ? `√${c[0]}` : `√(${rational_text(c)})`;
  const size = [b[0] < 0n ? -b[0] : b[0], b[1]];
  const factor = size[0] === size[1] ? "" : size[1] === 1n ? `${size[0]}·` : `(${rational_text(size)})·`;
  if (a[0] === 0n) return `${b[0] < 0n ? "−" : ""}${factor}${root}`;
  return `${rational_text(a)} ${b[0] < 0n ? "−" : "+"} ${factor}${root}`;
}

// short writes a number for a label of the picture: three places, and the sign that typography has.
export function short(x, places = 3) {
  if (typeof x === "string") return x;
  if (!Number.isFinite(x)) return x > 0 ? "∞" : "−∞";
  const said =
    Math.abs(x) >= 1e6 || (x !== 0 && Math.abs(x) < 1e-4) ? x.toExponential(2) : String(Number(x.toFixed(places)));
  return said.replace("-", "−");
}

// written is the shortest text that reads back to the same binary64, as a scene has it.
export const written = x => (Object.is(x, -0) ? "-0" : String(x));

// on_grid puts a dragged coordinate on multiples of 1/64, so that its exact numbers stay short.
export const on_grid = x => Math.round(x * 64) / 64;

// place_between gives how far the exact decimal lies from the binary64 below it to the one above, from 0 to 1.
export function place_between(digits, low, high) {
  const at = rational(digits),
    [ln, ld] = fraction_of(low),
    [hn, hd] = fraction_of(high);
  if (!at) return null;
  const whole = hn * ld - ln * hd,
    part = (at[0] * ld - ln * at[1]) * hd;
  return whole === 0n ? null : Number((part * 1000000n) / (whole * at[1])) / 1e6;
}
