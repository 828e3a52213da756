#include "durero/store/event_log.hpp"

#include "durero/io/json/json_writer.hpp"

namespace durero::store {

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
  EventNumber number = call.all ? of.last() : of.find(call.revision);
  for (std::uint64_t told = 0; number != no_event && (call.limit == 0 || told < call.limit); ++told) {
    const HistoryEvent event = of.event(number);
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
