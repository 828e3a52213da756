#pragma once
/// The database of a store: a file of SQLite, or a schema of a PostgreSQL server. Statements that both understand stand
/// once, with their parameters as $1, $2, … in the order in which they occur first. Errors are io::FileError, one line
/// that names the store.

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

namespace durero::store {

/// What is asked of a database, prepared once and asked again and again. Columns are numbered from 0, parameters
/// from 1.
class PreparedQuery {
 public:
  virtual ~PreparedQuery() = default;

  /// @{ The value of a parameter, which must live until the next reset().
  virtual PreparedQuery& bind(int parameter, std::int64_t value) = 0;
  virtual PreparedQuery& bind(int parameter, std::string_view text) = 0;
  virtual PreparedQuery& bind_bytes(int parameter, std::string_view bytes) = 0;
  /// @}
  /// Steps to the next row: whether there is one.
  virtual bool step() = 0;
  /// Begins anew, with no parameters.
  virtual void reset() noexcept = 0;
  /// Asks to the end, and begins anew. Its error may be thrown by what is asked of the database next.
  virtual void run() {
    while (step()) continue;
    reset();
  }

  /// @{ A column of the row. Bytes and texts are valid until the next step.
  virtual std::int64_t integer(int column) const noexcept = 0;
  virtual std::string_view bytes(int column) const noexcept = 0;
  /// @}
};

/// Resets a query at the end of its scope, so that it holds no lock.
class QueryScope {
 public:
  explicit QueryScope(PreparedQuery& query) noexcept : query_(query) {}
  ~QueryScope() { query_.reset(); }
  QueryScope(const QueryScope&) = delete;
  QueryScope& operator=(const QueryScope&) = delete;

 private:
  PreparedQuery& query_;
};

/// An open database.
class Database {
 public:
  /// Whether it is only read. Writers wait for each other.
  enum class Mode : bool { read, write };

  /// `name` is that of the store in messages.
  explicit Database(std::string name) : path_(std::move(name)) {}
  virtual ~Database() = default;
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  /// Throws unless the database is a store of this version, with its tables and no others' ways to change them.
  virtual void require_store() = 0;
  virtual std::unique_ptr<PreparedQuery> prepare(const char* sql) = 0;
  /// Carries out a statement without answer.
  virtual void run(const std::string& sql) = 0;

  /// Begins a transaction that sees what is there at its first question, whoever writes beside.
  virtual void begin_reading() = 0;
  /// Begins a transaction that alone may write. Waits until no other program writes.
  virtual void begin_writing() = 0;
  /// Keeps the transaction, on disk.
  virtual void commit() = 0;
  /// Takes the transaction back.
  virtual void rollback() noexcept = 0;
  /// Whether a transaction is open.
  virtual bool is_in_transaction() const noexcept = 0;
  /// Whether nothing can be asked any more, since the server is gone.
  virtual bool is_lost() noexcept = 0;
  /// What is wrong beneath the tables; empty where nothing is found.
  virtual std::string fault() = 0;

  /// @{ Of a new database alone: its tables, and how it appears, whole. Throws where a store is there already.
  virtual void make_tables() = 0;
  virtual void publish() = 0;
  /// @}

  /// As messages name the store: without a password.
  const std::string& path() const noexcept { return path_; }
  /// Refuses what the store is, or what it holds.
  [[noreturn]] void refuse(const std::string& wrong, const std::string& expected) const;

 private:
  std::string path_;
};

/// How long a program waits for others that write, in milliseconds. A hundred of them, each with a transaction of a
/// second, are done before.
inline constexpr int patience = 120'000;

/// Opens the store of a path, or of the URI of a PostgreSQL server.
std::unique_ptr<Database> open_database(const std::string& path, Database::Mode mode);

/// A new one without tables, which nobody sees before publish().
std::unique_ptr<Database> new_database(const std::string& path);

/// What is to be expected where a store is spoiled.
inline constexpr const char* expected_whole = "expected a store that is whole: `durero store verify` says what is";

}  // namespace durero::store
