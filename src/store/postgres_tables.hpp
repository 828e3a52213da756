#pragma once
/// The tables of a store in a schema of PostgreSQL.

#include <string>

#include "postgres_connection.hpp"

namespace durero::store {

/// The statements that make them. Beside those of every store, `store` has the version, and is what writers lock.
std::string statements_of_tables();

/// Throws io::FileError where the current schema has no store, one of another version, or other tables than a store.
void require_tables(const Database& of, PostgresConnection& connection);

}  // namespace durero::store
