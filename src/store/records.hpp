#pragma once
/// What the tables of a store hold, row by row: events, snapshots and names. A row that is read is held against its
/// digest: a snapshot and a name have a seal for it, and an event its hash, which its reader checks.

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "database.hpp"
#include "durero/store/history_event.hpp"

namespace durero::store {

/// What a name stands for.
enum class NameKind : std::uint8_t {
  branch,  ///< a line of work, which goes on with its edits
  tag,     ///< a name that stays where it is
  head,    ///< where the next edit goes: its name is that of a branch, or empty
  redo,    ///< behind an event, whose number is its name, where it was left last by an undo
};

/// A name and the event that it stands for.
struct NamedEvent {
  std::string name;
  EventNumber event;
};

/// A name as it is found, whether or not it is as it was written.
struct FoundName {
  /// What its seal says.
  enum class Seal : std::uint8_t {
    right,   ///< it is as it was written
    wrong,   ///< it is not
    unknown  ///< its event cannot be read
  };
  NameKind kind;
  NamedEvent named;
  Seal seal;
};

/// The title of a name in messages: branch main.
std::string title_of(NameKind kind, std::string_view name);

/// How the scene of an event is made.
struct EventOrigin {
  EventNumber number;
  EventNumber parent;
  EventKind kind;
  bool has_snapshot;
};

class Records {
 public:
  /// Of a database that is a store. Throws io::FileError where it is none, or one of a later version.
  explicit Records(Database& database);

  /// The event of a number, as it is found; nothing where there is none.
  std::optional<HistoryEvent> event(EventNumber number);
  /// The event of a number, as it is found. Throws io::FileError where there is none.
  HistoryEvent required_event(EventNumber number);
  /// The same, held against its hash. Throws io::FileError also where it is not as it was written.
  HistoryEvent checked_event(EventNumber number);
  /// Events of numbers from the first to the last, ascending, as they are found. Throws io::FileError where one of them
  /// cannot be read.
  std::vector<HistoryEvent> events(EventNumber first, EventNumber last);
  /// What an event is made from. Throws io::FileError where there is no such event.
  EventOrigin origin(EventNumber number);
  /// What the events of numbers from the first to the last are made from, ascending, as events().
  std::vector<EventOrigin> origins(EventNumber first, EventNumber last);
  /// The hash of an event, as it is stored: of no_event 32 zeros.
  Digest hash(EventNumber number);
  /// The greatest number of an event.
  EventNumber last();
  /// Keeps an event under its number.
  void put(const HistoryEvent& event);

  bool has_snapshot(EventNumber event);
  /// The snapshot of an event that has one.
  std::string snapshot(EventNumber event);
  void put_snapshot(EventNumber event, std::string_view content);

  /// The event of a name; nothing where there is none.
  std::optional<EventNumber> named(NameKind kind, std::string_view name);
  /// All names of a kind, ascending.
  std::vector<NamedEvent> names(NameKind kind);
  /// Every name of every kind, right or wrong.
  std::vector<FoundName> found_names();
  void put_name(NameKind kind, const NamedEvent& named);
  void remove_name(NameKind kind, std::string_view name);

  Database& database() noexcept { return database_; }

 private:
  HistoryEvent read_event(const PreparedQuery& from) const;
  EventOrigin read_origin(const PreparedQuery& from) const;
  Digest seal_of(NameKind kind, const NamedEvent& named);
  void require_seal(const Digest& seal, std::string_view stored, const std::string& what);

  Database& database_;
  std::unique_ptr<PreparedQuery> event_, origin_, hash_, last_, put_, has_snapshot_, snapshot_, put_snapshot_, named_,
      names_, found_names_, put_name_, remove_name_;
};

}  // namespace durero::store
