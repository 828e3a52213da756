// Stores: whatever is edited, undone, done again and left, each event has the scene that its operations alone give.
#include "durero/store/store.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <thread>

#include "kept.hpp"
#include "support/catch.hpp"
#include "support/scenes.hpp"

using namespace durero;
using test::ball;
using test::balls;
using test::edit;
using test::KeptStore;
using test::text_at;

namespace {

const std::string sample =
    R"({"format":"durero-scene","version":1,"materials":{"red":{"color":[1,0,0]}},"groups":{"g":{"elementos":["a"]}},)"
    R"("elementos":[{"id":"a","tipo":"esfera","centro":[0,0,0],"radio":1}]})";

/// The scene of operations, without a store.
std::string text_after(const std::string& scene, const std::vector<std::string>& operations) {
  io::EditedScene edited(scene.empty() ? scene::GroupedScene()
                                       : io::read_grouped_scene(io::Source("s", scene), io::Bodies::read));
  for (const std::string& operation : operations)
    for (const io::ScriptStep& step : io::read_script(test::script(operation), edited.of().scene.stage()))
      edited.apply_total(step);
  return edited.scene_text();
}

std::string error_of(const std::function<void()>& what) {
  try {
    what();
  } catch (const io::FileError& error) {
    return error.what();
  }
  return "none";
}

}  // namespace

TEST_CASE("An edit is kept with its answer, and a refused one is not") {
  const KeptStore kept(sample);
  {
    store::Store of = kept.open();
    const store::EditResult result = edit(of, "# a comment\n  " + ball(1) + ball(1) + "Eliminar_Esfera e=a # gone\n");
    CHECK(result.is_refused);
    CHECK(result.event == 3);
    CHECK(
        result.answers ==
        R"({"line":2,"ok":true,"r":"esfera_agregada"})"
        "\n"
        R"({"line":3,"ok":false,"r":"elemento_ya_existe","violated":"Agregar_Elemento.pre.1","predicate":"e? ∉ elementos"})"
        "\n"
        R"({"line":4,"ok":true,"r":"esfera_eliminada","left_group":"g"})"
        "\n");
  }
  store::Store of = kept.open(store::StoreAccess::read);
  CHECK(of.last() == 3);
  CHECK(text_at(of) == text_after(sample, {ball(1), "Eliminar_Esfera e=a"}));
  const store::HistoryEvent first = of.event(2), second = of.event(3);
  CHECK(first.operation == "Agregar_Esfera e?=s1 centro?=(1,0,0) radio?=1");
  CHECK(first.begins);
  CHECK(first.by.author == "ann");
  CHECK(second.operation == "Eliminar_Esfera e=a # gone");
  CHECK(second.answer == R"({"line":4,"ok":true,"r":"esfera_eliminada","left_group":"g"})");
  CHECK_FALSE(second.begins);
  CHECK(second.parent == 2);
  CHECK(second.hash == hash_of(second, first.hash));
}

TEST_CASE("All operations are kept, or none") {
  const KeptStore kept;
  store::Store of = kept.open();
  CHECK(edit(of, ball(1) + ball(2), true).event == 3);
  const store::EditResult refused = edit(of, ball(3) + ball(1) + ball(4), true);
  CHECK(refused.is_refused);
  CHECK(refused.event == store::no_event);
  CHECK(std::ranges::count(refused.answers, '\n') == 2);
  CHECK(of.last() == 3);
  CHECK(text_at(of) == text_after("", {balls(1, 3)}));
  CHECK(edit(of, ball(3), true).event == 4);
  CHECK(text_at(of) == text_after("", {balls(1, 4)}));
}

TEST_CASE("A line that is no operation leaves nothing of its transaction") {
  const KeptStore kept;
  store::Store of = kept.open();
  CHECK_THROWS_AS(edit(of, ball(1) + "Mover e=s1\n"), io::InputError);
  CHECK(of.last() == 1);
  CHECK(edit(of, ball(1)).event == 2);
}

TEST_CASE("A transaction that fails in its midst leaves nothing, and the store goes on") {
  const KeptStore kept;
  store::Store of = kept.open();
  std::size_t asked = 0;
  const store::CarryOut failing = [&](io::EditedScene& edited, const io::ScriptStep& step) {
    if (++asked == 2) throw std::runtime_error("in the midst");
    return edited.apply_total(step);
  };
  CHECK_THROWS_WITH(of.edit({test::script(balls(1, 4)), 0, test::by_ann, false, failing}), "in the midst");
  CHECK(text_at(of) == text_after("", {}));
  asked = 0;
  CHECK_THROWS_WITH(of.edit({test::script(balls(1, 4)), 0, test::by_ann, false, failing}), "in the midst");
  store::Store other = kept.open();
  edit(other, ball(7));  // under the number that the first had in what has failed
  edit(of, ball(8));
  CHECK(text_at(of) == text_after("", {ball(7), ball(8)}));
}

TEST_CASE("Undo goes back a transaction at a time, and redo to where it left from last") {
  const KeptStore kept;
  store::Store of = kept.open();
  CHECK_FALSE(of.undo());
  CHECK_FALSE(of.redo());
  edit(of, balls(1, 3));
  edit(of, balls(3, 6));
  const std::string both = text_at(of);
  CHECK(of.undo() == 3);
  CHECK(text_at(of) == text_after("", {balls(1, 3)}));
  CHECK(of.undo() == 1);
  CHECK_FALSE(of.undo());
  CHECK(text_at(of) == text_after("", {}));
  CHECK(of.redo() == 3);
  CHECK(of.redo() == 6);
  CHECK_FALSE(of.redo());
  CHECK(text_at(of) == both);
  // Another edit is another way; the first is there still, and from where they part redo goes the last way.
  of.undo();
  CHECK(edit(of, ball(9)).event == 7);
  CHECK_FALSE(of.redo());
  CHECK(text_at(of) == text_after("", {balls(1, 3), ball(9)}));
  CHECK(text_at(of, "6") == both);
  CHECK(of.undo() == 3);
  CHECK(of.redo() == 7);
  CHECK(of.common_ancestor(6, 7) == 3);
  CHECK(of.common_ancestor(7, 2) == 2);
}

TEST_CASE("What an addition answers of a group depends on its own transaction alone") {
  const KeptStore kept(sample);
  store::Store of = kept.open();
  const std::string again = "Agregar_Esfera e?=a centro?=(0,0,0) radio?=1\n";
  CHECK(edit(of, "Eliminar_Esfera e=a\n" + again)
            .answers.find("\"line\":2,\"ok\":true,\"r\":\"esfera_agregada\",\"left_group\":\"g\"") !=
        std::string::npos);
  of.undo();
  edit(of, "Eliminar_Esfera e=a\n");
  CHECK(edit(of, again).answers == R"({"line":1,"ok":true,"r":"esfera_agregada"})"
                                   "\n");
  store::Store reader = kept.open(store::StoreAccess::read);
  CHECK(text_at(reader) == text_at(of));  // each answer is held against what is kept
}

TEST_CASE("A revision is HEAD, a number, a branch or a tag, and perhaps some transactions before") {
  const KeptStore kept;
  store::Store of = kept.open();
  edit(of, balls(1, 4));
  edit(of, ball(4));
  of.add_tag("v1", "HEAD~1");
  of.add_branch("other", "v1");
  for (const auto& [revision, number] : std::map<std::string, store::EventNumber>{{"HEAD", 5},
                                                                                  {"HEAD~", 4},
                                                                                  {"HEAD~0", 5},
                                                                                  {"HEAD~2", 1},
                                                                                  {"main", 5},
                                                                                  {"3", 3},
                                                                                  {"3~1", 1},
                                                                                  {"v1", 4},
                                                                                  {"other~1", 1}})
    CHECK(of.find(revision) == number);
  for (const char* none : {"", "~1", "0", "6", "-1", "main~x", "main~3", "v2", "HEAD~-1", "99999999999999999999"})
    CHECK(error_of([&] { of.find(none); }).find("no revision \"" + std::string(none)) != std::string::npos);
  CHECK(error_of([&] { of.find("v2"); }) ==
        kept.path + ": no revision \"v2\"; expected the number of an event, or one of HEAD, main, other, v1");
}

TEST_CASE("Branches go on with their edits, tags stay, and no name is given twice") {
  const KeptStore kept;
  store::Store of = kept.open();
  edit(of, ball(1));
  of.add_branch("night", "HEAD");
  of.add_tag("v1", "HEAD");
  of.go_to("night");
  CHECK(of.head().branch == "night");
  CHECK(edit(of, ball(2)).event == 3);
  CHECK(of.find("night") == 3);
  CHECK(of.find("main") == 2);
  CHECK(of.find("v1") == 2);
  of.go_to("v1");
  CHECK(of.head().branch.empty());
  CHECK(edit(of, ball(3)).event == 4);  // on no branch
  CHECK(of.head().event == 4);
  CHECK(of.find("v1") == 2);
  CHECK(of.undo() == 2);
  CHECK(of.redo() == 4);
  of.go_to("main");
  CHECK(of.head().event == 2);
  CHECK(text_at(of, "4") == text_after("", {ball(1), ball(3)}));
  for (const char* taken : {"main", "night", "v1"}) {
    CHECK_THROWS_AS(of.add_branch(taken, "1"), io::FileError);
    CHECK_THROWS_AS(of.add_tag(taken, "1"), io::FileError);
  }
  for (const char* none : {"", "12", "HEAD", "a b", "a~1"}) CHECK_THROWS_AS(of.add_tag(none, "1"), io::FileError);
  CHECK_THROWS_AS(of.remove_branch("main"), io::FileError);
  CHECK_THROWS_AS(of.remove_branch("v1"), io::FileError);
  CHECK_THROWS_AS(of.remove_tag("night"), io::FileError);
  of.remove_branch("night");
  of.remove_tag("v1");
  CHECK(of.branches().size() == 1);
  CHECK(of.tags().empty());
  CHECK(text_at(of, "3") == text_after("", {ball(1), ball(2)}));
}

TEST_CASE("An import puts another scene in the place, and is undone as one step") {
  const KeptStore kept;
  store::Store of = kept.open();
  edit(of, balls(1, 3));
  CHECK(of.import(io::read_grouped_scene(io::Source("s", sample)), "s.json", test::by_ann) == 4);
  CHECK(text_at(of) == text_after(sample, {}));
  const std::string material = "Agregar_Esfera e?=b centro?=(5,0,0) radio?=1 material?=red\n";
  edit(of, material);
  CHECK(text_at(of) == text_after(sample, {material}));
  of.undo();
  of.undo();
  CHECK(text_at(of) == text_after("", {balls(1, 3)}));
  of.redo();
  CHECK(text_at(of) == text_after(sample, {}));
}

TEST_CASE("Long histories have snapshots on their way, and each event its own scene") {
  const KeptStore kept;
  const int count = 2600;
  {
    store::Store of = kept.open();
    for (int i = 0; i < count; i += 100) edit(of, balls(i, i + 100));
    for (int i = 0; i < count; i += 2) edit(of, fmt::format("Eliminar_Esfera e=s{}\n", i));
  }
  store::Store of = kept.open(store::StoreAccess::read);
  for (const int at : {0, 1, 999, 1000, 1001, 1002, 2000, 2599, 2600}) {
    CHECK(text_at(of, std::to_string(at + 1)) == text_after("", {balls(0, at)}));
  }
  std::vector<std::string> all{balls(0, count)};
  for (int i = 0; i < count; i += 2) all.push_back(fmt::format("Eliminar_Esfera e=s{}\n", i));
  CHECK(text_at(of) == text_after("", all));
}

TEST_CASE("Whatever is done, in any order, each event has the scene that its own operations give") {
  const KeptStore kept(sample);
  test::Random random(20260131);
  std::map<store::EventNumber, std::vector<std::string>> operations{{1, {}}};
  int names = 0;
  for (int i = 0; i < 300; ++i) {
    store::Store of = kept.open();
    switch (random.below(6)) {
      case 0:
        of.undo();
        break;
      case 1:
        of.redo();
        break;
      case 2:
        of.go_to(random.below(2) == 0 ? "main"
                                      : std::to_string(1 + random.below(static_cast<std::uint64_t>(of.last()))));
        break;
      default: {  // a transaction of some operations, of which some are refused
        std::string lines;
        for (std::uint64_t n = 1 + random.below(4); n > 0; --n)
          lines += random.below(3) == 0 ? fmt::format("Eliminar_Elemento e=s{}\n", random.below(20))
                                        : ball(static_cast<int>(random.below(20)), 0.5 + names++);
        const store::EventNumber before = of.head().event, last = of.last();
        edit(of, lines);
        for (store::EventNumber event = last + 1; event <= of.last(); ++event) {
          operations[event] = operations[event == last + 1 ? before : event - 1];
          operations[event].push_back(of.event(event).operation);
        }
      }
    }
  }
  store::Store of = kept.open(store::StoreAccess::read);
  REQUIRE(of.last() > 150);
  REQUIRE(operations.size() == static_cast<std::size_t>(of.last()));
  for (const auto& [event, all] : operations) CHECK(text_at(of, std::to_string(event)) == text_after(sample, all));
}

TEST_CASE("A reader sees what was there when it began, whatever a writer does") {
  const KeptStore kept;
  store::Store writer = kept.open();
  edit(writer, ball(1));
  store::Store reader = kept.open(store::StoreAccess::read);
  CHECK(reader.last() == 2);
  edit(writer, ball(2));
  CHECK(reader.last() == 2);
  CHECK(text_at(reader) == text_after("", {ball(1)}));
  store::Store later = kept.open(store::StoreAccess::read);
  CHECK(later.last() == 3);
}

TEST_CASE("Writers wait for each other, and each goes on where the other left") {
  const KeptStore kept;
  const auto write = [&](int first) {
    store::Store of = kept.open();
    for (int i = first; i < first + 50; ++i) edit(of, ball(i));
  };
  std::thread one([&] { write(0); }), two([&] { write(50); });
  one.join();
  two.join();
  store::Store of = kept.open(store::StoreAccess::read);
  CHECK(of.last() == 101);
  CHECK(text_at(of) == text_after("", {balls(0, 100)}));
}

TEST_CASE("A file that is no store is refused, and a store takes no file's place") {
  test::Folder folder;
  const auto write = [&](const std::string& name, const std::string& bytes) {
    std::ofstream(folder.file(name)) << bytes;
    return folder.file(name);
  };
  const auto error_at = [&](const std::string& path) {
    return error_of([&] { store::Store of(path, store::StoreAccess::read); });
  };
  const std::string nowhere = folder.file("nowhere"), empty = write("empty", ""), text = write("text", sample);
  CHECK(error_at(nowhere) == nowhere + ": cannot be read: No such file or directory; expected a store");
  CHECK(error_at(empty) == empty + ": is empty; expected a store, which `durero store init` makes");
  CHECK(error_at(text) == text + ": is no store; expected one that `durero store init` made");
  CHECK(error_of([&] { store::Store::create(text, {}, "", {}); }) ==
        text + ": is there already; expected a path of no file, for a new store");
  store::Store::create(empty, {}, "", {});  // as an init leaves it that is killed
  CHECK(error_at(empty) == "none");
  const std::string deep = folder.file("none/here");
  CHECK(error_of([&] { store::Store::create(deep, {}, "", {}); }).starts_with(deep + ": cannot be written: No such"));
}
