#pragma once
/// A connection to a PostgreSQL server. What is sent without waiting for its answer (libpq's pipeline) is answered
/// before anything else is asked.

#include <libpq-fe.h>

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "postgres_error.hpp"

namespace durero::store {

/// Everything but lost() throws io::FileError in the name of that database.
class PostgresConnection {
 public:
  PostgresConnection(const Database& of, const std::string& uri);

  /// What statements answer that have no parameters; that of the last, of several.
  PostgresAnswer ask(const std::string& sql);
  /// The first column of their only row; empty where there is another number of rows.
  std::string word(const std::string& sql);
  /// Prepares a statement by a name.
  void prepare(const std::string& name, const char* sql);
  /// What a prepared statement answers, in binary. An answer that is an error is returned, too.
  PostgresAnswer answer(const std::string& name, std::span<const std::string_view> values);
  /// Sends a prepared statement. Its error, if any, is thrown by what is called next.
  void send(const std::string& name, std::span<const std::string_view> values);
  /// Waits until what was sent is done.
  void settle();
  /// Takes a transaction back, whatever was sent in it.
  void rollback() noexcept;

  /// Whether the server is gone, as far as is known without asking it.
  bool is_lost() noexcept;
  PGconn* get() const noexcept { return connection_.get(); }

 private:
  struct Finish {
    void operator()(PGconn* connection) const noexcept { PQfinish(connection); }
  };
  /// The answers to what was sent.
  struct PipelineOutcome {
    PostgresAnswer error{};  ///< the first, if any
    bool is_whole = false;   ///< each statement is answered
  };
  PipelineOutcome outcome_of_sent() noexcept;

  const Database& of_;
  std::unique_ptr<PGconn, Finish> connection_;
  bool is_sending_ = false;
};

}  // namespace durero::store
