import { make_drawing } from "./drawing.js";
import { el, fill } from "./dom.js";
import { on_grid, short } from "./numbers.js";
import { drawn_of } from "./drawn.js";
import { across, add, long, look, moved, perspective, product, sub, times } from "./vectors.js";
import { frame_of, pixel_of, shown_ball, usual_orbit } from "./window.js";
import { say } from "./words.js";

// The scene in three dimensions: eye, window and pixel, a ray with two handles, all its crossings, normals, lights and
// shadow rays. Colours are those of Okabe and Ito, which most eyes tell apart.
const hex = (text, alpha = 1) => [1, 3, 5].map(i => parseInt(text.slice(i, i + 2), 16) / 255).concat(alpha);
const tints = {
  ray: hex("#0072b2"),
  beyond: hex("#0072b2", 0.45),
  first: hex("#d55e00"),
  other: hex("#cc79a7"),
  normal: hex("#009e73"),
  light: hex("#e69f00"),
  shadow: hex("#b3261e"),
  window: hex("#7a7a85"),
  refused: hex("#d32f2f"),
};
const field = (40 * Math.PI) / 180;

export function make_stage({ canvas, labels, on }) {
  const drawing = make_drawing(canvas);
  if (!drawing) return null;
  let model = { p: [0, 0, 0], v: [0, 0, 1], crossings: [], lights: [], hit: null, hovered: null, refused: null };
  let scene = null,
    frame = null,
    ball = { middle: [0, 0, 0], radius: 3 },
    orbit = [0.6, 0.3, 10],
    ghost = null,
    waiting = false,
    see_through = false;

  function eye_of() {
    const [a, b, far] = orbit;
    return add(ball.middle, times([Math.sin(a) * Math.cos(b), Math.sin(b), Math.cos(a) * Math.cos(b)], far));
  }
  const view_of = () => look(eye_of(), ball.middle, [0, 1, 0]);
  const aspect_of = () => Math.max(0.05, canvas.clientWidth / Math.max(1, canvas.clientHeight));
  // half_field is the tangent of half the field from below to above: an upright picture shows as much across as one of 6 by 5.
  const half_field = () => Math.tan(field / 2) * Math.max(1, 1.2 / aspect_of());
  const lens_of = () =>
    perspective(2 * Math.atan(half_field()), aspect_of(), Math.max(0.02, orbit[2] / 400), orbit[2] * 12 + 100);

  function set_scene(next, keep_view) {
    scene = next;
    frame = frame_of(scene);
    const { meshes, left_out } = drawn_of(scene);
    set_ghost(null);
    drawing.set_meshes(meshes);
    if (!keep_view) {
      ball = shown_ball(meshes, frame, scene.lights ?? []);
      orbit = usual_orbit(frame, ball);
    }
    redraw();
    return left_out;
  }

  // set_ghost shows an element that was refused, in red, beside those of the scene.
  function set_ghost(element) {
    if (!scene) return;
    ghost = element;
    const { meshes } = drawn_of(scene);
    const shape = element && usable(element) ? drawn_of({ elementos: [element] }).meshes : [];
    drawing.set_meshes([...meshes, ...shape.map(mesh => ({ ...mesh, id: " refused", colour: [0.9, 0.15, 0.12] }))]);
    redraw();
  }

  function arrow(list, from, way, tint, size, wide = 1.6) {
    const to = add(from, times(way, size)),
      [u] = across(way);
    list.push({ from, to, tint, wide });
    for (const s of [1, -1])
      list.push({ from: to, to: add(to, times(sub(times(u, s * 0.6), way), size * 0.28)), tint, wide });
  }

  function window_lines(list) {
    if (!frame) return;
    const tint = tints.window,
      corner = [
        [-1, -1],
        [1, -1],
        [1, 1],
        [-1, 1],
      ].map(([x, y]) => frame.at(x, y));
    corner.forEach((c, i) => {
      list.push({ from: c, to: corner[(i + 1) % 4], tint, wide: 1.8 });
      list.push({ from: frame.eye, to: c, tint: [...tint.slice(0, 3), 0.5], wide: 1 });
    });
    for (let i = 1; i < 8; ++i) {
      const s = i / 4 - 1,
        thin = [...tint.slice(0, 3), 0.35];
      list.push({ from: frame.at(s, -1), to: frame.at(s, 1), tint: thin, wide: 0.8 });
      list.push({ from: frame.at(-1, s), to: frame.at(1, s), tint: thin, wide: 0.8 });
    }
    const pixel = pixel_of(frame, model.p, model.v);
    if (!pixel) return;
    const dx = Math.max(1.2 / frame.width, 0.02),
      dy = Math.max(1.2 / frame.height, (0.02 * frame.wide) / frame.half);
    const box = [
      [-1, -1],
      [1, -1],
      [1, 1],
      [-1, 1],
    ].map(([x, y]) => frame.at(pixel.x + x * dx, pixel.y + y * dy));
    box.forEach((c, i) => list.push({ from: c, to: box[(i + 1) % 4], tint: tints.first, wide: 2 }));
  }

  function content() {
    const line_list = [],
      dot_list = [],
      signs = [];
    window_lines(line_list);
    const { p, v, crossings, lights, picked } = model,
      marks = name => (model.marked?.has(name) ? 1.6 : 1);
    const reach = (3 * ball.radius + long(sub(p, ball.middle))) / long(v);
    const first = crossings.find(c => c.first && c.at);
    if (first) line_list.push({ from: p, to: first.at, tint: tints.ray, wide: 3 * marks("ray") });
    line_list.push({
      from: first ? first.at : p,
      to: add(p, times(v, Math.max(reach, 1.1))),
      tint: first ? tints.beyond : tints.ray,
      wide: (first ? 1.6 : 3) * marks("ray"),
    });
    if (frame) {
      dot_list.push({ place: frame.eye, tint: tints.window, big: 13 * marks("eye") });
      signs.push({ at: frame.eye, text: say("eye"), kind: "quiet" });
      signs.push({ at: frame.at(-1, 1), text: say("window"), kind: "quiet" });
      const pixel = pixel_of(frame, p, v);
      if (pixel)
        signs.push({
          at: frame.at(pixel.x, pixel.y),
          text: `${say("pixel")} ${pixel.column}, ${pixel.row}`,
          kind: "first",
        });
    }
    crossings.forEach((c, i) => {
      if (!c.at) return;
      if (c.end) line_list.push({ from: c.at, to: c.end, tint: tints.first, wide: 5 });
      dot_list.push({
        place: c.at,
        tint: c.first ? tints.first : tints.other,
        big: (c.first ? 15 : 12) * (i === picked ? 1.3 : 1) * (c.first ? marks("first") : -1) * marks("crossings"),
      });
      if (c.normal) arrow(line_list, c.at, c.normal, tints.normal, 0.16 * ball.radius);
      signs.push({ at: c.at, text: `t = ${short(c.t)}`, kind: c.first ? "first" : "other", title: c.elemento });
    });
    for (const light of lights) {
      const dark = !light.visible;
      dot_list.push({ place: light.place, tint: tints.light, big: 17 * marks("lights") });
      signs.push({ at: light.place, text: say("light"), kind: "quiet" });
      if (!light.from) continue;
      const stop = light.blocked ?? light.place;
      line_list.push({ from: light.from, to: stop, tint: tints.light, wide: 2 });
      if (!dark) continue;
      line_list.push({ from: stop, to: light.place, tint: tints.shadow, wide: 2, dashes: 7 });
      if (light.blocked) dot_list.push({ place: light.blocked, tint: tints.shadow, big: 11 });
    }
    if (ghost) {
      const at = ghost.centro ?? ghost.vertices?.[0];
      if (at) {
        const size = 0.07 * ball.radius;
        for (const s of [1, -1])
          line_list.push({
            from: add(at, [-size, -s * size, 0]),
            to: add(at, [size, s * size, 0]),
            tint: tints.refused,
            wide: 4,
          });
        signs.push({ at, text: ghost.why ?? say("refused"), kind: "refused" });
      }
    }
    return { line_list, dot_list, signs };
  }

  function look_of(mesh) {
    if (mesh.id === " refused") return { alpha: 0.45, colour: [0.9, 0.15, 0.12], glow: 0.4 };
    const plane = mesh.tipo === "plano",
      lit = model.hovered?.has(mesh.id) || model.refused === mesh.id;
    const met = model.hit?.some(id => id === mesh.id || id.startsWith(mesh.id + ":"));
    const look = { alpha: see_through ? 0.32 : plane ? 0.42 : 1, glow: lit ? 1 : met ? 0.55 : 0 };
    if (model.refused === mesh.id) look.colour = [0.9, 0.15, 0.12];
    return look;
  }

  // projected is where a point is on the canvas, in pixels of the page; or null behind the eye.
  function projected(point) {
    const [x, y, , w] = moved(product(lens_of(), view_of()), point);
    return w <= 0.02 ? null : [((x / w + 1) / 2) * canvas.clientWidth, ((1 - y / w) / 2) * canvas.clientHeight];
  }

  function place(node, point) {
    const at = projected(point);
    const inside =
      at && at[0] > -20 && at[1] > -20 && at[0] < canvas.clientWidth + 20 && at[1] < canvas.clientHeight + 20;
    node.hidden = !inside;
    if (inside) node.style.transform = `translate(${at[0].toFixed(1)}px, ${at[1].toFixed(1)}px)`;
    return at;
  }

  function draw_signs(signs) {
    const taken = [],
      nodes = [];
    for (const sign of signs) {
      const at = projected(sign.at);
      if (!at) continue;
      let y = at[1];
      while (taken.some(t => Math.abs(t[0] - at[0]) < 76 && Math.abs(t[1] - y) < 17)) y += 17;
      taken.push([at[0], y]);
      const node = el("span", { class: `sign ${sign.kind}`, title: sign.title }, sign.text);
      const left = at[0] > canvas.clientWidth - 90;
      node.style.transform = `translate(${at[0].toFixed(1)}px, ${y.toFixed(1)}px)${left ? " translateX(calc(-100% - 20px))" : ""}`;
      nodes.push(node);
    }
    fill(labels.signs, nodes);
  }

  function render() {
    waiting = false;
    const { line_list, dot_list, signs } = content();
    drawing.draw({ view: view_of(), lens: lens_of(), ball, look_of, line_list, dot_list });
    draw_signs(signs);
    place(labels.origin, model.p);
    place(labels.target, add(model.p, model.v));
  }
  function redraw() {
    if (waiting) return;
    waiting = true;
    requestAnimationFrame(render);
  }

  // The handles.
  const per_pixel = point => {
    const depth = -moved(view_of(), point)[2];
    return (2 * depth * half_field()) / Math.max(1, canvas.clientHeight);
  };
  const screen_axes = () => {
    const m = view_of();
    return { right: [m[0], m[4], m[8]], top: [m[1], m[5], m[9]], back: [m[2], m[6], m[10]] };
  };
  const snapped = point => point.map(on_grid);

  function handle(node, get, set) {
    let grip = null;
    node.addEventListener("pointerdown", event => {
      node.setPointerCapture(event.pointerId);
      grip = { x: event.clientX, y: event.clientY, at: get() };
      event.preventDefault();
      node.focus({ preventScroll: true });
    });
    node.addEventListener("pointermove", event => {
      if (!grip) return;
      const { right, top, back } = screen_axes(),
        size = per_pixel(grip.at);
      const dx = (event.clientX - grip.x) * size,
        dy = (grip.y - event.clientY) * size;
      const way = event.shiftKey ? times(back, -dy) : add(times(right, dx), times(top, dy));
      set(snapped(add(grip.at, way)), false);
    });
    for (const end of ["pointerup", "pointercancel"])
      node.addEventListener(end, () => {
        if (grip) {
          grip = null;
          set(get(), true);
        }
      });
    node.addEventListener("keydown", event => {
      const { right, top, back } = screen_axes(),
        step = event.shiftKey ? 1 / 64 : 1 / 8;
      const ways = {
        ArrowRight: right,
        ArrowLeft: times(right, -1),
        ArrowUp: top,
        ArrowDown: times(top, -1),
        PageUp: times(back, -1),
        PageDown: back,
      };
      if (!ways[event.key]) return;
      event.preventDefault();
      const to = snapped(add(get(), times(ways[event.key], Math.max(step, 1 / 64))));
      set(to, true);
    });
  }
  handle(
    labels.origin,
    () => model.p,
    (to, done) => on.ray(to, sub(add(model.p, model.v), to), done),
  );
  handle(
    labels.target,
    () => add(model.p, model.v),
    (to, done) => on.ray(model.p, sub(to, model.p), done),
  );

  // Turning, going near, and what is below the pointer.
  const fingers = new Map();
  const turn = (a, b) => {
    orbit = [orbit[0] - a, Math.min(1.5, Math.max(-1.5, orbit[1] + b)), orbit[2]];
    on.orbit(orbit);
    redraw();
  };
  const approach = k => {
    orbit = [orbit[0], orbit[1], Math.min(400 * ball.radius, Math.max(0.05 * ball.radius, orbit[2] * k))];
    on.orbit(orbit);
    redraw();
  };
  const apart = () => {
    const [a, b] = [...fingers.values()];
    return Math.hypot(a[0] - b[0], a[1] - b[1]);
  };
  let pressed = null;

  function ray_at(event) {
    const box = canvas.getBoundingClientRect(),
      { right, top, back } = screen_axes();
    const x = (2 * (event.clientX - box.left)) / box.width - 1,
      y = 1 - (2 * (event.clientY - box.top)) / box.height;
    const high = half_field(),
      wide = (high * box.width) / box.height;
    return { p: eye_of(), v: sub(add(times(right, x * wide), times(top, y * high)), back) };
  }
  canvas.addEventListener("pointerdown", event => {
    canvas.setPointerCapture(event.pointerId);
    fingers.set(event.pointerId, [event.clientX, event.clientY]);
    pressed = [event.clientX, event.clientY];
  });
  canvas.addEventListener("pointermove", event => {
    const before = fingers.get(event.pointerId);
    if (!before) return on.hover(ray_at(event));
    const wide = fingers.size === 2 ? apart() : 0;
    fingers.set(event.pointerId, [event.clientX, event.clientY]);
    if (fingers.size === 1) turn((event.clientX - before[0]) * 0.008, (event.clientY - before[1]) * 0.008);
    else if (fingers.size === 2 && apart() > 0) approach(wide / apart());
  });
  canvas.addEventListener("pointerup", event => {
    fingers.delete(event.pointerId);
    if (pressed && Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) < 4) on.choose(ray_at(event));
    pressed = null;
  });
  canvas.addEventListener("pointercancel", event => fingers.delete(event.pointerId));
  canvas.addEventListener("pointerleave", () => on.hover(null));
  canvas.addEventListener(
    "wheel",
    event => {
      event.preventDefault();
      approach(Math.exp(event.deltaY * 0.001));
    },
    { passive: false },
  );
  canvas.addEventListener("keydown", event => {
    const keys = {
      "ArrowLeft": () => turn(-0.1, 0),
      "ArrowRight": () => turn(0.1, 0),
      "ArrowUp": () => turn(0, 0.1),
      "ArrowDown": () => turn(0, -0.1),
      "+": () => approach(0.9),
      "=": () => approach(0.9),
      "-": () => approach(1.1),
    };
    if (keys[event.key]) {
      event.preventDefault();
      keys[event.key]();
    }
  });
  canvas.addEventListener("webglcontextlost", event => {
    event.preventDefault();
    on.lost();
  });
  new ResizeObserver(redraw).observe(canvas);

  return {
    set_scene,
    set_ghost,
    redraw,
    set_model: next => {
      model = { ...model, ...next };
      redraw();
    },
    set_orbit: next => {
      if (next) {
        orbit = next;
        redraw();
      }
    },
    set_see_through: next => {
      see_through = next;
      redraw();
    },
    frame: () => frame,
    projected,
    render_now: render,
    gl: drawing.gl,
  };
}

// usable says whether the numbers of an element are enough to draw it.
function usable(element) {
  const good = x => typeof x === "number" && Number.isFinite(x),
    three = a => Array.isArray(a) && a.length === 3 && a.every(good);
  if (element.tipo === "triangulo") return element.vertices?.length === 3 && element.vertices.every(three);
  if (!three(element.centro)) return false;
  const positive = {
    esfera: ["radio"],
    cilindro: ["radio", "altura"],
    cono: ["proporcion", "altura"],
    tronco: ["radio", "proporcion", "altura"],
    plano: [],
    disco: ["radio"],
  }[element.tipo];
  if (!positive || !positive.every(k => good(element[k]) && element[k] > 0)) return false;
  return element.tipo === "esfera" || (three(element.vector) && long(element.vector) > 0);
}
