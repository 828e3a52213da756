#pragma once
/// Stores that are schemas of a PostgreSQL server: the first schema of the search path of who opens it.

#include <memory>
#include <string>

#include "database.hpp"

namespace durero::store {

/// Opens a store that is there. To write, it must be on a server that writes, durably. Refuses where the program was
/// built without libpq.
std::unique_ptr<Database> open_postgres(const std::string& uri, Database::Mode mode);

/// A new one, in a transaction of the server, which publish() ends. Its schema is made too, where the URI names one
/// that is not there.
std::unique_ptr<Database> new_postgres(const std::string& uri);

}  // namespace durero::store
