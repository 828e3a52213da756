import { el, fill, find } from "./dom.js";
import { facts, on_facts } from "./facts.js";
import { change, on_change, state } from "./state.js";
import { broken_of, operation_name, show_label, show_name, z_nodes } from "./text_panel.js";
import { parts_of } from "./values.js";
import { say } from "./words.js";

// The trace of operations: a slider over its steps, and forms made of the operations' own declarations.
let operations = [],
  chosen = "Agregar_Esfera",
  form_values = {},
  on_refused = () => {};

const samples = {
  Elemento: "moon",
  Punto: "(0,3,0)",
  Vector: "(0,1,0)",
  Rmas: "0.5",
  ℝ: "0.5",
  Vertices: "((0,0,0),(1,0,0),(0,1,0))",
  Ordinal: "0",
  Tipo: "soy_esfera",
  Terna: "(1,0,0)",
  Puntos: "((0,0,0),(1,0,0),(0,1,0))",
  Caras: "((0,1,2))",
  material: "",
  group: "things",
  Elementos: "ball",
};

function field(input) {
  const key = `${chosen} ${input.name}`,
    value = form_values[key] ?? (input.required ? sample_of(input) : "");
  form_values[key] = value;
  const shared = {
    "data-key": key,
    value,
    "spellcheck": "false",
    "autocomplete": "off",
    "oninput": e => {
      form_values[key] = e.target.value;
    },
  };
  const names =
    input.type === "material"
      ? Object.keys(facts.scene?.materials ?? {})
      : input.type === "Elemento"
        ? (facts.scene?.elementos ?? []).map(e => e.id)
        : input.type === "Tipo"
          ? ["esfera", "cilindro", "cono", "tronco", "plano", "disco", "triangulo"].map(t => "soy_" + t)
          : [];
  const list = names.length ? `names-${input.name}` : null;
  return el(
    "label",
    { class: "field" },
    el(
      "span",
      {},
      el("code", {}, `${input.name}?`),
      " : ",
      el("span", { class: "type" }, input.type),
      input.required ? "" : ` (${say("optional")})`,
    ),
    el("input", { type: "text", list, size: input.type === "Vertices" ? 22 : 11, ...shared }),
    list
      ? el(
          "datalist",
          { id: list },
          names.map(name => el("option", { value: name })),
        )
      : null,
  );
}
function sample_of(input) {
  if (input.type === "Elemento" && !chosen.startsWith("Agregar")) return facts.scene?.elementos?.[0]?.id ?? "ball";
  return samples[input.type] ?? "";
}

function text_of_form() {
  const operation = operations.find(o => o.name === chosen);
  const parts = operation.inputs
    .map(input => [input.name, (form_values[`${chosen} ${input.name}`] ?? "").trim()])
    .filter(([, value]) => value !== "");
  return [chosen, ...parts.map(([name, value]) => `${name}?=${value.replace(/\s+/g, "")}`)].join(" ");
}

function add(line) {
  const ops = [...state.ops.slice(0, state.step), line];
  change({ ops, step: ops.length });
}

function step_button(i) {
  const answer = i === 0 ? null : facts.answers[i - 1],
    kind = i === 0 ? "start" : !answer ? "" : answer.ok ? "done" : "refused";
  return el(
    "button",
    {
      "class": `step ${kind}`,
      "data-key": "step" + i,
      "aria-pressed": String(i === state.step),
      "onclick": () => change({ step: i }),
    },
    el("span", { class: "mark" }, i === 0 ? "0" : kind === "refused" ? "✗" : "✓"),
    i === 0 ? say("first_scene") : operation_name(state.ops[i - 1]),
  );
}

function slider() {
  return el("input", {
    "type": "range",
    "min": "0",
    "max": String(state.ops.length),
    "value": String(state.step),
    "step": "1",
    "id": "slider",
    "data-key": "slider",
    "aria-label": say("step_of_trace"),
    "aria-valuetext": state.step === 0 ? say("first_scene") : state.ops[state.step - 1],
    "oninput": e => change({ step: Number(e.target.value) }),
  });
}

// step_told says what a step answered, and what it changed of the components of the state.
function step_told() {
  const i = state.step;
  if (facts.error) return el("p", { class: "fault", role: "alert" }, facts.error);
  if (i === 0) return el("p", { class: "quiet" }, say("trace_help"));
  const answer = facts.answers[i - 1];
  if (!answer) return null;
  const line = el("code", { class: "op" }, state.ops[i - 1]);
  if (answer.ok)
    return el(
      "div",
      {},
      el("p", {}, line),
      el("p", { class: "good" }, "✓ r! = ", el("code", {}, answer.r)),
      changed(i),
    );
  return el(
    "div",
    { class: "refusal" },
    el("p", {}, line),
    el("p", { class: "fault" }, "✗ r! = ", el("code", {}, answer.r)),
    el(
      "ul",
      {},
      broken_of(i - 1).map(b =>
        el(
          "li",
          {},
          el("button", { class: "label", onclick: () => show_label(b.label) }, el("code", {}, b.label)),
          " ",
          el("span", { class: "z" }, z_nodes(b.predicate)),
          " ",
          Object.entries(b.values ?? {}).map(([name, value]) =>
            el("code", { class: "quiet" }, `${name} = ${typeof value === "string" ? value : JSON.stringify(value)} `),
          ),
        ),
      ),
    ),
  );
}
const components = {
  tipo: "de_que_tipo",
  centro: "mi_centro",
  radio: "mi_radio",
  vector: "mi_vector",
  altura: "mi_altura",
  proporcion: "mi_proporcion",
  vertices: "mi_vertices",
};
function changed(i) {
  const read = text => {
    try {
      return new Map(JSON.parse(text).elementos.map(e => [e.id, e]));
    } catch {
      return new Map();
    }
  };
  const before = read(facts.scenes[i - 1]),
    after = read(facts.scenes[i]),
    rows = [];
  for (const id of new Set([...before.keys(), ...after.keys()])) {
    const a = before.get(id),
      b = after.get(id);
    for (const [key, name] of Object.entries(components)) {
      const [x, y] = [a?.[key], b?.[key]].map(value => (value === undefined ? null : JSON.stringify(value)));
      if (x !== y)
        rows.push(
          el(
            "li",
            { "data-marks": "el:" + id },
            el("code", {}, `${name}${y === null || x === null ? "" : ` ${id}`}`),
            " ",
            x === null ? `∪ {${id} ↦ ${y}}` : y === null ? `⩤ {${id}}` : `: ${x} → ${y}`,
          ),
        );
    }
  }
  return rows.length ? el("ul", { class: "changed" }, rows.slice(0, 14)) : null;
}

function render() {
  const sorted = operations.map(o => el("option", { value: o.name, selected: o.name === chosen }, o.name)),
    operation = operations.find(o => o.name === chosen);
  fill(
    find("operations"),
    el(
      "div",
      { class: "panel-head" },
      el("h2", { id: "operations-head" }, say("trace_of_operations")),
      el("span", { class: "quiet" }, `${state.step} / ${state.ops.length}`),
      el(
        "button",
        {
          "class": "small",
          "data-key": "clear",
          "disabled": !state.ops.length,
          "onclick": () => change({ ops: [], step: 0 }),
        },
        say("clear"),
      ),
      el("button", { "class": "small", "data-key": "example", "onclick": example }, say("example_trace")),
    ),
    el(
      "div",
      { class: "scroll", id: "operations-scroll" },
      slider(),
      el("div", { class: "steps" }, [...Array(state.ops.length + 1).keys()].map(step_button)),
      el(
        "div",
        { class: "trace-columns" },
        el(
          "form",
          {
            class: "operation",
            onsubmit: e => {
              e.preventDefault();
              add(text_of_form());
            },
          },
          el(
            "label",
            { class: "field" },
            el("span", {}, say("operation")),
            el(
              "select",
              {
                "data-key": "operation",
                "onchange": e => {
                  chosen = e.target.value;
                  render();
                  const schema = operations.find(o => o.name === chosen)?.schema;
                  if (schema) show_name(schema);
                },
              },
              sorted,
            ),
          ),
          operation ? operation.inputs.map(field) : null,
          el("button", { "class": "action strong", "data-key": "apply", "type": "submit" }, say("apply")),
        ),
        step_told(),
      ),
    ),
  );
}

// example shows an edit that is done, and three that are refused.
function example() {
  const ops = [
    "Agregar_Esfera e?=moon centro?=(1.5,3,-0.5) radio?=0.5 material?=ochre",
    "Agregar_Esfera e?=ball centro?=(0,0,0) radio?=1",
    "Agregar_Cilindro e?=post centro?=(-3,0,-1) radio?=0.25 vector?=(1,1,0) altura?=2",
    "Eliminar_Esfera e?=tube",
    "Cambiar_Radio e?=moon radio?=0.75",
  ];
  change({ scene: "first", ops, step: 1 });
}

// refused_element is what the picture shows of a refusal: the element that was to be added, or the one that is named.
function refused_element() {
  const i = state.step,
    answer = facts.answers[i - 1];
  if (i === 0 || !answer || answer.ok) return { ghost: null, named: null };
  const parts = parts_of(state.ops[i - 1]),
    present = facts.scene?.elementos?.some(e => e.id === parts.e);
  const tipo =
    /^Agregar_(\w+)$/.exec(operation_name(state.ops[i - 1]))?.[1]?.toLowerCase() ??
    String(parts.t ?? "").replace("soy_", "");
  const ghost = /^Agregar/.test(operation_name(state.ops[i - 1]))
    ? {
        ...parts,
        id: parts.e,
        tipo: tipo === "elemento" ? String(parts.t ?? "").replace("soy_", "") : tipo,
        why: answer.violated,
      }
    : null;
  return { ghost, named: present ? parts.e : null };
}
// show_refusal brings the clause that refused the step into the text.
export function show_refusal() {
  const answer = facts.answers[state.step - 1];
  if (state.step > 0 && answer && !answer.ok) show_label(answer.violated);
}

// show_step shows the step that was asked, and says how it was answered.
function show_step() {
  render();
  on_refused(refused_element());
  show_refusal();
  const answer = facts.answers[state.step - 1];
  if (state.step === 0 || !answer) return;
  const refused = `${say("refused")}: ${answer.violated} ${answer.predicate}`;
  find("said").textContent = answer.ok ? `${state.ops[state.step - 1]}: ${answer.r}` : refused;
}

export function start_operations(list, refused) {
  operations = list;
  on_refused = refused;
  on_facts(what => {
    if (what === "scene" || what === "error") show_step();
  });
  on_change(keys => {
    if (keys.has("lang")) render();
  });
  show_step();
}
