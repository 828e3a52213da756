#pragma once
/// The log of a store: its events, the last one first, with the names that stand for them.

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "durero/store/store.hpp"

namespace durero::store {

/// What stands for events: HEAD, branches, then tags.
using EventNames = std::map<EventNumber, std::vector<std::string>>;

/// The names of all events that have one.
EventNames event_names_of(Store& of);

/// Which events a log has.
struct LogCall {
  std::string_view revision = "HEAD";  ///< the last of them, as Store::find() takes it
  std::uint64_t limit = 0;             ///< how many at most; 0: as many as there are
  bool all = false;                    ///< whether every event of the store, whatever the revision
};

/// Tells the events of a log, the last one first, each with its names. Throws io::FileError as Store does.
void tell_log(Store& of, const LogCall& call,
              const std::function<void(const HistoryEvent& event, const std::vector<std::string>& names)>& tell);

/// An event as a JSON object on a line of its own: event, parent (but of the first), begins, author, time, comment,
/// operation or, of an import, import, answer, hash, names.
std::string event_json(const HistoryEvent& event, const std::vector<std::string>& names);

}  // namespace durero::store
