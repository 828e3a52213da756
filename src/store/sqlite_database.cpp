#include "sqlite_database.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sqlite3.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <system_error>

#include "durero/io/file_lock.hpp"
#include "durero/io/output_file.hpp"
#include "durero/io/source.hpp"
#include "tables.hpp"

namespace durero::store {
namespace {

/// "Dure": how programs such as file(1) tell a store from other databases.
constexpr std::int64_t application = 0x44757265;

constexpr TableWords sqlite_words{"INTEGER", "TEXT", "BLOB", " STRICT", " STRICT, WITHOUT ROWID"};

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

/// A connection to a file, or to memory.
class SqliteDatabase final : public Database {
 public:
  /// Opens a file that is there. Where its folder cannot be written, one that is only read is read all the same.
  SqliteDatabase(const std::string& path, Mode mode);
  /// A new one in memory, which becomes a file of that name later.
  explicit SqliteDatabase(const std::string& path);

  void require_store() override;
  std::unique_ptr<PreparedQuery> prepare(const char* sql) override;
  void run(const std::string& sql) override;
  void begin_reading() override { run("BEGIN"); }
  void begin_writing() override { run("BEGIN IMMEDIATE"); }
  void commit() override { run("COMMIT"); }
  /// SQLite has done so itself where it could not go on.
  void rollback() noexcept override { sqlite3_exec(connection_.get(), "ROLLBACK", nullptr, nullptr, nullptr); }
  bool is_in_transaction() const noexcept override { return sqlite3_get_autocommit(connection_.get()) == 0; }
  bool is_lost() noexcept override { return false; }  // a file has no server
  std::string fault() override;
  void make_tables() override;
  void publish() override;

  sqlite3* connection() const noexcept { return connection_.get(); }
  [[noreturn]] void fail(int code) const;

 private:
  struct Close {
    void operator()(sqlite3* connection) const noexcept { sqlite3_close(connection); }
  };
  void open(const std::string& name, int flags);
  void require_file() const;
  bool stands_alone(const std::string& file) const;
  std::int64_t integer(const char* sql);
  std::string schema();
  std::string file_bytes() const;

  std::unique_ptr<sqlite3, Close> connection_;
};

/// SQLite numbers columns from 0 and parameters from 1, as the interface does.
class SqliteQuery final : public PreparedQuery {
 public:
  SqliteQuery(SqliteDatabase& of, const char* sql);
  PreparedQuery& bind(int parameter, std::int64_t value) override;
  PreparedQuery& bind(int parameter, std::string_view text) override;
  PreparedQuery& bind_bytes(int parameter, std::string_view bytes) override;
  bool step() override;
  void reset() noexcept override;
  std::int64_t integer(int column) const noexcept override;
  std::string_view bytes(int column) const noexcept override;

 private:
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const noexcept { sqlite3_finalize(statement); }
  };
  SqliteDatabase& of_;
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
};

SqliteQuery::SqliteQuery(SqliteDatabase& of, const char* sql) : of_(of) {
  sqlite3_stmt* made = nullptr;
  const int code = sqlite3_prepare_v2(of.connection(), sql, -1, &made, nullptr);
  statement_.reset(made);
  if (code != SQLITE_OK) of.fail(code);
}

PreparedQuery& SqliteQuery::bind(int parameter, std::int64_t value) {
  if (const int code = sqlite3_bind_int64(statement_.get(), parameter, value)) of_.fail(code);
  return *this;
}

PreparedQuery& SqliteQuery::bind(int parameter, std::string_view text) {
  if (const int code =
          sqlite3_bind_text64(statement_.get(), parameter, text.data(), text.size(), SQLITE_STATIC, SQLITE_UTF8))
    of_.fail(code);
  return *this;
}

PreparedQuery& SqliteQuery::bind_bytes(int parameter, std::string_view bytes) {
  if (const int code = sqlite3_bind_blob64(statement_.get(), parameter, bytes.data(), bytes.size(), SQLITE_STATIC))
    of_.fail(code);
  return *this;
}

bool SqliteQuery::step() {
  const int code = sqlite3_step(statement_.get());
  if (code == SQLITE_ROW) return true;
  if (code == SQLITE_DONE) return false;
  reset();
  of_.fail(code);
}

void SqliteQuery::reset() noexcept {
  sqlite3_reset(statement_.get());
  sqlite3_clear_bindings(statement_.get());
}

std::int64_t SqliteQuery::integer(int column) const noexcept { return sqlite3_column_int64(statement_.get(), column); }

std::string_view SqliteQuery::bytes(int column) const noexcept {
  const auto* const data = static_cast<const char*>(sqlite3_column_blob(statement_.get(), column));
  return {data, static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column))};
}

SqliteDatabase::SqliteDatabase(const std::string& path, Mode mode) : Database(path) {
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

SqliteDatabase::SqliteDatabase(const std::string& path) : Database(path) {
  open(":memory:", SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
}

void SqliteDatabase::open(const std::string& name, int flags) {
  sqlite3* made = nullptr;
  const int code = sqlite3_open_v2(name.c_str(), &made, flags, nullptr);
  connection_.reset(made);
  if (code != SQLITE_OK) fail(code);
  sqlite3_busy_timeout(made, patience);
}

void SqliteDatabase::require_file() const {
  struct stat found {};
  if (::stat(path().c_str(), &found) != 0)
    refuse(fmt::format("cannot be read: {}", std::strerror(errno)), "expected a store");
  if (!S_ISREG(found.st_mode)) refuse("is no regular file", "expected a store");
  if (found.st_size == 0) refuse("is empty", "expected a store, which `durero store init` makes");
}

/// Whether a file has no journal beside it, and can get none.
bool SqliteDatabase::stands_alone(const std::string& file) const {
  struct stat journal {};
  const bool has_journal = ::stat((file + "-wal").c_str(), &journal) == 0 && journal.st_size > 0;
  return !has_journal && ::access(file.substr(0, file.rfind('/') + 1).c_str(), W_OK) != 0;
}

void SqliteDatabase::run(const std::string& sql) {
  if (const int code = sqlite3_exec(connection_.get(), sql.c_str(), nullptr, nullptr, nullptr)) fail(code);
}

std::int64_t SqliteDatabase::integer(const char* sql) {
  SqliteQuery query(*this, sql);
  return query.step() ? query.integer(0) : 0;
}

/// The file that the database would be, in the mode of journals that lets a reader go on beside a writer. The bytes 18
/// and 19 of its header say by which journal the file is written and read: 2 is WAL, and 1, as a database
/// in memory has them, any other (the format of SQLite's files, 1.3.3).
std::string SqliteDatabase::file_bytes() const {
  sqlite3_int64 size = 0;
  const std::unique_ptr<unsigned char, void (*)(void*)> data(sqlite3_serialize(connection_.get(), "main", &size, 0),
                                                             sqlite3_free);
  if (!data) throw std::bad_alloc();
  std::string text(reinterpret_cast<const char*>(data.get()), static_cast<std::size_t>(size));
  text[18] = text[19] = 2;
  return text;
}

std::unique_ptr<PreparedQuery> SqliteDatabase::prepare(const char* sql) {
  return std::make_unique<SqliteQuery>(*this, sql);
}

/// The statements that have made the tables, but for those of SQLite itself.
std::string SqliteDatabase::schema() {
  SqliteQuery query(*this,
                    "SELECT sql FROM sqlite_schema WHERE name NOT LIKE 'sqlite!_%' ESCAPE '!' ORDER BY type, name");
  std::string all;
  while (query.step()) all.append(query.bytes(0)).append("\n");
  return all;
}

/// Another table may have a trigger, which would be carried out.
void SqliteDatabase::require_store() {
  if (integer("PRAGMA application_id") != application)
    refuse("is a database, and no store", "expected one that `durero store init` made");
  require_version(*this, integer("PRAGMA user_version"));
  static const std::string schema_of_stores = [] {
    SqliteDatabase empty("");
    empty.make_tables();
    return empty.schema();
  }();
  if (schema() != schema_of_stores) refuse("has other tables than a store", expected_whole);
}

void SqliteDatabase::make_tables() {
  run(fmt::format("PRAGMA application_id = {}; PRAGMA user_version = {}; {}", application, table_version,
                  table_statements(sqlite_words)));
}

std::string SqliteDatabase::fault() {
  SqliteQuery check(*this, "PRAGMA integrity_check(1)");
  return check.step() && check.bytes(0) != "ok" ? std::string(check.bytes(0)) : "";
}

/// An empty file takes the path, and is held, until the whole one takes its place: of two programs that make one store
/// the second finds the first's. A program that is killed between leaves an empty file, which is no store, and which
/// the next one takes.
void SqliteDatabase::publish() {
  const int made = ::open(path().c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | O_NONBLOCK, 0666);
  if (made < 0)
    refuse(fmt::format("cannot be written: {}", std::strerror(errno)),
           "expected a file that can be written, in a directory that can");
  ::close(made);
  const io::FileLock lock(path());
  struct stat found {};
  if (::stat(path().c_str(), &found) != 0 || !S_ISREG(found.st_mode) || found.st_size != 0)
    refuse("is there already", "expected a path of no file, for a new store");
  try {
    io::write_file(path(), file_bytes());
  } catch (const io::FileError&) {
    ::unlink(path().c_str());
    throw;
  }
}

void SqliteDatabase::fail(int code) const {
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

}  // namespace

std::unique_ptr<Database> open_sqlite(const std::string& path, Database::Mode mode) {
  return std::make_unique<SqliteDatabase>(path, mode);
}

std::unique_ptr<Database> new_sqlite(const std::string& path) { return std::make_unique<SqliteDatabase>(path); }

}  // namespace durero::store
