#include "durero/store/store.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "durero/io/lines.hpp"
#include "durero/io/pictures/picture_file.hpp"
#include "durero/model/tipos.hpp"
#include "durero/store/store_path.hpp"
#include "durero/text/shown.hpp"
#include "durero/text/whole_number.hpp"
#include "journal.hpp"
#include "snapshot.hpp"

namespace durero::store {
namespace {

constexpr std::string_view head_word = "HEAD";

/// The least number of edits between two snapshots. To carry them out takes some milliseconds, as the program needs to
/// start.
constexpr std::size_t least_interval = 1000;

/// A snapshot is due when as many edits lie behind the last as take about as long as to read it: an element of a
/// snapshot takes less than a quarter of an edit. So snapshots take at most four elements' bytes for each edit.
bool is_snapshot_due(Fold& fold) {
  return fold.behind_snapshot() >= std::max(least_interval, fold.edited().of().scene.size() / 4);
}

std::string_view trimmed(std::string_view line) {
  constexpr std::string_view blanks = " \t";
  const std::size_t begin = line.find_first_not_of(blanks);
  return begin == line.npos ? std::string_view() : line.substr(begin, line.find_last_not_of(blanks) + 1 - begin);
}

/// The lines of a script by their numbers, asked for in ascending order.
class ScriptLines {
 public:
  explicit ScriptLines(const io::Source& script) : text_(script.text()), lines_(text_) {}

  std::string operation(std::size_t number) {
    while (const auto line = lines_.next())
      if (line->number == number) return std::string(trimmed(text_.substr(line->begin, line->end - line->begin)));
    return "";
  }

 private:
  std::string_view text_;
  io::Lines lines_;
};

HistoryEvent import_event(EventNumber number, EventNumber parent, const std::string& from, const Provenance& by) {
  HistoryEvent event;
  event.number = number;
  event.parent = parent;
  event.kind = EventKind::import;
  event.operation = from.empty() ? "nothing" : text::escaped(from);
  event.answer = io::answer_text(1, {"imported"});
  event.by = by;
  return event;
}

/// Carries out the steps of a transaction, and keeps those that are accepted.
EditResult carry_out_steps(Journal& journal, const EditCall& call, std::vector<io::ScriptStep> steps) {
  EditResult result;
  ScriptLines lines(call.script);
  EventNumber number = journal.records.last();
  for (io::ScriptStep& step : steps) {
    const std::string operation = lines.operation(step.line);
    step.line += call.lines_before;
    const io::EditAnswer answer = call.carry_out(journal.fold.edited(), step);
    const std::string said = io::answer_text(step.line, answer);
    result.answers.append(said).append("\n");
    if (!answer.ok()) {
      result.is_refused = true;
      if (call.all_or_nothing) return result;
      continue;
    }
    HistoryEvent event;
    event.number = ++number;
    event.parent = journal.fold.at();
    event.begins = result.event == no_event;
    event.line = static_cast<std::int64_t>(step.line);
    event.operation = operation;
    event.answer = said;
    event.by = call.by;
    append(journal.records, event, journal.fold.hash());
    journal.fold.advance(event);
    result.event = event.number;
  }
  return result;
}

std::vector<StoredName> stored(const std::vector<NamedEvent>& names) {
  std::vector<StoredName> all;
  for (const NamedEvent& named : names) all.push_back({named.name, named.event});
  return all;
}

/// A new name is none of a number or of HEAD, and neither a branch nor a tag has it.
void require_new(Records& records, const std::string& name) {
  if (!model::Elemento::is_name(name) || text::whole_number(name) || name == head_word)
    records.database().refuse(fmt::format("{} is no name", text::shown(name)),
                              "expected 1 to 128 of A-Z a-z 0-9 _ . : -, not HEAD, and no number");
  for (const auto& [kind, word] : {std::pair(NameKind::branch, "branch"), std::pair(NameKind::tag, "tag")})
    if (records.named(kind, name))
      records.database().refuse(fmt::format("there is a {} {}", word, name), "expected a new name");
}

void add_name(Journal& journal, NameKind kind, const std::string& name, EventNumber event) {
  WriteTransaction transaction(journal);
  require_new(journal.records, name);
  journal.records.put_name(kind, {name, event});
  transaction.commit();
}

void remove_name(Journal& journal, NameKind kind, const std::string& name, const char* word) {
  WriteTransaction transaction(journal);
  if (!journal.records.named(kind, name))
    journal.database.refuse(fmt::format("there is no {} {}", word, text::shown(name)),
                            fmt::format("expected a {}", word));
  if (kind == NameKind::branch && head_of(journal.records).branch == name)
    journal.database.refuse(fmt::format("HEAD is on branch {}", name), "expected another branch, or HEAD elsewhere");
  journal.records.remove_name(kind, name);
  transaction.commit();
}

[[noreturn]] void refuse_revision(Journal& journal, std::string_view revision) {
  std::string known(head_word);
  for (const NameKind kind : {NameKind::branch, NameKind::tag})
    for (const NamedEvent& named : journal.records.names(kind)) known += ", " + named.name;
  journal.database.refuse(fmt::format("no revision {}", text::shown(revision)),
                          fmt::format("expected the number of an event, or one of {}", known));
}

}  // namespace

void Store::create(const std::string& path, scene::GroupedScene scene, const std::string& from, const Provenance& by) {
  const std::unique_ptr<Database> database = new_database(path);
  database->make_tables();
  Records records(*database);
  if (!from.empty()) io::rename_pictures(scene.scene.stage(), from, picture_place(path));
  HistoryEvent event = import_event(1, no_event, from, by);
  append(records, event, {}, snapshot_of(scene));
  records.put_name(NameKind::branch, {std::string(first_branch), event.number});
  records.put_name(NameKind::head, {std::string(first_branch), no_event});
  database->publish();
}

Store::Store(const std::string& path, StoreAccess access)
    : journal_(std::make_unique<Journal>(path,
                                         access == StoreAccess::write ? Database::Mode::write : Database::Mode::read)) {
  if (access == StoreAccess::read) journal_->database.begin_reading();
}

Store::~Store() = default;

const std::string& Store::path() const noexcept { return journal_->database.path(); }

bool Store::is_lost() noexcept { return journal_->database.is_lost(); }

StoreHead Store::head() { return head_of(journal_->records); }

HistoryEvent Store::event(EventNumber number) { return journal_->records.checked_event(number); }

EventNumber Store::last() { return journal_->records.last(); }

EventNumber Store::find(std::string_view revision) {
  Records& records = journal_->records;
  const std::size_t tilde = revision.find('~');
  const std::string_view name = revision.substr(0, tilde);
  std::optional<std::uint64_t> back = 0;
  if (tilde != revision.npos) back = tilde + 1 == revision.size() ? 1 : text::whole_number(revision.substr(tilde + 1));
  if (name.empty() || !back) refuse_revision(*journal_, revision);
  EventNumber number = no_event;
  if (name == head_word) {
    number = head().event;
  } else if (const auto given = text::whole_number(name)) {
    if (std::in_range<EventNumber>(*given) && records.event(static_cast<EventNumber>(*given)))
      number = static_cast<EventNumber>(*given);
  } else if (const auto branch = records.named(NameKind::branch, name)) {
    number = *branch;
  } else {
    number = records.named(NameKind::tag, name).value_or(no_event);
  }
  for (; *back > 0 && number != no_event; --*back) number = before_transaction(number);
  if (number == no_event) refuse_revision(*journal_, revision);
  return number;
}

EventNumber Store::before_transaction(EventNumber number) {
  HistoryEvent event = this->event(number);
  while (!event.begins) event = this->event(event.parent);
  return event.parent;
}

EventNumber Store::common_ancestor(EventNumber a, EventNumber b) {
  while (a != b) {
    EventNumber& later = a > b ? a : b;
    later = journal_->records.origin(later).parent;
  }
  return a;
}

const scene::GroupedScene& Store::state(EventNumber number) {
  journal_->fold.move_to(number);
  return journal_->fold.edited().of();
}

EditResult Store::edit(const EditCall& call) {
  EditAttempt attempt = std::move(edit_together({&call, 1}).front());
  if (attempt.error) std::rethrow_exception(attempt.error);
  if (attempt.is_stale)
    journal_->database.refuse(fmt::format("HEAD is at {}", attempt.head),
                              fmt::format("expected {}", call.expected_head));
  return std::move(attempt.result);
}

std::vector<EditAttempt> Store::edit_together(std::span<const EditCall> calls) {
  WriteTransaction transaction(*journal_);
  std::vector<EditAttempt> attempts;
  for (const EditCall& call : calls) {
    EditAttempt& attempt = attempts.emplace_back();
    journal_->database.run("SAVEPOINT attempt");
    try {
      attempt_edit(call, attempt);
    } catch (const io::FileError&) {
      throw;  // of the store
    } catch (const std::exception&) {
      attempt.error = std::current_exception();
    }
    const bool is_kept = !attempt.error && !(call.all_or_nothing && attempt.result.is_refused);
    if (!is_kept) {
      journal_->database.run("ROLLBACK TO attempt");
      if (journal_->fold.at() != head().event) journal_->fold.forget();
      attempt.result.event = no_event;
    }
    journal_->database.run("RELEASE attempt");
    attempt.head = head().event;
  }
  transaction.commit();
  return attempts;
}

void Store::attempt_edit(const EditCall& call, EditAttempt& attempt) {
  const StoreHead head = this->head();
  attempt.is_stale = call.expected_head != no_event && call.expected_head != head.event;
  if (attempt.is_stale) return;
  Fold& fold = journal_->fold;
  fold.move_to(head.event);
  fold.edited().begin_transaction();
  std::vector<io::ScriptStep> steps = io::read_script(call.script, fold.edited().of().scene.stage());
  attempt.result = carry_out_steps(*journal_, call, std::move(steps));
  const EditResult& result = attempt.result;
  if (result.event == no_event || (call.all_or_nothing && result.is_refused)) return;
  move_head(journal_->records, head, result.event);
  if (!is_snapshot_due(fold)) return;
  journal_->records.put_snapshot(result.event, snapshot_of(fold.edited().of()));
  fold.keep_snapshot();
}

std::vector<io::ScriptStep> Store::read(const io::Source& script) {
  return io::read_script(script, state(head().event).scene.stage());
}

EventNumber Store::import(scene::GroupedScene scene, const std::string& from, const Provenance& by) {
  WriteTransaction transaction(*journal_);
  const StoreHead head = this->head();
  if (!from.empty()) io::rename_pictures(scene.scene.stage(), from, picture_place(path()));
  HistoryEvent event = import_event(last() + 1, head.event, from, by);
  append(journal_->records, event, journal_->records.hash(head.event), snapshot_of(scene));
  move_head(journal_->records, head, event.number);
  transaction.commit();
  return event.number;
}

std::optional<EventNumber> Store::undo() {
  WriteTransaction transaction(*journal_);
  const StoreHead head = this->head();
  const EventNumber before = before_transaction(head.event);
  if (before == no_event) return std::nullopt;
  journal_->records.put_name(NameKind::redo, {std::to_string(before), head.event});
  move_head(journal_->records, head, before);
  transaction.commit();
  return before;
}

std::optional<EventNumber> Store::redo() {
  WriteTransaction transaction(*journal_);
  const StoreHead head = this->head();
  const auto after = journal_->records.named(NameKind::redo, std::to_string(head.event));
  if (!after) return std::nullopt;
  move_head(journal_->records, head, *after);
  transaction.commit();
  return after;
}

void Store::go_to(std::string_view revision) {
  WriteTransaction transaction(*journal_);
  Records& records = journal_->records;
  NamedEvent to{"", no_event};
  if (records.named(NameKind::branch, revision))
    to.name = revision;
  else
    to.event = find(revision);
  for (const NamedEvent& old : records.names(NameKind::head)) records.remove_name(NameKind::head, old.name);
  records.put_name(NameKind::head, to);
  transaction.commit();
}

std::vector<StoredName> Store::branches() { return stored(journal_->records.names(NameKind::branch)); }
std::vector<StoredName> Store::tags() { return stored(journal_->records.names(NameKind::tag)); }

void Store::add_branch(const std::string& name, std::string_view revision) {
  add_name(*journal_, NameKind::branch, name, find(revision));
}
void Store::add_tag(const std::string& name, std::string_view revision) {
  add_name(*journal_, NameKind::tag, name, find(revision));
}
void Store::remove_branch(const std::string& name) { remove_name(*journal_, NameKind::branch, name, "branch"); }
void Store::remove_tag(const std::string& name) { remove_name(*journal_, NameKind::tag, name, "tag"); }

}  // namespace durero::store
