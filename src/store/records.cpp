#include "records.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "durero/io/source.hpp"

namespace durero::store {
namespace {

bool copy_digest(std::string_view bytes, Digest& digest) {
  if (bytes.size() != digest.size()) return false;
  std::ranges::copy(bytes, digest.begin());
  return true;
}

/// Another table may have a trigger, which would be carried out: no statement is prepared before.
Database& of_store(Database& database) {
  database.require_store();
  return database;
}

std::int64_t number_of(NameKind kind) { return static_cast<std::int64_t>(kind); }

Digest seal_of_snapshot(const Digest& event, std::string_view content) {
  return FieldDigest().add("snapshot").add(bytes_of(event)).add(bytes_of(digest_of(content))).digest();
}

}  // namespace

std::string title_of(NameKind kind, std::string_view name) {
  switch (kind) {
    case NameKind::branch:
      return fmt::format("branch {}", name);
    case NameKind::tag:
      return fmt::format("tag {}", name);
    case NameKind::head:
      return "HEAD";
    case NameKind::redo:
      return fmt::format("what to do again behind event {}", name);
  }
  __builtin_unreachable();  // a kind is one of its enumerators
}

Records::Records(Database& database)
    : database_(of_store(database)),
      event_(database.prepare("SELECT number, parent, kind, begins, line, operation, answer, author, time, comment, "
                              "content, hash FROM event WHERE number BETWEEN $1 AND $2 ORDER BY number")),
      origin_(database.prepare("SELECT number, parent, kind, EXISTS (SELECT 1 FROM snapshot WHERE event = number) "
                               "FROM event WHERE number BETWEEN $1 AND $2 ORDER BY number")),
      hash_(database.prepare("SELECT hash FROM event WHERE number = $1")),
      last_(database.prepare("SELECT coalesce(max(number), 0) FROM event")),
      put_(database.prepare("INSERT INTO event VALUES ($1, $2, $3, $4, $5, $6, $7, $8, $9, $10, $11, $12)")),
      has_snapshot_(database.prepare("SELECT 1 FROM snapshot WHERE event = $1")),
      snapshot_(database.prepare("SELECT seal, content FROM snapshot WHERE event = $1")),
      put_snapshot_(database.prepare("INSERT INTO snapshot VALUES ($1, $2, $3)")),
      named_(database.prepare("SELECT event, seal FROM name WHERE kind = $1 AND name = $2")),
      names_(database.prepare("SELECT name, event, seal FROM name WHERE kind = $1 ORDER BY name")),
      found_names_(database.prepare("SELECT kind, name, event, seal FROM name ORDER BY kind, name")),
      put_name_(database.prepare("INSERT INTO name VALUES ($1, $2, $3, $4) ON CONFLICT (kind, name) "
                                 "DO UPDATE SET event = excluded.event, seal = excluded.seal")),
      remove_name_(database.prepare("DELETE FROM name WHERE kind = $1 AND name = $2")) {}

HistoryEvent Records::read_event(const PreparedQuery& from) const {
  HistoryEvent event;
  event.number = from.integer(0);
  event.parent = from.integer(1);
  const std::int64_t kind = from.integer(2);
  event.kind = static_cast<EventKind>(kind);
  event.begins = from.integer(3) != 0;
  event.line = from.integer(4);
  event.operation = from.bytes(5);
  event.answer = from.bytes(6);
  event.by = {std::string(from.bytes(7)), std::string(from.bytes(8)), std::string(from.bytes(9))};
  event.content = from.bytes(10);
  const bool is_known = kind == std::int64_t{0} || kind == std::int64_t{1};  // the two of EventKind
  if (!is_known || event.parent < no_event || event.parent >= event.number || !copy_digest(from.bytes(11), event.hash))
    database_.refuse(fmt::format("event {} is spoiled", event.number), expected_whole);
  return event;
}

std::optional<HistoryEvent> Records::event(EventNumber number) {
  const QueryScope scope(*event_);
  if (!event_->bind(1, number).bind(2, number).step()) return std::nullopt;
  return read_event(*event_);
}

std::vector<HistoryEvent> Records::events(EventNumber first, EventNumber last) {
  const QueryScope scope(*event_);
  std::vector<HistoryEvent> all;
  event_->bind(1, first).bind(2, last);
  while (event_->step()) all.push_back(read_event(*event_));
  return all;
}

HistoryEvent Records::required_event(EventNumber number) {
  if (auto found = event(number)) return *std::move(found);
  database_.refuse(fmt::format("event {} is missing", number), expected_whole);
}

HistoryEvent Records::checked_event(EventNumber number) {
  HistoryEvent event = required_event(number);
  if (hash_of(event, hash(event.parent)) != event.hash)
    database_.refuse(fmt::format("event {} is not as it was written", number), expected_whole);
  return event;
}

EventOrigin Records::read_origin(const PreparedQuery& from) const {
  const EventNumber number = from.integer(0), parent = from.integer(1);
  if (parent < no_event || parent >= number)
    database_.refuse(fmt::format("event {} is spoiled", number), expected_whole);
  return {number, parent, from.integer(2) == 0 ? EventKind::import : EventKind::edit, from.integer(3) != 0};
}

EventOrigin Records::origin(EventNumber number) {
  const QueryScope scope(*origin_);
  if (!origin_->bind(1, number).bind(2, number).step())
    database_.refuse(fmt::format("event {} is missing", number), expected_whole);
  return read_origin(*origin_);
}

std::vector<EventOrigin> Records::origins(EventNumber first, EventNumber last) {
  const QueryScope scope(*origin_);
  std::vector<EventOrigin> all;
  origin_->bind(1, first).bind(2, last);
  while (origin_->step()) all.push_back(read_origin(*origin_));
  return all;
}

Digest Records::hash(EventNumber number) {
  Digest digest{};
  if (number == no_event) return digest;
  const QueryScope scope(*hash_);
  if (!hash_->bind(1, number).step()) database_.refuse(fmt::format("event {} is missing", number), expected_whole);
  if (!copy_digest(hash_->bytes(0), digest))
    database_.refuse(fmt::format("event {} is spoiled", number), expected_whole);
  return digest;
}

EventNumber Records::last() {
  const QueryScope scope(*last_);
  return last_->step() ? last_->integer(0) : no_event;
}

void Records::put(const HistoryEvent& event) {
  put_->bind(1, event.number).bind(2, event.parent).bind(3, static_cast<std::int64_t>(event.kind));
  put_->bind(4, std::int64_t{event.begins}).bind(5, event.line).bind(6, event.operation).bind(7, event.answer);
  put_->bind(8, event.by.author).bind(9, event.by.time).bind(10, event.by.comment);
  put_->bind_bytes(11, event.content).bind_bytes(12, bytes_of(event.hash)).run();
}

bool Records::has_snapshot(EventNumber event) {
  const QueryScope scope(*has_snapshot_);
  return has_snapshot_->bind(1, event).step();
}

std::string Records::snapshot(EventNumber event) {
  const std::string what = fmt::format("the snapshot of event {}", event);
  const Digest of = hash(event);
  const QueryScope scope(*snapshot_);
  if (!snapshot_->bind(1, event).step()) database_.refuse(what + " is missing", expected_whole);
  require_seal(seal_of_snapshot(of, snapshot_->bytes(1)), snapshot_->bytes(0), what);
  return std::string(snapshot_->bytes(1));
}

void Records::put_snapshot(EventNumber event, std::string_view content) {
  const Digest seal = seal_of_snapshot(hash(event), content);
  put_snapshot_->bind(1, event).bind_bytes(2, bytes_of(seal)).bind_bytes(3, content).run();
}

/// A name is sealed with the hash of its event, so that a number that changes is seen.
Digest Records::seal_of(NameKind kind, const NamedEvent& named) {
  return FieldDigest()
      .add("name")
      .add(std::to_string(number_of(kind)))
      .add(named.name)
      .add(bytes_of(hash(named.event)))
      .digest();
}

void Records::require_seal(const Digest& seal, std::string_view stored, const std::string& what) {
  if (bytes_of(seal) != stored) database_.refuse(what + " is not as it was written", expected_whole);
}

std::optional<EventNumber> Records::named(NameKind kind, std::string_view name) {
  const QueryScope scope(*named_);
  if (!named_->bind(1, number_of(kind)).bind(2, name).step()) return std::nullopt;
  const NamedEvent found{std::string(name), named_->integer(0)};
  require_seal(seal_of(kind, found), named_->bytes(1), title_of(kind, name));
  return found.event;
}

std::vector<NamedEvent> Records::names(NameKind kind) {
  const QueryScope scope(*names_);
  std::vector<NamedEvent> all;
  names_->bind(1, number_of(kind));
  while (names_->step()) {
    all.push_back({std::string(names_->bytes(0)), names_->integer(1)});
    require_seal(seal_of(kind, all.back()), names_->bytes(2), title_of(kind, all.back().name));
  }
  return all;
}

std::vector<FoundName> Records::found_names() {
  const QueryScope scope(*found_names_);
  std::vector<FoundName> all;
  while (found_names_->step()) {
    const auto kind = static_cast<NameKind>(
        std::clamp(found_names_->integer(0), number_of(NameKind::branch), number_of(NameKind::redo)));
    const NamedEvent named{std::string(found_names_->bytes(1)), found_names_->integer(2)};
    FoundName& found = all.emplace_back(kind, named, FoundName::Seal::unknown);
    try {
      const bool is_right = bytes_of(seal_of(kind, named)) == found_names_->bytes(3);
      found.seal = is_right ? FoundName::Seal::right : FoundName::Seal::wrong;
    } catch (const io::FileError&) {  // its event has no hash
    }
  }
  return all;
}

void Records::put_name(NameKind kind, const NamedEvent& named) {
  const Digest seal = seal_of(kind, named);
  put_name_->bind(1, number_of(kind)).bind(2, named.name).bind(3, named.event);
  put_name_->bind_bytes(4, bytes_of(seal)).run();
}

void Records::remove_name(NameKind kind, std::string_view name) {
  remove_name_->bind(1, number_of(kind)).bind(2, name).run();
}

}  // namespace durero::store
