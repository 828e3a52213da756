#include "postgres_connection.hpp"

#include <fmt/format.h>

#include <array>
#include <new>
#include <vector>

namespace durero::store {
namespace {

/// Values as libpq takes them: binary, and each with its length.
struct BinaryValues {
  explicit BinaryValues(std::span<const std::string_view> values) : are_binary(values.size(), 1) {
    for (const std::string_view value : values) {
      texts.push_back(value.data() == nullptr ? "" : value.data());  // a null pointer would be no value at all
      lengths.push_back(static_cast<int>(value.size()));
    }
  }
  int count() const noexcept { return static_cast<int>(texts.size()); }

  std::vector<const char*> texts{};
  std::vector<int> lengths{}, are_binary;
};

}  // namespace

/// The parameters before the URI hold where that says nothing else. The one behind it holds whatever it says.
PostgresConnection::PostgresConnection(const Database& of, const std::string& uri) : of_(of) {
  constexpr std::array names{"connect_timeout", "fallback_application_name", "dbname", "client_encoding",
                             static_cast<const char*>(nullptr)};
  const std::array values{"20", "durero", uri.c_str(), "UTF8", static_cast<const char*>(nullptr)};
  connection_.reset(PQconnectdbParams(names.data(), values.data(), 1));
  if (!connection_) throw std::bad_alloc();
  PQsetNoticeProcessor(
      get(), [](void*, const char*) {}, nullptr);
  if (PQstatus(get()) == CONNECTION_OK) return;
  // What libpq says of a URI that it cannot read may hold the password.
  PQconninfoOption* const read = PQconninfoParse(uri.c_str(), nullptr);
  if (read == nullptr)
    of.refuse("is no URI that libpq reads", "expected postgresql://USER@HOST:PORT/DATABASE?PARAMETER=VALUE, with %");
  PQconninfoFree(read);
  of.refuse(fmt::format("cannot be opened: {}", said_of(get())),
            "expected a server that answers, and a user and a database that it has");
}

PostgresAnswer PostgresConnection::ask(const std::string& sql) {
  settle();
  return checked(of_, get(), PQexec(get(), sql.c_str()));
}

std::string PostgresConnection::word(const std::string& sql) {
  const PostgresAnswer answer = ask(sql);
  return PQntuples(answer.get()) == 1 ? PQgetvalue(answer.get(), 0, 0) : "";
}

void PostgresConnection::prepare(const std::string& name, const char* sql) {
  settle();
  checked(of_, get(), PQprepare(get(), name.c_str(), sql, 0, nullptr));
}

PostgresAnswer PostgresConnection::answer(const std::string& name, std::span<const std::string_view> values) {
  settle();
  const BinaryValues given(values);
  return PostgresAnswer(PQexecPrepared(get(), name.c_str(), given.count(), given.texts.data(), given.lengths.data(),
                                       given.are_binary.data(), 1));
}

void PostgresConnection::send(const std::string& name, std::span<const std::string_view> values) {
  const BinaryValues given(values);
  if (!is_sending_ && PQenterPipelineMode(get()) == 0) checked(of_, get(), nullptr);
  is_sending_ = true;
  if (PQsendQueryPrepared(get(), name.c_str(), given.count(), given.texts.data(), given.lengths.data(),
                          given.are_binary.data(), 1) == 0)
    checked(of_, get(), nullptr);
}

/// Behind an error the server does nothing more of what was sent. The answer to the synchronisation comes last. Where
/// it cannot be waited for, as libpq has seen the server go, there is none: two ends of a statement come in a row, and
/// the connection may pass for a good one still.
PostgresConnection::PipelineOutcome PostgresConnection::outcome_of_sent() noexcept {
  PipelineOutcome outcome;
  is_sending_ = false;
  if (PQpipelineSync(get()) == 0) return outcome;
  for (bool has_ended = false; !outcome.is_whole && PQstatus(get()) == CONNECTION_OK;) {
    PostgresAnswer answer(PQgetResult(get()));
    if (!answer && has_ended) break;
    has_ended = !answer;
    if (!answer) continue;
    const ExecStatusType status = PQresultStatus(answer.get());
    outcome.is_whole = status == PGRES_PIPELINE_SYNC;
    if (status == PGRES_FATAL_ERROR && !outcome.error) outcome.error = std::move(answer);
  }
  PQexitPipelineMode(get());
  return outcome;
}

void PostgresConnection::settle() {
  if (!is_sending_) return;
  PipelineOutcome outcome = outcome_of_sent();
  if (outcome.error || !outcome.is_whole) checked(of_, get(), outcome.error.release());
}

void PostgresConnection::rollback() noexcept {
  if (is_sending_) outcome_of_sent();
  PQclear(PQexec(get(), "ROLLBACK"));
}

bool PostgresConnection::is_lost() noexcept {
  PQconsumeInput(get());
  return PQstatus(get()) != CONNECTION_OK;
}

}  // namespace durero::store
