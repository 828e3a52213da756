// Questions to the engine: one call, one answer. The engine is the layers as WebAssembly, in a worker; or what the one who
// embeds the page has put into globalThis.dureroEngine, an object with call(question) → promise of the answer.

let engine = null;

function start_worker(address) {
  const worker = new Worker(address),
    waiting = new Map();
  let last = 0;
  const ready = new Promise((done, failed) => {
    worker.onmessage = ({ data }) => {
      if (data.ready) return done();
      if (data.failed) return failed(new Error(data.failed));
      waiting.get(data.id)(data.answer);
      waiting.delete(data.id);
    };
    worker.onerror = event => failed(new Error(event.message || "the worker does not start"));
  });
  return {
    ready,
    call: question =>
      new Promise(done => {
        waiting.set(++last, done);
        worker.postMessage({ id: last, question });
      }),
  };
}

// worker_engine has two workers: a ray that is dragged does not wait for a predicate that takes long.
const quick_calls = new Set(["edit", "ray", "light", "trace"]);
function worker_engine(text) {
  const address = URL.createObjectURL(new Blob([text, worker_end], { type: "text/javascript" }));
  const quick = start_worker(address),
    slow = start_worker(address);
  slow.ready.catch(() => {}); // whoever asks it is told
  return {
    ready: quick.ready,
    call: question => call_when_ready(quick_calls.has(question.call) ? quick : slow, question),
  };
}
async function call_when_ready(worker, question) {
  try {
    await worker.ready;
  } catch (trouble) {
    return { error: `call:1:1: ${trouble.message}` };
  }
  return worker.call(question);
}

const worker_end = `
;start().then(() => {
  self.onmessage = ({ data }) => {
    let answer;
    try { answer = call(data.question); } catch (trouble) { answer = { error: "call:1:1: " + trouble }; }
    self.postMessage({ id: data.id, answer });
  };
  self.postMessage({ ready: true });
}, trouble => self.postMessage({ failed: trouble.message ?? String(trouble) }));`;

// start_engine finds the engine, and waits until it answers.
export async function start_engine() {
  if (globalThis.dureroEngine) engine = globalThis.dureroEngine;
  else {
    const text = document.getElementById("engine").textContent;
    if (!text.trim()) throw new Error("this page was built without its engine");
    engine = worker_engine(text);
    await engine.ready;
  }
}

export const ask = question => engine.call(question);

// latest asks one question at a time: while one is on its way only the newest of the others is kept.
export function latest(answered) {
  let on_its_way = false,
    next = null;
  async function send(question) {
    if (on_its_way) {
      next = question;
      return;
    }
    on_its_way = true;
    const answer = await ask(question);
    on_its_way = false;
    const following = next;
    next = null;
    if (following) send(following);
    answered(answer, question, following !== null);
  }
  return {
    send,
    drop: () => {
      next = null;
    },
  };
}

// once asks the same question one time.
const answers = new Map();
export function once(question) {
  const key = JSON.stringify(question);
  if (!answers.has(key)) answers.set(key, ask(question));
  return answers.get(key);
}

// answered is the answer of a question that may not fail.
export async function answered(question) {
  const answer = await once(question);
  if (answer.error) throw new Error(answer.error);
  return answer;
}
