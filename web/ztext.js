// The Z text as the page lays it out: its tokens, what each names, and the boxes. No token is changed.

// tokens cuts a predicate into names, numbers, marks and what stands between; joined again they are the text.
const token = /[\p{L}_][\p{L}\p{N}_]*['′]*[?!]?|\d+(?:\.\d+)?|"[^"]*"|\s+|[^\s\p{L}\d_"]/gu;
export const tokens = text => text.match(token) ?? [];

// base_name is a name without its decorations: radio? and radio′ are of radio.
export const base_name = name => name.replace(/['′?!]+$/u, "");

const connectives = new Set([
  ..."∀∃∄λμ∧∨¬⇒⇔•⦁|⊢≡",
  "let",
  "if",
  "then",
  "else",
  "dom",
  "ran",
  "pre",
  "LET",
  "IF",
  "THEN",
  "ELSE",
]);
const types = {
  esfera: "esfera",
  cilindro: "cilindro",
  cono: "cono",
  tronco: "tronco",
  plano: "plano",
  disco: "disco",
  triangulo: "triangulo",
};
const whole = {
  rayo: "ray",
  ray: "ray",
  puntos_de_rayo: "ray",
  punto: "first",
  reduccion: "first",
  t: "first",
  alcances: "crossings",
  alcance: "crossings",
  interseccion: "crossings",
  fuentes: "lights",
  luz: "lights",
  visible: "lights",
  oscura: "lights",
  elementos: "scene",
  puntos_de_escena: "scene",
  ojo: "eye",
  de_que_elemento: "first",
};

// marks_of is the part of the picture that a name speaks of: "tipo:esfera", "ray", "first"; or nothing.
export function marks_of(name) {
  const base = base_name(name);
  if (Object.hasOwn(whole, base)) return whole[base];
  const word = base.toLowerCase().split("_").at(-1);
  return Object.hasOwn(types, word) && base !== word ? "tipo:" + types[word] : "";
}

// kind_of says how a token is shown.
export function kind_of(text) {
  if (/^\s+$/.test(text)) return "blank";
  if (connectives.has(text)) return "word";
  if (/^[\p{L}_]/u.test(text))
    return /[?]$/.test(text) ? "input" : /[!]$/.test(text) ? "output" : /['′]$/.test(text) ? "after" : "name";
  return /^\d/.test(text) ? "number" : "mark";
}

// indented breaks a long predicate before its outermost connectives, one step deeper each, so that no line is far longer
// than the width. It changes blanks alone.
const opening = "({[⦉⟨⦇⟦",
  closing = ")}]⦊⟩⦈⟧";
const levels = [["•", "⦁", "|"], ["⇔"], ["⇒"], ["∨"], ["∧"], ["="], ["+", "-"]];
export function indented(text, width = 56, depth = 0) {
  const room = Math.max(24, width - 2 * depth);
  if ([...text].length <= room) return [{ depth, text }];
  for (const level of levels) {
    const parts = split_at(text, level);
    if (parts.length > 1)
      return parts.flatMap((part, i) =>
        indented(part, width, depth + (i === 0 || (level.length === 1 && "∨∧".includes(level[0])) ? 0 : 1)),
      );
  }
  return [{ depth, text }];
}

// split_at cuts before each of the marks that stands outside of brackets; a bar of a set or a box is inside of them.
function split_at(text, marks) {
  const parts = [];
  let nested = 0,
    from = 0;
  const all = tokens(text);
  let at = 0,
    before = "";
  for (const one of all) {
    if (opening.includes(one)) ++nested;
    else if (closing.includes(one)) --nested;
    else if (nested === 0 && marks.includes(one) && at > from && /\s$/.test(before)) {
      const keeps = "•⦁|".includes(one) || one === "=";
      const cut = keeps ? at + one.length : at;
      if (cut < text.length) {
        parts.push(text.slice(from, cut).trim());
        from = cut;
      }
    }
    at += one.length;
    before = one;
  }
  parts.push(text.slice(from).trim());
  return parts.filter(Boolean);
}

// in_unicode shows a line of LaTeX mark-up by the marks that it stands for. A command that it does not know stays as it is.
const marks = {
  forall: "∀",
  exists: "∃",
  lambda: "λ",
  mu: "μ",
  land: "∧",
  lor: "∨",
  lnot: "¬",
  implies: "⇒",
  iff: "⇔",
  leq: "≤",
  geq: "≥",
  neq: "≠",
  in: "∈",
  notin: "∉",
  subseteq: "⊆",
  cup: "∪",
  cap: "∩",
  setminus: "∖",
  emptyset: "∅",
  bigcup: "⋃",
  power: "ℙ",
  finset: "𝔽",
  cross: "×",
  mapsto: "↦",
  fun: "→",
  pfun: "⇸",
  dres: "◁",
  rres: "▷",
  ndres: "⩤",
  oplus: "⊕",
  real: "ℝ",
  nat: "ℕ",
  num: "ℤ",
  Delta: "Δ",
  Xi: "Ξ",
  theta: "θ",
  dom: "dom",
  ran: "ran",
  inv: "∼",
  limg: "⦇",
  rimg: "⦈",
  lblot: "⦉",
  rblot: "⦊",
  negate: "−",
  IF: "if",
  THEN: "then",
  ELSE: "else",
  LET: "let",
  where: "─",
  also: "",
};
export const in_unicode = text =>
  text
    .replace(/~/g, " ")
    .replace(/\\t\d/g, "  ")
    .replace(/\\([A-Za-z]+)(?:\{[^{}]*\})?/g, (all, name) =>
      name === "begin" || name === "end"
        ? all.replace("\\begin", "┌").replace("\\end", "└")
        : Object.hasOwn(marks, name)
          ? marks[name] + all.slice(name.length + 1)
          : all,
    )
    .replace(/\\\\/g, "")
    .replace(/\\([_{}])/g, "$1")
    .replace(/@/g, "•");

// without_conjectures leaves the conjectures of a text out, in LaTeX and in Unicode, so that an exploration goes on past a false one.
export const without_conjectures = text =>
  text.replace(/\\begin\{zed\}\s*\\vdash\?[^]*?\\end\{zed\}/g, "").replace(/^─[^\n]*\n\s*⊢\?[^]*?^└[^\n]*$/gm, "");

// symbols of the keyboard: what a reader may type for a mark of Z, by its command of LaTeX.
export const palette = [
  "∈",
  "∉",
  "∪",
  "∩",
  "∖",
  "⊆",
  "∅",
  "ℙ",
  "𝔽",
  "×",
  "↦",
  "⇸",
  "→",
  "◁",
  "▷",
  "⩤",
  "⩥",
  "⊕",
  "∀",
  "∃",
  "λ",
  "μ",
  "•",
  "∧",
  "∨",
  "¬",
  "⇒",
  "⇔",
  "≤",
  "≥",
  "≠",
  "ℕ",
  "ℤ",
  "ℝ",
  "⦉",
  "⦊",
  "θ",
  "Δ",
  "Ξ",
  "′",
];
