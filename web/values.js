import { fraction_of } from "./numbers.js";
import { tokens } from "./ztext.js";

// Values of the page as expressions of Z, exactly: what a predicate says of inputs, of a ray and of its answer can so be evaluated.

// z_number writes a binary64 as a number of Z: a whole number, or a quotient.
export function z_number(x) {
  const [n, d] = fraction_of(x),
    size = n < 0n ? -n : n,
    said = d === 1n ? `${size}` : `${size} / ${d}`;
  return n < 0n ? `-(${said})` : said;
}
const z_rational = text => (text.startsWith("-") ? `-(${text.slice(1)})` : text);

// z_exact writes x + y√Δ.
export const z_exact = ({ x, y, delta }) =>
  y === "0" ? z_rational(x) : `${z_rational(x)} + (${z_rational(y)}) * √(${delta})`;
const triple = (p, write) => `⦉x == ${write(p[0])}, y == ${write(p[1])}, z == ${write(p[2])}⦊`;
export const z_point = p => triple(p, z_number);
export const z_set = names => (names.length ? `{${names.map(z_name).join(", ")}}` : "∅[Elemento]");
export const z_name = name => (/^[A-Za-z]\w*$/.test(name) ? name : JSON.stringify(name));
export const z_ray = (p, v) => `⦉p == ${z_point(p)}, v == ${z_point(v)}⦊`;

// parts_of reads the inputs of an operation, from its line or from its JSON.
export function parts_of(op) {
  if (/^\s*\{/.test(op)) {
    try {
      return JSON.parse(op);
    } catch {
      return {};
    }
  }
  const made = {};
  for (const part of op.trim().split(/\s+/).slice(1)) {
    const at = part.indexOf("=");
    if (at < 0) continue;
    const value = part.slice(at + 1),
      listed = /^[(\d.+-]/.test(value) ? value.replace(/\(/g, "[").replace(/\)/g, "]") : null;
    let read = value;
    if (listed) {
      try {
        read = JSON.parse(listed);
      } catch {
        read = value;
      }
    }
    made[part.slice(0, at).replace(/\?$/, "")] = read;
  }
  return made;
}

// input_values gives the inputs of an operation. A name that no element of the scene has is no value there.
export function input_values(parts, names) {
  const made = {},
    three = value => Array.isArray(value) && value.length === 3;
  for (const [key, value] of Object.entries(parts)) {
    if (typeof value === "number") made[key + "?"] = z_number(value);
    else if (key === "e" && names.includes(value)) made["e?"] = z_name(value);
    else if (key === "t") made["t?"] = String(value);
    else if (three(value) && value.every(x => typeof x === "number")) made[key + "?"] = z_point(value);
    else if (three(value) && value.every(three))
      made[key + "?"] = `⦉a == ${z_point(value[0])}, b == ${z_point(value[1])}, c == ${z_point(value[2])}⦊`;
  }
  return made;
}

// ray_values gives a ray as the question of the text, and what was answered as its answer.
export function ray_values({ p, v, on }, answer, names) {
  const made = { "rayo?": z_ray(p, v), "en?": z_set(on.filter(name => names.includes(name))) };
  if (!answer || answer.error) return made;
  const first = answer.crossings.find(c => c.first && c.point);
  Object.assign(made, { "resultado!": answer.hit.outcome, "elementos!": z_set(answer.hit.elementos ?? []) });
  if (answer.hit.outcome === "hit" && first)
    Object.assign(made, { "t!": z_exact(first.t), "punto!": triple(first.point, z_exact) });
  return made;
}

// values_in keeps the values of those names that stand in a predicate.
export function values_in(text, values) {
  return Object.fromEntries(
    [...new Set(tokens(text))].filter(token => Object.hasOwn(values, token)).map(name => [name, values[name]]),
  );
}
