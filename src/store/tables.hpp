#pragma once
/// The tables of a store, in the words of its database.

#include <cstdint>
#include <string>

#include "database.hpp"

namespace durero::store {

/// The version of the tables that is written, and read.
inline constexpr std::int64_t table_version = 1;

/// How a database calls what the tables consist of.
struct TableWords {
  const char* integer;  ///< the type of whole numbers of 64 bits
  const char* text;     ///< the type of texts, which are any bytes
  const char* bytes;    ///< the type of digests and snapshots
  const char* strict;   ///< what stands behind a table whose values have these types
  const char* keyed;    ///< what stands behind a table without numbers of its own
};

/// The statements that make the tables.
std::string table_statements(const TableWords& words);

/// Throws io::FileError where the tables are of another version.
void require_version(const Database& database, std::int64_t found);

}  // namespace durero::store
