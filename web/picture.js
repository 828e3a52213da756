import { ask, latest } from "./ask.js";
import { el, fill, find } from "./dom.js";
import { facts, on_facts, scene_names } from "./facts.js";
import { crossing_now } from "./inspector.js";
import { make_stage } from "./stage.js";
import { change, on_change, state } from "./state.js";
import { show_name } from "./text_panel.js";
import { add, times, unit } from "./vectors.js";
import { say } from "./words.js";

// The picture's panel: which scene it shows, what was answered about it, and what the pointer is over.
let stage = null,
  see_through = false;

function stage_panel() {
  const canvas = el("canvas", { id: "picture", tabindex: "0", role: "img" }),
    signs = el("div", { "class": "signs", "aria-hidden": "true" });
  const origin = el("button", { class: "handle origin", id: "handle-origin" }),
    target = el("button", { class: "handle target", id: "handle-target" });
  find("stage").append(
    el("div", { class: "panel-head", id: "stage-bar" }),
    el("div", { class: "canvas-holder" }, canvas, signs, origin, target),
    el("p", { "id": "picture-said", "class": "unseen", "aria-live": "polite" }),
  );
  return { canvas, labels: { signs, origin, target } };
}
function stage_bar() {
  const options = [...Object.keys(scene_names), ...(state.scene === "own" ? ["own"] : [])].map(name =>
    el("option", { value: name, selected: name === state.scene }, say("scene_" + name)),
  );
  fill(
    find("stage-bar"),
    el("h2", { id: "stage-head" }, say("picture")),
    el(
      "select",
      { "aria-label": say("scene"), "data-key": "scene", "onchange": e => choose_scene(e.target.value) },
      options,
    ),
    el("button", { "class": "small", "data-key": "scenetext", "onclick": scene_dialog }, say("scene_text")),
    el(
      "button",
      {
        "class": "small",
        "data-key": "through",
        "aria-pressed": String(see_through),
        "onclick": () => {
          see_through = !see_through;
          stage?.set_see_through(see_through);
          stage_bar();
        },
      },
      say("see_through"),
    ),
    el("button", { "class": "small", "data-key": "fromeye", "onclick": from_eye }, say("from_the_eye")),
  );
  find("picture").setAttribute("aria-label", say("picture_help"));
  find("handle-origin").setAttribute("aria-label", say("handle_origin"));
  find("handle-target").setAttribute("aria-label", say("handle_target"));
}
function choose_scene(scene) {
  const text = scene === "own" ? state.own : documents[scene_names[scene]],
    camera = JSON.parse(text).camera;
  change({
    scene,
    ops: [],
    step: 0,
    crossing: 0,
    on: [],
    orbit: null,
    ...(camera ? { p: camera.eye, v: camera.look_at.map((x, i) => x - camera.eye[i]) } : {}),
  });
}
// scene_dialog shows the scene as text, to read, to change, to open from the disk and to keep.
function scene_dialog() {
  const area = el("textarea", {
      "class": "z-input",
      "rows": "18",
      "spellcheck": "false",
      "aria-label": say("scene_text"),
      "value": facts.scene_text,
    }),
    told = el("p", { class: "fault", role: "alert" });
  const keep = URL.createObjectURL(new Blob([facts.scene_text], { type: "application/json" }));
  const input = el("input", {
    "type": "file",
    "accept": ".json,application/json",
    "aria-label": say("open_scene"),
    "onchange": async () => {
      area.value = await input.files[0].text();
    },
  });
  const dialog = el(
    "dialog",
    {
      "id": "scene-dialog",
      "aria-labelledby": "scene-dialog-head",
      "onclose": () => {
        URL.revokeObjectURL(keep);
        dialog.remove();
      },
    },
    el("h2", { id: "scene-dialog-head" }, say("scene_text")),
    area,
    told,
    el(
      "div",
      { class: "row" },
      el(
        "button",
        {
          class: "action strong",
          id: "use-scene",
          onclick: async () => {
            const answer = await ask({ call: "edit", scene: area.value, operations: [] });
            if (answer.error) {
              told.textContent = answer.error;
              return;
            }
            dialog.close();
            change({ own: answer.scenes[0], scene: "own", ops: [], step: 0, crossing: 0, on: [], orbit: null });
          },
        },
        say("use_scene"),
      ),
      input,
      el("a", { href: keep, download: "scene.json" }, say("keep_scene")),
      el("button", { onclick: () => dialog.close() }, say("close")),
    ),
  );
  document.body.append(dialog);
  dialog.showModal();
}
function from_eye() {
  const frame = stage?.frame();
  if (frame)
    change({
      p: [...frame.eye],
      v: state.p.every((x, i) => x === frame.eye[i]) ? state.v : state.p.map((x, i) => x + state.v[i] - frame.eye[i]),
      on: [],
    });
}

const number = x => (typeof x === "number" ? x : x === "-inf" ? -Infinity : Infinity);
const place_of = c => (c.point ? c.point.map(e => number(e.binary64)) : null);

// show_answers hands to the stage what the engine said of the ray.
function show_answers() {
  const answer = facts.ray;
  if (!answer || answer.error) return stage.set_model({ crossings: [], lights: [], hit: [] });
  const along = t => state.p.map((x, i) => x + t * state.v[i]);
  const crossings = answer.crossings.map(c => ({
    elemento: c.elemento,
    t: c.t ? number(c.t.binary64) : 0,
    first: c.first,
    normal: c.normal,
    at: place_of(c) ?? (c.kind === "segment" ? state.p : null),
    end: c.kind === "segment" ? along(c.end ? number(c.end.binary64) : 50) : null,
  }));
  stage.set_model({ crossings, hit: answer.hit.elementos ?? [], picked: answer.crossings.indexOf(crossing_now()) });
  find("picture-said").textContent = told(answer);
}
function told(answer) {
  const { hit, crossings } = answer;
  return (
    `${say("outcome_" + hit.outcome)}${hit.outcome === "hit" ? ` t = ${hit.t}: ${hit.elementos.join(", ")}` : ""}. ${crossings.length} ${say("crossings")}: ` +
    crossings.map(c => c.elemento).join(", ")
  );
}
// show_lights hands over each light with its shadow ray. A directional light is as far as the picture needs.
function show_lights() {
  const positions = (facts.scene?.lights ?? []).map(l => ({ place: l.position, visible: true, from: null }));
  for (const one of facts.light?.lights ?? []) {
    const directional = one.directional_light !== undefined;
    const blocked = one.crossings?.find(c => c.point && (directional || number(c.t?.binary64) < 1));
    if (directional) positions.push({ place: add(one.p, times(unit(one.v), 8)) });
    const shown = directional ? positions.at(-1) : positions[one.light];
    if (shown) Object.assign(shown, { visible: one.visible, from: one.p, blocked: blocked ? place_of(blocked) : null });
  }
  stage.set_model({ lights: positions });
}

// hovered: what the pointer is over in the picture is told exactly, by the engine; in the text it marks the picture.
const hover = latest(answer => {
  if (!answer.hits) return;
  const id = answer.hits[0]?.elementos?.[0] ?? null;
  stage.set_model({ hovered: id ? new Set([id]) : null });
  find("picture").title = id ?? "";
});
function point_at(ray) {
  if (!ray) return stage.set_model({ hovered: null });
  if (facts.scene_text) hover.send({ call: "trace", scene: facts.scene_text, rays: [[...ray.p, ...ray.v]] });
}
async function choose_at(ray) {
  const answer = await ask({ call: "trace", scene: facts.scene_text, rays: [[...ray.p, ...ray.v]] }),
    id = answer.hits?.[0]?.elementos?.[0];
  if (!id) return;
  stage.set_model({ hovered: new Set([id]) });
  const at = facts.ray?.crossings?.findIndex(c => c.elemento === id) ?? -1,
    element = facts.scene.elementos.find(e => e.id === id);
  if (at >= 0) change({ crossing: at });
  if (element) show_name({ disco: "puntos_disco" }[element.tipo] ?? "puntos_" + element.tipo);
  find("said").textContent = element ? `${id} : ${element.tipo}` : id;
}
function marked(event) {
  const marks = event.target.closest?.("[data-marks]")?.dataset.marks?.split(" ") ?? [];
  if (event.target.closest?.("#stage")) return;
  const ids = new Set(),
    elements = facts.scene?.elementos ?? [];
  for (const mark of marks) {
    if (mark.startsWith("el:")) ids.add(mark.slice(3));
    if (mark.startsWith("tipo:")) elements.filter(e => e.tipo === mark.slice(5)).forEach(e => ids.add(e.id));
    if (mark === "scene") elements.forEach(e => ids.add(e.id));
  }
  stage?.set_model({ hovered: ids.size ? ids : null, marked: new Set(marks) });
}

function start_stage() {
  const panel = stage_panel();
  stage = make_stage({
    ...panel,
    on: {
      ray: (p, v, done) => {
        if (v.some(x => x !== 0)) change({ p, v, ...(done ? {} : { on: [] }) }, done);
      },
      orbit: orbit => change({ orbit: orbit.map(x => Math.round(x * 1000) / 1000) }),
      hover: point_at,
      choose: choose_at,
      lost: () => {
        find("said").textContent = say("no_webgl");
      },
    },
  });
  if (!stage) {
    panel.canvas.hidden = true;
    find("stage").append(el("p", { class: "fault", role: "alert" }, say("no_webgl")));
    stage = {
      set_scene: () => [],
      set_model() {},
      set_ghost() {},
      set_orbit() {},
      set_see_through() {},
      redraw() {},
      frame: () => null,
      render_now() {},
    };
  }
  document.addEventListener("pointerover", marked);
  document.addEventListener("focusin", marked);
}

let shown_scene = "";
function show_scene() {
  const key = state.scene + state.own,
    again = shown_scene === key,
    left_out = stage.set_scene(facts.scene, again);
  shown_scene = key;
  if (!again && state.orbit) stage.set_orbit(state.orbit);
  if (left_out.length) find("said").textContent = `${say("not_drawn")} ${left_out.join(", ")}`;
  show_lights();
}

// show_refused shows in red the element that was to be added, or the one that an operation named.
export function show_refused({ ghost, named }) {
  stage.set_ghost(ghost && facts.scene ? ghost : null);
  stage.set_model({ refused: named });
}

export const stage_now = () => stage;
export const redraw_picture = () => stage?.redraw();

export function start_picture() {
  start_stage();
  stage_bar();
  stage.set_model({ p: state.p, v: state.v });
  on_facts(what => {
    if (what === "scene") show_scene();
    if (what === "ray") show_answers();
    if (what === "light") show_lights();
  });
  on_change(keys => {
    if (keys.has("lang") || keys.has("scene")) stage_bar();
    if (keys.has("theme") || keys.has("lang")) stage.redraw();
    if (keys.has("p") || keys.has("v")) stage.set_model({ p: state.p, v: state.v });
    if (keys.has("crossing") && facts.ray) show_answers();
  });
}
