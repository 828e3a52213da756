#include "journal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "durero/io/file_lock.hpp"
#include "durero/io/output_file.hpp"

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
  try {
    journal_.database.run("ROLLBACK");
  } catch (const std::exception&) {  // the database has done so where it could not go on
  }
}

void WriteTransaction::commit() {
  journal_.database.run("COMMIT");
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
  event.number = records.last() + 1;
  const bool is_import = event.kind == EventKind::import;
  if (is_import) event.content = bytes_of(digest_of(snapshot));
  event.hash = hash_of(event, parent);
  records.put(event);
  if (is_import) records.put_snapshot(event.number, snapshot);
}

void make_store(Database& database) { Records::make_tables(database); }

/// An empty file takes the path, and is held, until the whole one takes its place: of two programs that make one store
/// the second finds the first's. A program that is killed between leaves an empty file, which is no store, and which
/// the next one takes.
void publish(const std::string& path, const std::string& bytes) {
  const int made = ::open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | O_NONBLOCK, 0666);
  if (made < 0)
    throw io::FileError(path, fmt::format("cannot be written: {}", std::strerror(errno)),
                        "expected a file that can be written, in a directory that can");
  ::close(made);
  const io::FileLock lock(path);
  struct stat found {};
  if (::stat(path.c_str(), &found) != 0 || !S_ISREG(found.st_mode) || found.st_size != 0)
    throw io::FileError(path, "is there already", "expected a path of no file, for a new store");
  try {
    io::write_file(path, bytes);
  } catch (const io::FileError&) {
    ::unlink(path.c_str());
    throw;
  }
}

}  // namespace durero::store
