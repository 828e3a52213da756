// What the page asks of the engine, by the native program: the examples, the exercises, and the shapes that it reads.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { after, test } from "node:test";
import { native_engine } from "./browser.mjs";

const root = process.env.DURERO_ROOT,
  engine = native_engine(process.env.DURERO_CALL);
after(() => engine.close());
globalThis.dureroEngine = engine;
const text = path => readFileSync(join(root, path), "utf8");
globalThis.documents = { "first.json": text("web/examples/first.json") };
const load = name => import(join(root, "web", `${name}.js`));
const [{ exercises, judge }, { start_engine }, numbers, { without_conjectures }, values] = await Promise.all(
  ["exercises", "ask", "numbers", "ztext", "values"].map(load),
);
await start_engine();
const answered = async question => {
  const answer = await engine.call(question);
  assert.equal(answer.error, undefined, `${JSON.stringify(question).slice(0, 200)}: ${answer.error}`);
  return answer;
};

for (const exercise of exercises) {
  test(`exercise ${exercise.id}: its own answer is right, and others are not`, async () => {
    const own = await judge(exercise, exercise.try_);
    assert.ok(own.right, JSON.stringify(own));
    const wrong = {
      z: ["false", "∅", "2", "x", ")("],
      op: ["Agregar_Esfera e?=a centro?=(0,0,0) radio?=1", "nothing"],
      ray: ["0 9 0 0 1 0", "1 2 3", ""],
    }[exercise.kind];
    for (const answer of wrong) assert.equal((await judge(exercise, answer)).right, false, answer);
  });
}

test("an almost right answer is refuted by a counter-example", async () => {
  const near = exercises.find(x => x.id === "near"),
    { right, tree } = await judge(near, "x * x - 20 * x + 92 ≤ 0");
  const witness = node => (node.witness ? node.value : node.parts?.map(witness).find(Boolean));
  assert.equal(right, false);
  assert.match(witness(tree.tree), /x == \d+/);
});

for (const name of ["lift", "file_system"]) {
  test(`the example ${name} is well-typed, and its machine steps and has a graph`, async () => {
    const z = text(`web/examples/${name}.tex`),
      checked = await answered({ call: "zed.check", text: z });
    assert.deepEqual(
      checked.defects.filter(d => d.severity === "error"),
      [],
    );
    const run = await answered({ call: "zed.run", text: z });
    assert.ok(run.states.length === 1 && run.operations.some(o => o.enabled === "yes"));
    const graph = await answered({ call: "zed.graph", text: without_conjectures(z), most: 40 });
    assert.equal(
      (await answered({ call: "zed.check", text: without_conjectures(z), states: 0 })).conjectures.length,
      0,
    );
    assert.ok(
      graph.states.length > 3 &&
        graph.states.some(s => s.initial) &&
        graph.steps.every(s => graph.states[s.from] && graph.states[s.to]),
    );
  });
}

test("a ray's exact numbers are those that the page writes", async () => {
  const scene = globalThis.documents["first.json"],
    p = [-3, 2, -4.5],
    v = [4, -1.25, 5.5];
  const { hit, crossings, decided } = await answered({ call: "ray", scene, p, v }),
    { hits } = await answered({ call: "trace", scene, rays: [[...p, ...v]] });
  assert.deepEqual({ ...hit, ray: 0 }, hits[0]);
  assert.ok(crossings.length >= 2 && crossings.some(c => c.first));
  for (const c of crossings)
    for (const exact of [c.t, ...c.point]) {
      assert.equal(numbers.hexadecimal(exact.binary64), exact.hex);
      assert.equal(exact.above, numbers.next_up(exact.binary64));
      assert.equal(exact.below, numbers.next_down(exact.binary64));
      const place = numbers.place_between(exact.digits.replace("…", ""), exact.below, exact.above);
      assert.ok(
        place >= 0.24 && place <= 0.76,
        `${exact.digits} is no nearer to ${exact.binary64} than to its neighbours`,
      );
      assert.ok(numbers.quadratic_text(exact.x, exact.y, exact.delta).length > 0);
    }
  assert.deepEqual(
    decided.first.map(d => d.elemento),
    hit.elementos,
  );
  assert.ok(
    decided.first.every(d => ["triage", "stable", "exact"].includes(d.step) && d.low <= hit.t && hit.t <= d.high),
  );
});

test("the place of every predicate of the text is known, and the page's first paragraph is there", async () => {
  const { files } = await answered({ call: "text" }),
    { labels } = await answered({ call: "labels" }),
    known = new Set(labels.map(l => l.label));
  let predicates = 0;
  for (const { file } of files)
    for (const part of (await answered({ call: "text", file })).parts)
      for (const line of part.lines ?? [])
        if (line.label) {
          ++predicates;
          assert.ok(known.has(line.label), line.label);
        }
  assert.ok(predicates > 300);
  assert.ok(labels.every(l => ["proved", "tested", "stated"].includes(l.status)));
});

test("each predicate of a hit is true of the exact answer, and of a wrong one some is false", async () => {
  const scene = globalThis.documents["first.json"],
    ray = { p: [-3, 2, -4.5], v: [4, -1.25, 5.5], on: [] },
    names = JSON.parse(scene).elementos.map(e => e.id);
  const answer = await answered({ call: "ray", scene, p: ray.p, v: ray.v }),
    { parts } = await answered({ call: "text", file: "spec/interseccion.tex" });
  const lines = parts.find(p => p.names?.includes("Hay_Interseccion")).lines.filter(l => l.label);
  assert.ok(lines.length >= 5);
  const truth = async given =>
    Promise.all(
      lines.map(
        async l =>
          (
            await engine.call({
              call: "eval",
              expression: l.text,
              bindings: values.values_in(l.text, given),
              scene,
              steps: 3000000,
            })
          ).value,
      ),
    );
  const right = values.ray_values(ray, answer, names);
  assert.deepEqual(
    await truth(right),
    lines.map(() => "true"),
  );
  for (const wrong of [
    { "t!": "1 / 2" },
    { "elementos!": "{tube}" },
    { "resultado!": "miss" },
    { "punto!": values.z_point([0, 0, 0]) },
  ])
    assert.ok((await truth({ ...right, ...wrong })).includes("false"), JSON.stringify(wrong));
});

test("the clauses of an operation are evaluated with its inputs", async () => {
  const scene = globalThis.documents["first.json"],
    given = values.input_values(
      values.parts_of("Agregar_Cilindro e?=ball centro?=(0,0,0) radio?=-0.5 vector?=(0,0x1p0,0) altura?=2"),
      ["ball"],
    );
  for (const [predicate, value] of [
    ["e? ∉ elementos", "false"],
    ["radio? ∈ Rmas", "false"],
    ["altura? ∈ Rmas", "true"],
    ["centro?.x = 0", "true"],
  ])
    assert.equal(
      (await answered({ call: "eval", expression: predicate, bindings: values.values_in(predicate, given), scene }))
        .value,
      value,
      predicate,
    );
});
