import { ask, latest } from "./ask.js";
import { on_change, state } from "./state.js";

// What the engine answers about the state: the scene after each step, the ray, the shadow rays. Answers alone stand here.
export const facts = {
  scenes: [],
  answers: [],
  refusals: [],
  scene_text: "",
  scene: null,
  ray: null,
  light: null,
  error: null,
  first: null, // when the first ray was answered
};
const listeners = [];
export const on_facts = listener => listeners.push(listener);
const tell = what => listeners.forEach(listener => listener(what));

export const scene_names = {
  first: "first.json",
  still: "still-life.json",
  mirrors: "mirrors.json",
  balls: "shader.json",
};
export const base_text = () =>
  state.scene === "own" ? state.own : documents[scene_names[state.scene] ?? "first.json"];

// picture_of reads a scene for the picture. Its exact numbers stay in the text, which the engine reads.
function picture_of(text) {
  try {
    return JSON.parse(text);
  } catch {
    return null;
  }
}

let asked_scene = 0;
async function update_scene() {
  const mine = ++asked_scene;
  const answer = await ask({ call: "edit", scene: base_text(), operations: state.ops });
  if (mine !== asked_scene) return;
  if (answer.error) {
    facts.error = answer.error;
    tell("error");
    return;
  }
  Object.assign(facts, {
    scenes: answer.scenes,
    answers: answer.answers,
    refusals: answer.refusals ?? [],
    error: null,
  });
  pick_step();
}

function pick_step() {
  const text = facts.scenes[Math.min(state.step, facts.scenes.length - 1)];
  const is_new = text !== facts.scene_text;
  facts.scene_text = text;
  if (is_new) facts.scene = picture_of(text);
  tell("scene");
  if (is_new) update_ray(true);
}

const rays = latest((answer, question, stale) => {
  facts.ray = answer;
  facts.first ??= performance.now();
  facts.asked = question;
  tell("ray");
  if (!stale) lights.send({ ...question, call: "light" });
});
const lights = latest(answer => {
  facts.light = answer;
  tell("light");
});

export function update_ray() {
  if (!facts.scene_text) return;
  const question = { call: "ray", scene: facts.scene_text, p: state.p, v: state.v };
  const on = state.on.filter(name => facts.scene?.elementos?.some(e => e.id === name));
  if (on.length) question.on = on;
  rays.send(question);
}

export function start_facts() {
  on_change(keys => {
    if (keys.has("scene") || keys.has("own") || keys.has("ops")) update_scene();
    else if (keys.has("step")) pick_step();
    if (keys.has("p") || keys.has("v") || keys.has("on")) update_ray();
  });
  return update_scene();
}
