#include "durero/store/event_log.hpp"

#include "durero/io/json/json_writer.hpp"
#include "journal.hpp"
#include "rows_back.hpp"

namespace durero::store {
namespace {

struct ReadEvents {
  Records& of;
  std::vector<HistoryEvent> operator()(EventNumber first, EventNumber last) const { return of.events(first, last); }
};

/// Events on the way back, each held against its hash.
class EventsBack {
 public:
  explicit EventsBack(Records& records) : records_(records), rows_(ReadEvents{records}) {}

  /// Throws io::FileError where it is missing, or not as it was written.
  HistoryEvent at(EventNumber number) {
    const HistoryEvent* const found = rows_.find(number);
    if (found == nullptr) return records_.checked_event(number);
    HistoryEvent event = *found;
    const HistoryEvent* const parent = event.parent == no_event ? nullptr : rows_.find(event.parent);
    const Digest before = parent == nullptr ? records_.hash(event.parent) : parent->hash;
    return hash_of(event, before) == event.hash ? event : records_.checked_event(number);
  }

 private:
  Records& records_;
  RowsBack<HistoryEvent, ReadEvents> rows_;
};

}  // namespace

EventNames event_names_of(Store& of) {
  EventNames names;
  names[of.head().event].push_back("HEAD");
  for (const StoredName& branch : of.branches()) names[branch.event].push_back(branch.name);
  for (const StoredName& tag : of.tags()) names[tag.event].push_back(tag.name);
  return names;
}

void tell_log(Store& of, const LogCall& call,
              const std::function<void(const HistoryEvent& event, const std::vector<std::string>& names)>& tell) {
  EventNames names = event_names_of(of);
  EventsBack events(of.journal().records);
  EventNumber number = call.all ? of.last() : of.find(call.revision);
  for (std::uint64_t told = 0; number != no_event && (call.limit == 0 || told < call.limit); ++told) {
    const HistoryEvent event = events.at(number);
    tell(event, names[number]);
    number = call.all ? number - 1 : event.parent;
  }
}

std::string event_json(const HistoryEvent& event, const std::vector<std::string>& names) {
  std::string text;
  io::json::Writer out(text);
  out.begin_object().member("event", static_cast<std::uint64_t>(event.number));
  if (event.parent != no_event) out.member("parent", static_cast<std::uint64_t>(event.parent));
  out.member("begins", event.begins).member("author", event.by.author).member("time", event.by.time);
  out.member("comment", event.by.comment);
  out.member(event.kind == EventKind::import ? "import" : "operation", event.operation);
  out.member("answer", event.answer).member("hash", hexadecimal(event.hash));
  out.key("names").begin_array();
  for (const std::string& name : names) out.value(name);
  out.end_array().end_object();
  return text + "\n";
}

}  // namespace durero::store
