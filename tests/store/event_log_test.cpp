// The log of a store: its events, the last one first, with their names.
#include "durero/store/event_log.hpp"

#include "kept.hpp"
#include "store/database.hpp"
#include "support/catch.hpp"

using namespace durero;
using test::ball;
using test::edit;
using test::KeptStore;

namespace {

/// `5 HEAD main,4,…`: the numbers of a log's events, each with its names.
std::string log_of(store::Store& of, const store::LogCall& call) {
  std::string text;
  store::tell_log(of, call, [&](const store::HistoryEvent& event, const std::vector<std::string>& names) {
    text += std::to_string(event.number);
    for (const std::string& name : names) text += " " + name;
    text += ",";
  });
  return text;
}

}  // namespace

TEST_CASE("a log goes from a revision to the first event, or through all") {
  const KeptStore kept;
  store::Store of = kept.open();
  edit(of, ball(1) + ball(2));
  of.undo();
  edit(of, ball(3));
  of.add_tag("left", "3");
  CHECK(log_of(of, {}) == "4 HEAD main,1,");
  CHECK(log_of(of, {"left"}) == "3 left,2,1,");
  CHECK(log_of(of, {"HEAD", 0, true}) == "4 HEAD main,3 left,2,1,");
  CHECK(log_of(of, {"left", 2}) == "3 left,2,");
  CHECK(log_of(of, {"HEAD", 1, true}) == "4 HEAD main,");
  CHECK_THROWS_AS(log_of(of, {"nowhere"}), io::FileError);
}

TEST_CASE("a long log, which is read by runs, has each event of its way") {
  const KeptStore kept;
  store::Store of = kept.open();
  edit(of, test::balls(0, 3000));
  of.add_branch("early", "HEAD");
  of.undo();
  edit(of, test::balls(3000, 3100));
  of.go_to("early");
  edit(of, ball(9000));
  std::string main = "3101 main,", early = "3102 HEAD early,", all = early + main;
  for (int number = 3100; number > 3001; --number) main += std::to_string(number) + ",";
  for (int number = 3100; number > 3001; --number) all += std::to_string(number) + ",";
  for (int number = 3001; number > 1; --number) early += std::to_string(number) + ",";
  for (int number = 3001; number > 1; --number) all += std::to_string(number) + ",";
  CHECK(log_of(of, {"main"}) == main + "1,");
  CHECK(log_of(of, {"early"}) == early + "1,");
  CHECK(log_of(of, {"HEAD", 0, true}) == all + "1,");
  store::tell_log(of, {}, [&](const store::HistoryEvent& event, const std::vector<std::string>&) {
    CHECK(event.hash == of.event(event.number).hash);
  });
}

TEST_CASE("a log holds each event of a run against its hash") {
  for (const char* const sql : {"UPDATE event SET author = 'eve' WHERE number = 2",
                                "UPDATE event SET hash = (SELECT hash FROM event WHERE number = 1) WHERE number = 2"}) {
    const KeptStore kept;
    {
      store::Store of = kept.open();
      edit(of, test::balls(1, 5));
    }
    store::open_database(kept.path, store::Database::Mode::write)->run(sql);
    store::Store of = kept.open(store::StoreAccess::read);
    CHECK_THROWS_AS(log_of(of, {}), io::FileError);
    CHECK(log_of(of, {"HEAD", 2}) == "5 HEAD main,4,");
  }
}

TEST_CASE("a log ends at an event that is not as it was written, and none beside its way disturbs it") {
  const KeptStore kept;
  {
    store::Store of = kept.open();
    edit(of, ball(1));
    of.undo();
    edit(of, ball(2) + ball(3));
  }
  const auto change = [&](const char* sql) { store::open_database(kept.path, store::Database::Mode::write)->run(sql); };
  const auto whole_log = [&](bool all = false) {
    store::Store of = kept.open(store::StoreAccess::read);
    return log_of(of, {"HEAD", 0, all});
  };
  change("UPDATE event SET hash = content, parent = 9 WHERE number = 2");  // it cannot be read at all
  CHECK(whole_log() == "4 HEAD main,3,1,");
  CHECK_THROWS_WITH(whole_log(true), Catch::Contains("event 2 is spoiled"));
  store::Store of = kept.open(store::StoreAccess::read);
  CHECK(test::text_at(of).find("\"s3\"") != std::string::npos);
  change("UPDATE event SET author = 'eve' WHERE number = 3");
  CHECK_THROWS_WITH(whole_log(), Catch::Contains("event 3 is not as it was written"));
  change("DELETE FROM event WHERE number = 3");
  CHECK_THROWS_WITH(whole_log(), Catch::Contains("event 3 is missing"));
}

TEST_CASE("an event is a line of JSON, which says what it is") {
  const KeptStore kept;
  store::Store of = kept.open();
  edit(of, ball(1));
  const store::HistoryEvent first = of.event(1), second = of.event(2);
  CHECK(store::event_json(first, {}) ==
        R"({"event":1,"begins":true,"author":"ann","time":"2026-01-31T12:00:00Z","comment":"a reason",)"
        R"("import":"scene.json","answer":"{\"line\":1,\"ok\":true,\"r\":\"imported\"}","hash":")" +
            store::hexadecimal(first.hash) + "\",\"names\":[]}\n");
  CHECK(store::event_json(second, {"HEAD", "main"}) ==
        R"({"event":2,"parent":1,"begins":true,"author":"ann","time":"2026-01-31T12:00:00Z","comment":"a reason",)"
        R"("operation":"Agregar_Esfera e?=s1 centro?=(1,0,0) radio?=1",)"
        R"("answer":"{\"line\":1,\"ok\":true,\"r\":\"esfera_agregada\"}","hash":")" +
            store::hexadecimal(second.hash) + "\",\"names\":[\"HEAD\",\"main\"]}\n");
}
