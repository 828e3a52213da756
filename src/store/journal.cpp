#include "journal.hpp"

#include <fmt/format.h>

#include "durero/io/source.hpp"

namespace durero::store {
namespace {

/// The one head has the name of its branch; on no branch it has no name, and its event.
StoredName head_name(Records& records) {
  const std::vector<NamedEvent> all = records.names(NameKind::head);
  if (all.size() != 1) records.database().refuse("HEAD is missing", expected_whole);
  return {all.front().name, all.front().event};
}

}  // namespace

WriteTransaction::~WriteTransaction() {
  if (!is_open_) return;
  journal_.fold.forget();
  journal_.database.rollback();
}

void WriteTransaction::commit() {
  journal_.database.commit();
  is_open_ = false;
}

StoreHead head_of(Records& records) {
  const StoredName head = head_name(records);
  if (head.name.empty()) return {"", head.event};
  const auto event = records.named(NameKind::branch, head.name);
  if (!event) records.database().refuse(fmt::format("branch {}, where HEAD is, is missing", head.name), expected_whole);
  return {head.name, *event};
}

void move_head(Records& records, const StoreHead& head, EventNumber to) {
  if (head.branch.empty())
    records.put_name(NameKind::head, {"", to});
  else
    records.put_name(NameKind::branch, {head.branch, to});
}

void append(Records& records, HistoryEvent& event, const Digest& parent, std::string_view snapshot) {
  const bool is_import = event.kind == EventKind::import;
  if (is_import) event.content = bytes_of(digest_of(snapshot));
  event.hash = hash_of(event, parent);
  records.put(event);
  if (is_import) records.put_snapshot(event.number, snapshot);
}

}  // namespace durero::store
