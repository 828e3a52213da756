#include "durero/io/spool.hpp"

#include <filesystem>

#include "support/catch.hpp"
#include "support/folder.hpp"

using namespace durero;

TEST_CASE("What is put aside is read again, and no file shows") {
  const test::Folder folder;
  io::Spool spool(folder.file("out"));
  CHECK(folder.files() == 0);
  spool.write("one ");
  spool.write("two");
  io::Input input = spool.read();
  while (input.read()) {
  }
  CHECK(input.waiting() == "one two");
  CHECK(folder.files() == 0);
}

TEST_CASE("Where nothing can be put aside, the target is named") {
  CHECK_THROWS_WITH(io::Spool("/nowhere/out"), Catch::Contains("/nowhere/out: cannot be written: No such file"));
}
