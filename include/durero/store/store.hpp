#pragma once
/// A store keeps a scene with its whole history in one file, or in a schema of a PostgreSQL server, whose URI then
/// stands in the place of the path: each edit that was accepted, with its answer, as an event that is chained to the
/// one before. Nothing of it is ever deleted. Several programs may use it at a time: those that write wait for each
/// other, and those that read see what was there when they began.

#include <cstdint>
#include <exception>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "durero/io/source.hpp"
#include "durero/scene/grouped_scene.hpp"
#include "durero/store/carry_out.hpp"
#include "durero/store/history_event.hpp"

namespace durero::store {

struct Journal;

/// What a store is opened for.
enum class StoreAccess : std::uint8_t {
  read,    ///< it stays as it is, and one that cannot be written is read too
  write,   ///< it is written, too
  follow,  ///< as read, but each question sees what others have written by then; StoreReading holds several together
};

/// The operations of a transaction, which is one step of undo.
struct EditCall {
  const io::Source& script;               ///< whole lines of a script
  std::size_t lines_before = 0;           ///< how many lines of the script stand before them
  Provenance by{};                        ///< of the transaction
  bool all_or_nothing = false;            ///< whether a refusal ends it, and leaves nothing of it
  CarryOut carry_out = store::carry_out;  ///< how each operation is carried out
  EventNumber expected_head = no_event;   ///< where HEAD must be; no_event: anywhere
};

/// What a transaction has come to.
struct EditResult {
  std::string answers{};         ///< a JSON line for each operation, as io::answer_text has it
  bool is_refused = false;       ///< whether some operation was refused
  EventNumber event = no_event;  ///< the last event that was kept; no_event where none was
};

/// What one of several transactions has come to.
struct EditAttempt {
  EditResult result{};          ///< as of one alone
  EventNumber head = no_event;  ///< where HEAD is behind it
  bool is_stale = false;        ///< whether HEAD was elsewhere than expected, and nothing was done
  std::exception_ptr error{};   ///< why its script could not be read or carried out; null where it was
};

/// Where the next edit goes.
struct StoreHead {
  std::string branch;  ///< which goes on with it; empty where it is on none
  EventNumber event;   ///< on which it stands
};

/// A name and the event that it stands for.
struct StoredName {
  std::string name;   ///< as find() takes it
  EventNumber event;  ///< its event
};

/// The version of libpq, which reaches PostgreSQL servers; empty in a build without it.
std::string libpq_version();

/// The branch that a new store has.
inline constexpr std::string_view first_branch = "main";

/// A store, open. Members throw io::FileError where the file cannot be used or is not whole, where a name is wrong or
/// stands for nothing, and change nothing then.
class Store {
 public:
  /// Makes a new store with that scene, read from the file `from`, whose pictures are then named from the store's
  /// folder; an empty name stands for no file. Throws io::FileError where there is a file of that path.
  static void create(const std::string& path, scene::GroupedScene scene, const std::string& from, const Provenance& by);

  /// Opens a store that is there.
  Store(const std::string& path, StoreAccess access);
  ~Store();
  Store(const Store&) = delete;
  Store& operator=(const Store&) = delete;

  /// The path that it was opened by; a URI without its password.
  const std::string& path() const noexcept;
  /// Whether its server is gone, so that every further call throws. Another Store may find it again.
  bool is_lost() noexcept;

  /// Where the next edit goes.
  StoreHead head();
  /// The event of a revision: a branch, a tag, the number of an event, or HEAD, and perhaps ~N for the N-th transaction
  /// before.
  EventNumber find(std::string_view revision);
  /// An event.
  HistoryEvent event(EventNumber number);
  /// The greatest number of an event.
  EventNumber last();
  /// The number of the event before the transaction that an event is of; no_event where that is the first.
  EventNumber before_transaction(EventNumber number);
  /// The last event that is on the ways of both to the first.
  EventNumber common_ancestor(EventNumber a, EventNumber b);
  /// The scene of an event. Valid until the next call.
  const scene::GroupedScene& state(EventNumber number);

  /// Carries a transaction out where HEAD is, and keeps the operations that are accepted, durably. Throws
  /// io::InputError, and keeps nothing, where a line is no operation.
  EditResult edit(const EditCall& call);
  /// Carries transactions out one after the other, as edit() does, and makes all of them durable at once: whoever waits
  /// for the disk waits once. Each is done or refused for itself, and is a step of its own.
  std::vector<EditAttempt> edit_together(std::span<const EditCall> calls);
  /// Reads a script with the materials of HEAD, as edit() would, and changes nothing. Throws io::InputError.
  std::vector<io::ScriptStep> read(const io::Source& script);
  /// Puts another scene in the place of that of HEAD, as create() does.
  EventNumber import(scene::GroupedScene scene, const std::string& from, const Provenance& by);

  /// Goes back before the last transaction. The event where HEAD is then; nothing where there is none before.
  std::optional<EventNumber> undo();
  /// Goes on to where undo() has left from last. The event where HEAD is then; nothing where there is no such.
  std::optional<EventNumber> redo();

  /// Puts HEAD on a branch, or, where the revision is none, on an event.
  void go_to(std::string_view revision);
  /// @{ Branches and tags, ascending by name.
  std::vector<StoredName> branches();
  std::vector<StoredName> tags();
  /// @}
  /// @{ Makes a branch or a tag of a name that neither has.
  void add_branch(const std::string& name, std::string_view revision);
  void add_tag(const std::string& name, std::string_view revision);
  /// @}
  /// @{ Takes the name away; its events stay. Not of the branch where HEAD is.
  void remove_branch(const std::string& name);
  void remove_tag(const std::string& name);
  /// @}

  /// What the sources of this layer alone look into.
  Journal& journal() noexcept { return *journal_; }

 private:
  /// A part of a transaction of the database, which is to be taken back where it throws or leaves nothing.
  void attempt_edit(const EditCall& call, EditAttempt& attempt);

  std::unique_ptr<Journal> journal_;
};

}  // namespace durero::store
