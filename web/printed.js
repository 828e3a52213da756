import { ask, once } from "./ask.js";
import { el, fill, find } from "./dom.js";
import { nodes_of } from "./marked.js";
import { paint } from "./surface.js";
import { change, on_change, state } from "./state.js";
import { label_entry, show_label, z_block } from "./text_panel.js";
import { say } from "./words.js";
import { in_unicode } from "./ztext.js";

// The printed text against the corrected, entry by entry; where an entry changes what is drawn, both are drawn.
let errata = [],
  printed = [];
const size = [160, 100];

function entry_list() {
  const groups = new Map();
  for (const e of errata) groups.set(e.source, [...(groups.get(e.source) ?? []), e]);
  return el(
    "nav",
    { "class": "side", "aria-label": say("errata") },
    [...groups].map(([source, list]) => [
      el("h3", {}, source),
      el(
        "ul",
        {},
        list.map(e =>
          el(
            "li",
            {},
            el(
              "button",
              {
                "data-key": "e" + e.name,
                "aria-current": e.name === state.erratum ? "true" : null,
                "onclick": () => change({ erratum: e.name }),
              },
              el("b", {}, e.name),
              " ",
              e.title,
              e.drawn ? el("span", { class: "quiet" }, " ◧") : null,
            ),
          ),
        ),
      ),
    ]),
  );
}

function line_node({ file, line, text }, marks) {
  return el(
    "div",
    { class: "printed-line" },
    el("span", { class: "quiet place" }, `${file.replace("spec/impresa/", "")}:${line}`),
    el("code", { class: marks ? "wrong" : "" }, in_unicode(text.replace(/\s*%.*$/, ""))),
  );
}

// around gives the printed lines that an entry marks, and those beside them.
function around(entry) {
  return printed.flatMap(({ file, lines }) => {
    const marked = lines.filter(l => l.marks.includes(entry.name)).map(l => l.line);
    return lines
      .filter(l => marked.some(m => Math.abs(m - l.line) <= 5) && l.text.trim())
      .map(l => ({ file, ...l, marked: marked.includes(l.line) }));
  });
}

function pictures(entry) {
  if (!entry.drawn) return null;
  const figure = (kind, text) => {
    const canvas = el("canvas", {
        "width": size[0],
        "height": size[1],
        "role": "img",
        "aria-label": say("drawn_" + kind),
      }),
      said = el("figcaption", {}, say("drawn_" + kind), " ", el("span", { class: "quiet" }, say("drawing")));
    draw(canvas, text, entry.drawn, said, say("drawn_" + kind));
    return el("figure", { class: kind }, canvas, said);
  };
  return el(
    "div",
    { class: "pair" },
    figure("printed", documents["superficies.tex"]),
    figure("corrected", documents["puntos.tex"]),
  );
}

async function draw(canvas, text, scene, said, title) {
  const read = JSON.parse(scene),
    answer = await ask({ call: "surface", with: text, scene: read, width: size[0], height: size[1] });
  said.replaceChildren(title, answer.error ? ` ${answer.error}` : "");
  if (!answer.error) paint(canvas, answer, read);
}

function show() {
  const entry = errata.find(e => e.name === state.erratum) ?? errata[0];
  if (!entry) return;
  const corrected = (entry.labels ?? []).map(label => ({ label, entry: label_entry(label) })).filter(l => l.entry);
  fill(
    find("printed"),
    el("h2", {}, say("printed_title")),
    el("p", { class: "lead" }, say("printed_lead")),
    el(
      "div",
      { class: "with-side" },
      entry_list(),
      el(
        "article",
        { lang: "en" },
        el("h3", {}, `${entry.name} · ${entry.title}`),
        pictures(entry),
        el(
          "div",
          { class: "pair" },
          el(
            "section",
            { class: "printed" },
            el("h4", {}, say("as_printed")),
            around(entry).map(l => line_node(l, l.marked)),
            el("p", {}, nodes_of(entry.printed)),
          ),
          el(
            "section",
            { class: "corrected" },
            el("h4", {}, say("as_corrected")),
            corrected.map(({ label, entry: e }) =>
              el(
                "div",
                { class: "pred" },
                el("div", {}, z_block(e.predicate, 50)),
                el(
                  "button",
                  {
                    class: "label",
                    onclick: () => {
                      change({ view: "scene" });
                      show_label(label);
                    },
                  },
                  el("code", {}, label),
                ),
              ),
            ),
            el("p", {}, nodes_of(entry.correction)),
          ),
        ),
        el("h4", {}, say("defect")),
        el("p", {}, nodes_of(entry.defect)),
        el("h4", {}, say("proof")),
        el("p", {}, nodes_of(entry.proof)),
      ),
    ),
  );
}

export async function start_printed() {
  const render = async () => {
    if (state.view !== "printed") return;
    if (!errata.length) {
      const answer = await once({ call: "errata" });
      if (answer.error) return fill(find("printed"), el("p", { class: "fault" }, answer.error));
      ({ errata, printed } = answer);
    }
    show();
  };
  on_change(keys => {
    if (keys.has("view") || keys.has("erratum") || keys.has("lang")) render();
  });
  await render();
}
