import { answered, ask, once } from "./ask.js";
import { el, fill, find } from "./dom.js";
import { facts, on_facts } from "./facts.js";
import { change, on_change, state } from "./state.js";
import { nodes_of } from "./marked.js";
import { say } from "./words.js";
import { input_values, parts_of, ray_values, values_in } from "./values.js";
import { indented, kind_of, marks_of, tokens } from "./ztext.js";

// The Z text: its paragraphs, a line a predicate with its label, and beside each what is proved, tested and evaluated here.
let files = [],
  parts = [],
  names = new Map(),
  labels = new Map(),
  opened = "",
  explained = new Map(),
  shown_file = "";

// Rare marks are in few fonts: the page draws others for them, and a copy of the text has them as they are.
const rare = { "⩤": "◁", "⩥": "▷", "⦉": "⟨", "⦊": "⟩", "⨟": ";", "⨠": "≫", "⦂": ":" };
export const mark_node = mark => (rare[mark] ? rare_node(mark) : mark);
const rare_node = mark =>
  el(
    "span",
    {
      "class": `rare ${"⩤⩥".includes(mark) ? "struck" : "⦉⦊".includes(mark) ? "barred" : "bold"}`,
      "data-drawn": rare[mark],
    },
    el("span", { class: "gone" }, mark),
  );

// z_nodes shows a text of Z: each name leads to its paragraph and marks its part of the picture.
export function z_nodes(text, here = "") {
  return tokens(text).map(token => {
    const kind = kind_of(token);
    if (kind === "blank") return token;
    const marks = marks_of(token);
    const leads = names.has(token) && token !== here;
    if (leads)
      return el("a", { "class": `z ${kind}`, "href": "#", "data-name": token, "data-marks": marks || null }, token);
    return el("span", { "class": `z ${kind}`, "data-marks": marks || null }, mark_node(token));
  });
}

// z_block shows a predicate that may be longer than the panel.
export function z_block(text, width = 58, here = "") {
  return indented(text, width).map(({ depth, text: line }) =>
    el("span", { class: "z-line", style: `padding-inline-start:${0.9 * depth}rem` }, z_nodes(line, here)),
  );
}

// verdict_of says how a predicate stands in what is evaluated here: "holds", "fails", or nothing where it was not asked.
function verdict_of(label) {
  const at = Math.min(state.step, facts.answers.length) - 1;
  if (explained.get(label)?.here === here_now()) {
    const { value } = explained.get(label).answer;
    if (value === "true" || value === "false") return value === "true" ? "holds" : "fails";
  }
  if (at < 0) return "";
  const answer = facts.answers[at],
    broken = broken_of(at);
  if (!answer.ok && broken.some(b => b.label === label)) return "fails";
  const mine = operation_labels.get(operation_name(state.ops[at]));
  if (mine?.includes(label)) return answer.ok || /\.pre\.\d+$/.test(label) ? "holds" : "";
  return "";
}

export function broken_of(at) {
  const answer = facts.answers[at];
  if (!answer || answer.ok) return [];
  const refusal = facts.refusals[at];
  return refusal?.broken ?? [{ label: answer.violated, predicate: answer.predicate, values: {} }];
}
export const operation_name = op =>
  /^\s*\{/.test(op)
    ? (() => {
        try {
          return JSON.parse(op).op;
        } catch {
          return "";
        }
      })()
    : op.trim().split(/\s+/)[0];
const operation_labels = new Map();

const signs = { proved: "◆", tested: "●", stated: "○" };
function status_node(entry) {
  if (!entry) return null;
  return el(
    "span",
    { class: `status ${entry.status}`, title: say("status_" + entry.status) },
    signs[entry.status] ?? "○",
    el("span", { class: "unseen" }, say("status_" + entry.status)),
  );
}
function verdict_node(verdict) {
  if (!verdict) return null;
  return el(
    "span",
    { class: `verdict ${verdict}`, title: say("here_" + verdict) },
    verdict === "holds" ? "▸ ✓" : "▸ ✗",
    el("span", { class: "unseen" }, say("here_" + verdict)),
  );
}

function predicate(line, here) {
  const entry = labels.get(line.label),
    verdict = line.label ? verdict_of(line.label) : "";
  if (!line.label) return el("div", { class: "decl" }, z_block(line.text, 52, here));
  const open = opened === line.label;
  return el(
    "div",
    { class: `pred ${verdict}`, id: "p-" + line.label },
    el("div", { class: "pred-text" }, z_block(line.text, 52, here)),
    el(
      "button",
      {
        "class": "label",
        "data-key": "label " + line.label,
        "aria-expanded": String(open),
        "aria-controls": "c-" + line.label,
        "onclick": () => choose_label(open ? "" : line.label),
      },
      status_node(entry),
      verdict_node(verdict),
      el("code", {}, line.label),
    ),
    open ? card(line, entry) : null,
  );
}

// card tells of a label: its clause, its tests, its theorems with what they assume, and its value in this scene.
function card(line, entry) {
  const place = p => el("li", {}, el("code", {}, p));
  const group = (title, list) =>
    list?.length
      ? [
          el("dt", {}, title),
          el(
            "dd",
            {},
            el(
              "ul",
              {},
              list.slice(0, 6).map(place),
              list.length > 6 ? el("li", {}, `… ${list.length - 6} ${say("more")}`) : null,
            ),
          ),
        ]
      : null;
  const theorem = t =>
    el(
      "details",
      { class: "theorem" },
      el("summary", {}, el("code", {}, t.name), " ", el("span", { class: "quiet" }, t.place)),
      theorems[t.place] ? el("pre", {}, theorems[t.place].trim()) : null,
      el(
        "p",
        { class: "quiet" },
        t.assumptions?.length
          ? `${say("axioms_of_it")} ${t.assumptions.map(a => a.split(".").at(-1)).join(", ")}`
          : say("axioms"),
      ),
    );
  const known = explained.get(line.label);
  return el(
    "div",
    { class: "card", id: "c-" + line.label },
    entry
      ? el(
          "dl",
          {},
          group(say("clause"), entry.clauses),
          group(say("function"), entry.functions),
          group(say("tests"), entry.tests),
          entry.theorems?.length ? [el("dt", {}, say("theorems")), el("dd", {}, entry.theorems.map(theorem))] : null,
        )
      : null,
    broken_card(line.label),
    el(
      "button",
      { "class": "action", "data-key": "explain", "onclick": () => explain_one(line) },
      say("evaluate_here"),
    ),
    known ? explanation(known.answer) : null,
  );
}

function broken_card(label) {
  const at = Math.min(state.step, facts.answers.length) - 1,
    broken = at < 0 ? [] : broken_of(at).filter(b => b.label === label);
  return broken.map(b =>
    el(
      "p",
      { class: "fault" },
      say("does_not_hold"),
      " ",
      Object.entries(b.values ?? {}).map(([name, value]) =>
        el("code", {}, `${name} = ${typeof value === "string" ? value : JSON.stringify(value)}`, " "),
      ),
    ),
  );
}

// here_now is all that an evaluation depends on: the scene, the ray and the operation.
const here_now = () => JSON.stringify([facts.scene_text, state.p, state.v, state.on, state.ops[state.step - 1]]);

// known_values gives the inputs of the operation that was carried out last, and the ray with its answer, as values of Z.
function known_values() {
  const op = state.step > 0 ? parts_of(state.ops[state.step - 1]) : {},
    names = (facts.scene?.elementos ?? []).map(e => e.id);
  return { ...input_values(op, names), ...ray_values(state, facts.ray, names) };
}

async function explain(line) {
  const here = here_now(),
    answer = await ask({
      call: "eval",
      expression: line.text,
      bindings: values_in(line.text, known_values()),
      scene: facts.scene_text,
      explain: true,
      steps: 3000000,
    });
  explained.set(line.label, { answer, here });
  return answer;
}
async function explain_one(line) {
  const answer = await explain(line);
  render();
  if (!answer.error) find("said").textContent = `${line.label}: ${answer.value}`;
}
async function explain_all(part) {
  for (const line of part.lines.filter(l => l.label)) await explain(line);
  render();
}

// explanation shows the tree of parts with their values; parts whose value is false are open.
export function explanation(answer) {
  if (answer.error) return el("p", { class: "fault" }, answer.error.replace(/^expression:\d+:\d+: /, ""));
  if (!answer.tree) return el("p", {}, el("code", {}, z_nodes(answer.value)));
  return el("div", { class: "tree" }, branch(answer.tree, 0));
}
const cut = (text, most) => ([...text].length > most ? [...text].slice(0, most).join("") + "…" : text);
function branch(node, depth) {
  const kind = node.witness ? "witness" : node.value === "true" ? "holds" : node.value === "false" ? "fails" : "value";
  const term = node.witness
    ? el("b", { class: "witness" }, say(node.term === "witness" ? "witness" : "counter_example"))
    : el("span", { class: "term" }, z_nodes(cut(node.term, 160)));
  const head = [
    term,
    " ",
    el(
      "span",
      { class: `value ${kind}`, title: node.value, ...element_marks(node.value) },
      z_nodes(cut(node.value, 90)),
    ),
  ];
  if (!node.parts?.length) return el("div", { class: "leaf" }, head);
  return el(
    "details",
    { open: depth < 1 || (depth < 6 && kind !== "value" && kind !== "holds") },
    el("summary", {}, head),
    node.parts.map(part => branch(part, depth + 1)),
  );
}

// element_marks: a value that names elements of the scene marks them.
function element_marks(value) {
  const all = facts.scene?.elementos?.map(e => e.id) ?? [],
    named = new Set(value.match(/[\p{L}\p{N}_.:-]+/gu) ?? []);
  const met = all.filter(id => named.has(id));
  return met.length && met.length <= 12 ? { "data-marks": met.map(id => "el:" + id).join(" ") } : {};
}

function box(part) {
  const here = part.names?.[0] ?? "",
    declares = part.lines.filter(l => l.declares),
    rest = part.lines.filter(l => !l.declares);
  const framed = ["schema", "axiom", "generic"].includes(part.kind);
  return el(
    "div",
    {
      "class": `zbox ${part.kind} ${part.names?.includes(state.para) ? "chosen" : ""}`,
      "data-names": (part.names ?? []).join(" "),
      "id": here ? "z-" + here : null,
    },
    framed ? el("h3", { class: "zname" }, part.kind === "schema" ? here : "") : null,
    declares.map(l => predicate(l, here)),
    framed && declares.length && rest.length ? el("hr") : null,
    rest.map(l => predicate(l, here)),
    part.names?.includes(state.para) && rest.some(l => l.label)
      ? el("button", { "class": "small", "data-key": "all", "onclick": () => explain_all(part) }, say("evaluate_all"))
      : null,
  );
}

function render() {
  if (!files.length) return;
  const options = files.map(({ file, section }) =>
    el("option", { value: file, selected: file === state.file }, section || file),
  );
  fill(
    find("text"),
    el(
      "div",
      { class: "panel-head" },
      el("h2", { id: "text-head" }, say("z_text")),
      el(
        "select",
        {
          "aria-label": say("file_of_text"),
          "data-key": "file",
          "onchange": e => change({ file: e.target.value, para: "", label: "" }),
        },
        options,
      ),
    ),
    el(
      "p",
      { class: "legend" },
      el("span", { class: "status proved" }, "◆"),
      " ",
      say("proved"),
      " ",
      el("span", { class: "status tested" }, "●"),
      " ",
      say("tested"),
      " ",
      el("span", { class: "verdict holds" }, "▸"),
      " ",
      say("evaluated_here"),
    ),
    el(
      "div",
      {
        "class": "scroll",
        "id": "text-scroll",
        "tabindex": "0",
        "role": "region",
        "aria-label": say("z_text"),
        "lang": "en",
      },
      parts.map(part =>
        part.prose !== undefined ? el("p", { class: "prose" }, nodes_of(tidy(part.prose))) : box(part),
      ),
    ),
  );
}
const tidy = prose =>
  prose
    .replace(/\\emph\{([^}]*)\}/g, "*$1*")
    .replace(/\\_/g, "_")
    .replace(/~/g, " ")
    .replace(/``|''/g, '"');

async function load_file() {
  const file = state.file,
    answer = await once({ call: "text", file });
  if (answer.error || state.file !== file) return;
  parts = answer.parts;
  shown_file = file;
  render();
  reveal();
}

// reveal brings the chosen paragraph, or the clause that fails, into sight.
function reveal() {
  const scroll = find("text-scroll");
  const target =
    document.getElementById("p-" + state.label) ??
    [...document.querySelectorAll("#text .zbox")].find(box => box.dataset.names.split(" ").includes(state.para));
  if (!target || !scroll) return;
  const top = target.getBoundingClientRect().top - scroll.getBoundingClientRect().top + scroll.scrollTop - 30;
  scroll.scrollTo({ top, behavior: "instant" });
}

function choose_label(label) {
  opened = label;
  change({ label });
  render();
}

// show_name goes to the paragraph of a name, whichever file it stands in.
export function show_name(name) {
  const file = names.get(name);
  if (file) change({ file, para: name, label: "" });
}
export const show_label = label => {
  const entry = labels.get(label);
  if (!entry) return;
  opened = label;
  change({ file: entry.text.replace(/:\d+$/, ""), para: entry.paragraph, label });
};
export const label_entry = label => labels.get(label);

export async function start_text(operations) {
  for (const operation of operations) operation_labels.set(operation.name, operation.labels ?? []);
  const [text, index] = await Promise.all([answered({ call: "text" }), answered({ call: "labels" })]);
  files = text.files;
  for (const entry of index.labels) {
    labels.set(entry.label, entry);
    const file = entry.text.replace(/:\d+$/, "");
    for (const name of [entry.paragraph, entry.label.split(".")[0]]) if (name) names.set(name, file);
  }
  opened = state.label;
  on_change(keys => {
    if (keys.has("label")) opened = state.label;
    if (keys.has("file")) load_file();
    else if (keys.has("para") || keys.has("label")) {
      render();
      reveal();
    }
    if (keys.has("lang") || keys.has("step")) render();
  });
  on_facts(what => {
    if (what === "scene" && shown_file) render();
  });
  document.addEventListener("click", event => {
    const link = event.target.closest("a[data-name]");
    if (!link) return;
    event.preventDefault();
    change({ view: "scene" });
    show_name(link.dataset.name);
  });
  await load_file();
  collect_names();
}

// collect_names learns where each name is declared, so that it leads there.
async function collect_names() {
  for (const { file } of files)
    for (const { names: declared } of (await answered({ call: "text", file })).parts)
      for (const name of declared ?? []) names.set(name, file);
  render();
}
