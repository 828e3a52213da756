#include "postgres_database.hpp"

#include <fmt/format.h>
#include <libpq-fe.h>

#include <array>
#include <optional>
#include <string_view>

#include "durero/store/store.hpp"
#include "durero/store/store_path.hpp"
#include "postgres_error.hpp"
#include "postgres_tables.hpp"
#include "tables.hpp"

namespace durero::store {
namespace {

/// More than the greatest event has. A parameter is 10⁹ bytes at most, as SQLite's, which both hold.
constexpr std::size_t most_parameters = 12;
constexpr std::size_t most_bytes = 1'000'000'000;

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

  void require_store() override { require_tables(*this, connection_.get()); }
  std::unique_ptr<PreparedQuery> prepare(const char* sql) override;
  void run(const std::string& sql) override { ask(sql.c_str()); }
  void begin_reading() override { run("BEGIN ISOLATION LEVEL REPEATABLE READ READ ONLY"); }
  void begin_writing() override;
  void commit() override;
  bool is_in_transaction() const noexcept override;
  bool is_lost() noexcept override;
  std::string fault() override { return ""; }  // its checksums are its server's
  void make_tables() override;
  void publish() override { commit(); }

  /// Goes on reading behind an error, which ends a transaction: of a page that is spoiled, others are asked for.
  void read_on();
  void begin_new();
  PGconn* connection() const noexcept { return connection_.get(); }

 private:
  struct Finish {
    void operator()(PGconn* connection) const noexcept { PQfinish(connection); }
  };
  void connect(const std::string& uri);
  void require_durable();
  PostgresAnswer ask(const char* sql) { return checked(*this, connection(), PQexec(connection(), sql)); }
  std::string word(const char* sql);

  Mode mode_;
  std::unique_ptr<PGconn, Finish> connection_;
  int prepared_ = 0;  // how many queries
};

/// A statement of the server's, prepared where it is asked first. Numbers go as eight bytes, the highest first; texts
/// and bytes as they are; rows come so.
class PostgresQuery final : public PreparedQuery {
 public:
  PostgresQuery(PostgresDatabase& of, std::string name, const char* sql) : of_(of), name_(std::move(name)), sql_(sql) {}
  PreparedQuery& bind(int parameter, std::int64_t value) override;
  PreparedQuery& bind(int parameter, std::string_view text) override { return bind_bytes(parameter, text); }
  PreparedQuery& bind_bytes(int parameter, std::string_view bytes) override;
  bool step() override;
  void reset() noexcept override;
  std::int64_t integer(int column) const noexcept override;
  std::string_view bytes(int column) const noexcept override;

 private:
  void ask();

  PostgresDatabase& of_;
  std::string name_;
  const char* sql_;
  bool is_prepared_ = false;
  int count_ = 0;  // of parameters
  std::array<std::array<char, 8>, most_parameters> numbers_{};
  std::array<std::string_view, most_parameters> values_{};
  PostgresAnswer answer_{};
  int row_ = -1;
};

PreparedQuery& PostgresQuery::bind(int parameter, std::int64_t value) {
  std::array<char, 8>& number = numbers_.at(static_cast<std::size_t>(parameter - 1));
  for (std::size_t i = 0; i < number.size(); ++i)
    number[i] = static_cast<char>(static_cast<std::uint64_t>(value) >> (56U - 8U * i));
  return bind_bytes(parameter, {number.data(), number.size()});
}

PreparedQuery& PostgresQuery::bind_bytes(int parameter, std::string_view bytes) {
  if (bytes.size() > most_bytes)
    of_.refuse("cannot hold so much at once: a snapshot takes 10⁹ bytes at most", "expected a smaller scene");
  // A null pointer would be no value at all.
  values_.at(static_cast<std::size_t>(parameter - 1)) = bytes.data() == nullptr ? std::string_view("") : bytes;
  count_ = std::max(count_, parameter);
  return *this;
}

void PostgresQuery::ask() {
  PGconn* const connection = of_.connection();
  if (!is_prepared_) checked(of_, connection, PQprepare(connection, name_.c_str(), sql_, 0, nullptr));
  is_prepared_ = true;
  std::array<const char*, most_parameters> values{};
  std::array<int, most_parameters> lengths{}, are_binary{};
  for (std::size_t i = 0; i < static_cast<std::size_t>(count_); ++i) {
    values[i] = values_[i].data();
    lengths[i] = static_cast<int>(values_[i].size());
    are_binary[i] = 1;
  }
  PGresult* const answer =
      PQexecPrepared(connection, name_.c_str(), count_, values.data(), lengths.data(), are_binary.data(), 1);
  if (error_state(answer).starts_with("XX")) of_.read_on();
  answer_ = checked(of_, connection, answer);
}

bool PostgresQuery::step() {
  if (!answer_) ask();
  return ++row_ < PQntuples(answer_.get());
}

void PostgresQuery::reset() noexcept {
  answer_.reset();
  row_ = -1;
  count_ = 0;
}

/// A whole number has 8 or 4 bytes, and whether something is, 1.
std::int64_t PostgresQuery::integer(int column) const noexcept {
  const std::string_view value = bytes(column);
  std::uint64_t number =
      value.size() == 4 && (static_cast<unsigned char>(value[0]) & 0x80U) != 0 ? ~std::uint64_t{0} : 0;
  for (const char byte : value) number = number << 8U | static_cast<unsigned char>(byte);
  return static_cast<std::int64_t>(number);
}

std::string_view PostgresQuery::bytes(int column) const noexcept {
  return {PQgetvalue(answer_.get(), row_, column), static_cast<std::size_t>(PQgetlength(answer_.get(), row_, column))};
}

PostgresDatabase::PostgresDatabase(const std::string& uri, Mode mode) : Database(shown_path(uri)), mode_(mode) {
  connect(uri);
  run(mode == Mode::read ? "SET default_transaction_read_only = on" : settings_to_write);
  if (mode == Mode::write) require_durable();
}

/// The names before the URI hold where that says nothing else. The names behind it hold whatever it says.
void PostgresDatabase::connect(const std::string& uri) {
  constexpr std::array names{"connect_timeout", "fallback_application_name", "dbname", "client_encoding",
                             static_cast<const char*>(nullptr)};
  const std::array values{"20", "durero", uri.c_str(), "UTF8", static_cast<const char*>(nullptr)};
  connection_.reset(PQconnectdbParams(names.data(), values.data(), 1));
  if (!connection_) throw std::bad_alloc();
  PQsetNoticeProcessor(
      connection(), [](void*, const char*) {}, nullptr);
  if (PQstatus(connection()) == CONNECTION_OK) return;
  // What libpq says of a URI that it cannot read may hold the password.
  PQconninfoOption* const read = PQconninfoParse(uri.c_str(), nullptr);
  if (read == nullptr)
    refuse("is no URI that libpq reads", "expected postgresql://USER@HOST:PORT/DATABASE?PARAMETER=VALUE, with %");
  PQconninfoFree(read);
  refuse(fmt::format("cannot be opened: {}", said_of(connection())),
         "expected a server that answers, and a user and a database that it has");
}

/// The first column of the first row.
std::string PostgresDatabase::word(const char* sql) {
  const PostgresAnswer answer = ask(sql);
  return PQntuples(answer.get()) > 0 ? PQgetvalue(answer.get(), 0, 0) : "";
}

void PostgresDatabase::require_durable() {
  if (word("SHOW transaction_read_only") != "off")
    refuse("cannot be written: its server only reads", "expected the primary server");
  if (word("SHOW fsync") != "on")
    refuse("cannot be written durably: its server has fsync = off", "expected a server that waits for its disk");
}

std::unique_ptr<PreparedQuery> PostgresDatabase::prepare(const char* sql) {
  return std::make_unique<PostgresQuery>(*this, fmt::format("q{}", ++prepared_), sql);
}

void PostgresDatabase::begin_writing() {
  try {
    run(begin_to_write);
  } catch (...) {
    PQclear(PQexec(connection(), "ROLLBACK"));
    throw;
  }
}

void PostgresDatabase::read_on() {
  if (mode_ == Mode::write || PQtransactionStatus(connection()) != PQTRANS_INERROR) return;
  PQclear(PQexec(connection(), "ROLLBACK"));
  begin_reading();
}

/// Where a statement before has failed, the server takes the transaction back, and calls that no error.
void PostgresDatabase::commit() {
  PGresult* const answer = PQexec(connection(), "COMMIT");
  if (PQstatus(connection()) != CONNECTION_OK) {
    PQclear(answer);
    refuse(fmt::format("is out of reach: {}", said_of(connection())),
           "expected a server that goes on: `durero store log` tells whether the last transaction is kept");
  }
  const PostgresAnswer kept = checked(*this, connection(), answer);
  if (std::string_view(PQcmdStatus(kept.get())) != "COMMIT")
    refuse("has taken the transaction back", "expected a transaction without an error");
}

bool PostgresDatabase::is_in_transaction() const noexcept { return PQtransactionStatus(connection()) != PQTRANS_IDLE; }

bool PostgresDatabase::is_lost() noexcept {
  PQconsumeInput(connection());
  return PQstatus(connection()) != CONNECTION_OK;
}

/// The schema that a URI names by its search path is made where there is none; of several names none is. A name stands
/// in the path between quotes, or in any letters, which count as small ones.
void PostgresDatabase::begin_new() {
  run("BEGIN");
  if (!word("SELECT current_schema()").empty()) return;
  const std::string name = word(
      "SELECT quote_ident(CASE WHEN path LIKE '\"%' THEN replace(trim(BOTH '\"' FROM path), '\"\"', '\"') ELSE "
      "lower(path) END) FROM current_setting('search_path') AS path WHERE path NOT LIKE '%,%' AND path NOT LIKE '%$%'");
  if (name.empty())
    refuse(fmt::format("has no schema {}", word("SHOW search_path")), "expected one, which CREATE SCHEMA makes");
  run("CREATE SCHEMA " + name);
}

void PostgresDatabase::make_tables() {
  const std::string sql = statements_of_tables();
  PostgresAnswer answer(PQexec(connection(), sql.c_str()));
  const std::string state = error_state(answer.get());
  if (state == "42P07" || state == "23505")  // there is such a table, or another program makes one
    refuse("is there already", "expected a schema without a store, for a new store");
  checked(*this, connection(), answer.release());
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
