import { el, svg } from "./dom.js";
import { chip } from "./names.js";
import { short } from "./numbers.js";
import { say } from "./words.js";

// decided_block shows which step decided for each of the first elements; bound and margin stand on one logarithmic scale.
export function decided_block({ decided }) {
  if (!decided) return null;
  const steps = ["triage", "stable", "exact"],
    counts = steps.filter(step => decided.steps?.[step]).map(step => `${say("step_" + step)} ${decided.steps[step]}`);
  return el(
    "div",
    { class: "block decided" },
    el("h3", {}, say("who_decided")),
    (decided.first ?? []).map(one => {
      const at = steps.indexOf(one.step);
      return el(
        "div",
        {},
        el("p", {}, chip(one.elemento)),
        el(
          "ol",
          { class: "ladder" },
          steps.map((step, i) =>
            el(
              "li",
              { "class": i === at ? "here" : i < at ? "passed" : "", "aria-current": i === at ? "step" : null },
              el("strong", {}, say("step_" + step)),
              el("span", { class: "quiet" }, say(i === at ? "said_so" : i < at ? "undecided" : "not_asked")),
            ),
          ),
        ),
        scale({ ...one, margin: decided.margin }),
      );
    }),
    counts.length ? el("p", { class: "quiet" }, `${say("elements_decided")} ${counts.join(", ")}.`) : null,
    decided.order
      ? el(
          "p",
          { class: "quiet" },
          `${say("order_by")} ${say("step_" + decided.order)}; ${say("rounding_by")} ${say("step_" + decided.rounding)}.`,
        )
      : null,
  );
}

function scale({ bound, margin, low, high }) {
  if (typeof bound !== "number") return el("p", { class: "quiet" }, say("no_bound"));
  const least = -20,
    most = 4,
    log = x => (x > 0 ? Math.min(most, Math.max(least, Math.log10(x))) : least);
  const x = k => 10 + (340 * (k - least)) / (most - least),
    bar = (value, y, kind) =>
      svg("rect", { x: x(least), y, width: Math.max(2, x(log(value)) - x(least)), height: 12, class: kind });
  const lines = [-18, -15, -12, -9, -6, -3, 0, 3].map(k => [
    svg("line", { x1: x(k), x2: x(k), y1: 4, y2: 64, class: "grid" }),
    svg("text", { "x": x(k), "y": 76, "text-anchor": "middle" }, `10${super_script(k)}`),
  ]);
  const has_margin = typeof margin === "number";
  return el(
    "div",
    {},
    svg(
      "svg",
      {
        "viewBox": "0 0 360 82",
        "class": "scale",
        "role": "img",
        "aria-label": `${say("bound")} ${bound}, ${say("margin")} ${margin ?? "—"}`,
      },
      lines,
      bar(bound, 12, "bound"),
      has_margin ? bar(margin, 40, "margin") : null,
      svg("text", { x: x(log(bound)) + 5, y: 22 }, say("bound")),
      has_margin ? svg("text", { x: Math.min(x(log(margin)) + 5, 300), y: 50 }, say("margin")) : null,
    ),
    el(
      "dl",
      { class: "facts" },
      el("dt", {}, say("bound")),
      el("dd", {}, el("code", {}, short(bound))),
      has_margin ? [el("dt", {}, say("margin")), el("dd", {}, el("code", {}, short(margin)))] : null,
      low !== undefined ? [el("dt", {}, say("between")), el("dd", {}, el("code", {}, `[${low}, ${high}]`))] : null,
    ),
  );
}
const super_script = k =>
  String(k)
    .replace("-", "⁻")
    .replace(/\d/g, d => "⁰¹²³⁴⁵⁶⁷⁸⁹"[d]);
