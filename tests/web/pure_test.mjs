// The parts of the page that need neither a browser nor the engine.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { gzipSync } from "node:zlib";

const root = process.argv[2] ?? process.env.DURERO_ROOT,
  out = process.env.DURERO_OUT;
const load = name => import(join(root, "web", `${name}.js`));
const [
  { address_of, start_state, state_of },
  numbers,
  z,
  drawn,
  machine,
  words,
  shader,
  marked,
  exercises,
  vectors,
  scene_window,
] = await Promise.all(
  [
    "address",
    "numbers",
    "ztext",
    "drawn",
    "machine",
    "words",
    "shader_view",
    "marked",
    "exercises",
    "vectors",
    "window",
  ].map(load),
);

// A generator of its own, so that each run draws the same.
let seed = 20261129;
const random = () => {
  seed = (seed * 1664525 + 1013904223) >>> 0;
  return seed / 2 ** 32;
};
const pick = list => list[Math.floor(random() * list.length)];
const any_double = () => {
  for (;;) {
    const x = numbers.of_bits((BigInt(Math.floor(random() * 2 ** 32)) << 32n) | BigInt(Math.floor(random() * 2 ** 32)));
    if (Number.isFinite(x)) return x;
  }
};

test("an address brings back the state that it was made of", () => {
  const letters = ["a", "&", "=", "#", "%", "∀", "\n", " ", "\\", "𝔽", "?", "+"];
  const text = () => Array.from({ length: Math.floor(random() * 12) }, () => pick(letters)).join("");
  for (let i = 0; i < 500; ++i) {
    const state = {
      ...start_state(),
      own: text(),
      ztext: text(),
      para: text(),
      p: [any_double(), any_double(), any_double()],
      v: [any_double(), 1, -0.125],
      ops: ["Agregar_Esfera e?=a", text().replaceAll("\n", "") + "x"],
      step: Math.floor(random() * 3),
      doubts: random() < 0.5,
      on: random() < 0.5 ? [] : ["ball", "a:b"],
      orbit: random() < 0.5 ? null : [1.5, -0.25, 8],
    };
    const { state: back, trouble } = state_of(address_of(state));
    assert.deepEqual(trouble, []);
    assert.deepEqual(back, state);
  }
  assert.equal(address_of(start_state()), "");
});

test("an address names what it does not know, and the rest holds", () => {
  const { state, trouble } = state_of("#view=walk&p=1,2&v=0,0,0&colour=red&step=9&file=%E0%A4%A&constructor=1");
  assert.deepEqual(trouble, ["p", "colour", "file", "constructor", "v"]);
  assert.equal(state.view, "walk");
  assert.deepEqual([state.p, state.v, state.step], [start_state().p, start_state().v, 0]);
});

test("binary64 as hexadecimal, as fractions, and with both neighbours", () => {
  for (const [x, said] of [
    [1, "0x1p+0"],
    [0, "0x0p+0"],
    [-0.1, "-0x1.999999999999ap-4"],
    [5e-324, "0x0.0000000000001p-1022"],
    [1.7976931348623157e308, "0x1.fffffffffffffp+1023"],
    [-0, "-0x0p+0"],
  ])
    assert.equal(numbers.hexadecimal(x), said);
  for (let i = 0; i < 2000; ++i) {
    const x = any_double(),
      up = numbers.next_up(x),
      [n, d] = numbers.fraction_of(x);
    assert.ok(up > x && (numbers.next_down(up) === x || x === 0));
    assert.equal(numbers.greatest_divisor(n, d), 1n);
    const size = d === 1n ? Number(n) : Number(n) / Number(d); // a quotient of two binary64, of which one is a power of two
    if (Math.abs(x) > 1e-290 && Math.abs(x) < 1e290) assert.equal(size, x);
  }
  for (const [x, n, power] of [
    [5e-324, 1n, 1074n],
    [2.2250738585072014e-308, 1n, 1022n],
    [-1.5e-323, -3n, 1074n],
  ])
    assert.deepEqual(numbers.fraction_of(x), [n, 1n << power]);
  assert.equal(numbers.next_up(-5e-324), -0);
  assert.equal(numbers.next_up(Infinity), Infinity);
});

test("numbers x + y√Δ are written with what is 0 or 1 left out", () => {
  for (const [x, y, d, said] of [
    ["4", "-1/2", "3", "4 − (1/2)·√3"],
    ["0", "1", "2", "√2"],
    ["0", "-1", "2/3", "−√(2/3)"],
    ["7/3", "0", "0", "7/3"],
    ["1", "2", "1", "3"],
    ["-1", "5", "7", "−1 + 5·√7"],
    ["1/2", "1/2", "1", "1"],
  ])
    assert.equal(numbers.quadratic_text(x, y, d), said);
  for (const wrong of ["", ".", "1/0", "a", "1e99999", "0x10", "1/-2"])
    assert.equal(numbers.rational(wrong), null, wrong);
  assert.deepEqual(numbers.rational("-0.125e1"), [-5n, 4n]);
});

test("the place of forty digits between two neighbours", () => {
  assert.equal(
    numbers.place_between("1.00000000000000011102230246251565404236316680908203125", 1, numbers.next_up(1)),
    0.5,
  );
  assert.equal(numbers.place_between("1", 1, numbers.next_up(1)), 0);
  assert.equal(numbers.place_between("-0.25", -1, 0), 0.75);
});

const predicates = [...readFileSync(join(root, "docs/spec-tool.md"), "utf8").matchAll(/`([^`]*[∀∃∈∪∧⇒•][^`]*)`/gu)]
  .map(m => m[1])
  .concat([
    "∀ w, centro : Punto; prop : Rmas; dir : Unitario; h : Rmas • potencia_cono (w, centro, prop, dir, h) = alejamiento (w, centro, dir) - cuadrado (prop * avance (w, centro, dir) - h * prop)",
    "dom mi_centro = de_que_tipo ∼ ⦇ {soy_esfera, soy_cilindro, soy_cono, soy_tronco, soy_plano, soy_disco} ⦈",
    'x\' = 0.5 ∧ "a-b" ∉ r! ∪ {e? ↦ t?}',
  ]);

test("tokens joined are the text, and a broken predicate loses no mark", () => {
  assert.ok(predicates.length > 5);
  for (const text of predicates) {
    assert.equal(z.tokens(text).join(""), text);
    for (const width of [20, 40, 60])
      assert.equal(
        z
          .indented(text, width)
          .map(l => l.text)
          .join("")
          .replace(/\s/g, ""),
        text.replace(/\s/g, ""),
      );
  }
  assert.deepEqual(z.tokens("r! = x' + t?"), ["r!", " ", "=", " ", "x'", " ", "+", " ", "t?"]);
  const balanced = text =>
    [..."({[⦉⦇"].every((open, i) => text.split(open).length === text.split([...")}]⦊⦈"][i]).length);
  for (const text of ["f (a ∧ b, c) ∧ g (d ∧ e, h) ∧ k = 1", "{x : ℕ | x > 1 ∧ x < 2} = y ∧ [a ∧ b] = c"])
    for (const line of z.indented(text, 24)) assert.ok(balanced(line.text), line.text);
  assert.ok(z.indented(predicates.at(-3), 58).length > 2);
  assert.ok(
    Math.max(
      ...z
        .indented("a_long_name ∧ another_name ∧ a_third_name_here ∧ {x : ℕ | x > 1 ∧ x < 2}", 30)
        .map(l => l.text.length),
    ) <= 30,
  );
});

test("LaTeX mark-up by its marks", () => {
  for (const [latex, said] of [
    ["  \\forall centro : Punto @", "  ∀ centro : Punto •"],
    ["puntos\\_cono(h) = \\{~ w : Punto | 0 \\leq w ~\\} \\\\", "puntos_cono(h) = {  w : Punto | 0 ≤ w  } "],
    ["\\begin{axdef}", "┌{axdef}"],
    ["\\t1 x \\unknown y", "   x \\unknown y"],
    ["\\inverse \\in", "\\inverse ∈"],
  ])
    assert.equal(z.in_unicode(latex), said);
});

test("a text without its conjectures is the same but for them", () => {
  assert.equal(
    z.without_conjectures(
      "a\n\\begin{zed}\n  \\vdash? \\forall x : \\nat @ x = x\n\\end{zed}\nb \\begin{zed} [X] \\end{zed}",
    ),
    "a\n\nb \\begin{zed} [X] \\end{zed}",
  );
  assert.equal(z.without_conjectures("─\n⊢? ∀ x : ℕ ⦁ x = x\n└\n─\n[X]\n└\n"), "\n─\n[X]\n└\n");
});

test("what a name marks in the picture", () => {
  for (const [name, marks] of [
    ["puntos_esfera", "tipo:esfera"],
    ["Agregar_Cono", "tipo:cono"],
    ["soy_disco", "tipo:disco"],
    ["rayo?", "ray"],
    ["punto!", "first"],
    ["radio?", ""],
    ["esfera", ""],
    ["constructor", ""],
    ["mi_radio'", ""],
  ])
    assert.equal(z.marks_of(name), marks, name);
});

test("the triangles of each shape lie on it", () => {
  const first = JSON.parse(readFileSync(join(root, "web/examples/first.json"), "utf8")),
    { meshes, left_out } = drawn.drawn_of(first);
  assert.deepEqual(left_out, []);
  assert.equal(meshes.length, 7);
  const near = (a, b) => assert.ok(Math.abs(a - b) < 1e-9, `${a} is not ${b}`);
  for (const mesh of meshes) {
    const e = first.elementos.find(x => x.id === mesh.id);
    assert.ok(mesh.indices.every(i => i < mesh.positions.length / 3));
    for (let i = 0; i < mesh.positions.length; i += 3) {
      const p = mesh.positions.slice(i, i + 3),
        n = mesh.normals.slice(i, i + 3),
        q = vectors.sub(p, e.centro ?? e.vertices[0]);
      near(vectors.long(n), 1);
      const s = e.vector ? vectors.dot(q, e.vector) : 0,
        out = e.vector ? vectors.long(vectors.sub(q, vectors.times(e.vector, s))) : 0;
      if (e.tipo === "esfera") near(vectors.long(q), e.radio);
      if (e.tipo === "cilindro") near(out, e.radio);
      if (e.tipo === "cono") near(out, e.proporcion * (e.altura - s));
      if (e.tipo === "tronco") near(out, e.radio + e.proporcion * (e.altura - s));
      if (["plano", "disco"].includes(e.tipo)) near(s, 0);
      if (e.tipo === "disco") assert.ok(out <= e.radio + 1e-9);
      if (e.altura && out > 0)
        near(
          vectors.dot(
            n,
            vectors.sub(e.vector, vectors.times(vectors.sub(q, vectors.times(e.vector, s)), (e.proporcion ?? 0) / out)),
          ),
          0,
        );
      if (e.altura) assert.ok(s >= -1e-9 && s <= e.altura + 1e-9);
    }
  }
});

test("an instance is the image of its original, and what has no mesh is named", () => {
  const scene = {
    elementos: [
      { id: "a", tipo: "esfera", centro: [0, 0, 0], radio: 1 },
      {
        id: "b",
        tipo: "instancia",
        de: "a",
        mapa: [
          [2, 0, 0, "1/2"],
          [0, 1, 0, 0],
          [0, 0, -1, 0],
        ],
      },
      { id: "c", tipo: "escrita", de: "a" },
    ],
  };
  const { meshes, left_out } = drawn.drawn_of(scene),
    b = meshes.find(m => m.id === "b");
  assert.deepEqual(left_out, ["c"]);
  for (let i = 0; i < b.positions.length; i += 3)
    assert.ok(
      Math.abs(((b.positions[i] - 0.5) / 2) ** 2 + b.positions[i + 1] ** 2 + b.positions[i + 2] ** 2 - 1) < 1e-9,
    );
  for (let i = 0; i < b.positions.length; i += 3) assert.ok((b.positions[i] - 0.5) * b.normals[i] >= -1e-12); // outwards, though the map mirrors
});

// A solid's triangles: in front of each, along its normal, is no point of the solid, and behind it is one. Beside an edge of the
// solid a triangle's middle may be too near to it for the step; these are small.
const ball = (p, middle, radius) => Math.hypot(...vectors.sub(p, middle)) - radius;
const cup = p => Math.max(ball(p, [-3, 1, 0], 1), p[1] - 1.25, -ball(p, [-3, 1.25, 0], 0.75));
const outside_of = {
  lens: p => Math.max(ball(p, [0, 1, -3], 3.25), ball(p, [0, 1, 3], 3.25)),
  block: p =>
    Math.max(...vectors.sub(p, [3, 1, 0]).map(x => Math.abs(x) - 1), 0.5 - Math.hypot(p[0] - 3, p[2])),
  walls: p => outside_of.block(p),
  cup,
  moved_cup: p => cup([(p[0] - 1.5) / 0.5, p[1], p[2] - 5]),
};
test("the triangles of a solid lie on the surface of the whole", () => {
  const document = readFileSync(join(root, "docs/formats/scene.md"), "utf8");
  const scene = JSON.parse(document.match(/<!-- file solids.json -->\n```json\n([^]*?)```/)[1]);
  // The engine gives a box as what is behind six planes.
  const { esquinas } = scene.elementos.find(e => e.id === "block").de[0],
    walls = [0, 1, 2].flatMap(k =>
      [0, 1].map(side => ({
        tipo: "plano",
        centro: esquinas[side],
        vector: [0, 1, 2].map(i => (i === k ? 2 * side - 1 : 0)),
      })),
    );
  const block = { ...scene.elementos.find(e => e.id === "block"), id: "walls" };
  scene.elementos.push({ ...block, de: [{ tipo: "interseccion", de: walls }, block.de[1]] });
  const mapa = [
    ["1/2", 0, 0, 1.5],
    [0, 1, 0, 0],
    [0, 0, 1, 5],
  ];
  scene.elementos.push({ id: "moved_cup", tipo: "instancia", de: "cup", mapa });
  const { meshes, left_out } = drawn.drawn_of(scene);
  assert.deepEqual(left_out, []);
  for (const [id, outside] of Object.entries(outside_of)) {
    const { positions, normals, indices } = meshes.find(m => m.id === id),
      middle = (list, corners) =>
        [0, 1, 2].map(k => corners.map(i => list[3 * i + k]).reduce((sum, x) => sum + x) / 3);
    let area = 0,
      wrong = 0;
    for (let i = 0; i < indices.length; i += 3) {
      const corners = indices.slice(i, i + 3),
        p = middle(positions, corners),
        n = vectors.times(vectors.unit(middle(normals, corners)), 0.02);
      const [a, b, c] = corners.map(k => positions.slice(3 * k, 3 * k + 3)),
        own = vectors.long(vectors.cross(vectors.sub(b, a), vectors.sub(c, a))) / 2;
      area += own;
      if (outside(vectors.add(p, n)) <= 0 || outside(vectors.sub(p, n)) >= 0) wrong += own;
    }
    assert.ok(indices.length > 2000, `${id} has ${indices.length / 3} triangles`);
    assert.ok(wrong < area / 50, `${id}: ${wrong} of its area ${area} is not of it`);
    console.log(`${id}: ${indices.length / 3} triangles, area ${area}, ${wrong} beside an edge`);
  }
});

test("the ray through a pixel goes through that pixel", () => {
  const scene = JSON.parse(readFileSync(join(root, "web/examples/first.json"), "utf8"));
  for (const mirrored of [false, true]) {
    const frame = scene_window.frame_of({ ...scene, camera: { ...scene.camera, mirrored } });
    for (let column = 0; column < frame.width; column += 7)
      for (let row = 0; row < frame.height; row += 7) {
        const found = scene_window.pixel_of(frame, frame.eye, scene_window.through_pixel(frame, column, row));
        assert.deepEqual([found.column, found.row], [column, row]);
      }
    assert.equal(scene_window.pixel_of(frame, [0, 0, 0], [0, 0, 1]), null);
    assert.equal(scene_window.pixel_of(frame, frame.eye, vectors.times(frame.forward, -1)), null);
  }
});

test("states in layers by their distance from the first", () => {
  const states = [{ initial: true }, {}, {}, {}],
    steps = [
      { from: 0, to: 1 },
      { from: 1, to: 2 },
      { from: 0, to: 2 },
      { from: 2, to: 3 },
      { from: 3, to: 0 },
    ];
  assert.deepEqual(machine.layers_of(states, steps), [[0], [1, 2], [3]]);
  const { place } = machine.places_of(states, steps);
  assert.equal(new Set([...place.values()].map(String)).size, 4);
});

test("the judge of a shader's pixels", () => {
  const hits = [
    { outcome: "hit", elementos: ["a"] },
    { outcome: "hit", elementos: ["b"] },
    { outcome: "miss", elementos: [] },
    { outcome: "miss", elementos: [] },
    { outcome: "hit", elementos: ["a", "b"] },
  ];
  const found = [1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 2, 1, 0, 1, 1, 0, 0, 1],
    { count, kinds } = shader.judged(found, hits, ["a", "b"]);
  assert.deepEqual(count, { doubtful: 1, equal: 2, wrong: 2 });
  assert.deepEqual([...kinds], [0, 2, 0, 1, 2]);
  const rays = shader.rays_of({
    eye: [1, 2, 3],
    forward: [0, 0, 1],
    step_x: [0.5, 0, 0],
    step_y: [0, 0.25, 0],
    size: [2, 2],
  });
  assert.deepEqual(rays, [
    [1, 2, 3, -0.25, -0.125, 1],
    [1, 2, 3, 0.25, -0.125, 1],
    [1, 2, 3, -0.25, 0.125, 1],
    [1, 2, 3, 0.25, 0.125, 1],
  ]);
});

test("the documents of the walk have their sections and rows", () => {
  const text = readFileSync(join(root, "docs/refinement.md"), "utf8");
  for (const heading of ["A ray: `Primera_Interseccion`", "An operation: `Agregar_Esfera`"]) {
    const rows = marked.rows_of(marked.section_of(text, heading));
    assert.ok(rows.length > 8 && rows.every(row => row.length === 4 && !row[0].startsWith("---")), heading);
  }
  const walk = readFileSync(join(root, "web/walk.js"), "utf8"),
    starts = [...walk.matchAll(/^ +(?:"((?:[^"\\]|\\.)+)"): (?:\(|answer)/gm)].map(m => m[1]);
  assert.ok(starts.length > 15);
  const rows = ["A ray:", "An operation:"].flatMap(h => marked.rows_of(marked.section_of(text, h)));
  for (const start of starts)
    assert.ok(
      rows.some(row => row[0].startsWith(start)),
      `no step begins with ${start}`,
    );
});

test("each word that the page says is there in both languages, and none is left over", () => {
  const sources = readdirSync(join(root, "web"))
    .filter(f => f.endsWith(".js") && f !== "words.js")
    .map(f => readFileSync(join(root, "web", f), "utf8"))
    .join("\n");
  const exact = new Set([...sources.matchAll(/say\(\s*"([a-z_0-9]+)"\s*\)/g)].map(m => m[1])),
    quoted = new Set([...sources.matchAll(/"([a-z_0-9]+)"/g)].map(m => m[1]));
  for (const key of exact) assert.ok(words.words[key], `no words for ${key}`);
  const families = ["ex_", "view_", "scene_", "theme_", "status_", "here_", "drawn_", "outcome_", "step_", "walk_"];
  for (const [key, [english, spanish]] of Object.entries(words.words)) {
    assert.ok(english.trim() && spanish.trim(), key);
    assert.ok(quoted.has(key) || families.some(f => key.startsWith(f)), `${key} is said nowhere`);
  }
  for (const x of exercises.exercises)
    for (const text of words.words["ex_" + x.id]) assert.equal(text.split("|").length, 2);
});

test("the page is one file that asks no other", { skip: !out }, () => {
  execFileSync("sh", [join(root, "web/build.sh"), out]);
  const page = readFileSync(join(out, "index.html"), "utf8");
  for (const left of ["@STYLE@", "@SCRIPT@", "@ENGINE@"]) assert.ok(!page.includes(left), left);
  const frame = page.slice(0, page.indexOf("const documents = ")),
    scripts = page.slice(page.indexOf("const modules = {}"));
  for (const other of ["http:", "https:", "src=", "@import", "fetch(", "import("])
    assert.ok(!frame.includes(other) && !scripts.replace("http://www.w3.org/2000/svg", "").includes(other), other);
  assert.deepEqual(page.match(/<\/script/g).length, 2);
});

// counting_module: a module of WebAssembly that has the engine's functions. Its call counts in a global, answers the count by
// one digit at address 0, and is stopped by the machine at each second call.
function counting_module() {
  const section = (id, ...items) => [id, items.flat().length + 1, items.length, ...items.flat()];
  const name = (text, kind, index) => [text.length, ...new TextEncoder().encode(text), kind, index];
  const body = (...code) => [code.length + 2, 0, ...code, 0x0b];
  const [no_result, to_i32, i32_to_i32] = [0, 1, 2];
  const count = [0x23, 0];
  return Uint8Array.from([
    ...[0, 0x61, 0x73, 0x6d, 1, 0, 0, 0],
    ...section(1, [0x60, 0, 0], [0x60, 0, 1, 0x7f], [0x60, 1, 0x7f, 1, 0x7f]),
    ...section(3, [no_result], [i32_to_i32], [to_i32], [to_i32]),
    ...section(5, [0, 1]),
    ...section(6, [0x7f, 1, 0x41, 0, 0x0b]),
    ...section(7, name("_initialize", 0, 0), name("room", 0, 1), name("call", 0, 2), name("length", 0, 3), name("memory", 2, 0)),
    ...section(
      10,
      body(),
      body(0x41, 32), // i32.const 32
      body(
        ...[...count, 0x41, 1, 0x6a, 0x24, 0], // count + 1, set
        ...[...count, 0x41, 2, 0x46, 0x04, 0x40, 0x00, 0x0b], // = 2: unreachable
        ...[0x41, 0, ...count, 0x41, 48, 0x6a, 0x3a, 0, 0], // the digit at address 0
        ...[0x41, 0],
      ),
      body(0x41, 1),
    ),
  ]);
}

test("a module that the machine stops is told of, and starts anew", async () => {
  const text = readFileSync(join(root, "web/engine.js"), "utf8").replace(/^if \(typeof module.*$/m, "");
  const packed = gzipSync(counting_module()).toString("base64");
  const engine = new Function(`${text}\nconst module_text = "${packed}";\nreturn { start, call };`)();
  await engine.start();
  assert.equal(engine.call({}), 1);
  const stopped = engine.call({});
  assert.match(stopped.error, /^call:1:1: the engine stopped, unreachable/);
  assert.deepEqual([stopped.source, stopped.line, stopped.column], ["call", 1, 1]);
  assert.equal(engine.call({}), 1, "a new instance, which has counted nothing");
  assert.match(engine.call({}).error, /stopped/);
});
