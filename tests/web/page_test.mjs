// The whole page in Chromium, with the native engine in the place of the WebAssembly: what a reader does, and what is seen.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { gzipSync } from "node:zlib";
import { after, before, test } from "node:test";
import { give_engine, native_engine, start_browser } from "./browser.mjs";

const root = process.env.DURERO_ROOT,
  out = process.env.DURERO_OUT,
  engine = native_engine(process.env.DURERO_CALL);
let page;
const address = `file://${out}/index.html`;
const open = async hash => {
  await page.ask("Page.navigate", { url: "about:blank" });
  await page.ask("Page.navigate", { url: address + hash });
  await page.until("document.body?.dataset.ready === '1'");
};
const state = key => page.evaluate(`dureroPage.state.${key}`);
const click = selector => page.evaluate(`document.querySelector(${JSON.stringify(selector)}).click()`);
const settled = () =>
  page.until(
    "dureroPage.facts.ray && dureroPage.facts.asked.v.every((x, i) => x === dureroPage.state.v[i]) && dureroPage.facts.asked.p.every((x, i) => x === dureroPage.state.p[i])",
  );
const type = (selector, text) =>
  page.evaluate(
    `{ const e = document.querySelector(${JSON.stringify(selector)}); e.value = ${JSON.stringify(text)}; e.dispatchEvent(new Event("input", { bubbles: true })); e.dispatchEvent(new Event("change", { bubbles: true })); }`,
  );
const picture = name => page.picture(join(out, `${name}.png`));

before(async () => {
  execFileSync("sh", [join(root, "web/build.sh"), out]);
  page = await start_browser(process.env.DURERO_CHROMIUM);
  await give_engine(page, engine.call);
});
after(async () => {
  engine.close();
  await page.close();
});

test("it opens from the disk, asks no other place, and prints no error", async () => {
  await open("");
  await settled();
  await picture("wide");
  assert.deepEqual(page.errors, []);
  assert.deepEqual(
    page.asked.filter(url => !/^(file|blob|data|about):/.test(url)),
    [],
  );
  assert.match(await page.evaluate("document.querySelector('.outcome').textContent"), /t = /);
});

test("a handle is dragged: the ray, its crossings and the picture follow, as the tracer has them", async () => {
  await open("");
  await settled();
  for (const handle of ["#handle-target", "#handle-origin"]) {
    const before_v = await state("v"),
      at = await page.middle(handle);
    await page.drag(at, [-46, 22]);
    await settled();
    const [p, v] = [await state("p"), await state("v")];
    assert.notDeepEqual(v, before_v);
    const { hits } = await engine.call({
      call: "trace",
      scene: await page.evaluate("dureroPage.facts.scene_text"),
      rays: [[...p, ...v]],
    });
    assert.deepEqual(await page.evaluate("dureroPage.facts.ray.hit"), hits[0]);
    const now = await page.middle(handle);
    assert.ok(
      Math.abs(now[0] - at[0] + 46) < 4 && Math.abs(now[1] - at[1] - 22) < 4,
      `${handle} is at ${now}, and was at ${at}`,
    );
  }
  await picture("dragged");
});

test("a handle moves by the keys, on multiples of 1/64", async () => {
  await open("");
  await settled();
  await page.evaluate("document.querySelector('#handle-target').focus()");
  const old = await state("v");
  await page.key("ArrowRight");
  await settled();
  const v = await state("v"),
    p = await state("p");
  assert.notDeepEqual(v, old);
  assert.ok(v.every((x, i) => Number.isInteger(64 * (x + p[i]))));
});

test("a pixel is aimed at, and the ray goes through it", async () => {
  await open("");
  await settled();
  await type("#pixel-column", "20");
  await click("[data-key=aim]");
  await settled();
  assert.ok((await page.evaluate("document.querySelector('.signs').textContent")).includes("pixel 20, "));
  assert.deepEqual(await state("p"), [-3, 2, -7]);
});

test("a wrong number is refused where it stands", async () => {
  await open("");
  await settled();
  const old = await state("v");
  await type("[data-key=v0]", "up");
  assert.equal(await page.evaluate("document.querySelector('[data-key=v0]').getAttribute('aria-invalid')"), "true");
  assert.deepEqual(await state("v"), old);
  await open("#v=0,0,0");
  assert.match(await page.evaluate("document.querySelector('#said').textContent"), /v/);
});

test("an operation that is refused turns its clause red, in the text and in the picture", async () => {
  await open("");
  await type("[data-key='Agregar_Esfera radio']", "0");
  await click("[data-key=apply]");
  await page.until("document.querySelector('.pred.fails')");
  assert.equal(await page.evaluate("document.querySelector('.pred.fails').id"), "p-Agregar_Esfera.pre.2");
  await page.until("document.querySelector('.sign.refused')?.textContent === 'Agregar_Esfera.pre.2'");
  const colour = await page.evaluate("getComputedStyle(document.querySelector('.pred.fails .pred-text')).color");
  assert.equal(colour, "rgb(179, 38, 30)");
  const [panel, clause] = await page.evaluate(
    "['#text-scroll', '.pred.fails'].map(s => { const b = document.querySelector(s).getBoundingClientRect(); return [b.top, b.bottom]; })",
  );
  assert.ok(clause[0] >= panel[0] && clause[1] <= panel[1], `the clause is at ${clause}, and its panel at ${panel}`);
  await picture("refused");
  await type("#slider", "0");
  await page.until("!document.querySelector('.pred.fails') && !document.querySelector('.sign.refused')");
  await type("[data-key='Agregar_Esfera radio']", "0.5");
  await click("[data-key=apply]");
  await page.until("dureroPage.facts.scene.elementos.some(e => e.id === 'moon')");
  assert.equal((await state("ops")).length, 1);
});

test("a clause is evaluated in the scene, with its parts", async () => {
  await page.evaluate("dureroPage.change({ file: 'spec/escena.tex', para: 'Escena', label: 'Escena.inv.3' })");
  await page.until("document.querySelector('#z-Escena .card [data-key=explain]')");
  await click("#z-Escena .card [data-key=explain]");
  await page.until("document.querySelector('.card .tree .value.holds')");
  assert.ok(
    await page.evaluate(
      "document.querySelector('.card .theorem') !== null && document.querySelector('.card').textContent.includes('tests/model/')",
    ),
  );
  await picture("explained");
});

test("a name leads to its paragraph, in whichever file and box it stands", async () => {
  await open("");
  for (const name of ["potencia_cilindro", "Punto", "Primera_Interseccion"]) {
    await type("#seek", name);
    await page.evaluate("document.querySelector('[role=search]').requestSubmit()");
    await page.until(`document.querySelector(".zbox.chosen")?.textContent.includes("${name}")`);
    const [panel, box] = await page.evaluate(
      "['#text-scroll', '.zbox.chosen'].map(s => { const b = document.querySelector(s).getBoundingClientRect(); return [b.top, b.bottom]; })",
    );
    assert.ok(box[0] < panel[1] && box[1] > panel[0], `${name} is at ${box}, and its panel at ${panel}`);
  }
  await page.evaluate("dureroPage.change({ file: 'spec/escena.tex', para: 'Escena', label: '' })");
  await page.until("[...document.querySelectorAll('#z-Escena a')].some(a => a.textContent === 'Punto')");
});

test("what the pointer is over in the text is marked in the picture", async () => {
  const seen = () =>
    page.evaluate(
      "new Promise(done => requestAnimationFrame(() => requestAnimationFrame(() => done(document.querySelector('#picture').toDataURL().length + document.querySelector('#picture').toDataURL().slice(-6000)))))",
    );
  await open("");
  await settled();
  const bare = await seen(),
    at = await page.middle("#inspector .chip");
  await page.ask("Input.dispatchMouseEvent", { type: "mouseMoved", x: at[0], y: at[1] });
  await new Promise(done => setTimeout(done, 150));
  assert.notEqual(await seen(), bare);
});

test("a reader's own text: defects at their lines, then steps, states and a graph", async () => {
  await open("#view=own");
  const book = readFileSync(join(root, "demo/birthday_book.tex"), "utf8");
  await type("#own-text", book.replace("known = \\dom birthday", "known = \\dom birthdays"));
  await page.until("document.querySelector('#own-answers .defects li button')");
  assert.equal(
    await page.evaluate("document.querySelector('#own-answers .defects li button').textContent.split(':')[0]"),
    String(book.slice(0, book.indexOf("known = \\dom")).split("\n").length),
  );
  await type("#own-text", book);
  await page.until("document.querySelector('.machine-operation')");
  await type("[data-key='AddBirthday name?']", "NAME1");
  await type("[data-key='AddBirthday date?']", "DATE2");
  await click("[data-key=opAddBirthday]");
  await page.until("document.querySelectorAll('.states tbody tr').length === 2");
  assert.ok(
    await page.evaluate(
      "[...document.querySelectorAll('.states td.changed')].some(td => td.textContent === '{NAME1 ↦ DATE2}')",
    ),
  );
  await click("[data-key=graph]");
  await page.until("document.querySelectorAll('.graph .node').length > 3");
  await picture("own");
  await click("[data-key=back]");
  await page.until("document.querySelectorAll('.states tbody tr').length === 1");
});

test("an exercise is judged by what it means", async () => {
  await open("#view=exercises&exercise=near");
  await type("[data-key=anear]", "x > 7 ∧ x ≤ 13");
  await click("[data-key=jnear]");
  await page.until("document.querySelector('.exercise.wrong .value.witness')");
  assert.match(await page.evaluate("document.querySelector('.exercise.wrong .value.witness').textContent"), /x == 7/);
  await picture("exercise");
  await type("[data-key=anear]", "x * x - 20 * x + 91 ≤ 0");
  await click("[data-key=jnear]");
  await page.until("document.querySelector('.exercise.right')");
});

test("E10 and E11 are drawn as printed and as corrected, and differ", async () => {
  for (const name of ["E10", "E11"]) {
    await open(`#view=printed&erratum=${name}`);
    await page.until(
      "document.querySelectorAll('figure canvas').length === 2 && [...document.querySelectorAll('figure canvas')].every(c => c.dataset.painted) && ![...document.querySelectorAll('figcaption')].some(c => c.textContent.includes('…'))",
      120000,
    );
    const [printed, corrected] = await page.evaluate(
      "[...document.querySelectorAll('figure canvas')].map(c => c.toDataURL())",
    );
    assert.ok(printed.length > 800 && corrected.length > 800);
    assert.notEqual(printed, corrected);
    await picture(`printed-${name}`);
  }
});

test("a surface is drawn while it is typed, and a fault is told at its place", async () => {
  await open("#view=surface");
  await page.until("document.querySelector('#surface-said.good')", 120000);
  const torus = await page.evaluate("document.querySelector('#surface-canvas').toDataURL()"),
    text = await page.evaluate("document.querySelector('#surface-text').value");
  await type("#surface-text", text.replace("cuadrado(menor)) - ", "cuadrado(menr)) - "));
  await page.until("document.querySelector('#surface-said.fault')");
  assert.match(await page.evaluate("document.querySelector('#surface-said').textContent"), /^\w+:\d+:\d+: .*menr/);
  await type(
    "#surface-text",
    text.replace("menor < mayor", "menor < 2 * mayor").replace("4 * cuadrado(mayor)", "5 * cuadrado(mayor)"),
  );
  await page.until("document.querySelector('#surface-said.good')", 120000);
  await page.until(`document.querySelector('#surface-canvas').toDataURL() !== ${JSON.stringify(torus)}`);
  await picture("surface");
});

test("a shader's elements are the exact ones on all but doubtful pixels", async () => {
  await open("#view=shader");
  await page.until("document.querySelector('#shader-canvas') && !document.querySelector('#compare').disabled");
  await new Promise(done => setTimeout(done, 1500));
  assert.equal(await page.evaluate("document.querySelector('#shader-trouble').hidden"), true);
  await click("#compare");
  await page.until("document.querySelectorAll('#shader-said li').length === 3", 120000);
  const [equal, doubtful, wrong] = await page.evaluate(
    "[...document.querySelectorAll('#shader-said li')].map(li => parseInt(li.textContent))",
  );
  assert.equal(wrong, 0);
  assert.ok(equal > 5000 && doubtful < 400, `${equal} equal, ${doubtful} doubtful`);
  await picture("shader");
  // A ball twice: each of its pixels meets two elements at one point, and the certificate says that it cannot tell.
  const twin = encodeURIComponent("Agregar_Esfera e?=twin centro?=(-0.5,1,0) radio?=1");
  await open(`#view=shader&step=1&doubts=1&ops=${twin}`);
  await page.until("document.querySelector('#shader-canvas')");
  await new Promise(done => setTimeout(done, 1500));
  await click("#compare");
  await page.until("document.querySelectorAll('#shader-said li').length === 3", 120000);
  const counts = await page.evaluate(
    "[...document.querySelectorAll('#shader-said li')].map(li => parseInt(li.textContent))",
  );
  assert.ok(counts[1] > 100 && counts[2] === 0, `${counts[1]} doubtful, ${counts[2]} wrong`);
  await picture("shader-doubts");
});

test("the walk has the values of the reader's own ray at each step", async () => {
  await open("#view=walk&p=0,1,-4&v=0,0,1");
  await page.until(
    "document.querySelectorAll('.walk-step .live').length > 8 && ![...document.querySelectorAll('.walk-step .live')].some(l => l.textContent.includes('…'))",
    120000,
  );
  const said = await page.evaluate("[...document.querySelectorAll('.walk-step')].map(s => s.textContent).join('\\n')"),
    t = await page.evaluate("dureroPage.facts.ray.hit.t");
  assert.ok(said.includes(`t = ${t}`));
  const bytes = Buffer.alloc(8);
  bytes.writeDoubleBE(t);
  assert.ok(said.includes(bytes.toString("hex").match(/../g).join(" ")));
  await picture("walk");
});

test("a scene as text: a fault is told at its place, and another scene is shown", async () => {
  await open("");
  await click("[data-key=scenetext]");
  const text = await page.evaluate("document.querySelector('#scene-dialog textarea').value");
  await type("#scene-dialog textarea", text.replace('"radio":1,', '"radio":-1,'));
  await click("#use-scene");
  assert.match(
    await page.until("document.querySelector('#scene-dialog [role=alert]').textContent"),
    /^scene:\d+:\d+: radio.* is -1/,
  );
  await type("#scene-dialog textarea", text.replace('"radio":1,', '"radio":0.25,'));
  await click("#use-scene");
  await page.until(
    "!document.querySelector('#scene-dialog') && dureroPage.facts.scene.elementos.find(e => e.id === 'ball').radio === 0.25",
  );
  assert.equal(await state("scene"), "own");
});

test("the address brings everything back", async () => {
  await open("");
  await page.evaluate(
    "dureroPage.change({ ops: ['Agregar_Esfera e?=moon centro?=(0,4,0) radio?=0.5'], step: 1, p: [0, 4, -8], v: [0, 0, 1], lang: 'es', theme: 'dark' })",
  );
  await settled();
  await page.until("location.hash.includes('lang=es')");
  const hash = await page.evaluate("location.hash"),
    old = await page.evaluate("JSON.stringify(dureroPage.state)");
  await open(hash);
  await settled();
  assert.equal(await page.evaluate("JSON.stringify(dureroPage.state)"), old);
  assert.deepEqual(await page.evaluate("dureroPage.facts.ray.hit.elementos"), ["moon"]);
  assert.equal(await page.evaluate("document.documentElement.lang + document.documentElement.dataset.theme"), "esdark");
  assert.match(await page.evaluate("document.querySelector('#head nav').textContent"), /Escena/);
  await picture("dark");
});

test("each control has a name, in both languages", async () => {
  for (const lang of ["en", "es"]) {
    await open(`#lang=${lang}&exercise=near`);
    for (const view of ["scene", "own", "exercises", "surface", "shader", "walk", "printed"]) {
      await page.evaluate(`dureroPage.change({ view: "${view}" })`);
      const held = await page.until(
        `document.querySelectorAll("#${view} :is(button, input, select, textarea, canvas)").length`,
      );
      const bare = await page.evaluate(
        `[...document.querySelectorAll("main > section:not([hidden]) :is(button, input, select, textarea, canvas, [role=img])")].filter(e => e.offsetParent !== null && !(e.textContent.trim() || e.getAttribute("aria-label") || e.closest("label")?.textContent.trim())).map(e => e.outerHTML.slice(0, 120))`,
      );
      assert.ok(held > 0);
      assert.deepEqual(bare, [], `${view} in ${lang}`);
    }
  }
});

test("on a telephone nothing is wider than the screen, light and dark", async () => {
  for (const [name, dark] of [
    ["light", false],
    ["dark", true],
  ]) {
    await page.show(390, 844, { scale: 2, dark, phone: true });
    await open("");
    for (const view of ["scene", "printed", "walk", "own", "exercises", "surface", "shader"]) {
      await page.evaluate(`dureroPage.change({ view: "${view}" })`);
      await new Promise(done => setTimeout(done, 500));
      assert.equal(await page.evaluate("Math.max(document.documentElement.scrollWidth, innerWidth)"), 390, view);
      await picture(`phone-${view}-${name}`);
    }
  }
  await page.show(1440, 900);
});

test("a drag's frame, beside an empty one", async () => {
  const more = [1, 2, 3].map(i => `Agregar_Esfera e?=more${i} centro?=(${i},3,0) radio?=0.25`).join("\n");
  await open(`#step=3&ops=${encodeURIComponent(more)}`);
  await settled();
  const measured = await page.evaluate(`(async () => {
    const frames = async work => {
      const times = [];
      for (let i = 0; i < 40; ++i) {
        await new Promise(done => requestAnimationFrame(done));
        const began = performance.now();
        work(i);
        times.push(performance.now() - began);
      }
      return times.sort((a, b) => a - b)[20];
    };
    const empty = await frames(() => { dureroPage.stage.gl.clear(dureroPage.stage.gl.COLOR_BUFFER_BIT); dureroPage.stage.gl.finish(); });
    const drag = await frames(i => { dureroPage.change({ v: [4, -1.25 + i / 64, 5.5] }, false); dureroPage.stage.render_now(); dureroPage.stage.gl.finish(); });
    return { empty, drag, elements: dureroPage.facts.scene.elementos.length };
  })()`);
  console.log(
    `drag ${measured.drag.toFixed(2)} ms, empty frame ${measured.empty.toFixed(2)} ms, ${measured.elements} elements`,
  );
  assert.equal(measured.elements, 10);
  assert.ok(
    measured.drag <= 16 + 8 * measured.empty,
    "a drag's frame takes 16 ms at most, and more where an empty one takes long too",
  );
});

test("an engine that does not start, or does not answer, is told of", async () => {
  const own = await start_browser(process.env.DURERO_CHROMIUM),
    folder = join(out, "failing");
  mkdirSync(folder, { recursive: true });
  const engines = [
    ["async function start() { throw new Error('no memory'); }", /no memory/],
    ["async function start() {} function call() { return { error: 'call:1:1: tired' }; }", /call:1:1: tired/],
    ["", /without its engine/],
  ];
  try {
    for (const [body, said] of engines) {
      writeFileSync(join(folder, "engine.js"), body);
      execFileSync("sh", [join(root, "web/build.sh"), folder, ...(body ? [join(folder, "engine.js")] : [])]);
      await own.ask("Page.navigate", { url: "about:blank" });
      await own.ask("Page.navigate", { url: `file://${folder}/index.html` });
      assert.match(
        await own.until("(t => t?.includes(': ') && t)(document.querySelector('#said')?.textContent)"),
        said,
      );
    }
    assert.deepEqual(own.errors, []);
  } finally {
    await own.close();
  }
});

test(
  "with its own engine in it, the page answers as the native program",
  { skip: !process.env.DURERO_ENGINE && "no engine is built" },
  async () => {
    const own = await start_browser(process.env.DURERO_CHROMIUM),
      folder = join(out, "own");
    try {
      execFileSync("sh", [join(root, "web/build.sh"), folder, process.env.DURERO_ENGINE]);
      await own.ask("Page.navigate", { url: `file://${folder}/index.html` });
      await own.until(
        "globalThis.dureroPage?.facts?.ray || document.querySelector('#said')?.textContent.includes(':')",
      );
      const first = await own.until("globalThis.dureroPage?.facts?.first");
      await own.until("document.body?.dataset.ready === '1'");
      await own.drag(await own.middle("#handle-target"), [-60, 30]);
      await own.until(
        "dureroPage.facts.asked.v.every((x, i) => x === dureroPage.state.v[i]) && dureroPage.facts.light",
      );
      const question = await own.evaluate("dureroPage.facts.asked");
      assert.deepEqual(await own.evaluate("dureroPage.facts.ray"), await engine.call(question));
      const took = await own.evaluate(`(async () => {
      const times = [];
      for (let i = 0; i < 30; ++i) {
        const began = performance.now();
        dureroPage.change({ v: [4, -1.25 + i / 64, 5.5] }, false);
        while (!(dureroPage.facts.asked.v[1] === -1.25 + i / 64)) await new Promise(done => setTimeout(done, 0));
        times.push(performance.now() - began);
      }
      return times.sort((a, b) => a - b)[15];
    })()`);
      const packed = gzipSync(readFileSync(join(folder, "index.html")), { level: 9 }).length;
      console.log(
        `first answer ${Math.round(first)} ms after the start, a drag's answer ${took.toFixed(1)} ms, ${packed} bytes compressed`,
      );
      assert.ok(packed <= 4 * 2 ** 20, `${packed} bytes compressed; expected 4 MiB at most`);
      assert.deepEqual(own.errors, []);
      assert.deepEqual(
        own.asked.filter(url => !/^(file|blob|data|about):/.test(url)),
        [],
      );
    } finally {
      await own.close();
    }
  },
);

test("at the end, still no error", () => assert.deepEqual(page.errors, []));
