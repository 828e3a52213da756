#include "postgres_database.hpp"

#include <fmt/format.h>

#include <string_view>

#include "durero/store/store.hpp"
#include "durero/store/store_path.hpp"
#include "postgres_query.hpp"
#include "postgres_tables.hpp"
#include "tables.hpp"

namespace durero::store {
namespace {

/// The settings of a connection that writes. A peer that is lost is seen within 10 + 3·5 seconds, so that its lock
/// ends; a server that answers before an edit is on its disk is asked not to.
constexpr const char* settings_to_write =
    "SET lock_timeout = 120000; SET tcp_keepalives_idle = 10; SET tcp_keepalives_interval = 5; "
    "SET tcp_keepalives_count = 3; SELECT set_config('synchronous_commit', 'on', false) "
    "WHERE current_setting('synchronous_commit') = 'off'; ";

/// One writer holds this lock: whoever waits for it sees, once it has it, what was written before.
constexpr const char* begin_to_write =
    "BEGIN ISOLATION LEVEL REPEATABLE READ; LOCK TABLE store IN SHARE ROW EXCLUSIVE MODE";

class PostgresDatabase final : public Database {
 public:
  PostgresDatabase(const std::string& uri, Mode mode);

  void require_store() override { require_tables(*this, connection_); }
  std::unique_ptr<PreparedQuery> prepare(const char* sql) override;
  void run(const std::string& sql) override { connection_.ask(sql); }
  void begin_reading() override { run("BEGIN ISOLATION LEVEL REPEATABLE READ READ ONLY"); }
  void begin_writing() override;
  void commit() override;
  void rollback() noexcept override { connection_.rollback(); }
  bool is_in_transaction() const noexcept override { return PQtransactionStatus(connection_.get()) != PQTRANS_IDLE; }
  bool is_lost() noexcept override { return connection_.is_lost(); }
  std::string fault() override { return ""; }  // its checksums are its server's
  void make_tables() override;
  void publish() override { commit(); }

  void begin_new();

 private:
  void require_durable();
  void read_on();

  Mode mode_;
  PostgresConnection connection_;
  int prepared_ = 0;  // how many queries
};

PostgresDatabase::PostgresDatabase(const std::string& uri, Mode mode)
    : Database(shown_path(uri)), mode_(mode), connection_(*this, uri) {
  run(mode == Mode::read ? "SET default_transaction_read_only = on" : settings_to_write);
  if (mode == Mode::write) require_durable();
}

void PostgresDatabase::require_durable() {
  if (connection_.word("SHOW transaction_read_only") != "off")
    refuse("cannot be written: its server only reads", "expected the primary server");
  if (connection_.word("SHOW fsync") != "on")
    refuse("cannot be written durably: its server has fsync = off", "expected a server that waits for its disk");
}

std::unique_ptr<PreparedQuery> PostgresDatabase::prepare(const char* sql) {
  return std::make_unique<PostgresQuery>(*this, connection_, fmt::format("q{}", ++prepared_), sql,
                                         [this] { read_on(); });
}

void PostgresDatabase::begin_writing() {
  try {
    run(begin_to_write);
  } catch (...) {
    rollback();
    throw;
  }
}

/// An error ends a transaction. Behind a page that is spoiled a reader begins another, so that the rest is read.
void PostgresDatabase::read_on() {
  if (mode_ == Mode::write || PQtransactionStatus(connection_.get()) != PQTRANS_INERROR) return;
  rollback();
  begin_reading();
}

/// Where a statement before has failed, the server takes the transaction back, and calls that no error.
void PostgresDatabase::commit() {
  connection_.settle();
  PostgresAnswer answer(PQexec(connection_.get(), "COMMIT"));
  if (PQstatus(connection_.get()) != CONNECTION_OK)
    refuse(fmt::format("is out of reach: {}", said_of(connection_.get())),
           "expected a server that goes on: `durero store log` tells whether the last transaction is kept");
  answer = checked(*this, connection_.get(), answer.release());
  if (std::string_view(PQcmdStatus(answer.get())) != "COMMIT")
    refuse("has taken the transaction back", "expected a transaction without an error");
}

/// The schema that a URI names by its search path is made where there is none; of several names none is. A name stands
/// in the path between quotes, or in any letters, which count as small ones.
void PostgresDatabase::begin_new() {
  run("BEGIN");
  if (!connection_.word("SELECT current_schema()").empty()) return;
  const std::string name = connection_.word(
      "SELECT quote_ident(CASE WHEN path LIKE '\"%' THEN replace(trim(BOTH '\"' FROM path), '\"\"', '\"') ELSE "
      "lower(path) END) FROM current_setting('search_path') AS path WHERE path NOT LIKE '%,%' AND path NOT LIKE '%$%'");
  if (name.empty())
    refuse(fmt::format("has no schema {}", connection_.word("SHOW search_path")),
           "expected one, which CREATE SCHEMA makes");
  run("CREATE SCHEMA " + name);
}

void PostgresDatabase::make_tables() {
  const std::string sql = statements_of_tables();
  PGconn* const connection = connection_.get();
  PostgresAnswer answer(PQexec(connection, sql.c_str()));
  const std::string state = error_state(answer.get());
  if (state == "42P07" || state == "23505")  // there is such a table, or another program makes one
    refuse("is there already", "expected a schema without a store, for a new store");
  checked(*this, connection, answer.release());
}

}  // namespace

/// libpq tells 10⁴ times the major version, and the minor one.
std::string libpq_version() { return fmt::format("{}.{}", PQlibVersion() / 10'000, PQlibVersion() % 10'000); }

std::unique_ptr<Database> open_postgres(const std::string& uri, Database::Mode mode) {
  return std::make_unique<PostgresDatabase>(uri, mode);
}

std::unique_ptr<Database> new_postgres(const std::string& uri) {
  auto database = std::make_unique<PostgresDatabase>(uri, Database::Mode::write);
  database->begin_new();
  return database;
}

}  // namespace durero::store
