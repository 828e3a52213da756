#pragma once
/// Whether a store is whole: each event is chained to the one before, answers again what it answered, and leads to the
/// scene of its snapshot.

#include <functional>
#include <string>
#include <vector>

#include "durero/store/store.hpp"

namespace durero::store {

/// What of an event is left.
enum class EventStanding : std::uint8_t {
  whole,    ///< it is as it was written, and so is all before it
  rebased,  ///< it, or something before it, is lost, but its own snapshot tells its scene
  follows,  ///< it is as it was written, and its scene follows from that of a rebased one
  lost,     ///< its scene cannot be told
};

/// What verify() finds.
struct StoreReport {
  std::vector<std::string> defects{};      ///< one line each, without the store's name; none of a whole store
  std::vector<EventStanding> standings{};  ///< of event i + 1
  std::vector<EventNumber> spoiled{};      ///< the events whose snapshots are not as they should be
  std::size_t snapshots = 0;               ///< how many are
  std::size_t names = 0;                   ///< how many branches and tags are as they should be

  /// Whether there is no defect.
  bool is_whole() const noexcept { return defects.empty(); }
};

/// Carries all events out again, and checks everything that the store holds. progress() is called now and then with the
/// number of events since the last call. Throws what `by` throws beside io::FileError.
StoreReport verify(
    Store& store, const CarryOut& by = carry_out,
    const std::function<void(std::size_t)>& progress = [](std::size_t) {});

/// Writes a new store with the events that are not lost: a rebased one becomes an import of its snapshot. A name of a
/// lost event goes to the last event before it that is not lost. Returns what has become of names, a line each.
/// Precondition: the report is that of the store. Throws io::FileError where nothing is left, or where there is a file
/// of that path.
std::vector<std::string> salvage(Store& store, const StoreReport& report, const std::string& path);

}  // namespace durero::store
