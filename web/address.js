// The state of the page in its address, behind #: what is shown comes back from it, and nothing is kept elsewhere.

export const start_state = () => ({
  view: "scene",
  scene: "first",
  own: "",
  ops: [],
  step: 0,
  p: [-3, 2, -4.5],
  v: [4, -1.25, 5.5],
  on: [],
  crossing: 0,
  para: "Agregar_Esfera",
  file: "spec/operaciones.tex",
  label: "",
  walk: "ray",
  erratum: "E10",
  z: "birthday",
  ztext: "",
  way: "",
  exercise: "",
  surface: "torus",
  stext: "",
  selems: "",
  orbit: null,
  doubts: false,
  lang: "",
  theme: "",
});

const triple = { write: a => a.map(String).join(","), read: read_triple };
const word = { write: a => a, read: a => a };
const flag = { write: a => (a ? "1" : ""), read: a => a === "1" };
const whole = { write: String, read: a => (/^\d{1,6}$/.test(a) ? Number(a) : undefined) };
const list = { write: a => a.join("\n"), read: a => a.split("\n").filter(line => line !== "") };

const kinds = {
  view: word,
  scene: word,
  own: word,
  ops: list,
  step: whole,
  p: triple,
  v: triple,
  on: list,
  crossing: whole,
  para: word,
  file: word,
  label: word,
  walk: word,
  erratum: word,
  z: word,
  ztext: word,
  way: word,
  exercise: word,
  surface: word,
  stext: word,
  selems: word,
  orbit: triple,
  doubts: flag,
  lang: word,
  theme: word,
};

function read_triple(text) {
  const parts = text.split(",").map(part => (part.trim() === "" ? NaN : Number(part)));
  return parts.length === 3 && parts.every(Number.isFinite) ? parts : undefined;
}

// address_of writes what differs from the start.
export function address_of(state) {
  const start = start_state(),
    parts = [];
  for (const [key, kind] of Object.entries(kinds)) {
    if (JSON.stringify(state[key]) === JSON.stringify(start[key])) continue;
    parts.push(`${key}=${encodeURIComponent(kind.write(state[key] ?? ""))}`);
  }
  return parts.length ? "#" + parts.join("&") : "";
}

// state_of reads an address. A key or a value that it does not know is named in trouble, and the rest holds.
export function state_of(address) {
  const state = start_state(),
    trouble = [];
  for (const part of address.replace(/^#/, "").split("&").filter(Boolean)) {
    const cut = part.indexOf("="),
      key = cut < 0 ? part : part.slice(0, cut);
    let value;
    try {
      value =
        Object.hasOwn(kinds, key) && cut >= 0 ? kinds[key].read(decodeURIComponent(part.slice(cut + 1))) : undefined;
    } catch {
      value = undefined;
    }
    if (value === undefined) trouble.push(key);
    else state[key] = value;
  }
  if (state.v.every(x => x === 0)) {
    trouble.push("v");
    state.v = start_state().v;
  }
  state.step = Math.min(state.step, state.ops.length);
  return { state, trouble };
}
