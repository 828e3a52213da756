#include "postgres_tables.hpp"

#include <fmt/format.h>

#include <charconv>
#include <string_view>

#include "tables.hpp"

namespace durero::store {
namespace {

/// A text of PostgreSQL is no text of every encoding, and holds no zero byte. A store keeps what was written.
constexpr TableWords postgres_words{"BIGINT", "BYTEA", "BYTEA", "", ""};

/// The tables as they are, a word each for a table, a column and a constraint. A table is plain (r) and outlives a
/// crash (p). Triggers, rules, policies and children, which change what is read or written, would be more.
constexpr const char* description = R"(
WITH tables AS (
  SELECT c.* FROM pg_class c JOIN pg_namespace n ON n.oid = c.relnamespace
  WHERE n.nspname = current_schema() AND c.relname IN ('store', 'event', 'snapshot', 'name'))
SELECT string_agg(word, ' ' ORDER BY word COLLATE "C") FROM (
  SELECT format('%s:%s%s', relname, relkind, relpersistence) || CASE WHEN relrowsecurity
    OR EXISTS (SELECT FROM pg_trigger WHERE tgrelid = tables.oid)
    OR EXISTS (SELECT FROM pg_rewrite WHERE ev_class = tables.oid)
    OR EXISTS (SELECT FROM pg_inherits WHERE tables.oid IN (inhrelid, inhparent))
    THEN ':more' ELSE '' END AS word FROM tables
  UNION ALL SELECT format('%s.%s:%s:%s', relname, attname, format_type(atttypid, atttypmod), attnotnull)
    || CASE WHEN atthasdef OR attisdropped OR attgenerated <> '' OR attidentity <> '' THEN ':more' ELSE '' END
    FROM tables JOIN pg_attribute ON attrelid = tables.oid AND attnum > 0
  UNION ALL SELECT format('%s:%s', relname, pg_get_constraintdef(k.oid))
    FROM tables JOIN pg_constraint k ON conrelid = tables.oid AND contype <> 'n') AS words)";

constexpr std::string_view described_store =
    "event.answer:bytea:t event.author:bytea:t event.begins:bigint:t event.comment:bytea:t event.content:bytea:t "
    "event.hash:bytea:t event.kind:bigint:t event.line:bigint:t event.number:bigint:t event.operation:bytea:t "
    "event.parent:bigint:t event.time:bytea:t event:PRIMARY KEY (number) event:rp "
    "name.event:bigint:t name.kind:bigint:t name.name:bytea:t name.seal:bytea:t name:PRIMARY KEY (kind, name) name:rp "
    "snapshot.content:bytea:t snapshot.event:bigint:t snapshot.seal:bytea:t snapshot:PRIMARY KEY (event) snapshot:rp "
    "store.version:bigint:t store:rp";

}  // namespace

std::string statements_of_tables() {
  return fmt::format("CREATE TABLE store (version BIGINT NOT NULL); INSERT INTO store VALUES ({}); {}", table_version,
                     table_statements(postgres_words));
}

/// A table of the name that stands in another schema of the search path is none of this store: the path is this schema
/// alone from here on.
void require_tables(const Database& of, PostgresConnection& connection) {
  const std::string schema = connection.word(
      "SELECT set_config('search_path', quote_ident(current_schema()), false) WHERE current_schema() IS NOT NULL");
  if (schema.empty())
    of.refuse(fmt::format("has no schema {}", connection.word("SHOW search_path")),
              "expected one that `durero store init` made");
  if (connection.word("SELECT to_regclass('store')").empty())
    of.refuse(fmt::format("has no store in schema {}", schema), "expected one that `durero store init` made");
  const std::string version = connection.word("SELECT version FROM store");
  std::int64_t found = 0;
  std::from_chars(version.data(), version.data() + version.size(), found);
  require_version(of, found);
  if (connection.word(description) != described_store) of.refuse("has other tables than a store", expected_whole);
}

}  // namespace durero::store
