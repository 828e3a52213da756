import { ask } from "./ask.js";
import { el, fill, find } from "./dom.js";
import { change, on_change, state } from "./state.js";
import { say } from "./words.js";
import { explanation } from "./text_panel.js";

// Exercises. The evaluator, the contracts or the tracer judges each answer; nothing is compared as text.
const let_points = "let w == ⦉x == a, y == b, z == 0⦊; c == ⦉x == 1, y == 0, z == 0⦊; d == ⦉x == 0, y == 1, z == 0⦊ •";

// A question has a kind: "z" is judged by an expression of Z with the answer in the place of □; "op" is an operation that must be
// refused by a label; "ray" is six numbers whose first hit must satisfy a test.
export const exercises = [
  { id: "even", kind: "z", judge: "(□) = {0, 2, 4, 6, 8, 10}", try_: "{ n : 0‥5 • 2 * n }" },
  { id: "near", kind: "z", judge: "∀ x : -5‥25 • (□) ⇔ (x ≥ 7 ∧ x ≤ 13)", try_: "x * x - 20 * x + 91 ≤ 0" },
  {
    id: "domain",
    kind: "z",
    judge: "∀ f : ℙ ((1‥2) × (1‥2)) • (□) ⇔ f ∈ (1‥2) ⇸ (1‥2)",
    try_: "∀ a : 1‥2 • # { p : f | p.1 = a } ≤ 1",
  },
  {
    id: "override",
    kind: "z",
    judge: "∀ k : 1‥3; v : 1‥3 • (□) = {1 ↦ 1, 2 ↦ 3} ⊕ {k ↦ v}",
    try_: "({k} ⩤ {1 ↦ 1, 2 ↦ 3}) ∪ {k ↦ v}",
  },
  {
    id: "cylinder",
    kind: "z",
    judge: `∀ a : -3‥3; b : -3‥3; r : 1‥3 • ${let_points} (□) ⇔ potencia_cilindro(w, c, r, d) = 0`,
    try_: "alejamiento(w, c, d) = r * r",
  },
  { id: "radius", kind: "z", judge: "(□) ∈ Rmas ∧ (□) * (□) = (□)", try_: "1" },
  {
    id: "root",
    kind: "z",
    judge:
      "let t == (□) • 0 < t < 16 / 5 ∧ potencia_esfera(⦉x == t / 2, y == 0, z == t⦊, ⦉x == 0, y == 0, z == 4⦊, 3) = 0",
    try_: "(16 - 2 * √29) / 5",
  },
  {
    id: "refused",
    kind: "op",
    label: "Agregar_Cilindro.pre.3",
    try_: "Agregar_Cilindro e?=post centro?=(0,0,0) radio?=1 vector?=(1,1,0) altura?=1",
  },
  {
    id: "tie",
    kind: "ray",
    right: hit => hit.outcome === "hit" && hit.elementos.length >= 2,
    try_: "2.75 5 1.5 0 -1 0",
  },
  { id: "nowhere", kind: "ray", right: hit => hit.outcome === "no_minimum", try_: "2.75 0.5 1.5 0 1 0" },
];

let answers = {},
  verdicts = {};

export async function judge(exercise, answer) {
  if (exercise.kind === "z") return judge_z(exercise, answer);
  const scene = documents["first.json"];
  if (exercise.kind === "op") {
    const said = await ask({ call: "edit", scene, operations: [answer] });
    if (said.error) return { right: false, text: said.error };
    return { right: said.answers[0].violated === exercise.label, text: JSON.stringify(said.answers[0]) };
  }
  const said = await ask({ call: "trace", scene, rays: answer.trim() + "\n" });
  if (said.error) return { right: false, text: said.error };
  return {
    right: said.hits.length === 1 && exercise.right(said.hits[0]),
    text: said.hits.map(h => JSON.stringify(h)).join("\n"),
  };
}

async function judge_z({ judge: expression }, answer) {
  const said = await ask({
    call: "eval",
    expression: expression.replaceAll("□", answer),
    explain: true,
    steps: 5000000,
  });
  if (said.error) return { right: false, text: said.error };
  return { right: said.value === "true", text: "", tree: said.value === "true" ? null : said };
}

function exercise_node(exercise, i) {
  const words = say(`ex_${exercise.id}`),
    verdict = verdicts[exercise.id],
    open = state.exercise === exercise.id;
  return el(
    "li",
    { class: `exercise ${verdict ? (verdict.right ? "right" : "wrong") : ""}` },
    el(
      "h3",
      {},
      el(
        "button",
        {
          "class": "plain",
          "data-key": "x" + exercise.id,
          "aria-expanded": String(open),
          "onclick": () => change({ exercise: open ? "" : exercise.id }),
        },
        `${i + 1}. ${words.split("|")[0]}`,
        verdict?.right ? " ✓" : "",
      ),
    ),
    open
      ? el(
          "form",
          {
            onsubmit: async e => {
              e.preventDefault();
              verdicts[exercise.id] = await judge(exercise, answers[exercise.id] ?? "");
              render();
              find("said").textContent = say(verdicts[exercise.id].right ? "right" : "not_right");
            },
          },
          el("p", {}, words.split("|")[1]),
          el(
            "div",
            { class: "row" },
            el("input", {
              "class": "z-input grow",
              "data-key": "a" + exercise.id,
              "spellcheck": "false",
              "autocomplete": "off",
              "aria-label": say("your_answer"),
              "value": answers[exercise.id] ?? "",
              "oninput": e => {
                answers[exercise.id] = e.target.value;
              },
            }),
            el("button", { "class": "action", "type": "submit", "data-key": "j" + exercise.id }, say("check_it")),
            el(
              "button",
              {
                "class": "small",
                "type": "button",
                "data-key": "s" + exercise.id,
                "onclick": () => {
                  answers[exercise.id] = exercise.try_;
                  render();
                },
              },
              say("show_one"),
            ),
          ),
          verdict
            ? el(
                "div",
                { class: verdict.right ? "good" : "fault", role: "status" },
                verdict.right ? `✓ ${say("right")}` : `✗ ${say("not_right")}`,
                verdict.text ? el("pre", {}, verdict.text) : null,
                verdict.tree ? explanation(verdict.tree) : null,
              )
            : null,
        )
      : null,
  );
}

function render() {
  if (state.view !== "exercises") return;
  const done = exercises.filter(x => verdicts[x.id]?.right).length;
  fill(
    find("exercises"),
    el("h2", {}, say("exercises_title")),
    el("p", { class: "lead" }, say("exercises_lead")),
    el("p", { class: "quiet" }, `${done} / ${exercises.length}`),
    el("ol", { class: "exercise-list" }, exercises.map(exercise_node)),
  );
}

export function start_exercises() {
  on_change(keys => {
    if (keys.has("view") || keys.has("exercise") || keys.has("lang")) render();
  });
  render();
}
