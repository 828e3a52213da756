import { ask } from "./ask.js";
import { el, fill, find, later } from "./dom.js";
import { graph, state_table } from "./machine.js";
import { change, on_change, state } from "./state.js";
import { mark_node, z_nodes } from "./text_panel.js";
import { say } from "./words.js";
import { palette, without_conjectures } from "./ztext.js";

// A reader's own Z: it is checked while it is typed, and stepped through.
const samples = { birthday: "birthday_book.tex", lift: "lift.tex", files: "file_system.tex" };
let checked = null,
  ran = null,
  drawn = null,
  asked = 0,
  inputs = {},
  expression = "",
  value = null;

const text_now = () => state.ztext || documents[samples[state.z] ?? "birthday_book.tex"];

async function check_and_run() {
  const mine = ++asked,
    text = text_now();
  const answer = await ask({ call: "zed.check", text, states: 8 });
  if (mine !== asked) return;
  checked = answer;
  ran = null;
  drawn = null;
  render_answers();
  if (answer.error || (answer.ok === false && answer.defects?.some(d => d.severity === "error"))) return;
  await run(state.way ? { way: state.way } : {}, mine);
}

async function run(more, mine = ++asked) {
  const answer = await ask({ call: "zed.run", text: text_now(), ...more });
  if (mine !== asked) return;
  if (!answer.error || !ran) ran = answer;
  else ran = { ...ran, refused: answer.error };
  if (answer.way) change({ way: answer.states?.length > 1 ? answer.way : "" });
  render_answers();
}

async function draw_graph() {
  drawn = { waiting: true };
  render_answers();
  const first = await ask({ call: "zed.graph", text: text_now(), most: 30 });
  drawn = first.refuted
    ? {
        ...(await ask({ call: "zed.graph", text: without_conjectures(text_now()), most: 30 })),
        refuted: first.refuted,
        way: first.way,
      }
    : first;
  render_answers();
}

async function evaluate() {
  value = await ask({ call: "eval", expression, text: text_now(), explain: true });
  render_answers();
}

const typed = later(() => {
  change({ ztext: find("own-text").value, way: "" });
  check_and_run();
}, 400);

function insert(symbol) {
  const area = find("own-text"),
    { selectionStart: a, selectionEnd: b } = area;
  area.setRangeText(symbol, a, b, "end");
  area.focus();
  typed();
}
function go_to(line, column) {
  const area = find("own-text"),
    lines = area.value.split("\n"),
    at = lines.slice(0, line - 1).reduce((sum, l) => sum + l.length + 1, 0) + Math.max(0, column - 1);
  area.focus();
  area.setSelectionRange(at, at + Math.max(1, (lines[line - 1] ?? "").length - column + 1));
  area.scrollTop = (line - 4) * parseFloat(getComputedStyle(area).lineHeight);
}

function defects() {
  if (!checked) return el("p", { class: "quiet" }, say("waiting"));
  if (checked.error) return el("p", { class: "fault" }, checked.error);
  const list = checked.defects ?? [],
    wrong = list.some(d => d.severity === "error");
  return el(
    "div",
    {},
    el(
      "p",
      { class: wrong ? "fault" : "good" },
      wrong ? `✗ ${list.length} ${say("defects")}` : `✓ ${say("text_is_right")}`,
    ),
    el(
      "ul",
      { class: "defects" },
      list.map(d =>
        el(
          "li",
          { class: d.severity },
          el("button", { class: "label", onclick: () => go_to(d.line, d.column) }, `${d.line}:${d.column}`),
          " ",
          d.message,
          d.expected ? el("span", { class: "quiet" }, `; ${d.expected}`) : null,
        ),
      ),
    ),
    conjectures(),
    checked.lines?.length
      ? el(
          "details",
          {},
          el("summary", {}, say("lines_of_check")),
          el("pre", { class: "lines" }, checked.lines.join("\n")),
        )
      : null,
  );
}

function conjectures() {
  return el(
    "ul",
    {},
    (checked.conjectures ?? []).map(c =>
      el(
        "li",
        { class: c.refuted ? "fault" : c.tried ? "good" : "quiet" },
        el("button", { class: "label", onclick: () => go_to(c.line, c.column) }, `${c.line}:${c.column}`),
        " ",
        c.refuted
          ? [`✗ ${say("conjecture_false")} `, el("code", {}, z_nodes(c.counterexample.map(l => l.trim()).join(", ")))]
          : c.tried
            ? `✓ ${say("conjecture_tried")} ${c.tried} ${say("states")}`
            : `? ${c.why_not}`,
      ),
    ),
  );
}

function operation_card(o) {
  const sign = { yes: "✓", no: "✗", open: "?" }[o.enabled];
  const fields = o.inputs.map(i => {
    const key = `${o.name} ${i.name}`;
    return el(
      "label",
      { class: "field" },
      el("span", {}, el("code", {}, i.name), ` : ${i.type}`),
      el("input", {
        "size": 8,
        "data-key": key,
        "value": inputs[key] ?? "",
        "placeholder": example_of(o, i.name),
        "oninput": e => {
          inputs[key] = e.target.value;
        },
      }),
    );
  });
  const given = () =>
    Object.fromEntries(o.inputs.map(i => [i.name, (inputs[`${o.name} ${i.name}`] ?? "").trim()]).filter(([, v]) => v));
  return el(
    "form",
    {
      class: `machine-operation ${o.enabled}`,
      onsubmit: e => {
        e.preventDefault();
        run({ way: ran.way, step: { operation: o.name, inputs: given() } });
      },
    },
    el(
      "button",
      { "class": "action", "type": "submit", "data-key": "op" + o.name, "disabled": o.enabled === "no" },
      sign,
      " ",
      o.name,
    ),
    fields,
    o.refused ? el("span", { class: "fault" }, o.refused) : null,
    o.enabled !== "yes" && o.predicates?.length
      ? el(
          "ul",
          {},
          o.predicates
            .filter(p => p.truth === (o.enabled === "no" ? "false" : "open"))
            .map(p =>
              el(
                "li",
                { class: p.truth === "false" ? "fault" : "quiet" },
                el("span", { class: "z" }, z_nodes(p.predicate)),
                p.after ? el("span", { class: "quiet" }, ` ${say("in_the_state_after")}`) : null,
                p.label ? el("code", { class: "quiet" }, ` ${p.label}`) : null,
              ),
            ),
        )
      : null,
  );
}
function example_of(o, name) {
  const found = new RegExp(`(?:^| )${name.replace("?", "\\?")} = ([^;]*)`).exec(o.example ?? "");
  return found ? found[1].trim() : "";
}

function machine() {
  if (!ran) return null;
  if (ran.error) return el("p", { class: "quiet" }, ran.error);
  return el(
    "section",
    {},
    el("h3", {}, say("machine"), " ", el("code", {}, ran.state)),
    el("p", { class: "quiet" }, [...(ran.carriers ?? []), ...(ran.taken ?? [])].join(" · ")),
    ran.refused ? el("p", { class: "fault", role: "alert" }, `✗ ${ran.refused}`) : null,
    ran.ways?.length
      ? el(
          "div",
          { class: "ways" },
          el("p", {}, say("several_ways")),
          ran.ways
            .slice(0, 12)
            .map((w, i) =>
              el(
                "button",
                { "data-key": "way" + i, "onclick": () => run({ way: w.way }) },
                [...Object.entries(w.inputs ?? {}), ...Object.entries(w.values ?? {})]
                  .map(([k, v]) => `${k} = ${v}`)
                  .join("; "),
              ),
            ),
        )
      : null,
    el("div", { class: "machine-operations" }, ran.operations.map(operation_card)),
    el(
      "div",
      { class: "row" },
      el(
        "button",
        { "class": "small", "data-key": "back", "disabled": ran.states.length < 2, "onclick": back },
        say("one_back"),
      ),
      el("button", { "class": "small", "data-key": "restart", "onclick": () => run({}) }, say("from_the_start")),
    ),
    state_table(ran),
    ran.invariant?.length
      ? el(
          "ul",
          { class: "invariant" },
          ran.invariant.map(p =>
            el(
              "li",
              { class: p.truth === "true" ? "good" : p.truth === "false" ? "fault" : "quiet" },
              p.truth === "true" ? "✓ " : p.truth === "false" ? "✗ " : "? ",
              el("span", { class: "z" }, z_nodes(p.predicate)),
            ),
          ),
        )
      : null,
    graph_part(),
  );
}

// back takes the last step off the saved way: its lines from the last "step" on.
function back() {
  const lines = ran.way.split("\n"),
    at = lines.findLastIndex(line => line.startsWith("step "));
  run({ way: lines.slice(0, at).join("\n") + "\n" });
}

function graph_part() {
  if (!drawn) return el("button", { "class": "action", "data-key": "graph", "onclick": draw_graph }, say("draw_graph"));
  if (drawn.waiting) return el("p", { class: "quiet" }, say("waiting"));
  if (drawn.error) return el("p", { class: "fault" }, drawn.error);
  return el(
    "div",
    {},
    el("h3", {}, `${say("graph")}: ${drawn.states.length} ${say("states")}, ${drawn.steps.length} ${say("steps")}`),
    el(
      "div",
      { class: "wide" },
      graph(drawn, ran.states.at(-1)?.values, i => {
        find("graph-said").textContent =
          `${i}: ` +
          Object.entries(drawn.states[i].values)
            .map(([k, v]) => `${k} == ${v}`)
            .join("; ");
      }),
    ),
    el("p", { id: "graph-said", class: "z", role: "status" }, say("graph_help")),
    drawn.bounded?.length ? el("p", { class: "quiet" }, `${say("bounded_by")} ${drawn.bounded.join(", ")}`) : null,
    drawn.refuted
      ? el(
          "div",
          { class: "fault" },
          el("p", {}, `✗ ${say("refuted")} `, el("span", { class: "z" }, z_nodes(drawn.refuted))),
          el(
            "ol",
            {},
            (drawn.way ?? []).map((line, i) => el("li", {}, el("code", {}, `${i}. ${line}`))),
          ),
        )
      : null,
  );
}

function render_answers() {
  const holder = find("own-answers");
  if (!holder) return;
  fill(
    holder,
    defects(),
    el(
      "form",
      {
        class: "row",
        onsubmit: e => {
          e.preventDefault();
          evaluate();
        },
      },
      el(
        "label",
        { class: "field grow" },
        say("expression"),
        el("input", {
          "data-key": "expression",
          "value": expression,
          "spellcheck": "false",
          "oninput": e => {
            expression = e.target.value;
          },
        }),
      ),
      el("button", { class: "action", type: "submit" }, say("evaluate")),
    ),
    value
      ? el("p", { class: value.error ? "fault" : "good" }, el("code", {}, z_nodes(value.error ?? value.value)))
      : null,
    machine(),
  );
}

function show() {
  if (state.view !== "own") return;
  fill(
    find("own"),
    el("h2", {}, say("own_title")),
    el("p", { class: "lead" }, say("own_lead")),
    el(
      "div",
      { class: "two" },
      el(
        "section",
        {},
        el(
          "div",
          { class: "row" },
          el(
            "label",
            {},
            say("example"),
            " ",
            el(
              "select",
              { "data-key": "z", "onchange": e => change({ z: e.target.value, ztext: "", way: "" }) },
              [
                ["birthday", say("birthday_book")],
                ["lift", say("lift")],
                ["files", say("file_system")],
              ].map(([key, name]) => el("option", { value: key, selected: key === state.z }, name)),
            ),
          ),
        ),
        el(
          "div",
          { "class": "palette", "role": "group", "aria-label": say("symbols") },
          palette.map(symbol =>
            el("button", { type: "button", tabindex: "-1", onclick: () => insert(symbol) }, mark_node(symbol)),
          ),
        ),
        el("textarea", {
          "id": "own-text",
          "class": "z-input",
          "spellcheck": "false",
          "rows": "30",
          "aria-label": say("your_text"),
          "oninput": typed,
          "value": text_now(),
        }),
      ),
      el("section", { id: "own-answers" }),
    ),
  );
  render_answers();
  check_and_run();
}

export function start_own() {
  on_change(keys => {
    if (keys.has("view") || keys.has("z") || keys.has("lang")) show();
  });
  show();
}
