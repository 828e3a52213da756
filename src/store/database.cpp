#include "database.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <system_error>

#include "durero/io/source.hpp"

namespace durero::store {
namespace {

/// How long a program waits for others that write, in milliseconds. A hundred of them, each with a transaction of a
/// second, are done before.
constexpr int patience = 120'000;

/// A path from the root, which SQLite takes for nothing else: ":memory:" and the empty name mean something to it.
std::string path_from_root(const std::string& path) {
  const std::unique_ptr<char, void (*)(void*)> real(::realpath(path.c_str(), nullptr), std::free);
  if (real) return real.get();
  throw io::FileError(path, fmt::format("cannot be read: {}", std::strerror(errno)), "expected a store");
}

/// The URI of a file that nobody changes.
std::string uri_of(const std::string& file) {
  std::string uri = "file:";
  for (const char c : file) {
    const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '/';
    uri += is_plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return uri + "?immutable=1";
}

}  // namespace

PreparedQuery::PreparedQuery(Database& of, const char* sql) : of_(&of) {
  sqlite3_stmt* made = nullptr;
  const int code = sqlite3_prepare_v2(of.connection_.get(), sql, -1, &made, nullptr);
  statement_.reset(made);
  if (code != SQLITE_OK) of.fail(code);
}

PreparedQuery& PreparedQuery::bind(int parameter, std::int64_t value) {
  if (const int code = sqlite3_bind_int64(statement_.get(), parameter, value)) of_->fail(code);
  return *this;
}

PreparedQuery& PreparedQuery::bind(int parameter, std::string_view text) {
  if (const int code =
          sqlite3_bind_text64(statement_.get(), parameter, text.data(), text.size(), SQLITE_STATIC, SQLITE_UTF8))
    of_->fail(code);
  return *this;
}

PreparedQuery& PreparedQuery::bind_bytes(int parameter, std::string_view bytes) {
  if (const int code = sqlite3_bind_blob64(statement_.get(), parameter, bytes.data(), bytes.size(), SQLITE_STATIC))
    of_->fail(code);
  return *this;
}

bool PreparedQuery::step() {
  const int code = sqlite3_step(statement_.get());
  if (code == SQLITE_ROW) return true;
  if (code == SQLITE_DONE) return false;
  reset();
  of_->fail(code);
}

void PreparedQuery::run() {
  while (step()) continue;
  reset();
}

void PreparedQuery::reset() noexcept {
  sqlite3_reset(statement_.get());
  sqlite3_clear_bindings(statement_.get());
}

std::int64_t PreparedQuery::integer(int column) const noexcept {
  return sqlite3_column_int64(statement_.get(), column);
}

std::string_view PreparedQuery::bytes(int column) const noexcept {
  const auto* const data = static_cast<const char*>(sqlite3_column_blob(statement_.get(), column));
  return {data, static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column))};
}

Database::Database(const std::string& path, Mode mode) : path_(path) {
  require_file();
  const std::string file = path_from_root(path);
  open(file, SQLITE_OPEN_READWRITE);
  try {
    run("PRAGMA cell_size_check = ON");
    run(mode == Mode::write ? "PRAGMA synchronous = FULL" : "PRAGMA query_only = ON");
    integer("SELECT count(*) FROM sqlite_schema");
  } catch (const io::FileError&) {
    // A reader makes a file beside the store, by which it and writers see each other. Where it can make none, and there
    // is no journal, the store is read as one that nobody writes; what is torn all the same does not keep its hashes.
    if (mode == Mode::write || !stands_alone(file)) throw;
    open(uri_of(file), SQLITE_OPEN_READONLY | SQLITE_OPEN_URI);
  }
}

Database::Database(const std::string& path) : path_(path) {
  open(":memory:", SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
}

void Database::open(const std::string& name, int flags) {
  sqlite3* made = nullptr;
  const int code = sqlite3_open_v2(name.c_str(), &made, flags, nullptr);
  connection_.reset(made);
  if (code != SQLITE_OK) fail(code);
  sqlite3_busy_timeout(made, patience);
}

void Database::require_file() const {
  struct stat found {};
  if (::stat(path_.c_str(), &found) != 0)
    refuse(fmt::format("cannot be read: {}", std::strerror(errno)), "expected a store");
  if (!S_ISREG(found.st_mode)) refuse("is no regular file", "expected a store");
  if (found.st_size == 0) refuse("is empty", "expected a store, which `durero store init` makes");
}

/// Whether a file has no journal beside it, and can get none.
bool Database::stands_alone(const std::string& file) const {
  struct stat journal {};
  const bool has_journal = ::stat((file + "-wal").c_str(), &journal) == 0 && journal.st_size > 0;
  return !has_journal && ::access(file.substr(0, file.rfind('/') + 1).c_str(), W_OK) != 0;
}

void Database::run(const std::string& sql) {
  if (const int code = sqlite3_exec(connection_.get(), sql.c_str(), nullptr, nullptr, nullptr)) fail(code);
}

std::int64_t Database::integer(const std::string& sql) {
  PreparedQuery query = prepare(sql.c_str());
  return query.step() ? query.integer(0) : 0;
}

/// The bytes 18 and 19 of the header say by which journal the file is written and read: 2 is WAL, and 1, as a database
/// in memory has them, any other (the format of SQLite's files, 1.3.3).
std::string Database::bytes() const {
  sqlite3_int64 size = 0;
  const std::unique_ptr<unsigned char, void (*)(void*)> data(sqlite3_serialize(connection_.get(), "main", &size, 0),
                                                             sqlite3_free);
  if (!data) throw std::bad_alloc();
  std::string text(reinterpret_cast<const char*>(data.get()), static_cast<std::size_t>(size));
  text[18] = text[19] = 2;
  return text;
}

void Database::refuse(const std::string& wrong, const std::string& expected) const {
  throw io::FileError(path_, wrong, expected);
}

void Database::fail(int code) const {
  const std::string said = connection_ ? sqlite3_errmsg(connection_.get()) : sqlite3_errstr(code);
  switch (code & 0xff) {
    case SQLITE_NOMEM:
      throw std::bad_alloc();
    case SQLITE_NOTADB:
      refuse("is no store", "expected one that `durero store init` made");
    case SQLITE_FULL:
      refuse("cannot be written: No space left on device",
             "expected room for it; nothing is kept of what was not answered");
    case SQLITE_READONLY:
      refuse("cannot be written: it is read-only", "expected a file that can be written, in a directory that can");
    case SQLITE_BUSY:
      refuse("is being written by another program", fmt::format("expected that it ends within {} s", patience / 1000));
    case SQLITE_CANTOPEN:
    case SQLITE_IOERR:
      refuse(fmt::format("cannot be used: {}", said),
             "expected a file that can be read, in a directory that can be written");
    case SQLITE_TOOBIG:
      refuse("cannot hold so much at once: a snapshot takes 10⁹ bytes at most", "expected a smaller scene");
    default:  // an open set: SQLite's results
      refuse(fmt::format("is spoiled: {}", said), expected_whole);
  }
}

}  // namespace durero::store
