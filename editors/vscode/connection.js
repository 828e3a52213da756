// A connection to a language server: messages of JSON-RPC behind headers that count their bytes.
"use strict";

const { spawn } = require("child_process");

class Connection {
  constructor(command, args, onNotification, onEnd) {
    this.process = spawn(command, args, { stdio: ["pipe", "pipe", "pipe"] });
    this.waiting = new Map();
    this.lastId = 0;
    this.bytes = Buffer.alloc(0);
    this.onNotification = onNotification;
    this.said = "";
    this.process.stdout.on("data", (bytes) => this.take(bytes));
    this.process.stderr.on("data", (bytes) => (this.said += bytes));
    this.process.stdin.on("error", () => {});  // the end of the program tells it
    this.process.on("error", (error) => this.end(onEnd, error.message));
    this.process.on("close", (status) => this.end(onEnd, status === 0 ? "" : this.said || `it ended with status ${status}`));
  }

  end(onEnd, said) {
    for (const { reject } of this.waiting.values()) reject(new Error(said || "the server has ended"));
    this.waiting.clear();
    if (!this.isOver) onEnd(said);
    this.isOver = true;
  }

  take(bytes) {
    this.bytes = Buffer.concat([this.bytes, bytes]);
    for (;;) {
      const end = this.bytes.indexOf("\r\n\r\n");
      if (end < 0) return;
      const length = Number(/content-length: *(\d+)/i.exec(this.bytes.toString("latin1", 0, end))[1]);
      if (this.bytes.length < end + 4 + length) return;
      const message = JSON.parse(this.bytes.toString("utf8", end + 4, end + 4 + length));
      this.bytes = this.bytes.subarray(end + 4 + length);
      this.receive(message);
    }
  }

  receive(message) {
    if (message.method !== undefined) return this.onNotification(message.method, message.params);
    const waiting = this.waiting.get(message.id);
    this.waiting.delete(message.id);
    if (waiting === undefined) return undefined;
    return message.error ? waiting.reject(new Error(message.error.message)) : waiting.resolve(message.result);
  }

  send(message) {
    if (this.isOver) return;
    const body = Buffer.from(JSON.stringify({ jsonrpc: "2.0", ...message }));
    this.process.stdin.write(`Content-Length: ${body.length}\r\n\r\n`);
    this.process.stdin.write(body);
  }

  notify(method, params) {
    this.send({ method, params });
  }

  // `token` is VS Code's: a request that is not wanted any more is cancelled.
  request(method, params, token) {
    const id = ++this.lastId;
    if (this.isOver) return Promise.reject(new Error("the server has ended"));
    const answer = new Promise((resolve, reject) => this.waiting.set(id, { resolve, reject }));
    this.send({ id, method, params });
    if (token) token.onCancellationRequested(() => this.notify("$/cancelRequest", { id }));
    return answer;
  }
}

module.exports = { Connection };
