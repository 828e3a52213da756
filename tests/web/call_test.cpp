#include "durero/web/call.hpp"

#include <fmt/format.h>

#include <fstream>
#include <sstream>

#include "durero/io/json/json.hpp"
#include "durero/io/json/scene_check.hpp"
#include "durero/io/json/scene_file.hpp"
#include "durero/spec/spec.hpp"
#include "support/catch.hpp"
#include "support/tree.hpp"
#include "web/json_text.hpp"

namespace durero::web {
namespace {

using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;

std::string file_text(const std::string& name) {
  std::ostringstream all;
  all << std::ifstream(test::source_dir() + "/" + name).rdbuf();
  return all.str();
}

/// A ball before a tube, a lamp above.
const std::string scene =
    R"({"format":"durero-scene","version":1,"camera":{"eye":[0,0,5],"look_at":[0,0,0],"up":[0,1,0],"fov_y":45},)"
    R"("lights":[{"position":[0,0,9],"color":[1,1,1]},{"position":[0,0,-9],"color":[1,1,1]}],)"
    R"("elementos":[{"id":"ball","tipo":"esfera","centro":[0,0,0],"radio":1},)"
    R"({"id":"tube","tipo":"cilindro","centro":[0,-1,-3],"radio":0.5,"vector":[0,1,0],"altura":3}]})";

std::string of_scene(const std::string& name, const std::string& rest) {
  return call(fmt::format(R"({{"call":"{}","scene":{}{}}})", name, scene, rest));
}

/// The answer is one line of JSON.
void require_line(const std::string& answer) {
  CHECK(answer.find('\n') == answer.npos);
  const io::Source source("answer", answer);
  CHECK_NOTHROW(io::json::Document(source));
}

std::string asked(const std::string& request) {
  const std::string answer = call(request);
  require_line(answer);
  return answer;
}

/// The error of an answer.
std::string error_of(const std::string& answer) {
  require_line(answer);
  const io::Source source("answer", answer);
  const io::json::Document document(source);
  const auto error = io::json::Reader(document).member("error");
  return error ? std::string(io::json::Reader(*error).string("error")) : "none: " + answer;
}

/// A member of an answer that is a text.
std::string text_of_member(const std::string& answer, std::string_view name) {
  const io::Source source("answer", answer);
  const io::json::Document document(source);
  const auto member = io::json::Reader(document).member(name);
  return member ? std::string(io::json::Reader(*member).string(name)) : "none: " + answer;
}

TEST_CASE("what is no call is answered by one line with its place") {
  CHECK(error_of(call("")) == "call:1:1: the text is empty; expected a JSON value");
  CHECK_THAT(error_of(call("nothing")), StartsWith("call:1:2: "));
  CHECK_THAT(error_of(call("[]")), Contains("a call is an array; expected an object"));
  CHECK(error_of(call("{}")) == "call:1:1: a call has no call; expected the name of what is asked");
  CHECK(error_of(call(R"({"call":7})")) == "call:1:9: call is a number; expected a string");
  CHECK(error_of(call(R"({"call":"texts"})")) == "call:1:9: nothing answers the call \"texts\"; expected text");
  CHECK_THAT(error_of(call(R"({"call":"x"})")), Contains("expected version, text, labels"));
  CHECK(error_of(call(R"({"call":"version","call":"text"})")) ==
        "call:1:19: the key \"call\" stands twice; expected it once");
  CHECK_THAT(error_of(call("{\"call\":\"\xff\"}")), StartsWith("call:1:"));
  CHECK_THAT(error_of(call(std::string(100'000, '['))), StartsWith("call:1:"));
  const std::string nested = std::string(100'000, '[') + std::string(100'000, ']');
  CHECK(error_of(call("{\"call\":" + nested + "}")) == "call:1:9: call is an array; expected a string");
  CHECK_THAT(error_of(of_scene("trace", ",\"rays\":" + nested)), Contains("expected a number"));
}

TEST_CASE("every call refuses keys that it has not, and says which it needs") {
  for (const char* name : {"version", "text", "labels", "errata", "operations", "check", "edit", "trace", "ray",
                           "light", "eval", "zed.check", "zed.run", "zed.graph", "surface", "render_shader"}) {
    CAPTURE(name);
    CHECK_THAT(error_of(call(fmt::format(R"({{"call":"{}","zqxj":1}})", name))),
               Contains(fmt::format("the call {} has no key \"zqxj\"; expected ", name)));
  }
  CHECK(error_of(call(R"({"call":"check"})")) == "call:1:9: the call check lacks scene; expected it");
  CHECK_THAT(error_of(of_scene("edit", "")), EndsWith("the call edit lacks operations; expected it"));
  CHECK_THAT(error_of(of_scene("trace", "")), EndsWith("the call trace lacks rays; expected it"));
  CHECK_THAT(error_of(of_scene("ray", ",\"p\":[0,0,0]")), EndsWith("the call ray lacks v; expected it"));
  CHECK_THAT(error_of(call(R"({"call":"eval"})")), EndsWith("the call eval lacks expression; expected it"));
  CHECK_THAT(error_of(call(R"({"call":"surface"})")), EndsWith("the call surface lacks with; expected it"));
}

TEST_CASE("the version has the calls") {
  CHECK_THAT(asked(R"({"call":"version"})"), StartsWith("{\"durero\":\"") && Contains("\"zed.graph\""));
}

TEST_CASE("the text has its files, and a file its prose and its paragraphs, a line a predicate") {
  CHECK_THAT(asked(R"({"call":"text"})"),
             Contains(R"({"file":"spec/escena.tex","section":"escena","parents":["tipos"]})"));
  const std::string escena = asked(R"({"call":"text","file":"spec/escena.tex"})");
  CHECK_THAT(escena, Contains(R"({"text":"elementos = dom de_que_tipo","line":24,"label":"Escena.inv.1"})") &&
                         Contains(R"({"text":"elementos : 𝔽 Elemento","line":14,"declares":true})") &&
                         Contains(R"("kind":"conjecture")") && Contains("The initialisation theorem"));
  CHECK(error_of(call(R"({"call":"text","file":"spec/nada.tex"})")) ==
        "call:1:23: the text has no file \"spec/nada.tex\"; expected one of those that text without a file names");
  for (const zed::Section& section : spec::text().sections)
    CHECK_THAT(asked(fmt::format(R"({{"call":"text","file":"{}"}})", section.file)), Contains("\"parts\":[{"));
}

TEST_CASE("a label has its clause, its tests and its theorem with the axioms that it rests on") {
  const std::string label = asked(R"({"call":"labels","of":"Init.conj.1"})");
  CHECK_THAT(label,
             StartsWith(R"({"labels":[{"label":"Init.conj.1","predicate":"⊢? ∃ Escena ' • Init",)") &&
                 Contains(R"("theorems":[{"name":"Init_exists","place":"proofs/)") &&
                 Contains(R"("status":"proved")") &&
                 EndsWith(R"("Classical_Prop.classic","FunctionalExtensionality.functional_extensionality_dep"]})"));
  CHECK_THAT(asked(R"({"call":"labels","of":"Escena"})"),
             Contains(R"("label":"Escena.inv.1")") && Contains(R"("label":"Escena.inv.9")") && !Contains("Init"));
  CHECK_THAT(asked(R"({"call":"labels"})"), Contains("reduccion.def.2"));
  CHECK(error_of(call(R"({"call":"labels","of":"nada"})")) ==
        "call:1:23: the text has no label of \"nada\"; expected a label, or a name that the text declares with labels");
}

TEST_CASE("an erratum has its four points, and two of them are drawn") {
  const std::string errata = asked(R"({"call":"errata"})");
  CHECK_THAT(errata,
             Contains(R"({"name":"E10","title":"A squared distance equals a length","source":"The Z paper",)") &&
                 Contains(R"("labels":["potencia_cilindro.def.1"],"drawn":"{)") && Contains(R"("name":"E35")") &&
                 Contains(R"("name":"EA12")") && Contains(R"("name":"ER14")"));
  CHECK_THAT(errata, Contains(R"({"file":"spec/impresa/escena.tex","lines":[)") &&
                         Contains(R"(elementos : \\power Elemento \\\\  % E22","marks":["E22"]})"));
}

TEST_CASE("operations have inputs with the sets that the text declares them from") {
  const std::string operations = asked(R"({"call":"operations"})");
  CHECK_THAT(operations,
             Contains(R"({"name":"Agregar_Esfera","inputs":[{"name":"e","type":"Elemento","required":true},)"
                      R"({"name":"centro","type":"Punto","required":true},{"name":"radio","type":"ℝ","required":true},)"
                      R"({"name":"material","type":"material","required":false}],"schema":"Agregar_Esfera",)"
                      R"("labels":["Agregar_Elemento.pre.1",)") &&
                 Contains(R"({"name":"ungroup","inputs":[{"name":"g","type":"group","required":true}],"schema":null,)"
                          R"("labels":[]})"));
  const std::string torus = json_of(file_text("demo/surfaces/torus.tex"));
  CHECK_THAT(
      asked(fmt::format(R"({{"call":"operations","with":{}}})", torus)),
      Contains(R"({"name":"Agregar_Toro","inputs":[{"name":"e","type":"Elemento","required":true},)"
               R"({"name":"centro","type":"Punto","required":true},{"name":"mayor","type":"ℝ","required":true})"));
  CHECK_THAT(error_of(call(R"({"call":"operations","with":"nothing"})")), StartsWith("with:1:1: "));
}

TEST_CASE("a scene is checked as check_scene() checks it, an object or its text") {
  const io::Source source("scene", scene);
  std::string json = io::check_json(io::check_scene(source));
  std::erase(json, '\n');
  const std::string answer = of_scene("check", "");
  require_line(answer);
  CHECK_THAT(answer, StartsWith("{\"ok\":true,\"check\":" + json + ",\"lines\":[\"scene: 2 elementos: "));
  CHECK(asked(fmt::format(R"({{"call":"check","scene":{}}})", json_of(scene))) == answer);
  const std::string bad = asked(R"({"call":"check","scene":{"format":"durero-scene","version":1,"elementos":[7]}})");
  CHECK_THAT(bad, StartsWith("{\"ok\":false,") &&
                      EndsWith("\"lines\":[\"scene:1:51: an element is a number; expected an object\"]}"));
  CHECK(error_of(call(R"({"call":"check","scene":7})")) == "call:1:25: scene is a number; expected a string");
}

TEST_CASE("edits are answered in the lines of durero edit, with the scene after each") {
  const std::string operations =
      R"(,"operations":["Agregar_Esfera e?=moon centro?=(0,4,0) radio?=0.5",{"op":"Eliminar_Elemento","e":"bal"}])";
  const std::string answer = of_scene("edit", operations);
  require_line(answer);
  CHECK_THAT(answer, StartsWith(R"({"ok":false,"answers":[{"line":1,"ok":true,"r":"esfera_agregada"},)"
                                R"({"line":2,"ok":false,"r":"elemento_no_existe","violated":"Eliminar_Elemento.pre.1",)"
                                R"("predicate":"e? ∈ elementos"}],"refusals":[null,{"line":2,"ok":false,)") &&
                         Contains(R"("broken":[{"label":"Eliminar_Elemento.pre.1")"));
  const std::string before = json_of(io::scene_text(io::read_scene(io::Source("scene", scene))));
  CHECK_THAT(answer, Contains("\"scenes\":[" + before + ",") && Contains("moon"));
  CHECK_THAT(of_scene("edit", operations + ",\"scenes\":false,\"audit\":true"), !Contains(before));
  CHECK(of_scene("edit", R"(,"operations":[])") ==
        R"({"ok":true,"answers":[],"refusals":[],"scenes":[)" + before + "]}");
  CHECK_THAT(of_scene("edit", R"(,"operations":"Eliminar_Esfera e=ball\n")"), StartsWith(R"({"ok":true)"));
  CHECK(error_of(of_scene("edit", R"(,"operations":["Agregar"])")).starts_with("operations:1:1: "));
  CHECK_THAT(error_of(of_scene("edit", R"(,"operations":[7])")),
             EndsWith("an operation is a number; expected a string"));
  const std::string torus = json_of(file_text("demo/surfaces/torus.tex"));
  CHECK_THAT(
      of_scene("edit", R"(,"operations":["Agregar_Toro e=ring centro=(0,0,0) mayor=1 menor=2"],"with":)" + torus),
      Contains(R"("ok":false,)") && Contains("menor < mayor"));
}

TEST_CASE("rays are traced in the lines of durero trace, a text or an array") {
  CHECK(of_scene("trace", R"(,"rays":[[0,0,5,0,0,-1],{"ray":[0,0,1,0,0,-1],"on":["ball"]},[9,9,9,0,1,0]])") ==
        R"({"hits":[{"ray":0,"outcome":"hit","elementos":["ball"],"t":4,"point":[0,0,1]},)"
        R"({"ray":1,"outcome":"hit","elementos":["ball"],"t":2,"point":[0,0,-1]},)"
        R"({"ray":2,"outcome":"miss","elementos":[]}]})");
  CHECK(of_scene("trace", R"(,"rays":"# none\n0 0 5 0 0 -1\n")") ==
        R"({"hits":[{"ray":0,"outcome":"hit","elementos":["ball"],"t":4,"point":[0,0,1]}]})");
  CHECK(error_of(of_scene("trace", R"(,"rays":"1 2 3")")).starts_with("rays:1:"));
  CHECK_THAT(error_of(of_scene("trace", R"(,"rays":[[0,0,0,0,0,0]])")),
             EndsWith("the direction of a ray is 0; expected another one"));
  CHECK_THAT(error_of(of_scene("trace", R"(,"rays":[{"ray":[0,0,0,0,0,1],"on":["x"]}])")),
             EndsWith("no element is called \"x\"; expected an element of the scene"));
}

TEST_CASE("a ray has every crossing exactly, the first marked, and the step that decided it") {
  const std::string answer = of_scene("ray", R"(,"p":[0,0,5],"v":[0,0,-1])");
  require_line(answer);
  CHECK_THAT(
      answer,
      StartsWith(R"({"hit":{"ray":0,"outcome":"hit","elementos":["ball"],"t":4,"point":[0,0,1]},)"
                 R"("decided":{"first":[{"elemento":"ball","step":"triage","t":4,)") &&
          Contains(R"("steps":{"triage":2,"stable":0,"exact":0},"order":"triage","rounding":"triage","margin":2})"));
  CHECK_THAT(answer, Contains(R"({"elemento":"ball","tipo":"esfera","kind":"point","first":true,)"
                              R"("t":{"x":"4","y":"0","delta":"0","digits":"4","binary64":4,"hex":"0x1p+2",)") &&
                         Contains(R"("normal":[0,0,1],"quadratic":{"A":"1","B":"-5","C":"24","discriminant":"1"}})") &&
                         Contains(R"("kind":"point","first":false,"t":{"x":"6")") && Contains(R"("t":{"x":"15/2")") &&
                         Contains(R"("t":{"x":"17/2")"));
}

TEST_CASE("a ray along a surface has a stretch, one from the origin has no beginning, and ties are all first") {
  const std::string along =
      asked(R"({"call":"ray","scene":{"format":"durero-scene","version":1,"elementos":[{"id":"c","tipo":"cilindro",)"
            R"("centro":[0,0,0],"radio":1,"vector":[0,1,0],"altura":2}]},"p":[1,-3,0],"v":[0,1,0]})");
  CHECK_THAT(along, Contains(R"("step":"exact")") && Contains(R"("kind":"segment","first":true,"t":{"x":"3")") &&
                        Contains(R"("end":{"x":"5")") && Contains(R"("margin":null)"));
  const std::string within =
      asked(R"({"call":"ray","scene":{"format":"durero-scene","version":1,"elementos":[{"id":"c","tipo":"cilindro",)"
            R"("centro":[0,0,0],"radio":1,"vector":[0,1,0],"altura":2}]},"p":[1,1,0],"v":[0,1,0]})");
  CHECK_THAT(within,
             Contains(R"("outcome":"no_minimum")") && Contains(R"("kind":"segment","first":true,"end":{"x":"1")"));
  const std::string tied = asked(
      R"({"call":"ray","scene":{"format":"durero-scene","version":1,"elementos":[{"id":"a","tipo":"esfera",)"
      R"("centro":[0,0,0],"radio":1},{"id":"b","tipo":"esfera","centro":[0,0,-1],"radio":2}]},"p":[0,0,5],"v":[0,0,-1]})");
  CHECK_THAT(tied, Contains(R"("elementos":["a","b"])") && Contains(R"("order":"exact")") &&
                       Contains(R"({"elemento":"a","tipo":"esfera","kind":"point","first":true,)") &&
                       Contains(R"({"elemento":"b","tipo":"esfera","kind":"point","first":true,)"));
}

TEST_CASE("a body is crossed exactly too") {
  const std::string answer = asked(
      R"({"call":"ray","scene":{"format":"durero-scene","version":1,"elementos":[{"id":"a","tipo":"esfera",)"
      R"("centro":[9,0,0],"radio":1},{"id":"i","tipo":"instancia","de":"a","mapa":[[1,0,0,-9],[0,1,0,0],[0,0,3,0]]}]},)"
      R"("p":[0,0,5],"v":[0,0,-1]})");
  CHECK_THAT(answer, Contains(R"("elementos":["i"],"t":2,)") &&
                         Contains(R"({"elemento":"i","tipo":"instancia","kind":"point","first":true,"t":{"x":"2")") &&
                         Contains(R"("kind":"point","first":false,"t":{"x":"8")"));
}

TEST_CASE("each light has its shadow ray from the hit, and what stands in its way") {
  const std::string answer = of_scene("light", R"(,"p":[0,0,5],"v":[0,0,-1])");
  require_line(answer);
  CHECK_THAT(answer, StartsWith(R"({"hit":{"ray":0,)") &&
                         Contains(R"({"light":0,"position":[0,0,9],"p":[0,0,1],"v":[0,0,8],"visible":true,)"
                                  R"("blocked_by":[],"crossings":[]})") &&
                         Contains(R"({"light":1,"position":[0,0,-9],"p":[0,0,1],"v":[0,0,-10],"visible":false,)"
                                  R"("blocked_by":["ball","tube"],"crossings":[{)"));
  CHECK(of_scene("light", R"(,"p":[9,9,9],"v":[0,1,0])") ==
        R"({"hit":{"ray":0,"outcome":"miss","elementos":[]},"lights":[]})");
}

TEST_CASE("an expression has its value, and its parts as a tree") {
  CHECK(asked(R"({"call":"eval","expression":"1/3 + 0.25"})") ==
        R"({"value":"7/12","yes":true,"steps":27,"taken":[]})");
  CHECK_THAT(of_scene("eval", R"(,"expression":"mi_radio ball")"), StartsWith(R"({"value":"1",)"));
  const std::string tree = asked(R"({"call":"eval","expression":"∀ x : 1‥3 • x < 3","explain":true})");
  CHECK_THAT(tree, Contains(R"({"term":"counter-example","value":"x == 3","witness":true,"parts":[{"term":"x < 3",)") &&
                       Contains(R"("lines":["∀ x : 1 ‥ 3 • x < 3  ▸  false","  counter-example  ▸  x == 3",)") &&
                       Contains(R"("value":"false","yes":false)"));
  CHECK_THAT(
      asked(R"({"call":"eval","expression":"N + 1","text":"\\begin{axdef} N : \\nat \\end{axdef}","let":["N=7"]})"),
      StartsWith(R"({"value":"8",)"));
}

TEST_CASE("a name may be local to an expression, with a value that has the names before it") {
  const std::string rest = R"(,"expression":"e? ∈ elementos ∧ mi_radio e? < radio? ∧ centro?.y = radio?","bindings":)";
  CHECK_THAT(of_scene("eval", rest + R"({"e?":"ball","radio?":"3/2","centro?":"⦉x == 0, y == radio?, z == 0⦊"})"),
             StartsWith(R"({"value":"true","yes":true,)"));
  CHECK_THAT(of_scene("eval",
                      rest + R"({"e?":"\"tube\"","radio?":"1/4","centro?":"⦉x == 0, y == 0, z == 0⦊"},"explain":true)"),
             Contains(R"({"term":"e? ∈ elementos","value":"true")") &&
                 Contains(R"({"term":"mi_radio e? < radio?","value":"false")"));
  CHECK_THAT(error_of(of_scene("eval", rest + R"({"e?":"nadie"})")),
             Contains("e?: nadie is not declared; expected a declared name"));
  CHECK_THAT(error_of(of_scene("eval", rest + R"({"1":"2"})")),
             EndsWith("1: this is no name; expected one, such as radio?"));
  CHECK_THAT(error_of(of_scene("eval", rest + R"({"e?":"1 = 1"})")),
             EndsWith("e?: a predicate has no value; expected an expression"));
  CHECK_THAT(error_of(of_scene("eval", rest + R"({"e?":"1/0"})")), Contains("e?: this has no value"));
}

TEST_CASE("an expression that cannot be evaluated is refused at its place") {
  CHECK_THAT(error_of(call(R"({"call":"eval","expression":"1 + nadie"})")),
             StartsWith("expression:1:5: nadie is not declared; "));
  CHECK_THAT(error_of(call(R"({"call":"eval","expression":"# {x : ℕ | x mod 2 = 1}"})")),
             StartsWith("expression:1:1: this is not decided: "));
  CHECK(
      error_of(call(R"({"call":"eval","expression":"# { x : 1‥1000 | x > 5 }","steps":10
})")) ==
      "expression:1:1: steps 10 did not do: stopped after 10 steps; expected a smaller expression, or a greater steps");
  CHECK_THAT(error_of(call(R"({"call":"eval","expression":"1","let":["N=1"]})")), StartsWith("let:1:1: "));
  CHECK_THAT(error_of(of_scene("eval", R"(,"expression":"1","text":"")")),
             EndsWith("a scene is a state of the program's own text; expected no text beside it"));
  CHECK_THAT(error_of(call(R"({"call":"eval","expression":"1","text":"nothing","name":"t.tex"})")),
             StartsWith("t.tex:1:1: no Z paragraph; "));
}

TEST_CASE("a text is checked in the lines of durero spec check") {
  CHECK(
      asked(R"({"call":"zed.check","text":"\\begin{zed} N == M \\end{zed}","name":"t.tex"})") ==
      R"({"ok":false,"defects":[{"file":"t.tex","line":1,"column":18,"severity":"error","message":"M is not declared",)"
      R"("expected":"expected a declared name"}],"sections":[{"file":"t.tex","name":"Specification","paragraphs":1}],)"
      R"("conjectures":[],"taken":[],"lines":["t.tex:1:18: M is not declared; expected a declared name"]})");
  CHECK_THAT(asked(R"({"call":"zed.check","text":"\\begin{zed} \\vdash? \\forall n : 1 \\upto 2 @ n = 1 \\end{zed}"})"),
             StartsWith(R"({"ok":false,"defects":[],)") && Contains(R"("refuted":true,"counterexample":["  n = 2"])"));
  CHECK_THAT(asked(R"({"call":"zed.check","text":"\\begin{zsection}\n\\SECTION s \\parents tipos\n\\end{zsection}\n)"
                   R"(\\begin{zed} O == Punto \\end{zed}"})"),
             StartsWith(R"({"ok":true,)"));
  CHECK_THAT(asked(R"({"call":"zed.check","states":0})"),
             StartsWith(R"({"ok":true,)") && Contains("proved as Init_exists"));
  CHECK_THAT(error_of(call(R"({"call":"zed.check","text":7})")), EndsWith("text is a number; expected a string"));
  CHECK_THAT(error_of(call(R"({"call":"zed.check","name":"t"})")),
             EndsWith("name names no text; expected text beside it"));
}

/// A call about the birthday book of two people and one date.
std::string about_book(const std::string& name, const std::string& rest) {
  return asked(fmt::format(R"({{"call":"{}","text":{},"setup":{{"given":{{"NAME":["ann","bob"],"DATE":1}}}}{}}})", name,
                           json_of(file_text("demo/birthday_book.tex")), rest));
}

TEST_CASE("a machine begins, goes on by the way that it was told, and lists what may follow") {
  const std::string begun = about_book("zed.run", "");
  CHECK_THAT(begun,
             StartsWith(R"({"state":"BirthdayBook","init":"InitBirthdayBook","carriers":["DATE == {DATE1}",)"
                        R"("NAME == {ann, bob}"],"taken":[],"components":[{"name":"known","type":"ℙ NAME"},)") &&
                 Contains(R"("states":[{"operation":"InitBirthdayBook","line":"InitBirthdayBook","inputs":{},)") &&
                 Contains(R"("values":{"known":"∅[NAME]","birthday":"∅[NAME × DATE]"},"changed":[]}])") &&
                 Contains(R"("ways":[],"refused":null)"));
  const std::string way = json_of(text_of_member(begun, "way"));
  const std::string added =
      about_book("zed.run", R"(,"way":)" + way + R"(,"step":{"operation":"AddBirthday","inputs":{"name?":"ann"}})");
  CHECK_THAT(added, Contains(R"("inputs":{"date?":"DATE1","name?":"ann"},"outputs":{},)") &&
                        Contains(R"("changed":["known","birthday"]})"));
  const std::string two = about_book("zed.run", R"(,"way":)" + way + R"(,"step":{"operation":"AddBirthday"})");
  CHECK_THAT(two, Contains(R"("ways":[{"step":{"operation":"AddBirthday",)") && !Contains(R"("ways":[],)"));
  const std::string again =
      about_book("zed.run", R"(,"way":)" + json_of(text_of_member(added, "way")) +
                                R"(,"step":{"operation":"AddBirthday","inputs":{"name?":"ann"}})");
  CHECK_THAT(again, Contains(R"("refused":"AddBirthday cannot go on here")"));
}

TEST_CASE("of an operation it is told what refuses it, and whether it may go on where that is looked for") {
  const std::string looked = about_book("zed.run", "");
  CHECK_THAT(looked, Contains(R"("enabled":"yes","example":"AddBirthday  date? = DATE1; name? = ann","refused":null,)"
                              R"("predicates":[{"truth":"true",)"));
  const std::string not_looked = about_book("zed.run", R"(,"look":false)");
  CHECK_THAT(not_looked, Contains(R"({"name":"AddBirthday",)") && Contains(R"("refused":null})") &&
                             !Contains("enabled") && !Contains("predicates"));
  const std::string own = asked(R"({"call":"zed.run"})");
  CHECK_THAT(own, StartsWith(R"({"state":"Escena","init":"Init",)") && !Contains("enabled"));
}

TEST_CASE("what a machine cannot be asked is refused at its place") {
  const std::string way = json_of(text_of_member(about_book("zed.run", ""), "way"));
  const auto step = [&](const std::string& of) {
    return error_of(about_book("zed.run", R"(,"way":)" + way + R"(,"step":)" + of));
  };
  CHECK_THAT(step(R"({"operation":"Nada"})"), EndsWith("no operation is called \"Nada\"; expected one of the text"));
  CHECK_THAT(step(R"({"operation":"AddBirthday","inputs":{"x?":"1"}})"), Contains("\"x?\" is no input of AddBirthday"));
  CHECK_THAT(step(R"({"operation":"AddBirthday","inputs":{"name?":"carl"}})"), Contains("name?: carl is not declared"));
  CHECK_THAT(step(R"({"inputs":{}})"), Contains("operation"));
  CHECK_THAT(error_of(about_book("zed.run", R"(,"way":"nothing")")), StartsWith("way:1:1: this is no trace"));
  CHECK_THAT(error_of(about_book("zed.run", R"(,"step":{"operation":"AddBirthday"})")),
             Contains("there is no state yet"));
  CHECK_THAT(error_of(call(R"({"call":"zed.run","text":"\\begin{zed} N == 1 \\end{zed}"})")), StartsWith("text:1:1: "));
  CHECK_THAT(error_of(call(R"({"call":"zed.run","setup":{"members":0}})")), Contains("expected 1 to 20"));
  CHECK_THAT(error_of(call(R"({"call":"zed.run","setup":{"given":{"N":"x"}}})")), StartsWith("call:1:"));
}

TEST_CASE("the states of a machine are a graph, and a false conjecture has the way to it") {
  const std::string graph = about_book("zed.graph", "");
  CHECK_THAT(
      graph,
      Contains(R"("states":[{"initial":true,"values":{"known":"∅[NAME]",)") &&
          Contains(R"({"from":0,"to":1,"operation":"AddBirthday","line":"AddBirthday  date? = DATE1; name? = ann"})") &&
          Contains(R"("way":["InitBirthdayBook","AddBirthday)"));
  CHECK_THAT(about_book("zed.graph", R"(,"most":2)"), Contains(R"("bounded":["states: --states"])"));
}

TEST_CASE("a surface of a text is met by a grid of rays, and its type is told") {
  const std::string torus = json_of(file_text("demo/surfaces/torus.tex"));
  const std::string types = R"({"types":[{"tipo":"toro","attributes":[{"name":"centro","kind":"triple"},)"
                            R"({"name":"mayor","kind":"number"},{"name":"menor","kind":"number"}]}])";
  CHECK(asked(fmt::format(R"({{"call":"surface","with":{}}})", torus)) == types + "}");
  const std::string grid = asked(fmt::format(R"({{"call":"surface","with":{},"scene":{},"width":3,"height":2}})", torus,
                                             json_of(file_text("demo/surfaces/torus.json"))));
  CHECK_THAT(grid, StartsWith(types + R"(,"width":3,"height":2,"hits":[{"e":"floor","t":14.442056704564095,)") &&
                       Contains(R"({"e":"ring",)"));
  CHECK_THAT(error_of(call(fmt::format(R"({{"call":"surface","with":{},"scene":{},"width":0}})", torus, scene))),
             EndsWith("width is 0; expected 1 to 512"));
  CHECK_THAT(
      error_of(call(fmt::format(
          R"({{"call":"surface","with":{},"scene":{{"format":"durero-scene","version":1,"elementos":[]}}}})", torus))),
      EndsWith("the scene has no camera; expected one, which rays start from"));
}

TEST_CASE("a scene becomes a shader with the names of its elements and its uniforms") {
  const std::string answer = of_scene("render_shader", R"(,"writes":"answer")");
  require_line(answer);
  CHECK_THAT(answer, StartsWith(R"({"fragment":"#version 300 es\u000a)") &&
                         EndsWith(R"(,"elementos":["ball","tube"],"uniforms":{"eye":[0,0,5],"forward":[0,0,-1],)"
                                  R"("step_x":[0.002301186555996537,-0,0],"step_y":[0,0.002301186555996537,0],)"
                                  R"("size":[640,360]}})"));
  CHECK(answer != of_scene("render_shader", ""));
  CHECK_THAT(error_of(of_scene("render_shader", R"(,"writes":"x")")),
             EndsWith("no shader writes \"x\"; expected color, answer or doubts"));
  CHECK(error_of(call(R"({"call":"render_shader","scene":{"format":"durero-scene","version":1,"elementos":[]}})"))
            .starts_with("scene:1:1: "));
}

TEST_CASE("what is kept is kept by the whole text") {
  for (int turn = 0; turn < 2; ++turn)
    for (int radius = 1; radius < 5; ++radius) {
      CHECK_THAT(
          asked(fmt::format(R"({{"call":"trace","scene":{{"format":"durero-scene","version":1,"elementos":[{{"id":)"
                            R"("a","tipo":"esfera","centro":[0,0,0],"radio":{}}}]}},"rays":[[0,0,9,0,0,-1]]}})",
                            radius)),
          Contains(fmt::format("\"t\":{},", 9 - radius)));
      CHECK_THAT(asked(fmt::format(R"({{"call":"zed.run","text":"\\begin{{schema}}{{S}} n : \\nat \\end{{schema}} )"
                                   R"(\\begin{{schema}}{{Init}} S \\where n = {} \\end{{schema}} )"
                                   R"(\\begin{{schema}}{{Op}} \\Delta S \\end{{schema}}"}})",
                                   radius)),
                 Contains(fmt::format(R"("values":{{"n":"{}"}})", radius)));
    }
}

TEST_CASE("an answer does not depend on what was asked before") {
  const std::string way = json_of(text_of_member(about_book("zed.run", ""), "way"));
  const auto ask = [&](int which) {
    switch (which % 5) {
      case 0:
        return of_scene("trace", R"(,"rays":[[0,0,5,0,0,-1]])");
      case 1:
        return about_book("zed.run", R"(,"way":)" + way);
      case 2:
        return of_scene("eval", R"(,"expression":"# elementos")");
      case 3:
        return asked(R"({"call":"zed.check","text":"\\begin{zed} N == 1 \\end{zed}"})");
      default:
        return asked(fmt::format(R"({{"call":"eval","expression":"{}","text":"\\begin{{zed}} N == {} \\end{{zed}}"}})",
                                 "N", which));
    }
  };
  std::vector<std::string> first;
  for (int which = 0; which < 60; ++which) first.push_back(ask(which));
  for (int which = 59; which >= 0; --which) CHECK(ask(which) == first[static_cast<std::size_t>(which)]);
}

}  // namespace
}  // namespace durero::web
