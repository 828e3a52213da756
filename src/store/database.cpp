#include "database.hpp"

#include "durero/io/source.hpp"
#include "sqlite_database.hpp"

namespace durero::store {

void Database::refuse(const std::string& wrong, const std::string& expected) const {
  throw io::FileError(path_, wrong, expected);
}

std::unique_ptr<Database> open_database(const std::string& path, Database::Mode mode) {
  return open_sqlite(path, mode);
}

std::unique_ptr<Database> new_database(const std::string& path) { return new_sqlite(path); }

}  // namespace durero::store
