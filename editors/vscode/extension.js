// VS Code's side of `durero spec lsp`, without packages of others: it hands on what the editor asks and is told.
"use strict";

const vscode = require("vscode");
const { Connection } = require("./connection");

const paragraph = /\\begin\{(zed|axdef|gendef|schema|zsection)\}|^[─┌╷═]/m;
const languages = ["z", "latex", "tex"];

let connection;
let defects;
const open = new Set();

// A text of LaTeX without a paragraph of Z is none of this server's.
const isZ = (document) =>
  document.languageId === "z" || (languages.includes(document.languageId) && paragraph.test(document.getText()));

const named = (document) => ({ textDocument: { uri: document.uri.toString() } });
const placed = (document, position) => ({ ...named(document), position: toPosition(position) });
const toPosition = (position) => ({ line: position.line, character: position.character });
const toRange = (range) => ({ start: toPosition(range.start), end: toPosition(range.end) });
const rangeOf = (range) => new vscode.Range(range.start.line, range.start.character, range.end.line, range.end.character);
const locationOf = (location) => new vscode.Location(vscode.Uri.parse(location.uri), rangeOf(location.range));
const editOf = (edit) => new vscode.TextEdit(rangeOf(edit.range), edit.newText);

function symbolOf(symbol) {
  const made = new vscode.DocumentSymbol(
    symbol.name, symbol.detail, symbol.kind - 1, rangeOf(symbol.range), rangeOf(symbol.selectionRange));
  made.children = symbol.children.map(symbolOf);
  return made;
}

function completionOf(item) {
  const made = new vscode.CompletionItem(item.label, item.kind - 1);
  made.detail = item.detail;
  made.filterText = item.filterText;
  made.insertText = item.textEdit.newText;
  made.range = rangeOf(item.textEdit.range);
  return made;
}

function editsOf(changes) {
  const edits = new vscode.WorkspaceEdit();
  for (const [uri, all] of Object.entries(changes)) edits.set(vscode.Uri.parse(uri), all.map(editOf));
  return edits;
}

function told(method, params) {
  if (method !== "textDocument/publishDiagnostics") return;
  defects.set(vscode.Uri.parse(params.uri), params.diagnostics.map((each) => {
    const made = new vscode.Diagnostic(rangeOf(each.range), each.message, each.severity - 1);
    made.source = each.source;
    return made;
  }));
}

function didOpen(document) {
  const uri = document.uri.toString();
  if (!isZ(document) || open.has(uri)) return;
  open.add(uri);
  connection.notify("textDocument/didOpen", {
    textDocument: { uri, languageId: "z", version: document.version, text: document.getText() } });
}

function didChange(event) {
  const uri = event.document.uri.toString();
  if (!open.has(uri)) return didOpen(event.document);
  if (event.contentChanges.length === 0) return undefined;
  return connection.notify("textDocument/didChange", {
    textDocument: { uri, version: event.document.version },
    contentChanges: event.contentChanges.map((change) => ({ range: toRange(change.range), text: change.text })) });
}

function didClose(document) {
  if (open.delete(document.uri.toString())) connection.notify("textDocument/didClose", named(document));
}

function didSave(document) {
  if (open.has(document.uri.toString())) connection.notify("textDocument/didSave", named(document));
}

// Asks about an open text, and hands the answer to `make`; of another text, or where the server refuses, nothing.
async function ask(document, method, params, token, make) {
  if (!open.has(document.uri.toString())) return undefined;
  try {
    const result = await connection.request(`textDocument/${method}`, params, token);
    return result === null ? undefined : make(result);
  } catch (error) {
    return undefined;
  }
}

// A refused renaming says why.
async function insist(document, method, params, token, make) {
  if (!open.has(document.uri.toString())) throw new Error("no Z text is here");
  return make(await connection.request(`textDocument/${method}`, params, token));
}

function providers(selector) {
  const at = (method, make) => (document, position, token) =>
    ask(document, method, placed(document, position), token, make);
  const { languages: register } = vscode;
  return [
    register.registerHoverProvider(selector, {
      provideHover: at("hover", (told) =>
        new vscode.Hover(new vscode.MarkdownString(told.contents.value), rangeOf(told.range))) }),
    register.registerDefinitionProvider(selector, {
      provideDefinition: at("definition", (all) => all.map(locationOf)) }),
    register.registerReferenceProvider(selector, {
      provideReferences: (document, position, context, token) =>
        ask(document, "references", { ...placed(document, position), context }, token, (all) => all.map(locationOf)) }),
    register.registerDocumentHighlightProvider(selector, {
      provideDocumentHighlights: at("documentHighlight", (all) =>
        all.map((each) => new vscode.DocumentHighlight(rangeOf(each.range), each.kind - 1))) }),
    register.registerCompletionItemProvider(selector, {
      provideCompletionItems: at("completion", (all) => all.map(completionOf)) }, "\\", "."),
    register.registerRenameProvider(selector, {
      prepareRename: (document, position, token) =>
        insist(document, "prepareRename", placed(document, position), token, (named) => (
          { range: rangeOf(named.range), placeholder: named.placeholder })),
      provideRenameEdits: (document, position, newName, token) =>
        insist(document, "rename", { ...placed(document, position), newName }, token, (made) =>
          editsOf(made.changes)) }),
    register.registerDocumentFormattingEditProvider(selector, {
      provideDocumentFormattingEdits: (document, options, token) =>
        ask(document, "formatting", { ...named(document), options }, token, (all) => all.map(editOf)) }),
    register.registerDocumentSymbolProvider(selector, {
      provideDocumentSymbols: (document, token) =>
        ask(document, "documentSymbol", named(document), token, (all) => all.map(symbolOf)) }),
  ];
}

async function activate(context) {
  defects = vscode.languages.createDiagnosticCollection("durero");
  const path = vscode.workspace.getConfiguration("durero").get("path");
  connection = new Connection(path, ["spec", "lsp"], told, (said) => {
    if (said) vscode.window.showErrorMessage(`${path} spec lsp: ${said}`);
  });
  await connection.request("initialize", { processId: process.pid, rootUri: null, capabilities: {
    general: { positionEncodings: ["utf-16"] },
    textDocument: { hover: { contentFormat: ["markdown"] },
                    documentSymbol: { hierarchicalDocumentSymbolSupport: true } } } });
  connection.notify("initialized", {});
  const selector = languages.map((language) => ({ language }));
  context.subscriptions.push(
    defects, ...providers(selector), vscode.workspace.onDidOpenTextDocument(didOpen),
    vscode.workspace.onDidChangeTextDocument(didChange), vscode.workspace.onDidCloseTextDocument(didClose),
    vscode.workspace.onDidSaveTextDocument(didSave));
  vscode.workspace.textDocuments.forEach(didOpen);
}

async function deactivate() {
  if (!connection || connection.isOver) return;
  await connection.request("shutdown", null);
  connection.notify("exit", null);
}

module.exports = { activate, deactivate };
