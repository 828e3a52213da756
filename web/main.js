import { answered, start_engine } from "./ask.js";
import { el, fill, find } from "./dom.js";
import { facts, on_facts, start_facts } from "./facts.js";
import { start_exercises } from "./exercises.js";
import { start_inspector } from "./inspector.js";
import { show_refusal, start_operations } from "./operations.js";
import { start_own } from "./own.js";
import { start_printed } from "./printed.js";
import { start_shader } from "./shader_view.js";
import { redraw_picture, show_refused, stage_now, start_picture } from "./picture.js";
import { change, on_change, read_address, state } from "./state.js";
import { start_surface } from "./surface.js";
import { label_entry, show_label, show_name, start_text } from "./text_panel.js";
import { start_walk } from "./walk.js";
import { language, say, set_language } from "./words.js";

// The page as a whole: its head, its views, and how they start.
const views = ["scene", "printed", "walk", "own", "exercises", "surface", "shader"];

function head() {
  fill(
    find("head"),
    el("h1", {}, "Durero"),
    el("p", { class: "tagline" }, say("tagline")),
    el(
      "nav",
      { "aria-label": say("views") },
      el(
        "ul",
        {},
        views.map(view =>
          el(
            "li",
            {},
            el(
              "a",
              {
                "href": "#",
                "data-key": "view" + view,
                "aria-current": view === state.view ? "page" : null,
                "onclick": e => {
                  e.preventDefault();
                  change({ view });
                },
              },
              say("view_" + view),
            ),
          ),
        ),
      ),
    ),
    el(
      "div",
      { class: "tools" },
      el(
        "form",
        {
          role: "search",
          onsubmit: e => {
            e.preventDefault();
            seek(find("seek").value.trim());
          },
        },
        el("input", {
          "id": "seek",
          "type": "search",
          "size": 14,
          "data-key": "seek",
          "placeholder": say("name_or_label"),
          "aria-label": say("name_or_label"),
        }),
      ),
      el(
        "button",
        {
          "data-key": "lang",
          "onclick": () => change({ lang: language() === "es" ? "en" : "es" }),
          "lang": language() === "es" ? "en" : "es",
        },
        language() === "es" ? "English" : "Español",
      ),
      el(
        "button",
        { "data-key": "theme", "onclick": next_theme, "title": say("theme") },
        say("theme_" + (state.theme || "auto")),
      ),
    ),
  );
  find("skip").textContent = say("skip");
}
function next_theme() {
  const order = ["", "dark", "light"];
  change({ theme: order[(order.indexOf(state.theme) + 1) % 3] });
}
function seek(text) {
  if (!text) return;
  change({ view: "scene" });
  if (label_entry(text)) show_label(text);
  else show_name(text);
  find("said").textContent = label_entry(text) || state.para === text ? text : say("not_found");
}

function show_view() {
  for (const view of views) find(view).hidden = view !== state.view;
  document.title = state.view === "scene" ? "Durero" : `${say("view_" + state.view)} · Durero`;
  redraw_picture();
}

function looks() {
  document.documentElement.dataset.theme = state.theme;
  document.documentElement.lang = language();
}

function listen() {
  on_facts(what => {
    if (what === "error") find("said").textContent = facts.error;
  });
  on_change(keys => {
    if (keys.has("lang")) set_language(state.lang);
    if (keys.has("lang") || keys.has("theme")) looks();
    if (keys.has("lang") || keys.has("view") || keys.has("theme")) head();
    if (keys.has("view") || keys.has("lang")) show_view();
  });
  addEventListener("hashchange", () => {
    const trouble = read_address();
    if (trouble.length) find("said").textContent = `${say("address_trouble")} ${trouble.join(", ")}`;
  });
}

async function start() {
  const began = performance.now(),
    trouble = read_address();
  set_language(state.lang);
  looks();
  head();
  listen();
  start_picture();
  show_view();
  find("said").textContent = say("starting");
  try {
    await start_engine();
  } catch (error) {
    find("said").textContent = `${say("no_engine")} ${error.message}`;
    document.body.classList.add("no-engine");
    return;
  }
  try {
    await fill_views(trouble, began);
  } catch (error) {
    find("said").textContent = `${say("no_engine")} ${error.message}`;
  }
}

// fill_views starts what the engine answers for.
async function fill_views(trouble, began) {
  start_inspector(() => stage_now().frame());
  const [version, list] = await Promise.all([
    answered({ call: "version" }),
    answered({ call: "operations" }),
    start_facts(),
  ]);
  start_operations(list.operations, show_refused);
  await start_text(list.operations);
  if (!state.label) show_refusal();
  start_walk();
  start_own();
  start_exercises();
  start_surface();
  start_shader();
  await start_printed();
  if (trouble.length) find("said").textContent = `${say("address_trouble")} ${trouble.join(", ")}`;
  else if (find("said").textContent === say("starting")) find("said").textContent = "";
  find("built").textContent =
    `Durero ${version.durero} · ${say("first_answer_in")} ${Math.round(facts.first - began)} ms`;
  document.body.dataset.ready = "1";
}
globalThis.dureroPage = {
  get state() {
    return state;
  },
  get facts() {
    return facts;
  },
  get stage() {
    return stage_now();
  },
  change,
};
start();
