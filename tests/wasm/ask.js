// What the module answers: a call a line from the standard input, its answer a line on the standard output, as web_call.
//   node ask.js ENGINE.js
"use strict";
const engine = require(require("path").resolve(process.argv[2]));
const readline = require("readline");

engine.start().then(() => readline.createInterface({ input: process.stdin, crlfDelay: Infinity })
  .on("line", line => process.stdout.write(engine.call_text(line) + "\n")));
