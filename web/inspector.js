import { decided_block } from "./decided_view.js";
import { el, fill, find } from "./dom.js";
import { facts, on_facts } from "./facts.js";
import { exact_block } from "./exact_view.js";
import { short, written } from "./numbers.js";
import { change, on_change, state } from "./state.js";
import { through_pixel } from "./window.js";
import { set_of } from "./names.js";
import { say } from "./words.js";

// The ray and what is known of it: its crossings, one number of them exactly, the step that decided, and the lights.
let frame_of_stage = () => null;

function number_field(name, values, i, key) {
  return el(
    "label",
    { class: "number-field" },
    el("span", {}, `${name}.${"xyz"[i]}`),
    el("input", {
      "type": "text",
      "inputmode": "decimal",
      "value": written(values[i]),
      "data-key": name + i,
      "spellcheck": "false",
      "aria-label": `${name}.${"xyz"[i]}`,
      "onchange": event => {
        const x = Number(event.target.value),
          next = state[key].map((y, k) => (k === i ? x : y));
        const wrong =
          !Number.isFinite(x) || event.target.value.trim() === "" || (key === "v" && next.every(y => y === 0));
        event.target.setAttribute("aria-invalid", String(wrong));
        find("said").textContent = wrong ? say(key === "v" && x === 0 ? "null_direction" : "no_number") : "";
        if (!wrong) change({ [key]: next });
      },
    }),
  );
}

function ray_form() {
  const frame = frame_of_stage(),
    pixel = k => Number(find("pixel-" + k)?.value);
  return el(
    "details",
    { "class": "block", "open": true, "data-marks": "ray" },
    el("summary", {}, say("ray"), " ", el("code", {}, "{ p + t·v | t > 0 }")),
    el(
      "div",
      { class: "numbers" },
      [0, 1, 2].map(i => number_field("p", state.p, i, "p")),
      [0, 1, 2].map(i => number_field("v", state.v, i, "v")),
    ),
    frame
      ? el(
          "div",
          { class: "row" },
          el("span", {}, say("through_pixel")),
          ["column", "row"].map(k =>
            el("input", {
              "id": "pixel-" + k,
              "data-key": k,
              "type": "number",
              "min": "0",
              "max": String((k === "column" ? frame.width : frame.height) - 1),
              "value": shown_pixel[k] ?? (k === "column" ? frame.width >> 1 : frame.height >> 1),
              "aria-label": say(k),
              "onchange": () => aim(frame, pixel("column"), pixel("row")),
            }),
          ),
          el(
            "button",
            { "class": "action", "data-key": "aim", "onclick": () => aim(frame, pixel("column"), pixel("row")) },
            say("aim"),
          ),
        )
      : null,
    el("p", { class: "quiet" }, say("handles_help")),
  );
}
let shown_pixel = {};
function aim(frame, column, row) {
  if (!(column >= 0 && column < frame.width && row >= 0 && row < frame.height)) return;
  shown_pixel = { column, row };
  change({ p: [...frame.eye], v: through_pixel(frame, column, row), on: [] });
}

function hit_block(answer) {
  const { hit } = answer,
    said = { hit: say("outcome_hit"), miss: say("outcome_miss"), no_minimum: say("outcome_no_minimum") }[hit.outcome];
  return el(
    "div",
    { "class": `block hit ${hit.outcome}`, "data-marks": "first" },
    el(
      "p",
      { class: "outcome" },
      el("strong", {}, said),
      " ",
      hit.outcome === "hit"
        ? el("span", {}, "t = ", el("code", {}, typeof hit.t === "number" ? written(hit.t) : hit.t))
        : null,
    ),
    hit.outcome === "miss"
      ? null
      : el(
          "p",
          {},
          el("code", {}, "elementos! = "),
          set_of(hit.elementos),
          hit.elementos.length > 1 && hit.outcome === "hit" ? el("span", { class: "quiet" }, " ", say("tie")) : null,
        ),
  );
}

function crossing_list(answer) {
  if (!answer.crossings.length) return null;
  return el(
    "div",
    { class: "block" },
    el("h3", {}, say("all_crossings"), ` (${answer.crossings.length})`),
    el(
      "ol",
      { class: "crossings" },
      answer.crossings.map((c, i) =>
        el(
          "li",
          {},
          el(
            "button",
            {
              "class": `crossing ${c.first ? "first" : ""}`,
              "data-key": "crossing" + i,
              "aria-pressed": String(i === state.crossing),
              "data-marks": "el:" + c.elemento,
              "onclick": () => change({ crossing: i }),
            },
            el("span", { class: "dot" }),
            el("span", { class: "name" }, c.elemento),
            el("span", { class: "quiet" }, c.tipo),
            c.kind === "segment" ? el("span", { class: "quiet" }, say("segment")) : null,
            el("span", { class: "t" }, c.t ? `t = ${short(c.t.binary64, 4)}` : "t → 0⁺"),
          ),
        ),
      ),
    ),
  );
}

function light_block() {
  const answer = facts.light;
  if (!answer?.lights?.length) return null;
  return el(
    "div",
    { "class": "block", "data-marks": "lights" },
    el("h3", {}, say("lights")),
    el(
      "ul",
      { class: "lights" },
      answer.lights.map(light =>
        el(
          "li",
          {},
          el("strong", {}, `${say("light")} ${light.light ?? light.directional_light}`),
          " ",
          light.visible
            ? el("span", { class: "lit" }, say("visible"))
            : el("span", { class: "dark" }, say("in_shadow_of"), " ", set_of(light.blocked_by)),
        ),
      ),
    ),
  );
}

export function crossing_now() {
  const crossings = facts.ray?.crossings ?? [];
  return crossings[state.crossing] ?? crossings.find(c => c.first) ?? crossings[0] ?? null;
}

function render() {
  const answer = facts.ray,
    crossing = crossing_now();
  const body = !answer
    ? [el("p", { class: "quiet" }, say("waiting"))]
    : answer.error
      ? [el("p", { class: "fault" }, answer.error)]
      : [
          hit_block(answer),
          crossing_list(answer),
          crossing ? exact_block(crossing, render) : null,
          decided_block(answer),
          light_block(),
        ];
  fill(
    find("inspector"),
    el("div", { class: "panel-head" }, el("h2", { id: "inspector-head" }, say("inspector"))),
    el("div", { class: "scroll", id: "inspector-scroll" }, ray_form(), body),
  );
}

export function start_inspector(frame) {
  frame_of_stage = frame;
  on_facts(what => {
    if (what === "ray" || what === "light" || what === "scene") render();
  });
  on_change(keys => {
    if (keys.has("crossing") || keys.has("lang")) render();
  });
}
