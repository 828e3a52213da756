// The salvage of a store that is not whole.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "durero/store/verification.hpp"
#include "durero/text/shown.hpp"
#include "journal.hpp"

namespace durero::store {
namespace {

class Salvager {
 public:
  Salvager(Store& from, const StoreReport& report, const std::string& path)
      : report_(report), records_(from.journal().records), out_(new_database(path)), to_(with_tables(*out_)) {
    places_.assign(report.standings.size() + 1, no_event);
  }

  std::vector<std::string> run() {
    for (EventNumber number = 1; number <= last(); ++number)
      if (standing(number) != EventStanding::lost) keep(number);
    if (to_.last() == no_event) records_.database().refuse("has no event that is left", "expected one, to be written");
    keep_names();
    out_->publish();
    return std::move(said_);
  }

 private:
  EventNumber last() const { return static_cast<EventNumber>(report_.standings.size()); }
  EventStanding standing(EventNumber number) const { return report_.standings[static_cast<std::size_t>(number - 1)]; }
  EventNumber& place(EventNumber number) { return places_[static_cast<std::size_t>(number)]; }

  /// The parent of a lost event; where that cannot be read, the event that was written before it.
  EventNumber before(EventNumber number) {
    if (number > last()) return last();
    try {
      if (const EventNumber parent = records_.origin(number).parent; parent != no_event) return parent;
    } catch (const io::FileError&) {  // its row cannot be read
    }
    return number - 1;
  }

  /// The place of the last event that is left, of that one and those before it.
  EventNumber place_of_left(EventNumber number) {
    while (number != no_event && (number > last() || standing(number) == EventStanding::lost)) number = before(number);
    return place(number);
  }

  bool is_rebased(EventNumber number) const { return number != no_event && standing(number) == EventStanding::rebased; }

  void keep(EventNumber number) {
    HistoryEvent event = records_.required_event(number);
    const bool has_snapshot =
        records_.has_snapshot(number) && std::ranges::find(report_.spoiled, number) == report_.spoiled.end();
    const std::string snapshot = has_snapshot ? records_.snapshot(number) : "";
    event.begins = event.begins || is_rebased(number);
    event.parent = place_of_left(event.parent);
    if (is_rebased(number)) {
      event.kind = EventKind::import;
      event.operation = fmt::format("event {} of {}", number, text::escaped(records_.database().path()));
      event.answer = io::answer_text(1, {"imported"});
      event.line = 1;
      event.by.comment = "salvaged: what was before it is lost";
    }
    event.number = ++count_;
    append(to_, event, to_.hash(event.parent), snapshot);
    if (has_snapshot && event.kind == EventKind::edit) to_.put_snapshot(event.number, snapshot);
    place(number) = event.number;
  }

  void keep_names() {
    std::optional<NamedEvent> head;
    for (const FoundName& found : records_.found_names()) {
      const bool is_right = found.seal != FoundName::Seal::wrong;
      switch (found.kind) {
        case NameKind::branch:
        case NameKind::tag:
          keep_name(found);
          break;
        case NameKind::head:
          if (is_right) head = found.named;
          break;
        case NameKind::redo:
          if (is_right) keep_redo(found.named);
          break;
      }
    }
    keep_head(head);
  }

  void keep_name(const FoundName& found) {
    const std::string title = title_of(found.kind, text::escaped(found.named.name));
    const EventNumber was = found.named.event;
    if (found.seal == FoundName::Seal::wrong) return tell(title + " is not as it was written, and left out");
    const EventNumber is = place_of_left(was);
    if (is == no_event) return tell(fmt::format("{} is left out: nothing is left before event {}", title, was));
    to_.put_name(found.kind, {found.named.name, is});
    if (was > last() || standing(was) == EventStanding::lost)
      tell(
          fmt::format("{} stood for event {}, which is lost; it stands for event {} of the new store", title, was, is));
  }

  /// What to do again is kept where both of its events are left.
  void keep_redo(const NamedEvent& redo) {
    EventNumber behind = no_event;
    std::from_chars(redo.name.data(), redo.name.data() + redo.name.size(), behind);
    const auto is_left = [&](EventNumber number) {
      return number > no_event && number <= last() && standing(number) != EventStanding::lost;
    };
    if (is_left(behind) && is_left(redo.event))
      to_.put_name(NameKind::redo, {std::to_string(place(behind)), place(redo.event)});
  }

  /// HEAD stays where it was; where that is lost, it is on the first branch, which is made where it is lost, too.
  void keep_head(const std::optional<NamedEvent>& head) {
    if (head && !head->name.empty() && to_.named(NameKind::branch, head->name))
      return to_.put_name(NameKind::head, *head);
    if (head && head->name.empty() && place_of_left(head->event) != no_event)
      return to_.put_name(NameKind::head, {"", place_of_left(head->event)});
    const std::string main(first_branch);
    if (!to_.named(NameKind::branch, main)) to_.put_name(NameKind::branch, {main, to_.last()});
    to_.put_name(NameKind::head, {main, no_event});
    tell(fmt::format("HEAD is on branch {} now", main));
  }

  void tell(std::string what) { said_.push_back(std::move(what)); }

  /// The tables are made before what reads them.
  static Database& with_tables(Database& database) {
    database.make_tables();
    return database;
  }

  const StoreReport& report_;
  Records& records_;
  std::unique_ptr<Database> out_;
  Records to_;
  EventNumber count_ = no_event;     // of new events
  std::vector<EventNumber> places_;  // of each event among the new ones
  std::vector<std::string> said_;
};

}  // namespace

std::vector<std::string> salvage(Store& store, const StoreReport& report, const std::string& path) {
  return Salvager(store, report, path).run();
}

}  // namespace durero::store
