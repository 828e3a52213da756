// Names of stores: a URI is shown without its password.
#include "durero/store/store_path.hpp"

#include "durero/store/store.hpp"
#include "support/catch.hpp"
#include "support/folder.hpp"

using namespace durero;
using store::shown_path;

TEST_CASE("A URI of a server is told from a path") {
  for (const char* const uri : {"postgresql://", "postgres://h/d", "postgresql://u:p@h:1,i:2/d?a=b"})
    CHECK(store::is_server_uri(uri));
  for (const char* const path :
       {"room.store", "/postgresql://", "postgresql:", "postgresql:/x", "postgresql", "", "Postgres://h"})
    CHECK_FALSE(store::is_server_uri(path));
}

TEST_CASE("A URI is shown without its password") {
  CHECK(shown_path("postgresql://ann:secret@host:5433/scenes") == "postgresql://ann@host:5433/scenes");
  CHECK(shown_path("postgres://ann:a?b:c@h1,h2/d?x=y") == "postgres://ann@h1,h2/d?x=y");
  CHECK(shown_path("postgresql://:secret@/d") == "postgresql://@/d");
  CHECK(shown_path("postgresql://ann:@h") == "postgresql://ann@h");
  CHECK(shown_path("postgresql://host:5433/an@d") == "postgresql://host:5433/an@d");
  CHECK(shown_path("postgresql://[::1]:5433/d") == "postgresql://[::1]:5433/d");
}

TEST_CASE("A URI is shown without parameters that are secret") {
  CHECK(shown_path("postgresql://h/d?password=secret") == "postgresql://h/d");
  CHECK(shown_path("postgresql://h/d?a=b&password=secret&c=d") == "postgresql://h/d?a=b&c=d");
  CHECK(shown_path("postgresql://h/d?sslpassword=secret&a=b") == "postgresql://h/d?a=b");
  CHECK(shown_path("postgresql://h/d?%70assword=secret&a=%20b&") == "postgresql://h/d?a=%20b&");
  CHECK(shown_path("postgresql://h/d?passwords=x&user=ann") == "postgresql://h/d?passwords=x&user=ann");
}

TEST_CASE("A path is shown as it stands") {
  for (const char* const path : {"room.store", "a:b@c?password=d", ""}) CHECK(shown_path(path) == path);
}

TEST_CASE("Pictures of a store on a server are named from the root") {
  CHECK(store::picture_place("rooms/room.store") == "rooms/room.store");
  CHECK(store::picture_place("postgresql://h/d") == "/store");
}

TEST_CASE("A server that does not answer, or a build without libpq, is told in one line without the password") {
  const test::Folder folder;
  const std::string uri = "postgresql://ann:secret@/scenes?host=" + folder.file("nowhere");
  const std::string shown = "postgresql://ann@/scenes?host=" + folder.file("nowhere") + ": ";
  const std::string wrong = store::libpq_version().empty() ? "this build has no PostgreSQL" : "cannot be opened: ";
  for (const auto access : {store::StoreAccess::read, store::StoreAccess::write, store::StoreAccess::follow}) {
    try {
      store::Store(uri, access);
      FAIL("it is opened");
    } catch (const io::FileError& error) {
      CHECK(std::string(error.what()).starts_with(shown + wrong));
      CHECK(std::string(error.what()).find('\n') == std::string::npos);
    }
  }
  CHECK_THROWS_AS(store::Store::create(uri, {}, "", {}), io::FileError);
}
