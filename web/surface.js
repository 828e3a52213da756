import { latest } from "./ask.js";
import { el, fill, find, later } from "./dom.js";
import { change, on_change, state } from "./state.js";
import { add, dot, long, sub, times, unit } from "./vectors.js";
import { say } from "./words.js";

// A surface that is written in Z, drawn while it is typed: a grid of rays is asked for their first points.
const samples = ["torus", "ellipsoid", "hyperboloid", "cubic"];
const scenes = {
  torus: "torus.json",
  ellipsoid: "ellipsoid.json",
  hyperboloid: "hyperboloid.json",
  cubic: "cubic.json",
};
let scene = null,
  size = [32, 20],
  shown = null;

const text_now = () => state.stext || documents[`${state.surface}.tex`] || documents["torus.tex"];
// read_scene is the scene of an example, with the elements as the reader has changed them.
function read_scene() {
  const read = JSON.parse(documents[scenes[state.surface]] ?? documents["torus.json"]);
  try {
    if (state.selems) read.elementos = JSON.parse(state.selems);
  } catch {
    /* an address that was cut */
  }
  return Array.isArray(read.elementos) ? read : JSON.parse(documents["torus.json"]);
}

// paint shades the hits of a grid by the scene's lights, as Lambert's law has it, and without shadows.
export function paint(canvas, answer, scene) {
  const { width, height, hits } = answer,
    eye = scene.camera.eye;
  canvas.width = width;
  canvas.height = height;
  const context = canvas.getContext("2d"),
    image = context.createImageData(width, height);
  const background = scene.background ?? [0, 0, 0],
    colours = new Map(scene.elementos.map(e => [e.id, scene.materials?.[e.material]?.color ?? [0.8, 0.8, 0.8]]));
  hits.forEach((hit, i) =>
    image.data.set([...(hit ? shade(hit, colours.get(hit.e), scene, eye) : background).map(curve), 255], 4 * i),
  );
  context.putImageData(image, 0, 0);
  canvas.dataset.painted = "1";
}
const curve = x => Math.round(255 * Math.min(1, x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055));
function shade({ p, n }, colour, scene, eye) {
  const normal = dot(n, sub(eye, p)) < 0 ? times(n, -1) : n;
  let sum = [0.06, 0.06, 0.06];
  for (const light of scene.lights ?? [])
    sum = add(sum, times(light.color, Math.max(0, dot(normal, unit(sub(light.position, p))))));
  return colour.map((c, k) => c * sum[k]);
}

function turned(camera, a, b) {
  const from = sub(camera.eye, camera.look_at),
    far = long(from);
  const angle = Math.atan2(from[0], from[2]) + a,
    height = Math.min(1.5, Math.max(-1.5, Math.asin(from[1] / far) + b));
  return {
    ...camera,
    eye: add(
      camera.look_at,
      times([Math.sin(angle) * Math.cos(height), Math.sin(height), Math.cos(angle) * Math.cos(height)], far),
    ),
  };
}

const channel = latest((answer, question, stale) => {
  const said = find("surface-said"),
    canvas = find("surface-canvas");
  if (!said) return;
  canvas.classList.toggle("stale", Boolean(answer.error));
  if (answer.error) {
    said.className = "fault";
    said.textContent = answer.error;
    return;
  }
  shown = answer;
  paint(canvas, answer, question.scene);
  const met = answer.hits.filter(Boolean).length;
  said.className = "good";
  said.textContent = `${say("surface_types")}: ${answer.types.map(t => t.tipo).join(", ")}. ${met} ${say("of")} ${answer.hits.length} ${say("rays_meet")}.`;
  if (!stale && question.width < 256 && state.view === "surface") refine(question);
});
const refine = later(question => {
  if (state.view === "surface" && question.with === text_now())
    channel.send({ ...question, width: question.width * 2, height: question.height * 2 });
}, 350);

function send() {
  channel.send({ call: "surface", with: text_now(), scene, width: size[0], height: size[1] });
}
const typed = later(() => {
  change({ stext: find("surface-text").value });
  send();
}, 200);

function attribute_fields() {
  const own = scene.elementos.filter(
    e => !["esfera", "plano", "cilindro", "cono", "disco", "tronco", "triangulo"].includes(e.tipo),
  );
  return own.map(element =>
    el(
      "fieldset",
      {},
      el("legend", {}, `${element.id} : ${element.tipo}`),
      Object.entries(element)
        .filter(([key]) => !["id", "tipo", "material"].includes(key))
        .map(([key, value]) =>
          el(
            "label",
            { class: "field" },
            el("code", {}, key),
            el("input", {
              "type": "text",
              "value": JSON.stringify(value),
              "size": 10,
              "data-key": element.id + key,
              "onchange": event => {
                try {
                  element[key] = JSON.parse(event.target.value);
                  event.target.setAttribute("aria-invalid", "false");
                  change({ selems: JSON.stringify(scene.elementos) });
                  send();
                } catch {
                  event.target.setAttribute("aria-invalid", "true");
                }
              },
            }),
          ),
        ),
    ),
  );
}

function drag(canvas) {
  let from = null;
  canvas.addEventListener("pointerdown", e => {
    from = [e.clientX, e.clientY];
    canvas.setPointerCapture(e.pointerId);
  });
  canvas.addEventListener("pointermove", e => {
    if (!from) return;
    scene.camera = turned(scene.camera, (from[0] - e.clientX) * 0.01, (e.clientY - from[1]) * 0.01);
    from = [e.clientX, e.clientY];
    send();
  });
  for (const end of ["pointerup", "pointercancel"])
    canvas.addEventListener(end, () => {
      from = null;
    });
  canvas.addEventListener("keydown", e => {
    const ways = { ArrowLeft: [-0.15, 0], ArrowRight: [0.15, 0], ArrowUp: [0, 0.15], ArrowDown: [0, -0.15] };
    if (!ways[e.key]) return;
    e.preventDefault();
    scene.camera = turned(scene.camera, ...ways[e.key]);
    send();
  });
}

function show() {
  if (state.view !== "surface") return;
  const canvas = el("canvas", {
    "id": "surface-canvas",
    "tabindex": "0",
    "role": "img",
    "aria-label": say("surface_picture"),
    "width": size[0],
    "height": size[1],
  });
  fill(
    find("surface"),
    el("h2", {}, say("surface_title")),
    el("p", { class: "lead" }, say("surface_lead")),
    el(
      "div",
      { class: "two" },
      el(
        "section",
        {},
        el(
          "div",
          { class: "row" },
          el(
            "label",
            {},
            say("example"),
            " ",
            el(
              "select",
              { "data-key": "surface", "onchange": e => change({ surface: e.target.value, stext: "", selems: "" }) },
              samples.map(name => el("option", { value: name, selected: name === state.surface }, name)),
            ),
          ),
        ),
        el("textarea", {
          "id": "surface-text",
          "class": "z-input",
          "spellcheck": "false",
          "rows": "26",
          "aria-label": say("surface_text"),
          "oninput": typed,
          "value": text_now(),
        }),
      ),
      el("section", {}, canvas, el("p", { id: "surface-said", role: "status" }, say("drawing")), attribute_fields()),
    ),
  );
  drag(canvas);
  if (shown) paint(canvas, shown, scene);
  send();
}

export function start_surface() {
  scene = read_scene();
  on_change(keys => {
    if (keys.has("surface")) {
      scene = read_scene();
      shown = null;
    }
    if (keys.has("view") || keys.has("surface") || keys.has("lang")) show();
  });
  show();
}
