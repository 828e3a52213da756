#pragma once
/// What a PostgreSQL server or libpq refuses, as one line about a store.

#include <libpq-fe.h>

#include <memory>
#include <string>

#include "database.hpp"

namespace durero::store {

/// An answer of the server.
struct ClearAnswer {
  void operator()(PGresult* answer) const noexcept { PQclear(answer); }
};
using PostgresAnswer = std::unique_ptr<PGresult, ClearAnswer>;

/// The answer, where it is no error. Throws io::FileError where it is one.
PostgresAnswer checked(const Database& of, PGconn* connection, PGresult* answer);

/// The five letters that say what kind of error an answer is (SQLSTATE); empty where it is none, or the server is gone.
std::string error_state(const PGresult* answer);

/// The first line of what libpq says about a connection.
std::string said_of(PGconn* connection);

}  // namespace durero::store
