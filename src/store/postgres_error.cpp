#include "postgres_error.hpp"

#include <fmt/format.h>

#include <new>
#include <string_view>

namespace durero::store {
namespace {

/// What errors of some states mean for a store. `{}` stands for what the server says.
struct StateMeaning {
  std::string_view states;  // how they begin
  const char* wrong;
  const char* expected;
};

constexpr const char* asked_again = "expected that it is asked again; nothing is kept of what was not answered";
constexpr const char* another_server = "expected a server that goes on; what was answered is kept";

/// The states are of PostgreSQL's list (its documentation, appendix A); the first that fits counts.
constexpr StateMeaning meanings[] = {
    {"25006", "cannot be written: its server only reads", "expected the primary server"},
    {"23505", "was changed while it was used: {}", asked_again},
    {"40", "was changed while it was used: {}", asked_again},
    {"42501", "may not be used: {}", "expected a user that may"},
    {"53100", "cannot be written: No space left on device",
     "expected room for it; nothing is kept of what was not answered"},
    {"54", "cannot hold so much at once: a snapshot takes 10⁹ bytes at most", "expected a smaller scene"},
    {"55P03", "is being written by another program", "expected that it ends within 120 s"},
    {"57P", "is out of reach: {}", another_server},
    {"XX", "is spoiled: {}", expected_whole},
    {"", "cannot be used: {}", "expected a store that its server lets be asked"},
};
static_assert(patience == 120'000, "what is expected of others that write");

std::string first_line(std::string_view text) { return std::string(text.substr(0, text.find('\n'))); }

}  // namespace

std::string said_of(PGconn* connection) { return first_line(PQerrorMessage(connection)); }

std::string error_state(const PGresult* answer) {
  const char* const state = answer == nullptr ? nullptr : PQresultErrorField(answer, PG_DIAG_SQLSTATE);
  return state == nullptr ? "" : state;
}

PostgresAnswer checked(const Database& of, PGconn* connection, PGresult* answer) {
  PostgresAnswer held(answer);
  const ExecStatusType status = PQresultStatus(answer);  // of none it is an error
  if (status == PGRES_COMMAND_OK || status == PGRES_TUPLES_OK) return held;
  const std::string state = error_state(answer);
  if (state.empty() || PQstatus(connection) != CONNECTION_OK)
    of.refuse(fmt::format("is out of reach: {}", said_of(connection)), another_server);
  const char* const primary = PQresultErrorField(answer, PG_DIAG_MESSAGE_PRIMARY);
  const std::string said = first_line(primary == nullptr ? state : primary);
  for (const StateMeaning& meaning : meanings)
    if (state.starts_with(meaning.states)) of.refuse(fmt::format(fmt::runtime(meaning.wrong), said), meaning.expected);
  __builtin_unreachable();  // the last fits every state
}

}  // namespace durero::store
