#include "tables.hpp"

#include <fmt/format.h>

namespace durero::store {
namespace {

constexpr const char* tables = R"(
CREATE TABLE event (
  number {integer} PRIMARY KEY,
  parent {integer} NOT NULL,
  kind {integer} NOT NULL,
  begins {integer} NOT NULL,
  line {integer} NOT NULL,
  operation {text} NOT NULL,
  answer {text} NOT NULL,
  author {text} NOT NULL,
  time {text} NOT NULL,
  comment {text} NOT NULL,
  content {bytes} NOT NULL,
  hash {bytes} NOT NULL
){strict};
CREATE TABLE snapshot (event {integer} PRIMARY KEY, seal {bytes} NOT NULL, content {bytes} NOT NULL){strict};
CREATE TABLE name (
  kind {integer} NOT NULL,
  name {text} NOT NULL,
  event {integer} NOT NULL,
  seal {bytes} NOT NULL,
  PRIMARY KEY (kind, name)
){keyed};
)";

}  // namespace

std::string table_statements(const TableWords& words) {
  return fmt::format(fmt::runtime(tables), fmt::arg("integer", words.integer), fmt::arg("text", words.text),
                     fmt::arg("bytes", words.bytes), fmt::arg("strict", words.strict), fmt::arg("keyed", words.keyed));
}

void require_version(const Database& database, std::int64_t found) {
  if (found > table_version)
    database.refuse(fmt::format("is a store of version {}", found),
                    fmt::format("expected version {}: a later program reads it", table_version));
  if (found != table_version)
    database.refuse(fmt::format("is a store of version {}", found), fmt::format("expected {}", table_version));
}

}  // namespace durero::store
