#pragma once
/// The events of a store. They form a tree: each has a parent, but for the first, and says how the scene of its parent
/// becomes its own.

#include <cstdint>
#include <string>
#include <string_view>

#include "durero/store/digest.hpp"

namespace durero::store {

/// The number of an event in its store, from 1. A parent has a smaller number than its children.
using EventNumber = std::int64_t;
/// Stands for no event: the parent of the first.
inline constexpr EventNumber no_event = 0;

/// How a scene becomes another.
enum class EventKind : std::uint8_t {
  import,  ///< another scene takes its place, which the store keeps whole
  edit,    ///< an operation is carried out
};

/// Who did something, when and why: any text without a line end.
struct Provenance {
  std::string author{};   ///< a name
  std::string time{};     ///< of UTC, as 2026-01-31T12:00:00Z
  std::string comment{};  ///< the reason
};

/// An event of a store.
struct HistoryEvent {
  EventNumber number = no_event;     ///< its own
  EventNumber parent = no_event;     ///< of its parent
  EventKind kind = EventKind::edit;  ///< what it is
  bool begins = true;                ///< whether it is the first event of its transaction: undo goes before that
  std::int64_t line = 1;             ///< of the operation in its script, as its answer says
  std::string operation{};           ///< the line of the operation; of an import, the name of the file
  std::string answer{};              ///< the JSON line that was answered
  Provenance by{};                   ///< of the transaction
  std::string content{};             ///< of an import, the digest of its snapshot; of an edit it is empty
  Digest hash{};                     ///< hash_of() it
};

/// The hash that chains an event to its parent: the digest of the parent's hash and of everything that the event says
/// but for numbers.
Digest hash_of(const HistoryEvent& event, const Digest& parent);

/// Whether a text is a time as Provenance has it, of a day that there is.
bool is_time(std::string_view text);

}  // namespace durero::store
