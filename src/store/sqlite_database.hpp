#pragma once
/// Stores that are files of SQLite.

#include <memory>
#include <string>

#include "database.hpp"

namespace durero::store {

/// Opens a file that is there. Where its folder cannot be written, one that is only read is read all the same.
std::unique_ptr<Database> open_sqlite(const std::string& path, Database::Mode mode);

/// A new one in memory, which publish() makes a file of that path.
std::unique_ptr<Database> new_sqlite(const std::string& path);

}  // namespace durero::store
