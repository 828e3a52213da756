#pragma once
/// An SQLite database of one file, opened and asked. Errors are io::FileError, one line that names the file.

#include <sqlite3.h>

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace durero::store {

/// What is asked of a database, prepared once and asked again and again. Columns and parameters are numbered as SQLite
/// does: columns from 0, parameters from 1.
class PreparedQuery {
 public:
  /// @{ The value of a parameter, which must live until the next reset().
  PreparedQuery& bind(int parameter, std::int64_t value);
  PreparedQuery& bind(int parameter, std::string_view text);
  PreparedQuery& bind_bytes(int parameter, std::string_view bytes);
  /// @}
  /// Steps to the next row: whether there is one.
  bool step();
  /// Asks to the end, and begins anew.
  void run();
  /// Begins anew, with no parameters.
  void reset() noexcept;

  /// @{ A column of the row. Bytes and texts are valid until the next step.
  std::int64_t integer(int column) const noexcept;
  std::string_view bytes(int column) const noexcept;
  /// @}

 private:
  friend class Database;
  PreparedQuery(class Database& of, const char* sql);

  struct Finalize {
    void operator()(sqlite3_stmt* statement) const noexcept { sqlite3_finalize(statement); }
  };
  class Database* of_;
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
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

  /// Opens a file that is there. Where its folder cannot be written, one that is only read is read all the same.
  Database(const std::string& path, Mode mode);
  /// A new one in memory, which becomes a file of that name later: bytes().
  explicit Database(const std::string& path);

  PreparedQuery prepare(const char* sql) { return {*this, sql}; }
  void run(const std::string& sql);
  std::int64_t integer(const std::string& sql);
  /// Whether a transaction is open.
  bool is_in_transaction() const noexcept { return sqlite3_get_autocommit(connection_.get()) == 0; }

  /// The file that the database would be, in the mode of journals that lets a reader go on beside a writer (WAL).
  std::string bytes() const;

  const std::string& path() const noexcept { return path_; }
  /// Refuses what the file is, or what it holds.
  [[noreturn]] void refuse(const std::string& wrong, const std::string& expected) const;

 private:
  friend class PreparedQuery;
  struct Close {
    void operator()(sqlite3* connection) const noexcept { sqlite3_close(connection); }
  };
  void open(const std::string& name, int flags);
  void require_file() const;
  bool stands_alone(const std::string& file) const;
  [[noreturn]] void fail(int code) const;

  std::string path_;  // as messages name it
  std::unique_ptr<sqlite3, Close> connection_;
};

/// What is to be expected where a store is spoiled.
inline constexpr const char* expected_whole = "expected a store that is whole: `durero store verify` says what is";

}  // namespace durero::store
