#include "fold.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "durero/io/source.hpp"
#include "durero/text/shown.hpp"
#include "rows_back.hpp"
#include "snapshot.hpp"

namespace durero::store {
namespace {

/// How many edits are read at a time.
constexpr std::size_t run_length = 1024;

struct ReadOrigins {
  Records& of;
  std::vector<EventOrigin> operator()(EventNumber first, EventNumber last) const { return of.origins(first, last); }
};

}  // namespace

void Fold::refuse(EventNumber event, const std::string& wrong) const {
  records_.database().refuse(fmt::format("event {} {}", event, wrong), expected_whole);
}

void Fold::put(EventNumber at, const Digest& hash, scene::GroupedScene scene) {
  edited_.put(std::move(scene));
  at_ = at;
  hash_ = hash;
  behind_snapshot_ = 0;
}

void Fold::advance(const HistoryEvent& to) {
  at_ = to.number;
  hash_ = to.hash;
  ++behind_snapshot_;
}

void Fold::move_to(EventNumber to, const std::set<EventNumber>& spoiled) {
  std::vector<EventNumber> way;  // from the last event back to the first that is not there yet
  RowsBack<EventOrigin, ReadOrigins> origins(ReadOrigins{records_});
  EventNumber from = to;
  try {
    while (from != at_) {
      const EventOrigin* const near = origins.find(from);
      const EventOrigin origin = near == nullptr ? records_.origin(from) : *near;
      if (origin.has_snapshot && !spoiled.contains(from)) break;
      if (origin.kind == EventKind::import || origin.parent == no_event) refuse(from, "has no snapshot that is whole");
      way.push_back(from);
      from = origin.parent;
    }
    if (from != at_) put(from, records_.hash(from), scene_of(records_.snapshot(from), records_.database().path()));
    while (!way.empty()) apply(next_run(way));
  } catch (...) {
    forget();
    throw;
  }
}

/// The next events of a way, which ends where the first stands. Those whose numbers follow each other are read at once.
std::vector<HistoryEvent> Fold::next_run(std::vector<EventNumber>& way) const {
  const EventNumber first = way.back();
  std::size_t length = 0;
  for (; !way.empty() && length < run_length && way.back() == first + static_cast<EventNumber>(length); ++length)
    way.pop_back();
  std::vector<HistoryEvent> run = records_.events(first, first + static_cast<EventNumber>(length) - 1);
  if (run.size() != length) refuse(first, "or one behind it is missing");
  return run;
}

void Fold::require_hash(const HistoryEvent& event, const Digest& parent) const {
  if (event.kind != EventKind::edit || hash_of(event, parent) != event.hash)
    refuse(event.number, "is not as it was written");
}

/// The steps of a run; fewer or more than its events where some line is no operation.
std::vector<io::ScriptStep> Fold::read(std::span<const HistoryEvent> run) const {
  std::string script;
  for (const HistoryEvent& event : run) script.append(event.operation).append("\n");
  return io::read_script(io::Source(records_.database().path(), std::move(script)), edited_.of().scene.stage());
}

void Fold::apply_one(const HistoryEvent& event, io::ScriptStep step, const CarryOut& by) {
  require_hash(event, hash_);
  if (event.parent != at_) refuse(event.number, fmt::format("stands on event {}, and not on {}", event.parent, at_));
  if (event.begins) edited_.begin_transaction();
  step.line = static_cast<std::size_t>(event.line);
  const std::string answer = io::answer_text(step.line, by(edited_, step));
  if (answer != event.answer)
    refuse(event.number,
           fmt::format("answers {}, and was kept with {}", text::shown(answer), text::shown(event.answer)));
  advance(event);
}

void Fold::apply(std::span<const HistoryEvent> run, const CarryOut& by) {
  std::vector<io::ScriptStep> steps;
  try {
    steps = read(run);
  } catch (const io::InputError&) {  // one of them is no operation: which, they tell one by one
  }
  const bool is_read = steps.size() == run.size();
  for (std::size_t i = 0; i < run.size(); ++i) {
    if (is_read) {
      apply_one(run[i], std::move(steps[i]), by);
      continue;
    }
    require_hash(run[i], hash_);
    try {
      steps = read(run.subspan(i, 1));
    } catch (const io::InputError& error) {
      refuse(run[i].number, fmt::format("is no operation here: {}", error.message()));
    }
    if (steps.size() != 1) refuse(run[i].number, "is no operation");
    apply_one(run[i], std::move(steps.front()), by);
  }
}

}  // namespace durero::store
