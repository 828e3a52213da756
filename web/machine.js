import { el, svg } from "./dom.js";
import { z_nodes } from "./text_panel.js";
import { say } from "./words.js";

// Machines: a text's states as a table and as a graph.

// layers_of puts each state into the layer of its least number of steps from a first state.
export function layers_of(states, steps) {
  const depth = states.map(s => (s.initial ? 0 : Infinity)),
    next = states.map(() => []);
  for (const { from, to } of steps) next[from].push(to);
  let front = states.map((_, i) => i).filter(i => depth[i] === 0);
  while (front.length) {
    const after = [];
    for (const i of front)
      for (const j of next[i])
        if (depth[j] === Infinity) {
          depth[j] = depth[i] + 1;
          after.push(j);
        }
    front = after;
  }
  const most = Math.max(0, ...depth.filter(Number.isFinite)),
    layers = Array.from({ length: most + 1 }, () => []);
  depth.forEach((d, i) => layers[Number.isFinite(d) ? d : most].push(i));
  return layers;
}

// places_of orders each layer by the middle of what leads to it, so that fewer steps cross.
export function places_of(states, steps) {
  const layers = layers_of(states, steps),
    place = new Map();
  layers.forEach((layer, d) => {
    const middle = new Map(
      layer.map(i => {
        const before = steps.filter(s => s.to === i && place.has(s.from)).map(s => place.get(s.from)[1]);
        return [i, before.length ? before.reduce((a, b) => a + b) / before.length : 0];
      }),
    );
    layer.sort((a, b) => middle.get(a) - middle.get(b) || a - b);
    layer.forEach((i, k) => place.set(i, [d, k - (layer.length - 1) / 2]));
  });
  return { layers, place };
}

const told = values =>
  Object.entries(values)
    .map(([name, value]) => `${name} == ${value}`)
    .join("\n");

// graph draws the states; steps between the same two are one arrow with all their names.
export function graph(answer, now, choose) {
  const { states, steps } = answer,
    { layers, place } = places_of(states, steps),
    tall = Math.max(...layers.map(l => l.length));
  const dx = 150,
    dy = 52,
    width = dx * layers.length + 40,
    height = dy * tall + 50;
  const x = i => 50 + dx * place.get(i)[0],
    y = i => height / 2 + dy * place.get(i)[1];
  const arrows = new Map();
  for (const s of steps) {
    const key = `${s.from} ${s.to}`;
    if (!arrows.has(key)) arrows.set(key, { from: s.from, to: s.to, lines: [] });
    arrows.get(key).lines.push(s.line);
  }
  const names = lines => [...new Set(lines.map(l => l.split(" ")[0]))];
  const paths = [...arrows.values()]
    .filter(a => a.from !== a.to)
    .map(a =>
      arrow(
        x(a.from),
        y(a.from),
        x(a.to),
        y(a.to),
        arrows.size > 40 ? [] : names(a.lines),
        a.lines,
        arrows.has(`${a.to} ${a.from}`),
      ),
    );
  const same = JSON.stringify(now);
  const nodes = states.map((s, i) =>
    svg(
      "g",
      {
        "class": `node ${s.initial ? "initial" : ""} ${JSON.stringify(s.values) === same ? "now" : ""}`,
        "transform": `translate(${x(i)} ${y(i)})`,
        "tabindex": "0",
        "role": "button",
        "aria-label": `${say("state")} ${i}: ${told(s.values)}`,
      },
      svg("title", {}, told(s.values)),
      svg("circle", { r: 17 }),
      svg("text", { "text-anchor": "middle", "y": 5 }, String(i)),
    ),
  );
  nodes.forEach((node, i) => {
    node.addEventListener("click", () => choose(i));
    node.addEventListener("keydown", e => {
      if (e.key === "Enter" || e.key === " ") {
        e.preventDefault();
        choose(i);
      }
    });
  });
  return svg(
    "svg",
    {
      "class": "graph",
      "viewBox": `0 0 ${width} ${height}`,
      width,
      height,
      "role": "group",
      "aria-label": `${say("graph")}: ${states.length} ${say("states")}, ${steps.length} ${say("steps")}`,
    },
    svg(
      "defs",
      {},
      svg(
        "marker",
        {
          id: "tip",
          viewBox: "0 0 8 8",
          refX: 7,
          refY: 4,
          markerWidth: 7,
          markerHeight: 7,
          orient: "auto-start-reverse",
        },
        svg("path", { d: "M 0 0 L 8 4 L 0 8 z" }),
      ),
    ),
    paths,
    nodes,
  );
}

function arrow(x1, y1, x2, y2, names, lines, both) {
  const d = Math.hypot(x2 - x1, y2 - y1) || 1,
    ux = (x2 - x1) / d,
    uy = (y2 - y1) / d,
    bend = both || x2 <= x1 ? 22 : 6;
  const from = [x1 + 18 * ux, y1 + 18 * uy],
    to = [x2 - 20 * ux, y2 - 20 * uy],
    middle = [(x1 + x2) / 2 - uy * bend, (y1 + y2) / 2 + ux * bend];
  const said = names.length > 2 ? `${names[0]} +${names.length - 1}` : names.join(", ");
  return svg(
    "g",
    { class: "arrow" },
    svg("title", {}, lines.join("\n")),
    svg("path", { "d": `M ${from} Q ${middle} ${to}`, "marker-end": "url(#tip)" }),
    names.length === 0
      ? null
      : svg(
          "text",
          { "x": (x1 + x2) / 2 - uy * bend * 0.9, "y": (y1 + y2) / 2 + ux * bend * 0.9 - 4, "text-anchor": "middle" },
          said,
        ),
  );
}

// state_table has a row for each state of the way, and a column for each component; what a step changed is marked.
export function state_table(answer) {
  const names = answer.components.map(c => c.name);
  return el(
    "div",
    { class: "wide" },
    el(
      "table",
      { class: "states" },
      el("caption", { class: "unseen" }, say("states_of_the_way")),
      el(
        "thead",
        {},
        el(
          "tr",
          {},
          el("th", { scope: "col" }, "#"),
          el("th", { scope: "col" }, say("step")),
          answer.components.map(c =>
            el("th", { scope: "col" }, c.name, el("span", { class: "quiet" }, ` : ${c.type}`)),
          ),
        ),
      ),
      el(
        "tbody",
        {},
        answer.states.map((s, i) =>
          el(
            "tr",
            { class: i === answer.states.length - 1 ? "now" : "" },
            el("th", { scope: "row" }, String(i)),
            el("td", {}, el("code", {}, s.operation), said(s.inputs), said(s.outputs)),
            names.map(name =>
              el(
                "td",
                { class: s.changed?.includes(name) ? "changed" : "" },
                el("code", {}, z_nodes(s.values[name] ?? "")),
              ),
            ),
          ),
        ),
      ),
    ),
  );
}
const said = values =>
  Object.entries(values ?? {}).map(([name, value]) => el("span", { class: "quiet" }, ` ${name} = ${value}`));
