// What a build without libpq says of PostgreSQL.
#include "durero/io/source.hpp"
#include "durero/store/store.hpp"
#include "durero/store/store_path.hpp"
#include "postgres_database.hpp"

namespace durero::store {
namespace {

[[noreturn]] void refuse_server(const std::string& uri) {
  throw io::FileError(shown_path(uri), "this build has no PostgreSQL",
                      "expected a file, or a program that was built where libpq is");
}

}  // namespace

std::string libpq_version() { return ""; }

std::unique_ptr<Database> open_postgres(const std::string& uri, Database::Mode) { refuse_server(uri); }

std::unique_ptr<Database> new_postgres(const std::string& uri) { refuse_server(uri); }

}  // namespace durero::store
