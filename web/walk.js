import { ask } from "./ask.js";
import { el, fill, find } from "./dom.js";
import { facts, on_facts } from "./facts.js";
import { all_rows, nodes_of, rows_of, section_of } from "./marked.js";
import { bits_of, quadratic_text, written } from "./numbers.js";
import { change, on_change, state } from "./state.js";
import { set_of } from "./names.js";
import { broken_of, explanation, operation_name, show_label, z_nodes } from "./text_panel.js";
import { z_name, z_ray } from "./values.js";
import { say } from "./words.js";

// The walk down the ladder, docs/refinement.md alive: each step with its law, its theorem and its test, and beside them the
// values of the reader's own ray or operation at that step.
const headings = { ray: "A ray: `Primera_Interseccion`", operation: "An operation: `Agregar_Esfera`" };
const sentences = new Map(),
  axioms = new Map();

function read_documents() {
  for (const [name, sentence] of all_rows(documents["proofs/README.md"]))
    if (sentence) sentences.set(name.replaceAll("`", ""), sentence);
  for (const line of documents["proofs/assumptions.txt"].split("\n")) {
    const at = line.indexOf(": ");
    if (at > 0)
      axioms.set(
        line.slice(0, at),
        line
          .slice(at + 2)
          .trim()
          .split(/\s+/),
      );
  }
}

// assumed is what the chain of docs/proofs.md says that an arrow assumes besides the axioms.
function assumed(theorem) {
  const row = all_rows(documents["docs/proofs.md"]).find(cells => cells[2]?.includes("`" + theorem + "`"));
  return row?.[3] ?? "";
}

function theorem_node(name) {
  const premise = assumed(name),
    list = axioms.get(name) ?? [];
  return el(
    "details",
    { class: "theorem" },
    el("summary", {}, el("span", { class: "status proved" }, "◆"), " ", el("code", {}, name)),
    sentences.has(name) ? el("p", {}, nodes_of(sentences.get(name))) : null,
    premise ? el("p", {}, el("b", {}, say("assumes"), " "), nodes_of(premise)) : null,
    list.length
      ? el("p", { class: "quiet" }, `${say("axioms_of_it")} ${list.map(a => a.split(".").at(-1)).join(", ")}`)
      : null,
  );
}
const names_in = text => [...text.matchAll(/`([^`]+)`/g)].map(m => m[1]);

const with_ray = body => `let ray == ${z_ray(state.p, state.v)} • ${body}`;

// evaluated asks the text itself; the answer comes into the node.
function evaluated(body) {
  const expression = with_ray(body),
    node = el("div", { class: "live" }, el("code", { class: "z" }, body), el("p", { class: "quiet" }, say("waiting")));
  ask({ call: "eval", expression, scene: facts.scene_text, explain: true, steps: 3000000 }).then(answer =>
    fill(
      node,
      el("code", { class: "z" }, body),
      el("span", { class: "equals" }, " = "),
      answer.error
        ? el("span", { class: "fault" }, answer.error)
        : [
            el("code", { class: "z value" }, z_nodes(answer.value)),
            el("details", {}, el("summary", {}, say("part_by_part")), explanation(answer)),
          ],
    ),
  );
  return node;
}
const live = (...children) => el("div", { class: "live" }, children);
const exact_t = c => (c?.t ? el("code", {}, quadratic_text(c.t.x, c.t.y, c.t.delta)) : null);

const ray_steps = {
  "`spec/interseccion.tex`": () => evaluated("interseccion(puntos_de_escena(θ Escena), puntos_de_rayo(ray))"),
  "`reduccion`": () => evaluated("reduccion(alcances(θ Escena, ray, ∅), ray.p)"),
  "the three outcomes": ({ hit }) => live(el("code", {}, `resultado! = ${hit.outcome}`)),
  "`spec/tablas.tex`: the closed form": ({ crossings }) =>
    live(
      el(
        "ul",
        {},
        crossings
          .filter(c => c.t)
          .map(c => el("li", { "data-marks": "el:" + c.elemento }, c.elemento, ": t = ", exact_t(c))),
      ),
    ),
  "one element, of any type": ({ crossings }) =>
    crossings.length ? evaluated(`alcance(θ Escena, ray, ∅, ${z_name(crossings[0].elemento)})`) : live("∅"),
  "the clip": ({ crossings }) => live(counted(crossings)),
  "one element: its first hit": ({ crossings }) =>
    live(
      el(
        "ul",
        {},
        least_each(crossings).map(c => el("li", {}, c.elemento, ": ", exact_t(c))),
      ),
    ),
  "the scene": ({ hit }) => live(el("code", {}, "elementos! = "), set_of(hit.elementos)),
  "exact, over integers": ({ crossings }) => live("t = ", exact_t(crossings.find(c => c.first))),
  "binary64, certified": answer =>
    live(
      (answer.decided?.first ?? []).map(d =>
        el(
          "p",
          {},
          `${d.elemento}: ${say("step_" + d.step)}`,
          typeof d.bound === "number" ? `, ${say("bound")} ${d.bound}` : "",
          typeof answer.decided.margin === "number" ? `, ${say("margin")} ${answer.decided.margin}` : "",
        ),
      ),
    ),
  "fewer tests": ({ hit }) => live(el("code", {}, JSON.stringify(hit))),
};
function counted(crossings) {
  const counts = new Map();
  for (const c of crossings) counts.set(c.elemento, [...(counts.get(c.elemento) ?? []), c.kind]);
  return el(
    "ul",
    {},
    [...counts].map(([id, kinds]) =>
      el(
        "li",
        { "data-marks": "el:" + id },
        `${id}: ${kinds.length} ${say(kinds[0] === "segment" ? "segments" : "points")}`,
      ),
    ),
  );
}
function least_each(crossings) {
  const least = new Map();
  for (const c of crossings) if (!least.has(c.elemento)) least.set(c.elemento, c);
  return [...least.values()];
}

function bytes_of(x) {
  return bits_of(x).toString(16).padStart(16, "0").match(/../g).join(" ");
}
function rounding(answer) {
  const { hit } = answer;
  if (hit.outcome !== "hit" || typeof hit.t !== "number") return null;
  return el(
    "li",
    { class: "walk-step" },
    el("h3", {}, say("rounded_once")),
    live(
      el("p", {}, el("code", {}, `t = ${written(hit.t)}`)),
      el("p", { class: "bytes" }, el("code", {}, bytes_of(hit.t))),
      el("p", { class: "quiet" }, say("eight_bytes")),
    ),
  );
}

function operation_steps(at) {
  const op = state.ops[at],
    answer = facts.answers[at],
    name = op ? operation_name(op) : "";
  if (!answer) return {};
  const after = facts.scenes[at + 1];
  return {
    "`spec/operaciones.tex`": () =>
      live(
        el("code", {}, op),
        answer.ok
          ? el("p", { class: "good" }, `✓ pre ${name}`)
          : el(
              "ul",
              {},
              broken_of(at).map(b =>
                el(
                  "li",
                  { class: "fault" },
                  el(
                    "button",
                    {
                      class: "label",
                      onclick: () => {
                        change({ view: "scene" });
                        show_label(b.label);
                      },
                    },
                    el("code", {}, b.label),
                  ),
                  " ",
                  b.predicate,
                ),
              ),
            ),
      ),
    "the invariant": () => invariants(after),
    "`Agregar_Esfera_Total`": () => live(el("code", {}, `r! = ${answer.r}`)),
    "`model::apply`": () => live(el("code", {}, JSON.stringify(answer))),
    "`spec/tablas.tex`: `Tablas`": () => tables(after, op),
    "`scene::Scene`": () => live(el("p", {}, `${new TextEncoder().encode(after).length} ${say("bytes_of_scene")}`)),
    "`Scene::apply_total`": () => live(el("p", {}, answer.ok ? say("tables_changed") : say("tables_same"))),
    "`edit --by-spec`": () => evaluated_elements(after),
  };
}
function invariants(scene) {
  const node = live(say("waiting"));
  ask({ call: "check", scene }).then(answer =>
    fill(
      node,
      answer.error
        ? el("p", { class: "fault" }, answer.error)
        : el(
            "ul",
            {},
            answer.check.invariants
              .filter(i => i.label.startsWith("Escena"))
              .map(i =>
                el(
                  "li",
                  { class: i.holds ? "good" : "fault" },
                  i.holds ? "✓ " : "✗ ",
                  el("code", {}, i.label),
                  " ",
                  el("span", { class: "z" }, i.predicate),
                ),
              ),
          ),
    ),
  );
  return node;
}
function evaluated_elements(scene) {
  const node = live(say("waiting"));
  ask({ call: "eval", expression: "elementos", scene }).then(answer =>
    fill(
      node,
      el("code", { class: "z" }, "elementos = "),
      el("code", { class: "z" }, z_nodes(answer.error ?? answer.value)),
    ),
  );
  return node;
}
// tables shows the scene as the tables of spec/tablas.tex: a row an element, a table a type.
function tables(text, op) {
  const types = new Map(),
    named = /\be\??=(\S+)/.exec(op ?? "")?.[1];
  let scene;
  try {
    scene = JSON.parse(text);
  } catch {
    return live("—");
  }
  for (const e of scene.elementos) types.set(e.tipo, [...(types.get(e.tipo) ?? []), e]);
  return live(
    el(
      "div",
      { class: "wide" },
      [...types].map(([tipo, rows]) => {
        const keys = Object.keys(rows[0]).filter(k => !["id", "tipo", "material", "motion"].includes(k));
        return el(
          "table",
          { class: "states" },
          el("caption", {}, tipo),
          el(
            "thead",
            {},
            el(
              "tr",
              {},
              ["#", "id", ...keys].map(k => el("th", { scope: "col" }, k)),
            ),
          ),
          el(
            "tbody",
            {},
            rows.map((row, i) =>
              el(
                "tr",
                { "class": row.id === named ? "now" : "", "data-marks": "el:" + row.id },
                el("td", {}, String(i)),
                el("td", {}, row.id),
                keys.map(k => el("td", {}, JSON.stringify(row[k]))),
              ),
            ),
          ),
        );
      }),
    ),
  );
}

function step_node([step, law, theorems_cell, test], made) {
  const key = Object.keys(made).find(start => step.startsWith(start));
  return el(
    "li",
    { class: "walk-step" },
    el("h3", {}, nodes_of(step)),
    el("p", {}, nodes_of(law)),
    key ? made[key]() : null,
    el(
      "div",
      { class: "backing" },
      names_in(theorems_cell ?? "").map(theorem_node),
      el(
        "p",
        {},
        el("span", { class: "status tested" }, "●"),
        " ",
        names_in(test ?? "").map(t => [el("code", {}, t), " "]),
      ),
    ),
  );
}

function show() {
  if (state.view !== "walk") return;
  const rows = rows_of(section_of(documents["docs/refinement.md"], headings[state.walk] ?? headings.ray)),
    ready = facts.ray && !facts.ray.error;
  const at = Math.max(0, Math.min(state.step, facts.answers.length) - 1);
  const made =
    state.walk === "operation"
      ? operation_steps(at)
      : ready
        ? Object.fromEntries(Object.entries(ray_steps).map(([key, f]) => [key, () => f(facts.ray)]))
        : {};
  fill(
    find("walk"),
    el("h2", {}, say("walk_title")),
    el("p", { class: "lead" }, say("walk_lead")),
    el(
      "div",
      { "class": "tabs", "role": "group", "aria-label": say("walk_title") },
      ["ray", "operation"].map(k =>
        el(
          "button",
          { "data-key": "walk" + k, "aria-pressed": String(k === state.walk), "onclick": () => change({ walk: k }) },
          say("walk_" + k),
        ),
      ),
    ),
    state.walk === "operation" && !facts.answers.length
      ? el(
          "p",
          {},
          say("no_operation_yet"),
          " ",
          el(
            "button",
            {
              class: "action",
              onclick: () => change({ ops: ["Agregar_Esfera e?=moon centro?=(1.5,3,-0.5) radio?=0.5"], step: 1 }),
            },
            say("one_operation"),
          ),
        )
      : null,
    state.walk === "operation" && state.ops[at]
      ? el("p", {}, el("code", {}, state.ops[at]))
      : state.walk === "ray"
        ? el("p", {}, el("code", {}, `p = (${state.p.join(", ")}), v = (${state.v.join(", ")})`))
        : null,
    el(
      "ol",
      { class: "walk-steps", lang: "en" },
      rows.map(row => step_node(row, made)),
      state.walk === "ray" && ready ? rounding(facts.ray) : null,
    ),
  );
}

export function start_walk() {
  read_documents();
  on_change(keys => {
    if (keys.has("view") || keys.has("walk") || keys.has("lang")) show();
  });
  on_facts(what => {
    if (what === "ray" || what === "scene") show();
  });
  show();
}
