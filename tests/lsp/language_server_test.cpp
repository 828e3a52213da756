#include "durero/lsp/language_server.hpp"

#include <rapidjson/document.h>

#include "support/catch.hpp"

using Catch::Contains;
using durero::lsp::LanguageServer;

namespace {

/// A client that has sent some messages, and what was answered.
class TestClient {
 public:
  explicit TestClient(std::map<std::string, std::string> folder = {})
      : server("9.9", [folder = std::move(folder)](const std::string&) { return folder; }) {}

  /// Sends a message, lets the server do all of its work, and returns what it sent, a message a line.
  std::string send(const std::string& message) {
    server.take(message);
    std::string all;
    while (server.has_work()) server.step();
    for (const std::string& each : server.sent()) all += each + "\n";
    return all;
  }
  std::string ask(const std::string& method, const std::string& params) {
    return send(R"({"jsonrpc":"2.0","id":1,"method":")" + method + R"(","params":)" + params + "}");
  }
  std::string tell(const std::string& method, const std::string& params) {
    return send(R"({"jsonrpc":"2.0","method":")" + method + R"(","params":)" + params + "}");
  }
  void start(const std::string& capabilities = "{}") { ask("initialize", R"({"capabilities":)" + capabilities + "}"); }
  std::string open(const std::string& file, const std::string& text) {
    return tell("textDocument/didOpen", R"({"textDocument":{"uri":"file:///f/)" + file +
                                            R"(","languageId":"z","version":1,"text":")" + text + R"("}})");
  }
  std::string at(const std::string& method, const std::string& file, int line, int character,
                 const std::string& more = "") {
    return ask("textDocument/" + method, R"({"textDocument":{"uri":"file:///f/)" + file + R"("},"position":{"line":)" +
                                             std::to_string(line) + R"(,"character":)" + std::to_string(character) +
                                             "}" + more + "}");
  }

  LanguageServer server;
};

constexpr const char* counter = "┌ S\\nx : ℕ\\n└\\n┌ Op\\nΔS\\n├\\nx' = x + 1\\n└\\n";

}  // namespace

TEST_CASE("a session begins with initialize and ends with shutdown and exit") {
  TestClient client;
  CHECK_THAT(client.at("hover", "a", 0, 0), Contains("-32002"));
  CHECK_THAT(client.ask("initialize", "{}"), Contains(R"("positionEncoding":"utf-16")") && Contains("9.9"));
  CHECK_THAT(client.ask("initialize", "{}"), Contains("-32600"));
  CHECK(client.tell("initialized", "{}").empty());
  CHECK(client.server.status() == 1);
  CHECK(client.ask("shutdown", "null") == "{\"jsonrpc\":\"2.0\",\"id\":1,\"result\":null}\n");
  CHECK_THAT(client.at("hover", "a", 0, 0), Contains("-32600"));
  CHECK_FALSE(client.server.is_over());
  client.tell("exit", "null");
  CHECK(client.server.is_over());
  CHECK(client.server.status() == 0);
}

TEST_CASE("without shutdown, exit has the status 1") {
  TestClient client;
  client.tell("exit", "null");
  CHECK(client.server.is_over());
  CHECK(client.server.status() == 1);
}

TEST_CASE("what is no message has an error as its answer") {
  TestClient client;
  client.start();
  for (const char* bad : {"", "{", "\xFF", "[[[[", "nul"})
    CHECK_THAT(client.send(bad), Contains("-32700") && Contains("\"id\":null"));
  for (const char* bad :
       {"1", "[]", "{}", R"({"jsonrpc":"1.0","method":"x"})", R"({"jsonrpc":"2.0","id":{},"method":"x"})",
        R"({"jsonrpc":"2.0","id":1,"method":2})", R"({"jsonrpc":"2.0","id":1})"})
    CHECK_THAT(client.send(bad), Contains("-32600"));
  CHECK_THAT(client.ask("textDocument/nothing", "{}"), Contains("-32601"));
  CHECK_THAT(client.ask("textDocument/hover", "{}"), Contains("-32602"));
  CHECK_THAT(client.ask("textDocument/hover", "[]"), Contains("-32602"));
  CHECK_THAT(client.at("hover", "closed.tex", 0, 0), Contains("-32602") && Contains("is not open"));
  CHECK_THAT(client.at("hover", "closed.tex", -1, 0), Contains("-32602"));
  CHECK(client.send(R"({"jsonrpc":"2.0","id":9,"result":{}})").empty());
  CHECK(client.tell("$/setTrace", "{}").empty());
  CHECK_THAT(client.tell("textDocument/didChange", "{}"), Contains("window/logMessage"));
  CHECK_THAT(client.send(std::string(100000, '[')), Contains("-32700"));
}

TEST_CASE("defects are told as spec check gives them, and again when they change") {
  TestClient client;
  client.start();
  const std::string told = client.open("a.tex", "┌ S\\nx : M\\n└\\n");
  CHECK_THAT(told, Contains("M is not declared; expected a declared name") && Contains(R"("version":1)") &&
                       Contains(R"("start":{"line":1,"character":4},"end":{"line":1,"character":5})"));
  CHECK_THAT(
      client.tell(
          "textDocument/didChange",
          R"({"textDocument":{"uri":"file:///f/a.tex","version":2},"contentChanges":[{"range":{"start":{"line":1,"character":4},"end":{"line":1,"character":5}},"text":"ℕ"}]})"),
      Contains(R"("version":2,"diagnostics":[])"));
  CHECK_THAT(
      client.tell("textDocument/didChange",
                  R"({"textDocument":{"uri":"file:///f/a.tex","version":3},"contentChanges":[{"text":"no Z"}]})"),
      Contains("no Z paragraph"));
  CHECK_THAT(client.tell("textDocument/didClose", R"({"textDocument":{"uri":"file:///f/a.tex"}})"),
             Contains(R"("diagnostics":[])"));
}

TEST_CASE("conjectures are tried when a text is opened or saved, and those found false are told") {
  TestClient client;
  client.start();
  const std::string text = "─\\nT ::= a | b\\n⊢? ∀ x : T • x = x\\n⊢? ∀ x : T • x = a ∨ x ≠ b % T.conj.2\\n└\\n";
  CHECK_THAT(client.open("a.tex", text), Contains("conjecture T.conj.2 is false, as in this state:\\n  x = b") &&
                                             !Contains("T.conj.1") && Contains(R"("start":{"line":3,"character":0})"));
  CHECK_THAT(
      client.tell(
          "textDocument/didChange",
          R"({"textDocument":{"uri":"file:///f/a.tex","version":2},"contentChanges":[{"range":{"start":{"line":2,"character":18},"end":{"line":2,"character":18}},"text":" "}]})"),
      Contains(R"("version":2,"diagnostics":[])"));
  CHECK_THAT(client.tell("textDocument/didSave", R"({"textDocument":{"uri":"file:///f/a.tex"}})"),
             Contains("conjecture T.conj.2 is false"));
  CHECK(client.tell("textDocument/didSave", R"({"textDocument":{"uri":"file:///f/other.tex"}})").empty());
}

TEST_CASE("the weight of a defect is told apart from its message") {
  TestClient client;
  client.start();
  CHECK_THAT(client.open("a.tex", "─\\nT ::= a\\nU == T\\n└\\n"),
             Contains(R"("severity":2,"source":"durero","message":"a is declared and never used; expected a use)"));
}

TEST_CASE("a change that cannot be carried out changes nothing") {
  TestClient client;
  client.start();
  client.open("a.tex", counter);
  CHECK_THAT(
      client.tell(
          "textDocument/didChange",
          R"({"textDocument":{"uri":"file:///f/a.tex","version":2},"contentChanges":[{"text":"gone"},{"range":{"start":{"line":3,"character":0},"end":{"line":1,"character":0}},"text":""}]})"),
      Contains("a range ends before its start"));
  CHECK_THAT(client.at("hover", "a.tex", 6, 0), Contains("x'"));
}

TEST_CASE("a name is explained, found and renamed") {
  TestClient client;
  client.start(R"({"textDocument":{"hover":{"contentFormat":["markdown"]}}})");
  client.open("a.tex", counter);
  CHECK_THAT(client.at("hover", "a.tex", 6, 5), Contains("x : 𝔸") && Contains("component") && Contains("```z"));
  CHECK_THAT(client.at("definition", "a.tex", 6, 0), Contains(R"("start":{"line":1,"character":0})"));
  CHECK_THAT(client.at("references", "a.tex", 1, 0, R"(,"context":{"includeDeclaration":false})"),
             Contains(R"("start":{"line":6,"character":0},"end":{"line":6,"character":2})") &&
                 !Contains(R"("start":{"line":1)"));
  CHECK_THAT(client.at("documentHighlight", "a.tex", 1, 0), Contains(R"("kind":3)") && Contains(R"("kind":2)"));
  CHECK_THAT(client.at("prepareRename", "a.tex", 6, 0), Contains(R"("placeholder":"x")"));
  CHECK_THAT(client.at("rename", "a.tex", 6, 0, R"(,"newName":"total")"),
             Contains(R"("newText":"total'")") && Contains(R"("file:///f/a.tex":[)"));
  CHECK_THAT(client.at("prepareRename", "a.tex", 1, 4), Contains("-32803") && Contains("toolkit"));
  CHECK_THAT(client.at("prepareRename", "a.tex", 2, 0), Contains("-32803"));
  CHECK_THAT(client.at("rename", "a.tex", 6, 0, R"(,"newName":"a b")"), Contains("-32803"));
  CHECK_THAT(client.at("hover", "a.tex", 2, 0), Contains(R"("result":null)"));
}

TEST_CASE("names and commands are completed") {
  TestClient client;
  client.start();
  client.open("a.tex", counter);
  CHECK_THAT(client.at("completion", "a.tex", 6, 1), Contains(R"("label":"x'")") && Contains(R"("label":"S")"));
  client.open("l.tex", R"(\\begin{schema}{S}\n mi\\_x : \\nat\n\\where\n mi\\_x = \\em\n\\end{schema}\n)");
  CHECK_THAT(client.at("completion", "l.tex", 3, 12),
             Contains(R"("newText":"\\emptyset")") && Contains(R"("start":{"line":3,"character":9})"));
  CHECK_THAT(client.at("completion", "l.tex", 3, 6), Contains(R"("newText":"mi\\_x")"));
  client.open("u.tex", R"(┌ S\nx : \\na\n└\n)");
  CHECK_THAT(client.at("completion", "u.tex", 1, 7),
             Contains(R"("label":"\\nat","kind":14,"detail":"ℕ")") && Contains(R"("newText":"ℕ")"));
  CHECK_THAT(client.at("completion", "u.tex", 3, 0), Contains(R"("result":[])"));
}

TEST_CASE("an outline and a layout") {
  TestClient client;
  client.start(R"({"textDocument":{"documentSymbol":{"hierarchicalDocumentSymbolSupport":true}}})");
  client.open("l.tex", R"(\\begin{schema}{S}\nx : \\nat\n\\end{schema}\n)");
  CHECK_THAT(client.ask("textDocument/documentSymbol", R"({"textDocument":{"uri":"file:///f/l.tex"}})"),
             Contains(R"("name":"S","kind":23)") && Contains(R"("children":[{"name":"x","kind":8,"detail":"𝔸")"));
  CHECK_THAT(client.ask("textDocument/formatting", R"({"textDocument":{"uri":"file:///f/l.tex"},"options":{}})"),
             Contains(R"(  x : \\nat)"));
  client.open("b.tex", R"(\\begin{schema}{S}\nx : \n\\end{schema}\n)");
  CHECK_THAT(client.ask("textDocument/formatting", R"({"textDocument":{"uri":"file:///f/b.tex"},"options":{}})"),
             Contains("-32803"));
  TestClient flat;
  flat.start();
  flat.open("l.tex", counter);
  CHECK_THAT(flat.ask("textDocument/documentSymbol", R"({"textDocument":{"uri":"file:///f/l.tex"}})"),
             Contains(R"("containerName":"S")") && Contains(R"("location")"));
}

TEST_CASE("sections of several files are one text, as the editor has them") {
  TestClient client(std::map<std::string, std::string>{
      {"/f/a.tex",
       "\\begin{zsection}\n\\SECTION a \\parents standard\\_toolkit\n\\end{zsection}\n"
       "\\begin{zed}\n  A == \\nat\n\\end{zed}\n"}});
  client.start();
  const std::string child =
      R"(\\begin{zsection}\n\\SECTION b \\parents a\n\\end{zsection}\n\\begin{zed}\nB == A\n\\end{zed}\n)";
  CHECK_THAT(client.open("b.tex", child), Contains(R"("diagnostics":[])"));
  CHECK_THAT(client.at("definition", "b.tex", 4, 5), Contains(R"("uri":"file:///f/a.tex")") && Contains(R"("line":4)"));
  CHECK_THAT(client.at("rename", "b.tex", 4, 5, R"(,"newName":"C")"),
             Contains("file:///f/a.tex") && Contains("file:///f/b.tex"));
  const std::string parent = R"(\\begin{zsection}\n\\SECTION a\n\\end{zsection}\n\\begin{zed}\n[Z]\n\\end{zed}\n)";
  CHECK_THAT(client.open("a.tex", parent), Contains("A is not declared"));
}

TEST_CASE("a request that waits is cancelled, and one that was answered is not") {
  TestClient client;
  client.start();
  client.open("a.tex", counter);
  client.server.take(
      R"({"jsonrpc":"2.0","id":"h","method":"textDocument/documentSymbol","params":{"textDocument":{"uri":"file:///f/a.tex"}}})");
  client.server.take(R"({"jsonrpc":"2.0","method":"$/cancelRequest","params":{"id":"h"}})");
  CHECK_FALSE(client.server.has_work());
  const std::vector<std::string> sent = client.server.sent();
  REQUIRE(sent.size() == 1);
  CHECK_THAT(sent[0], Contains("-32800") && Contains(R"("id":"h")"));
  CHECK(client.tell("$/cancelRequest", R"({"id":7})").empty());
}

TEST_CASE("units of positions are agreed on") {
  TestClient client;
  client.start(R"({"general":{"positionEncodings":["utf-8","utf-16"]}})");
  client.open("a.tex", "─\\na == 𝔸 ∪ M\\n└\\n");
  CHECK_THAT(client.at("hover", "a.tex", 1, 6), Contains("𝔸"));
  CHECK_THAT(client.tell("textDocument/didSave", R"({"textDocument":{"uri":"file:///f/a.tex"}})"),
             !Contains("character\":9"));
}
