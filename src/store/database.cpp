#include "database.hpp"

#include "durero/io/source.hpp"
#include "durero/store/store_path.hpp"
#include "postgres_database.hpp"
#include "sqlite_database.hpp"

namespace durero::store {

void Database::refuse(const std::string& wrong, const std::string& expected) const {
  throw io::FileError(path_, wrong, expected);
}

std::unique_ptr<Database> open_database(const std::string& path, Database::Mode mode) {
  return is_server_uri(path) ? open_postgres(path, mode) : open_sqlite(path, mode);
}

std::unique_ptr<Database> new_database(const std::string& path) {
  return is_server_uri(path) ? new_postgres(path) : new_sqlite(path);
}

}  // namespace durero::store
