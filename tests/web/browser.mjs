// Chromium without a window, driven over its own pipe: messages of the DevTools protocol with a zero byte behind each.
import { spawn } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

const options = [
  "--headless",
  "--no-sandbox",
  "--disable-gpu",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
  "--no-first-run",
  "--use-gl=angle",
  "--use-angle=swiftshader",
  "--enable-unsafe-swiftshader",
  "--disable-extensions",
  "--hide-scrollbars",
  "--remote-debugging-pipe",
];

// start_browser gives a page; whatever the page prints as an error is kept in `errors`, whatever it fetches in `asked`.
export async function start_browser(program, { width = 1440, height = 900, scale = 1, dark = false } = {}) {
  const profile = mkdtempSync(join(tmpdir(), "durero-web-"));
  const child = spawn(program, [...options, `--user-data-dir=${profile}`, `--window-size=${width},${height}`], {
    stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"],
  });
  const [, , , into, out] = child.stdio,
    waiting = new Map(),
    listeners = new Map();
  let last = 0,
    rest = Buffer.alloc(0);
  out.on("data", data => {
    rest = Buffer.concat([rest, data]);
    for (let end; (end = rest.indexOf(0)) >= 0;) {
      const message = JSON.parse(rest.subarray(0, end).toString());
      rest = rest.subarray(end + 1);
      if (message.id) {
        const { done, failed } = waiting.get(message.id);
        waiting.delete(message.id);
        if (message.error) failed(new Error(message.error.message));
        else done(message.result);
      } else for (const f of listeners.get(message.method) ?? []) f(message.params);
    }
  });
  const send = (method, params = {}, sessionId = undefined) =>
    new Promise((done, failed) => {
      waiting.set(++last, { done, failed });
      into.write(JSON.stringify({ id: last, method, params, sessionId }) + "\0");
    });
  const on = (method, f) => listeners.set(method, [...(listeners.get(method) ?? []), f]);
  const { targetId } = await send("Target.createTarget", { url: "about:blank" });
  const { sessionId } = await send("Target.attachToTarget", { targetId, flatten: true });
  const ask = (method, params) => send(method, params, sessionId);
  const errors = [],
    asked = [];
  on("Runtime.exceptionThrown", ({ exceptionDetails: e }) => errors.push(e.exception?.description ?? e.text));
  on("Runtime.consoleAPICalled", ({ type, args }) => {
    if (type === "error") errors.push(args.map(a => a.value ?? a.description).join(" "));
  });
  on("Log.entryAdded", ({ entry }) => {
    if (entry.level === "error") errors.push(entry.text);
  });
  on("Network.requestWillBeSent", ({ request }) => asked.push(request.url));
  for (const domain of ["Page", "Runtime", "Log", "Network"]) await ask(`${domain}.enable`);

  async function evaluate(expression) {
    const { result, exceptionDetails } = await ask("Runtime.evaluate", {
      expression,
      awaitPromise: true,
      returnByValue: true,
    });
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  }
  async function until(expression, most = +(process.env.DURERO_WAIT ?? 60000)) {
    const began = Date.now();
    for (;;) {
      const value = await evaluate(expression);
      if (value) return value;
      if (Date.now() - began > most) throw new Error(`still not so after ${most} ms: ${expression}`);
      await new Promise(done => setTimeout(done, 40));
    }
  }
  async function show(width, height, { scale = 1, dark = false, phone = false } = {}) {
    await ask("Emulation.setDeviceMetricsOverride", { width, height, deviceScaleFactor: scale, mobile: phone });
    await ask("Emulation.setEmulatedMedia", {
      features: [{ name: "prefers-color-scheme", value: dark ? "dark" : "light" }],
    });
  }
  const mouse = (type, x, y, more = {}) =>
    ask("Input.dispatchMouseEvent", {
      type,
      x,
      y,
      button: "left",
      buttons: type === "mouseReleased" ? 0 : 1,
      clickCount: 1,
      ...more,
    });
  async function drag([x, y], [dx, dy], steps = 8) {
    await mouse("mousePressed", x, y);
    for (let i = 1; i <= steps; ++i) await mouse("mouseMoved", x + (dx * i) / steps, y + (dy * i) / steps);
    await mouse("mouseReleased", x + dx, y + dy);
  }
  const middle = selector =>
    evaluate(
      `(() => { const b = document.querySelector(${JSON.stringify(selector)}).getBoundingClientRect(); return [b.x + b.width / 2, b.y + b.height / 2]; })()`,
    );
  async function picture(file) {
    const { data } = await ask("Page.captureScreenshot", { format: "png" });
    writeFileSync(file, Buffer.from(data, "base64"));
  }
  async function key(name, code = name) {
    for (const type of ["keyDown", "keyUp"]) await ask("Input.dispatchKeyEvent", { type, key: name, code });
  }
  async function close() {
    const gone = new Promise(done => child.once("exit", done));
    await send("Browser.close").catch(() => {});
    await Promise.race([gone, new Promise(done => setTimeout(done, 5000))]);
    if (child.exitCode === null) child.kill("SIGKILL");
    rmSync(profile, { recursive: true, force: true });
  }
  await show(width, height, { scale, dark });
  return { ask, on, evaluate, until, show, mouse, drag, middle, picture, key, close, errors, asked };
}

// give_engine puts into each new document an engine that asks `call`, a function of this process.
export async function give_engine(page, call) {
  await page.ask("Runtime.addBinding", { name: "askOutside" });
  page.on("Runtime.bindingCalled", async ({ name, payload }) => {
    if (name !== "askOutside") return;
    const { id, question } = JSON.parse(payload),
      answer = await call(question);
    await page
      .ask("Runtime.evaluate", { expression: `answered(${id}, ${JSON.stringify(JSON.stringify(answer))})` })
      .catch(() => {}); // another document is there by now
  });
  await page.ask("Page.addScriptToEvaluateOnNewDocument", {
    source: `{
    const waiting = new Map();
    let last = 0;
    globalThis.answered = (id, text) => { waiting.get(id)?.(JSON.parse(text)); waiting.delete(id); };
    globalThis.dureroEngine = { call: question => new Promise(done => { waiting.set(++last, done); askOutside(JSON.stringify({ id: last, question })); }) };
  }`,
  });
}

// native_engine asks the program web_call, a question a line.
export function native_engine(program) {
  const child = spawn(program, [], { stdio: ["pipe", "pipe", "inherit"] }),
    waiting = [];
  let rest = "";
  child.stdout.setEncoding("utf8");
  child.stdout.on("data", text => {
    rest += text;
    for (let end; (end = rest.indexOf("\n")) >= 0; rest = rest.slice(end + 1))
      waiting.shift()(JSON.parse(rest.slice(0, end)));
  });
  return {
    call: question =>
      new Promise(done => {
        waiting.push(done);
        child.stdin.write(JSON.stringify(question) + "\n");
      }),
    close: () => child.stdin.end(),
  };
}
