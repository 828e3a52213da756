// Whether a store is whole: every change of what it holds is found, and what is salvaged is whole.
#include "durero/store/verification.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>

#include "kept.hpp"
#include "store/database.hpp"
#include "support/catch.hpp"

using namespace durero;
using store::EventStanding;
using test::ball;
using test::balls;
using test::edit;
using test::KeptStore;
using test::text_at;

namespace {

void change(const KeptStore& kept, const std::string& sql) {
  store::open_database(kept.path, store::Database::Mode::write)->run(sql);
}

store::StoreReport verified(const std::string& path, const store::CarryOut& by = store::carry_out) {
  store::Store of(path, store::StoreAccess::read);
  return store::verify(of, by);
}

std::string standings(const store::StoreReport& report) {
  std::string text;
  for (const EventStanding standing : report.standings) text += "wrfl"[static_cast<int>(standing)];
  return text;
}

/// What is left, in a new store that is whole.
struct Left {
  explicit Left(const KeptStore& kept) : path(kept.path + ".left") {
    std::filesystem::remove(path);
    store::Store of(kept.path, store::StoreAccess::read);
    const store::StoreReport report = store::verify(of);
    said = store::salvage(of, report, path);
    const store::StoreReport again = verified(path);
    CHECK(again.defects == std::vector<std::string>());
  }
  store::Store open() const { return store::Store(path, store::StoreAccess::read); }

  std::string path;
  std::vector<std::string> said;
};

/// Three transactions of two balls, a branch from the first on, and a tag.
struct Sample : KeptStore {
  Sample() {
    store::Store of = open();
    edit(of, balls(0, 2));  // events 2 and 3
    edit(of, balls(2, 4));  // 4 and 5
    of.undo();
    of.add_branch("other", "HEAD");
    of.go_to("other");
    edit(of, balls(6, 8));  // 6 and 7
    of.add_tag("v1", "HEAD");
    of.go_to("main");
    of.redo();
    edit(of, balls(4, 6));  // 8 and 9
  }
};

}  // namespace

TEST_CASE("A store that was written by its program is whole") {
  const Sample kept;
  const store::StoreReport report = verified(kept.path);
  CHECK(report.defects == std::vector<std::string>());
  CHECK(standings(report) == "wwwwwwwww");
  CHECK(report.snapshots == 1);
  CHECK(report.names == 3);
  const Left left(kept);
  CHECK(left.said.empty());
  store::Store was = kept.open(store::StoreAccess::read), is = left.open();
  CHECK(is.last() == was.last());
  for (store::EventNumber number = 1; number <= was.last(); ++number)
    CHECK(is.event(number).hash == was.event(number).hash);
  for (const char* revision : {"HEAD", "other", "v1", "5"}) CHECK(text_at(is, revision) == text_at(was, revision));
  CHECK(is.head().branch == "main");
}

TEST_CASE("Each change of an event is found, and what stands on it is lost") {
  const char* const changes[] = {
      "UPDATE event SET operation = 'Agregar_Esfera e?=s2 centro?=(2,0,0) radio?=9' WHERE number = 4",
      "UPDATE event SET answer = '{}' WHERE number = 4",
      "UPDATE event SET author = 'bob' WHERE number = 4",
      "UPDATE event SET time = '2026-01-31T12:00:01Z' WHERE number = 4",
      "UPDATE event SET comment = '' WHERE number = 4",
      "UPDATE event SET line = 2 WHERE number = 4",
      "UPDATE event SET content = hash WHERE number = 4",
      "UPDATE event SET begins = 0 WHERE number = 4",
      "UPDATE event SET kind = 0 WHERE number = 4",
      "UPDATE event SET kind = 7 WHERE number = 4",
      "UPDATE event SET parent = 2 WHERE number = 4",
      "UPDATE event SET parent = 0 WHERE number = 4",
      "UPDATE event SET parent = 8 WHERE number = 4",
      "UPDATE event SET hash = (SELECT hash FROM event WHERE number = 2) WHERE number = 4",
      "UPDATE event SET hash = content WHERE number = 4",
      "DELETE FROM event WHERE number = 4",
  };
  for (const char* sql : changes) {
    INFO(sql);
    const Sample kept;
    const std::string other = [&] {
      store::Store of = kept.open(store::StoreAccess::read);
      return text_at(of, "other");
    }();
    change(kept, sql);
    const store::StoreReport report = verified(kept.path);
    CHECK_FALSE(report.is_whole());
    CHECK(standings(report) == "wwwllwwll");
    store::Store of = kept.open(store::StoreAccess::read);
    CHECK_THROWS_AS(text_at(of), io::FileError);
    CHECK(text_at(of, "other") == other);
    const Left left(kept);
    // Whatever parent the changed row names, or the event that was written before it.
    const int place = std::string(sql).find("parent = 2") == std::string::npos ? 3 : 2;
    CHECK(left.said ==
          std::vector<std::string>{fmt::format(
              "branch main stood for event 9, which is lost; it stands for event {} of the new store", place)});
    store::Store is = left.open();
    CHECK(is.last() == 5);
    CHECK(text_at(is, "other") == other);
    CHECK(is.head().branch == "main");
  }
}

TEST_CASE("An edit that is kept with an answer that the contracts do not give is found") {
  const Sample kept;
  {  // another program's event, rightly chained, that tells a refused edit as accepted
    store::Store of = kept.open();
    const store::CarryOut lying = [](io::EditedScene&, const io::ScriptStep&) {
      return io::EditAnswer{"esfera_agregada"};
    };
    of.edit({test::script(ball(0)), 0, test::by_ann, false, lying});
  }
  const store::StoreReport report = verified(kept.path);
  REQUIRE(report.defects.size() == 1);
  CHECK(report.defects.front().starts_with("event 10 answers \"{\"line\":1,\"ok\":false"));
  CHECK(standings(report) == "wwwwwwwwwl");
}

TEST_CASE("Another opinion is asked for each edit") {
  const Sample kept;
  std::size_t asked = 0;
  CHECK(verified(kept.path, [&](io::EditedScene& edited, const io::ScriptStep& step) {
          ++asked;
          return edited.apply_total(step);
        }).is_whole());
  CHECK(asked == 8);
}

TEST_CASE("Each change of a name or a snapshot is found") {
  const std::pair<const char*, const char*> changes[] = {
      {"UPDATE name SET event = 4 WHERE name = 'v1'", "tag v1 is not as it was written"},
      {"UPDATE name SET event = 99 WHERE name = 'v1'", "tag v1 stands for event 99, which is missing"},
      {"UPDATE name SET name = 'v2' WHERE name = 'v1'", "tag v2 is not as it was written"},
      {"UPDATE name SET kind = 0 WHERE name = 'v1'", "branch v1 is not as it was written"},
      {"UPDATE name SET name = 'other' WHERE kind = 2", "HEAD is not as it was written"},
      {"DELETE FROM name WHERE kind = 2", "HEAD is missing"},
      {"DELETE FROM name WHERE name = 'main' AND kind = 0", "branch main, where HEAD is, is missing"},
      {"UPDATE name SET event = 6 WHERE kind = 3", "what to do again behind event 3 is not as it was written"},
      {"UPDATE snapshot SET seal = (SELECT hash FROM event WHERE number = 1)",
       "the snapshot of event 1 is not as it was written"},
      {"DELETE FROM snapshot", "the snapshot of event 1 is missing"},
      {"INSERT INTO snapshot SELECT 99, seal, content FROM snapshot WHERE event = 1",
       "the snapshot of event 99 has no event"},
  };
  for (const auto& [sql, defect] : changes) {
    INFO(sql);
    const Sample kept;
    change(kept, sql);
    const store::StoreReport report = verified(kept.path);
    CHECK_FALSE(report.is_whole());
    CHECK(std::ranges::find(report.defects, defect) != report.defects.end());
  }
}

TEST_CASE("A store without HEAD, or without its branch, gets one of what is left") {
  for (const auto& [sql, event] : {std::pair("DELETE FROM name WHERE kind = 2", 9),
                                   std::pair("DELETE FROM name WHERE kind = 0 AND name = 'main'", 9)}) {
    const Sample kept;
    change(kept, sql);
    const Left left(kept);
    CHECK(left.said == std::vector<std::string>{"HEAD is on branch main now"});
    store::Store is = left.open();
    CHECK(is.head().event == event);
    CHECK(is.last() == 9);
  }
  const Sample kept;
  change(kept, "UPDATE name SET event = 4 WHERE name = 'v1'");
  const Left left(kept);
  CHECK(left.said == std::vector<std::string>{"tag v1 is not as it was written, and left out"});
  CHECK(left.open().tags().empty());
}

TEST_CASE("Where what is before a snapshot is lost, its scene is told by it alone") {
  const KeptStore kept;
  {
    store::Store of = kept.open();
    for (int i = 0; i < 1200; i += 100) edit(of, balls(i, i + 100));
  }
  const std::string last = [&] {
    store::Store of = kept.open(store::StoreAccess::read);
    return text_at(of);
  }();
  SECTION("an event is changed") { change(kept, "UPDATE event SET author = 'bob' WHERE number = 500"); }
  SECTION("an event is missing") { change(kept, "DELETE FROM event WHERE number = 2"); }
  SECTION("the first snapshot is lost") { change(kept, "UPDATE snapshot SET seal = content WHERE event = 1"); }
  SECTION("the event of the snapshot is changed, but for its hash") {
    change(kept, "UPDATE event SET comment = 'no' WHERE number = 1001");
  }
  const store::StoreReport report = verified(kept.path);
  CHECK_FALSE(report.is_whole());
  CHECK(standings(report).substr(1000, 2) == "rf");
  CHECK(standings(report).back() == 'f');
  const Left left(kept);
  store::Store is = left.open();
  CHECK(text_at(is) == last);
  // The import is a step of undo by itself: before it is what was left of the past, or nothing.
  store::Store writer(left.path, store::StoreAccess::write);
  writer.undo();
  const store::EventNumber import = writer.undo().value();
  CHECK(writer.event(import).kind == store::EventKind::import);
  CHECK(writer.state(import).scene.size() == 1000);
  CHECK(writer.before_transaction(import) == writer.event(import).parent);
}

TEST_CASE("A snapshot that is another scene's is found, and events around it are whole") {
  const KeptStore kept;
  {
    store::Store of = kept.open();
    for (int i = 0; i < 1200; i += 100) edit(of, balls(i, i + 100));
    of.undo();
    edit(of, ball(2000));  // from event 1101 on, whose nearest snapshot is the one that is changed
  }
  change(kept, "UPDATE snapshot SET content = (SELECT content FROM snapshot WHERE event = 1) WHERE event = 1001");
  const store::StoreReport report = verified(kept.path);
  CHECK(report.defects == std::vector<std::string>{"the snapshot of event 1001 is not as it was written"});
  CHECK(std::ranges::count(report.standings, EventStanding::whole) == 1202);
  CHECK(report.spoiled == std::vector<store::EventNumber>{1001});
  store::Store of = kept.open(store::StoreAccess::read);
  CHECK_THROWS_AS(text_at(of), io::FileError);
  const Left left(kept);
  store::Store is = left.open();
  CHECK(is.last() == 1202);
  CHECK(is.state(1202).scene.size() == 1101);
}
