#include "durero/io/file_name.hpp"

#include <array>

#include "durero/io/source.hpp"
#include "support/catch.hpp"

using namespace durero;

TEST_CASE("A name ends in letters of either case") {
  CHECK(io::ends_in("a.obj", ".obj"));
  CHECK(io::ends_in("A.OBJ", ".obj"));
  CHECK(io::ends_in("folder/a.Obj", ".obj"));
  CHECK(io::ends_in(".obj", ".obj"));
  CHECK_FALSE(io::ends_in("obj", ".obj"));
  CHECK_FALSE(io::ends_in("a.obj2", ".obj"));
  CHECK_FALSE(io::ends_in("a.obk", ".obj"));
  CHECK_FALSE(io::ends_in("a.objs/a", ".obj"));
  CHECK_FALSE(io::ends_in("a.[bj", ".{bj"));  // no letters
}

TEST_CASE("An ending begins at the last dot of the file's own name") {
  CHECK(io::ending_of("a.json") == ".json");
  CHECK(io::ending_of("b.c/a.tar.GZ") == ".GZ");
  for (const char* const name : {"a", "-", "", "b.c/a", ".profile", "b/.profile", "a.", "..", "b.c/"}) {
    CAPTURE(name);
    CHECK(io::ending_of(name).empty());
  }
}

TEST_CASE("What is written has an ending of its format, or none") {
  constexpr std::array<std::string_view, 2> endings{".json", ".jsonl"};
  for (const char* const name : {"a.json", "A.JSON", "a.jsonl", "a", "-", "/dev/stdout", "b.nff/a"}) {
    CAPTURE(name);
    CHECK_NOTHROW(io::require_ending(name, endings, "hits"));
  }
  CHECK_THROWS_WITH(io::require_ending("b/y.stl", endings, "hits"),
                    "b/y.stl: \".stl\" is no ending of hits; expected a name that ends in .json or .jsonl, or has no "
                    "ending");
  for (const char* const name : {"a.nff", "a.json.bak", "a.xjson", "a.son"}) {
    CAPTURE(name);
    CHECK_THROWS_AS(io::require_ending(name, endings, "hits"), io::FileError);
  }
}
