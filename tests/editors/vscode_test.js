// The extension for VS Code with an editor that is made up here: vscode_test.js EXTENSION DURERO. It asks the real server.
"use strict";

const assert = require("assert");
const Module = require("module");

const [extension, durero] = process.argv.slice(2);

class Plain {
  constructor(...parts) {
    this.parts = parts;
  }
}
class Range {
  constructor(line, character, endLine, endCharacter) {
    this.start = { line, character };
    this.end = { line: endLine, character: endCharacter };
  }
}
class WorkspaceEdit {
  constructor() {
    this.all = new Map();
  }
  set(uri, edits) {
    this.all.set(uri.text, edits);
  }
}

const listeners = {};
const provided = {};
const defects = new Map();
let waiting = () => {};
const said = [];
const register = (kind) => (selector, provider) => {
  provided[kind] = provider;
  return {};
};
const uri = (text) => ({ text, toString: () => text });

const editor = {
  Range, WorkspaceEdit,
  Location: Plain, TextEdit: Plain, DocumentSymbol: Plain, CompletionItem: Plain, Diagnostic: Plain, Hover: Plain,
  MarkdownString: Plain, DocumentHighlight: Plain,
  Uri: { parse: uri },
  languages: {
    createDiagnosticCollection: () => ({ set: (of, all) => { defects.set(of.text, all); waiting(); } }),
    registerHoverProvider: register("hover"), registerDefinitionProvider: register("definition"),
    registerReferenceProvider: register("references"), registerDocumentHighlightProvider: register("highlight"),
    registerCompletionItemProvider: register("completion"), registerRenameProvider: register("rename"),
    registerDocumentFormattingEditProvider: register("layout"), registerDocumentSymbolProvider: register("outline"),
  },
  window: { showErrorMessage: (message) => said.push(message) },
  workspace: {
    getConfiguration: () => ({ get: () => durero }),
    textDocuments: [],
    onDidOpenTextDocument: (listener) => { listeners.open = listener; },
    onDidChangeTextDocument: (listener) => { listeners.change = listener; },
    onDidCloseTextDocument: (listener) => { listeners.close = listener; },
    onDidSaveTextDocument: (listener) => { listeners.save = listener; },
  },
};
const load = Module._load;
Module._load = (name, ...rest) => (name === "vscode" ? editor : load(name, ...rest));

const document = (name, languageId, text) => ({ uri: uri(name), languageId, version: 1, getText: () => text });
const told = () => new Promise((resolve) => { waiting = resolve; });

async function run() {
  const { activate, deactivate } = require(extension);
  await activate({ subscriptions: [] });
  const text = "┌ S\nx : ℕ\n└\n┌ Op\nΔS\n├\nx' = x + 1\n└\n";
  const z = document("untitled:z", "z", text);
  listeners.open(document("untitled:plain", "latex", "no paragraph"));  // is not told to the server
  let next = told();
  listeners.open(z);
  await next;
  assert.deepStrictEqual([...defects.keys()], ["untitled:z"]);
  assert.deepStrictEqual(defects.get("untitled:z"), []);

  const place = { line: 6, character: 0 };
  const hover = await provided.hover.provideHover(z, place);
  assert.match(hover.parts[0].parts[0], /x' : 𝔸/);
  const definition = await provided.definition.provideDefinition(z, place);
  assert.deepStrictEqual(definition[0].parts[1].start, { line: 1, character: 0 });
  const references = await provided.references.provideReferences(z, place, { includeDeclaration: true });
  assert.strictEqual(references.length, 3);
  assert.strictEqual((await provided.highlight.provideDocumentHighlights(z, place)).length, 3);
  const items = await provided.completion.provideCompletionItems(z, { line: 6, character: 1 });
  assert(items.some((item) => item.parts[0] === "x'" && item.insertText === "x'"));
  assert.strictEqual((await provided.rename.prepareRename(z, place)).placeholder, "x");
  const edits = await provided.rename.provideRenameEdits(z, place, "total");
  assert.deepStrictEqual(edits.all.get("untitled:z").map((edit) => edit.parts[1]), ["total", "total'", "total"]);
  await assert.rejects(provided.rename.provideRenameEdits(z, place, "a b"), /no word of Z/);
  assert.deepStrictEqual(await provided.layout.provideDocumentFormattingEdits(z, { tabSize: 2 }), []);
  const outline = await provided.outline.provideDocumentSymbols(z);
  assert.deepStrictEqual(outline.map((each) => each.parts[0]), ["S", "Op"]);
  assert.strictEqual(outline[0].children[0].parts[0], "x");

  next = told();
  listeners.change({ document: { ...z, version: 2 },
                     contentChanges: [{ range: new Range(1, 4, 1, 5), text: "M" }] });
  await next;
  assert.match(defects.get("untitled:z")[0].parts[1], /M is not declared/);
  next = told();
  listeners.close(z);
  await next;
  assert.deepStrictEqual(defects.get("untitled:z"), []);
  assert.strictEqual(await provided.hover.provideHover(z, place), undefined);
  await deactivate();
  assert.deepStrictEqual(said, []);
  console.log("the extension does what is asked");
}

run().catch((error) => {
  console.error(error);
  process.exit(1);
});
