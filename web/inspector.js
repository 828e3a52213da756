import { el, fill, find, svg } from "./dom.js";
import { facts, on_facts } from "./facts.js";
import { next_down, next_up, place_between, quadratic_text, short, written } from "./numbers.js";
import { change, on_change, state } from "./state.js";
import { through_pixel } from "./stage.js";
import { say } from "./words.js";

// The ray and what is known of it: its crossings, one number of them exactly, the step that decided, and the lights.
let part = "t", long_form = false, frame_of_stage = () => null;

const chip = id => el("span", { class: "chip", "data-marks": "el:" + id, tabindex: "0" }, id);
export const set_of = ids => ids?.length ? el("span", { class: "set" }, "{ ", ids.flatMap((id, i) => i ? [", ", chip(id)] : [chip(id)]), " }") : el("span", { class: "set" }, "∅");

function number_field(name, values, i, key) {
  return el("label", { class: "number-field" }, el("span", {}, `${name}.${"xyz"[i]}`),
    el("input", { type: "text", inputmode: "decimal", value: written(values[i]), "data-key": name + i, spellcheck: "false", "aria-label": `${name}.${"xyz"[i]}`,
      onchange: event => {
        const x = Number(event.target.value), next = state[key].map((y, k) => k === i ? x : y);
        const wrong = !Number.isFinite(x) || event.target.value.trim() === "" || (key === "v" && next.every(y => y === 0));
        event.target.setAttribute("aria-invalid", String(wrong));
        find("said").textContent = wrong ? say(key === "v" && x === 0 ? "null_direction" : "no_number") : "";
        if (!wrong) change({ [key]: next });
      } }));
}

function ray_form() {
  const frame = frame_of_stage(), pixel = k => Number(find("pixel-" + k)?.value);
  return el("details", { class: "block", open: true, "data-marks": "ray" }, el("summary", {}, say("ray"), " ", el("code", {}, "{ p + t·v | t > 0 }")),
    el("div", { class: "numbers" }, [0, 1, 2].map(i => number_field("p", state.p, i, "p")), [0, 1, 2].map(i => number_field("v", state.v, i, "v"))),
    frame ? el("div", { class: "row" }, el("span", {}, say("through_pixel")),
      ["column", "row"].map(k => el("input", { id: "pixel-" + k, "data-key": k, type: "number", min: "0", max: String((k === "column" ? frame.width : frame.height) - 1), value: shown_pixel[k] ?? (k === "column" ? frame.width >> 1 : frame.height >> 1), "aria-label": say(k),
        onchange: () => aim(frame, pixel("column"), pixel("row")) })),
      el("button", { class: "action", "data-key": "aim", onclick: () => aim(frame, pixel("column"), pixel("row")) }, say("aim"))) : null,
    el("p", { class: "quiet" }, say("handles_help")));
}
let shown_pixel = {};
function aim(frame, column, row) {
  if (!(column >= 0 && column < frame.width && row >= 0 && row < frame.height)) return;
  shown_pixel = { column, row };
  change({ p: [...frame.eye], v: through_pixel(frame, column, row), on: [] });
}

function hit_block(answer) {
  const { hit } = answer, said = { hit: say("outcome_hit"), miss: say("outcome_miss"), no_minimum: say("outcome_no_minimum") }[hit.outcome];
  return el("div", { class: `block hit ${hit.outcome}`, "data-marks": "first" },
    el("p", { class: "outcome" }, el("strong", {}, said), " ", hit.outcome === "hit" ? el("span", {}, "t = ", el("code", {}, typeof hit.t === "number" ? written(hit.t) : hit.t)) : null),
    hit.outcome === "miss" ? null : el("p", {}, el("code", {}, "elementos! = "), set_of(hit.elementos), hit.elementos.length > 1 && hit.outcome === "hit" ? el("span", { class: "quiet" }, " ", say("tie")) : null));
}

function crossing_list(answer) {
  if (!answer.crossings.length) return null;
  return el("div", { class: "block" }, el("h3", {}, say("all_crossings"), ` (${answer.crossings.length})`),
    el("ol", { class: "crossings" }, answer.crossings.map((c, i) => el("li", {}, el("button", {
      class: `crossing ${c.first ? "first" : ""}`, "data-key": "crossing" + i, "aria-pressed": String(i === state.crossing), "data-marks": "el:" + c.elemento, onclick: () => change({ crossing: i }) },
    el("span", { class: "dot" }), el("span", { class: "name" }, c.elemento), el("span", { class: "quiet" }, c.tipo), c.kind === "segment" ? el("span", { class: "quiet" }, say("segment")) : null,
    el("span", { class: "t" }, c.t ? `t = ${short(c.t.binary64, 4)}` : "t → 0⁺"))))));
}

// digits_node groups forty digits, and marks those that the binary64 has too.
function digits_node(exact) {
  const shown = exact.digits.replace("-", "−"), near = String(exact.binary64).replace("-", "−");
  let same = 0;
  while (same < near.length && near[same] === shown[same]) ++same;
  return el("code", { class: "digits" }, el("b", {}, shown.slice(0, same)), shown.slice(same));
}

function neighbours(exact) {
  const { below, binary64, above } = exact;
  if (typeof binary64 !== "number") return null;
  const low = typeof below === "number" ? below : next_down(binary64), high = typeof above === "number" ? above : next_up(binary64);
  const at = place_between(exact.digits.replace("…", ""), low, high) ?? 0.5, x = k => 20 + 320 * k;
  const middle = place_between(String(binary64), low, high) ?? 0.5;
  const tick = (k, text, kind) => [svg("line", { x1: x(k), x2: x(k), y1: 22, y2: 44, class: kind }), svg("text", { x: x(k), y: 60, "text-anchor": k < 0.2 ? "start" : k > 0.8 ? "end" : "middle" }, text)];
  return svg("svg", { viewBox: "0 0 360 84", class: "neighbours", role: "img", "aria-label": `${say("neighbours")}: ${low}, ${binary64}, ${high}` },
    svg("line", { x1: 8, x2: 352, y1: 33, y2: 33, class: "axis" }),
    svg("rect", { x: x(middle / 2), y: 27, width: 320 * (1 - middle) / 2 + 320 * middle / 2, height: 12, class: "rounds" }),
    tick(0, say("below"), "tick"), tick(middle, "binary64", "tick chosen"), tick(1, say("above"), "tick"),
    svg("path", { d: `M ${x(at)} 31 l -5 -12 h 10 z`, class: "exact" }), svg("text", { x: Math.min(310, Math.max(40, x(at))), y: 14, "text-anchor": "middle", class: "exact-word" }, say("exact")),
    svg("text", { x: x(middle), y: 78, "text-anchor": "middle", class: "quiet" }, say("rounds_here")));
}

const cut = text => text.length > 40 ? text.slice(0, 38) + "…" : text;
function exact_block(crossing) {
  const numbers = { t: crossing.t, x: crossing.point?.[0], y: crossing.point?.[1], z: crossing.point?.[2], end: crossing.end };
  const keys = Object.keys(numbers).filter(key => numbers[key]);
  if (!keys.length) return null;
  const key = keys.includes(part) ? part : keys[0], exact = numbers[key];
  const formula = quadratic_text(exact.x, exact.y, exact.delta), folded = formula.length > 150 && !long_form;
  return el("div", { class: "block exact-block" },
    el("div", { class: "tabs", role: "group", "aria-label": say("which_number") }, keys.map(k => el("button", { "data-key": "part" + k, "aria-pressed": String(k === key), onclick: () => { part = k; render(); } }, k === "t" || k === "end" ? k : `${say("point")}.${k}`))),
    el("dl", { class: "facts" },
      el("dt", {}, say("exactly")), el("dd", {}, el("code", { class: "formula" }, folded ? formula.slice(0, 140) + "…" : formula), formula.length > 150 ? el("button", { class: "small", "data-key": "fold", onclick: () => { long_form = !long_form; render(); } }, say(folded ? "all_digits" : "fewer")) : null),
      el("dt", {}, say("forty_digits")), el("dd", {}, digits_node(exact)),
      el("dt", {}, "binary64"), el("dd", {}, el("code", {}, typeof exact.binary64 === "number" ? written(exact.binary64) : exact.binary64), el("br"), el("code", { class: "quiet" }, exact.hex)),
      el("dt", {}, say("below")), el("dd", {}, el("code", { class: "quiet" }, String(exact.below))),
      el("dt", {}, say("above")), el("dd", {}, el("code", { class: "quiet" }, String(exact.above)))),
    neighbours(exact),
    crossing.quadratic ? el("p", { class: "quiet" }, el("code", { class: "z" }, "A·t² + 2B·t + C = 0"), ": ", ["A", "B", "C"].map(k => el("code", {}, `${k} = ${cut(crossing.quadratic[k])}  `)), el("code", {}, `Δ = ${cut(crossing.quadratic.discriminant)}`)) : null,
    crossing.normal ? el("p", { class: "quiet" }, say("normal"), " ", el("code", {}, `(${crossing.normal.map(x => short(x, 6)).join(", ")})`)) : null);
}

// decided_block shows which step decided for each of the first elements; bound and margin stand on one logarithmic scale.
function decided_block({ decided }) {
  if (!decided) return null;
  const steps = ["triage", "stable", "exact"], counts = steps.filter(step => decided.steps?.[step]).map(step => `${say("step_" + step)} ${decided.steps[step]}`);
  return el("div", { class: "block decided" }, el("h3", {}, say("who_decided")), (decided.first ?? []).map(one => {
    const at = steps.indexOf(one.step);
    return el("div", {}, el("p", {}, chip(one.elemento)),
      el("ol", { class: "ladder" }, steps.map((step, i) => el("li", { class: i === at ? "here" : i < at ? "passed" : "", "aria-current": i === at ? "step" : null }, el("strong", {}, say("step_" + step)), el("span", { class: "quiet" }, say(i === at ? "said_so" : i < at ? "undecided" : "not_asked"))))),
      scale({ ...one, margin: decided.margin }));
  }), counts.length ? el("p", { class: "quiet" }, `${say("elements_decided")} ${counts.join(", ")}.`) : null,
  decided.order ? el("p", { class: "quiet" }, `${say("order_by")} ${say("step_" + decided.order)}; ${say("rounding_by")} ${say("step_" + decided.rounding)}.`) : null);
}

function scale({ bound, margin, low, high }) {
  if (typeof bound !== "number") return el("p", { class: "quiet" }, say("no_bound"));
  const least = -20, most = 4, log = x => x > 0 ? Math.min(most, Math.max(least, Math.log10(x))) : least;
  const x = k => 10 + 340 * (k - least) / (most - least), bar = (value, y, kind) => svg("rect", { x: x(least), y, width: Math.max(2, x(log(value)) - x(least)), height: 12, class: kind });
  const lines = [-18, -15, -12, -9, -6, -3, 0, 3].map(k => [svg("line", { x1: x(k), x2: x(k), y1: 4, y2: 64, class: "grid" }), svg("text", { x: x(k), y: 76, "text-anchor": "middle" }, `10${super_script(k)}`)]);
  const has_margin = typeof margin === "number";
  return el("div", {}, svg("svg", { viewBox: "0 0 360 82", class: "scale", role: "img", "aria-label": `${say("bound")} ${bound}, ${say("margin")} ${margin ?? "—"}` },
    lines, bar(bound, 12, "bound"), has_margin ? bar(margin, 40, "margin") : null,
    svg("text", { x: x(log(bound)) + 5, y: 22 }, say("bound")), has_margin ? svg("text", { x: Math.min(x(log(margin)) + 5, 300), y: 50 }, say("margin")) : null),
  el("dl", { class: "facts" }, el("dt", {}, say("bound")), el("dd", {}, el("code", {}, short(bound))), has_margin ? [el("dt", {}, say("margin")), el("dd", {}, el("code", {}, short(margin)))] : null,
    low !== undefined ? [el("dt", {}, say("between")), el("dd", {}, el("code", {}, `[${low}, ${high}]`))] : null));
}
const super_script = k => String(k).replace("-", "⁻").replace(/\d/g, d => "⁰¹²³⁴⁵⁶⁷⁸⁹"[d]);

function light_block() {
  const answer = facts.light;
  if (!answer?.lights?.length) return null;
  return el("div", { class: "block", "data-marks": "lights" }, el("h3", {}, say("lights")), el("ul", { class: "lights" }, answer.lights.map(light => el("li", {},
    el("strong", {}, `${say("light")} ${light.light}`), " ", light.visible ? el("span", { class: "lit" }, say("visible")) : el("span", { class: "dark" }, say("in_shadow_of"), " ", set_of(light.blocked_by))))));
}

export function crossing_now() {
  const crossings = facts.ray?.crossings ?? [];
  return crossings[state.crossing] ?? crossings.find(c => c.first) ?? crossings[0] ?? null;
}

function render() {
  const answer = facts.ray, crossing = crossing_now();
  const body = !answer ? [el("p", { class: "quiet" }, say("waiting"))] : answer.error ? [el("p", { class: "fault" }, answer.error)]
    : [hit_block(answer), crossing_list(answer), crossing ? exact_block(crossing) : null, decided_block(answer), light_block()];
  fill(find("inspector"), el("div", { class: "panel-head" }, el("h2", { id: "inspector-head" }, say("inspector"))),
    el("div", { class: "scroll", id: "inspector-scroll" }, ray_form(), body));
}

export function start_inspector(frame) {
  frame_of_stage = frame;
  on_facts(what => { if (what === "ray" || what === "light" || what === "scene") render(); });
  on_change(keys => { if (keys.has("crossing") || keys.has("lang")) render(); });
}
