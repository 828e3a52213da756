// Events: a hash sees each thing that an event says, and a time is one of a day that there is.
#include "durero/store/history_event.hpp"

#include <functional>

#include "support/catch.hpp"

using namespace durero::store;

TEST_CASE("A hash sees whatever an event says, its parent and its content") {
  const HistoryEvent event{7, 6, EventKind::edit, true, 3, "ungroup g=a", "{}", {"ann", "2026-01-31T12:00:00Z", "why"},
                           {}};
  const Digest parent = digest_of("parent"), hash = hash_of(event, parent);
  CHECK(hash_of(event, parent) == hash);
  CHECK(hash_of(event, digest_of("another")) != hash);
  const std::function<void(HistoryEvent&)> changes[] = {[](HistoryEvent& e) { e.kind = EventKind::import; },
                                                        [](HistoryEvent& e) { e.begins = false; },
                                                        [](HistoryEvent& e) { e.line = 4; },
                                                        [](HistoryEvent& e) { e.operation += " "; },
                                                        [](HistoryEvent& e) { e.answer = "[]"; },
                                                        [](HistoryEvent& e) { e.by.author = "bob"; },
                                                        [](HistoryEvent& e) { e.by.time[18] = '1'; },
                                                        [](HistoryEvent& e) { e.by.comment = ""; },
                                                        [](HistoryEvent& e) { e.content = "content"; }};
  for (const auto& change : changes) {
    HistoryEvent changed = event;
    change(changed);
    CHECK(hash_of(changed, parent) != hash);
  }
  HistoryEvent moved = event;  // its number is its place in one store
  moved.number = 9, moved.parent = 8;
  CHECK(hash_of(moved, parent) == hash);
}

TEST_CASE("A time is one of UTC, of a day that there is") {
  for (const char* time : {"2026-01-31T12:00:00Z", "2024-02-29T23:59:59Z", "0000-01-01T00:00:00Z"})
    CHECK(is_time(time));
  for (const char* none :
       {"", "2026-01-31", "2026-02-29T12:00:00Z", "2026-13-01T12:00:00Z", "2026-00-01T12:00:00Z",
        "2026-01-31T24:00:00Z", "2026-01-31T12:60:00Z", "2026-01-31T12:00:60Z", "2026-01-31 12:00:00Z",
        "2026-01-31T12:00:00+", "-026-01-31T12:00:00Z", "2026-01-31T12:00:00Zx"})
    CHECK_FALSE(is_time(none));
}
