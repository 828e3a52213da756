import { el, svg } from "./dom.js";
import { next_down, next_up, place_between, quadratic_text, short, written } from "./numbers.js";
import { say } from "./words.js";

// An exact number as the inspector shows it.
let part = "t",
  long_form = false;

// digits_node groups forty digits, and marks those that the binary64 has too.
function digits_node(exact) {
  const shown = exact.digits.replace("-", "−"),
    near = String(exact.binary64).replace("-", "−");
  let same = 0;
  while (same < near.length && near[same] === shown[same]) ++same;
  return el("code", { class: "digits" }, el("b", {}, shown.slice(0, same)), shown.slice(same));
}

function neighbours(exact) {
  const { below, binary64, above } = exact;
  if (typeof binary64 !== "number") return null;
  const low = typeof below === "number" ? below : next_down(binary64),
    high = typeof above === "number" ? above : next_up(binary64);
  const at = place_between(exact.digits.replace("…", ""), low, high) ?? 0.5,
    x = k => 20 + 320 * k;
  const middle = place_between(String(binary64), low, high) ?? 0.5;
  const tick = (k, text, kind) => [
    svg("line", { x1: x(k), x2: x(k), y1: 22, y2: 44, class: kind }),
    svg("text", { "x": x(k), "y": 60, "text-anchor": k < 0.2 ? "start" : k > 0.8 ? "end" : "middle" }, text),
  ];
  return svg(
    "svg",
    {
      "viewBox": "0 0 360 84",
      "class": "neighbours",
      "role": "img",
      "aria-label": `${say("neighbours")}: ${low}, ${binary64}, ${high}`,
    },
    svg("line", { x1: 8, x2: 352, y1: 33, y2: 33, class: "axis" }),
    svg("rect", {
      x: x(middle / 2),
      y: 27,
      width: (320 * (1 - middle)) / 2 + (320 * middle) / 2,
      height: 12,
      class: "rounds",
    }),
    tick(0, say("below"), "tick"),
    tick(middle, "binary64", "tick chosen"),
    tick(1, say("above"), "tick"),
    svg("path", { d: `M ${x(at)} 31 l -5 -12 h 10 z`, class: "exact" }),
    svg(
      "text",
      { "x": Math.min(310, Math.max(40, x(at))), "y": 14, "text-anchor": "middle", "class": "exact-word" },
      say("exact"),
    ),
    svg("text", { "x": x(middle), "y": 78, "text-anchor": "middle", "class": "quiet" }, say("rounds_here")),
  );
}

const cut = text => (text.length > 40 ? text.slice(0, 38) + "…" : text);
// exact_block shows one number of a crossing: exactly, to forty digits, rounded, and between its neighbours.
export function exact_block(crossing, render) {
  const numbers = {
    t: crossing.t,
    x: crossing.point?.[0],
    y: crossing.point?.[1],
    z: crossing.point?.[2],
    end: crossing.end,
  };
  const keys = Object.keys(numbers).filter(key => numbers[key]);
  if (!keys.length) return null;
  const key = keys.includes(part) ? part : keys[0],
    exact = numbers[key];
  const formula = quadratic_text(exact.x, exact.y, exact.delta),
    folded = formula.length > 150 && !long_form;
  return el(
    "div",
    { class: "block exact-block" },
    el(
      "div",
      { "class": "tabs", "role": "group", "aria-label": say("which_number") },
      keys.map(k =>
        el(
          "button",
          {
            "data-key": "part" + k,
            "aria-pressed": String(k === key),
            "onclick": () => {
              part = k;
              render();
            },
          },
          k === "t" || k === "end" ? k : `${say("point")}.${k}`,
        ),
      ),
    ),
    el(
      "dl",
      { class: "facts" },
      el("dt", {}, say("exactly")),
      el(
        "dd",
        {},
        el("code", { class: "formula" }, folded ? formula.slice(0, 140) + "…" : formula),
        formula.length > 150
          ? el(
              "button",
              {
                "class": "small",
                "data-key": "fold",
                "onclick": () => {
                  long_form = !long_form;
                  render();
                },
              },
              say(folded ? "all_digits" : "fewer"),
            )
          : null,
      ),
      el("dt", {}, say("forty_digits")),
      el("dd", {}, digits_node(exact)),
      el("dt", {}, "binary64"),
      el(
        "dd",
        {},
        el("code", {}, typeof exact.binary64 === "number" ? written(exact.binary64) : exact.binary64),
        el("br"),
        el("code", { class: "quiet" }, exact.hex),
      ),
      el("dt", {}, say("below")),
      el("dd", {}, el("code", { class: "quiet" }, String(exact.below))),
      el("dt", {}, say("above")),
      el("dd", {}, el("code", { class: "quiet" }, String(exact.above))),
    ),
    neighbours(exact),
    crossing.quadratic
      ? el(
          "p",
          { class: "quiet" },
          el("code", { class: "z" }, "A·t² + 2B·t + C = 0"),
          ": ",
          ["A", "B", "C"].map(k => el("code", {}, `${k} = ${cut(crossing.quadratic[k])}  `)),
          el("code", {}, `Δ = ${cut(crossing.quadratic.discriminant)}`),
        )
      : null,
    crossing.normal
      ? el(
          "p",
          { class: "quiet" },
          say("normal"),
          " ",
          el("code", {}, `(${crossing.normal.map(x => short(x, 6)).join(", ")})`),
        )
      : null,
  );
}
