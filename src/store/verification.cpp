#include "durero/store/verification.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <set>

#include "durero/text/shown.hpp"
#include "journal.hpp"
#include "snapshot.hpp"

namespace durero::store {
namespace {

/// How many edits are carried out at a time.
constexpr std::size_t verified_at_once = 4096;

/// The row of an event takes more bytes than these: two texts, a time and a hash.
constexpr std::int64_t least_row = 64;

class Verifier {
 public:
  Verifier(Store& store, const CarryOut& by, const std::function<void(std::size_t)>& progress)
      : path_(store.path()),
        database_(store.journal().database),
        records_(store.journal().records),
        fold_(store.journal().fold),
        by_(by),
        progress_(progress) {}

  StoreReport run() {
    fold_.forget();
    const EventNumber bound = bound_of_numbers();
    report_.standings.assign(static_cast<std::size_t>(bound), EventStanding::lost);
    for (EventNumber number = 1; number <= bound; ++number) take(number);
    flush();
    tell_missing();
    attempt([&] { check_database(); });
    attempt([&] { check_names(); });
    return std::move(report_);
  }

 private:
  EventStanding& standing(EventNumber number) { return report_.standings[static_cast<std::size_t>(number - 1)]; }
  bool is_told(EventNumber number) { return number != no_event && standing(number) != EventStanding::lost; }

  /// The half of an error that says what is wrong, without the store's name.
  void add_defect(const io::FileError& error) {
    std::string what = error.what();
    what.erase(0, text::escaped(path_ + ": ").size());
    report_.defects.push_back(what.substr(0, what.rfind("; expected ")));
  }

  /// False where what is tried finds a defect.
  template <class Try>
  bool attempt(Try&& what) {
    try {
      what();
      return true;
    } catch (const io::FileError& error) {
      add_defect(error);
      return false;
    }
  }

  [[noreturn]] void refuse(const std::string& wrong) const { database_.refuse(wrong, expected_whole); }

  /// The last number; where it cannot be read, one that no event is behind.
  EventNumber bound_of_numbers() {
    EventNumber last = no_event;
    if (attempt([&] { last = records_.last(); })) return last;
    struct stat found {};
    return ::stat(path_.c_str(), &found) == 0 ? found.st_size / least_row : 0;
  }

  void take(EventNumber number) {
    if (number > ahead_) read_ahead(number);
    std::optional<HistoryEvent> event;
    bool has_snapshot = false;
    const bool is_read = attempt([&] {
      event = is_read_ahead_ ? next_ahead(number) : records_.event(number);
      has_snapshot = is_read_ahead_ ? snapshots_.contains(number) : records_.has_snapshot(number);
    });
    if (event) greatest_ = number;
    if (!is_read || !event) {
      flush();
      if (is_read) missing_.push_back(number);
      return;
    }
    if (event->kind == EventKind::import) {
      flush();
      progress_(1);
      attempt([&] { check_import(*event); });
      return;
    }
    if (!run_.empty() && event->parent != run_.back().number) flush();
    run_.push_back(*std::move(event));
    if (has_snapshot || run_.size() == verified_at_once) flush(has_snapshot);
  }

  /// Reads the next events at once. Where one of them cannot be read, each is read for itself.
  void read_ahead(EventNumber number) {
    ahead_ = number + static_cast<EventNumber>(verified_at_once) - 1;
    next_ = 0;
    snapshots_.clear();
    try {
      events_ = records_.events(number, ahead_);
      for (const EventOrigin& origin : records_.origins(number, ahead_))
        if (origin.has_snapshot) snapshots_.insert(origin.number);
      is_read_ahead_ = true;
    } catch (const io::FileError&) {
      is_read_ahead_ = false;
    }
  }

  /// The event of a number that has come behind those before.
  std::optional<HistoryEvent> next_ahead(EventNumber number) {
    if (next_ == events_.size() || events_[next_].number != number) return std::nullopt;
    return std::move(events_[next_++]);
  }

  /// Carries the run out; its last event may have a snapshot.
  void flush(bool has_snapshot = false) {
    if (run_.empty()) return;
    const EventNumber parent = run_.front().parent, last = run_.back().number;
    const std::size_t done = is_told(parent) ? carried_out(parent) : 0;
    for (std::size_t i = 0; i < done; ++i)
      standing(run_[i].number) =
          standing(parent) == EventStanding::whole ? EventStanding::whole : EventStanding::follows;
    if (parent == no_event) report_.defects.push_back(fmt::format("event {} stands on none", run_.front().number));
    if (has_snapshot) {
      const bool is_right = attempt([&] { check_snapshot(last, done == run_.size()); });
      if (!is_right) spoil(last);
    }
    progress_(run_.size());
    run_.clear();
  }

  void spoil(EventNumber number) {
    report_.spoiled.push_back(number);
    spoiled_.insert(number);
  }

  /// How many events of the run are as they were written, and answer what they answered.
  std::size_t carried_out(EventNumber parent) {
    const bool is_right = attempt([&] {
      fold_.move_to(parent, spoiled_);
      fold_.apply(run_, by_);
    });
    if (is_right) return run_.size();
    const auto failed = std::ranges::find(run_, fold_.at(), &HistoryEvent::parent);
    fold_.forget();
    return failed == run_.end() ? 0 : static_cast<std::size_t>(failed - run_.begin());
  }

  void check_snapshot(EventNumber number, bool is_reached) {
    const std::string content = records_.snapshot(number);
    const std::string title = fmt::format("the snapshot of event {} is not its scene", number);
    if (is_reached) {
      if (snapshot_of(fold_.edited().of()) != content) refuse(title);
    } else {
      fold_.put(number, records_.hash(number), scene_of(content, path_));
      if (snapshot_of(fold_.edited().of()) != content) refuse(title);
      standing(number) = EventStanding::rebased;
    }
    ++report_.snapshots;
  }

  void check_import(const HistoryEvent& event) {
    const std::string content = records_.snapshot(event.number);
    fold_.put(event.number, event.hash, scene_of(content, path_));
    if (snapshot_of(fold_.edited().of()) != content)
      refuse(fmt::format("the snapshot of event {} is not canonical", event.number));
    standing(event.number) = EventStanding::rebased;
    ++report_.snapshots;
    if (event.content != bytes_of(digest_of(content)) || hash_of(event, records_.hash(event.parent)) != event.hash)
      refuse(fmt::format("event {} is not as it was written", event.number));
    if (event.parent == no_event || standing(event.parent) == EventStanding::whole)
      standing(event.number) = EventStanding::whole;
  }

  /// Behind the last event there is none to miss.
  void tell_missing() {
    report_.standings.resize(static_cast<std::size_t>(greatest_));
    for (const EventNumber number : missing_)
      if (number < greatest_) report_.defects.push_back(fmt::format("event {} is missing", number));
    if (greatest_ == no_event) report_.defects.emplace_back("it has no events");
  }

  void check_database() {
    if (const std::string fault = database_.fault(); !fault.empty()) refuse(fmt::format("the database: {}", fault));
    const std::unique_ptr<PreparedQuery> strays = database_.prepare(
        "SELECT event FROM snapshot WHERE event NOT IN (SELECT number FROM event) ORDER BY event LIMIT 1");
    if (strays->step()) refuse(fmt::format("the snapshot of event {} has no event", strays->integer(0)));
  }

  void check_names() {
    for (const FoundName& found : records_.found_names()) {
      const std::string title = title_of(found.kind, found.named.name);
      if (found.seal == FoundName::Seal::wrong)
        report_.defects.push_back(title + " is not as it was written");
      else if (found.seal == FoundName::Seal::unknown)
        report_.defects.push_back(fmt::format("{} stands for event {}, which is missing", title, found.named.event));
      else if (found.kind == NameKind::branch || found.kind == NameKind::tag)
        ++report_.names;
    }
    attempt([&] { head_of(records_); });
  }

  const std::string& path_;
  Database& database_;
  Records& records_;
  Fold& fold_;
  const CarryOut& by_;
  const std::function<void(std::size_t)>& progress_;
  StoreReport report_;
  std::vector<HistoryEvent> run_;  // edits that follow each other, none but the last with a snapshot
  std::vector<EventNumber> missing_;
  EventNumber ahead_ = no_event;  // the last that was read ahead
  bool is_read_ahead_ = false;
  std::vector<HistoryEvent> events_;  // read ahead
  std::size_t next_ = 0;              // of these
  std::set<EventNumber> snapshots_;   // which of these have one
  std::set<EventNumber> spoiled_;
  EventNumber greatest_ = no_event;
};

}  // namespace

StoreReport verify(Store& store, const CarryOut& by, const std::function<void(std::size_t)>& progress) {
  return Verifier(store, by, progress).run();
}

}  // namespace durero::store
