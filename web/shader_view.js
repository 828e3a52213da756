import { ask } from "./ask.js";
import { el, fill, find, later } from "./dom.js";
import { program } from "./drawing.js";
import { facts, on_facts } from "./facts.js";
import { change, on_change, state } from "./state.js";
import { add, cross, dot, long, sub, times, unit } from "./vectors.js";
import { say } from "./words.js";

// The scene by a fragment shader that is made of it, and its elements held against the exact ones.
let gl = null,
  programs = {},
  made = null,
  made_of = "",
  camera = null,
  moving = false,
  share = 1,
  drawn = 0,
  waiting = false,
  compared = null,
  trouble = "";

// view_rays are the numbers of a picture's camera; a narrower picture shows as much across as the scene's.
function view_rays(width, height) {
  const forward = unit(sub(camera.look_at, camera.eye)),
    side = unit(cross(forward, camera.up)),
    up = cross(side, forward);
  const [w, h] = facts.scene.resolution ?? [640, 360],
    pixel = (2 * Math.tan((camera.fov_y * Math.PI) / 360)) / Math.min(height, (width * h) / w);
  return {
    eye: camera.eye,
    forward,
    step_x: times(side, pixel * (camera.mirrored ? -1 : 1)),
    step_y: times(up, pixel),
    size: [width, height],
  };
}

// rays_of lists the rays of all pixels, row by row from below.
export function rays_of({ eye, forward, step_x, step_y, size: [width, height] }) {
  const rays = [];
  for (let j = 0; j < height; ++j)
    for (let i = 0; i < width; ++i)
      rays.push([
        ...eye,
        ...add(add(forward, times(step_x, i + 0.5 - width / 2)), times(step_y, j + 0.5 - height / 2)),
      ]);
  return rays;
}

// judged compares what a shader wrote with exact hits: doubtful pixels, equal ones, and wrong ones, which there must be none of.
export function judged(found, hits, elementos) {
  const kinds = new Uint8Array(hits.length),
    count = { doubtful: 0, equal: 0, wrong: 0 };
  hits.forEach((hit, i) => {
    const name = found[4 * i] === 0 ? null : elementos[found[4 * i] - 1];
    const exact = hit.outcome === "hit" ? hit.elementos : [];
    const same = name === null ? hit.outcome === "miss" : exact.length === 1 && exact[0] === name;
    const kind = found[4 * i + 1] ? "doubtful" : same ? "equal" : "wrong";
    ++count[kind];
    kinds[i] = ["equal", "doubtful", "wrong"].indexOf(kind);
  });
  return { kinds, count };
}

async function make() {
  if (made_of === facts.scene_text) return;
  const text = facts.scene_text,
    answer = await ask({ call: "render_shader", scene: text, writes: "color" });
  if (text !== facts.scene_text) return;
  made_of = text;
  compared = null;
  programs = {};
  made = answer.error ? null : answer;
  trouble = answer.error ?? "";
  camera = facts.scene?.camera ? structuredClone(facts.scene.camera) : null;
}
const outputs = { color: 0, answer: 1, doubts: 2 };
function program_for(writes) {
  programs[writes] ??= program(
    gl,
    made.vertex,
    made.fragment.replace("#define WRITES 0", `#define WRITES ${outputs[writes]}`),
  );
  return programs[writes];
}
function draw(writes, width, height) {
  const used = program_for(writes),
    uniforms = view_rays(width, height);
  gl.viewport(0, 0, width, height);
  gl.useProgram(used.made);
  for (const [name, value] of Object.entries(uniforms)) {
    if (value.length === 2) gl.uniform2fv(used.uniform(name), value);
    else gl.uniform3fv(used.uniform(name), value);
  }
  gl.drawArrays(gl.TRIANGLES, 0, 3);
}

function answers_at(width, height) {
  const texture = gl.createTexture(),
    frame = gl.createFramebuffer(),
    found = new Uint32Array(4 * width * height);
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA32UI, width, height);
  gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
  draw("answer", width, height);
  gl.readPixels(0, 0, width, height, gl.RGBA_INTEGER, gl.UNSIGNED_INT, found);
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  gl.deleteFramebuffer(frame);
  gl.deleteTexture(texture);
  return found;
}

// A slow processor draws fewer pixels while the picture turns; at rest all of them.
function frame(now) {
  waiting = false;
  const canvas = find("shader-canvas");
  if (!canvas || !made || !camera || state.view !== "shader") return;
  if (moving && drawn)
    share = Math.min(1, Math.max(0.15, share * (now - drawn > 50 ? 0.8 : now - drawn < 22 ? 1.15 : 1)));
  drawn = moving ? now : 0;
  canvas.width = Math.max(1, Math.round(canvas.clientWidth * (moving ? share : 1)));
  canvas.height = Math.max(1, Math.round(canvas.clientHeight * (moving ? share : 1)));
  try {
    draw(state.doubts ? "doubts" : "color", canvas.width, canvas.height);
  } catch (error) {
    tell_trouble(String(error.message ?? error));
  }
}
function redraw() {
  if (waiting) return;
  waiting = true;
  requestAnimationFrame(frame);
}
const rest = later(() => {
  moving = false;
  redraw();
}, 200);
function move() {
  moving = true;
  compared = null;
  tell();
  rest();
  redraw();
}

function turn(across, upwards) {
  const up = unit(camera.up),
    from = sub(camera.eye, camera.look_at),
    far = long(from),
    high = dot(from, up),
    flat = sub(from, times(up, high)),
    level = long(flat);
  const first = level > 0 ? times(flat, 1 / level) : unit(cross(up, Math.abs(up[0]) < 0.6 ? [1, 0, 0] : [0, 1, 0])),
    second = cross(up, first);
  const angle = Math.min(1.55, Math.max(-1.55, Math.atan2(high, level) + upwards)),
    way = add(times(first, Math.cos(across)), times(second, Math.sin(across)));
  camera = {
    ...camera,
    eye: add(camera.look_at, add(times(way, far * Math.cos(angle)), times(up, far * Math.sin(angle)))),
  };
  move();
}
function approach(factor) {
  camera = { ...camera, eye: add(camera.look_at, times(sub(camera.eye, camera.look_at), factor)) };
  move();
}

const compare_size = [96, 60];
async function compare() {
  const [width, height] = compare_size,
    found = answers_at(width, height),
    uniforms = view_rays(width, height);
  compared = { waiting: true };
  tell();
  const answer = await ask({ call: "trace", scene: facts.scene_text, rays: rays_of(uniforms) });
  compared = answer.error ? { error: answer.error } : { width, height, ...judged(found, answer.hits, made.elementos) };
  tell();
}

function map_of({ width, height, kinds }) {
  const canvas = el("canvas", { width, height, "class": "map", "role": "img", "aria-label": say("map_of_pixels") }),
    context = canvas.getContext("2d"),
    image = context.createImageData(width, height);
  const colours = [
    [0, 114, 178],
    [204, 121, 167],
    [213, 94, 0],
  ];
  kinds.forEach((kind, i) =>
    image.data.set([...colours[kind], 255], 4 * ((height - 1 - Math.floor(i / width)) * width + (i % width))),
  );
  context.putImageData(image, 0, 0);
  return canvas;
}

function tell() {
  const holder = find("shader-said");
  if (!holder) return;
  fill(
    holder,
    !compared
      ? null
      : compared.waiting
        ? el("p", { class: "quiet" }, say("waiting"))
        : compared.error
          ? el("p", { class: "fault" }, compared.error)
          : el(
              "div",
              { class: "row" },
              map_of(compared),
              el(
                "ul",
                {},
                el("li", {}, el("span", { class: "swatch equal" }), ` ${compared.count.equal} ${say("pixels_equal")}`),
                el(
                  "li",
                  {},
                  el("span", { class: "swatch doubtful" }),
                  ` ${compared.count.doubtful} ${say("pixels_doubtful")}`,
                ),
                el(
                  "li",
                  { class: compared.count.wrong ? "fault" : "" },
                  el("span", { class: "swatch wrong" }),
                  ` ${compared.count.wrong} ${say("pixels_wrong")}`,
                ),
              ),
            ),
  );
}
function tell_trouble(text) {
  const node = find("shader-trouble");
  if (node) {
    node.hidden = !text;
    node.textContent = text;
  }
}

function listen(canvas) {
  const fingers = new Map(),
    apart = () => {
      const [a, b] = [...fingers.values()];
      return Math.hypot(a[0] - b[0], a[1] - b[1]);
    };
  canvas.addEventListener("pointerdown", e => {
    canvas.setPointerCapture(e.pointerId);
    fingers.set(e.pointerId, [e.clientX, e.clientY]);
  });
  for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, e => fingers.delete(e.pointerId));
  canvas.addEventListener("pointermove", e => {
    const before = fingers.get(e.pointerId);
    if (!before || !camera) return;
    const wide = fingers.size === 2 ? apart() : 0;
    fingers.set(e.pointerId, [e.clientX, e.clientY]);
    if (fingers.size === 1) turn((before[0] - e.clientX) * 0.008, (e.clientY - before[1]) * 0.008);
    else if (fingers.size === 2 && apart() > 0) approach(wide / apart());
  });
  canvas.addEventListener(
    "wheel",
    e => {
      e.preventDefault();
      if (camera) approach(Math.exp(e.deltaY * 0.001));
    },
    { passive: false },
  );
  canvas.addEventListener("keydown", e => {
    const keys = {
      "ArrowLeft": () => turn(-0.1, 0),
      "ArrowRight": () => turn(0.1, 0),
      "ArrowUp": () => turn(0, 0.1),
      "ArrowDown": () => turn(0, -0.1),
      "+": () => approach(0.9),
      "=": () => approach(0.9),
      "-": () => approach(1.1),
    };
    if (keys[e.key] && camera) {
      e.preventDefault();
      keys[e.key]();
    }
  });
}

async function show() {
  if (state.view !== "shader" || !facts.scene_text) return;
  if (!find("shader-canvas")) {
    const canvas = el("canvas", {
      "id": "shader-canvas",
      "tabindex": "0",
      "role": "img",
      "aria-label": say("shader_picture"),
    });
    fill(
      find("shader"),
      el("h2", {}, say("shader_title")),
      el("p", { class: "lead" }, say("shader_lead")),
      el(
        "div",
        { class: "row" },
        el(
          "label",
          {},
          el("input", {
            type: "checkbox",
            checked: state.doubts,
            id: "doubts",
            onchange: e => change({ doubts: e.target.checked }),
          }),
          " ",
          say("show_doubtful"),
        ),
        el("button", { class: "action", id: "compare", onclick: compare }, say("hold_against")),
        el(
          "button",
          { class: "small", onclick: () => change({ scene: "balls", ops: [], step: 0 }) },
          say("mirrors_and_glass"),
        ),
      ),
      el("p", { id: "shader-trouble", class: "fault", hidden: true, role: "alert" }),
      canvas,
      el("div", { id: "shader-said", role: "status" }),
    );
    listen(canvas);
    new ResizeObserver(redraw).observe(canvas);
    gl = canvas.getContext("webgl2", { antialias: false, alpha: false, preserveDrawingBuffer: true });
    programs = {};
  }
  if (!gl) return tell_trouble(say("no_webgl"));
  await make();
  tell_trouble(trouble || (camera ? "" : say("no_camera")));
  tell();
  redraw();
}

export function start_shader() {
  on_change(keys => {
    if (keys.has("lang")) find("shader").replaceChildren();
    if (keys.has("view") || keys.has("doubts") || keys.has("lang")) show();
  });
  on_facts(what => {
    if (what === "scene") show();
  });
  show();
}
