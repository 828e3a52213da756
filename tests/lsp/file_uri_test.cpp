#include "lsp/file_uri.hpp"

#include "support/catch.hpp"

using namespace durero::lsp;

TEST_CASE("a file's address and its path lead to each other") {
  CHECK(path_of_uri("file:///a/b%20c.tex") == "/a/b c.tex");
  CHECK(path_of_uri("file://localhost/a.tex") == "/a.tex");
  CHECK(path_of_uri("file:///a/./b/../%C3%A9.tex") == "/a/é.tex");
  CHECK(path_of_uri("file:///a%2") == "/a%2");
  CHECK(path_of_uri("untitled:Untitled-1") == "untitled:Untitled-1");
  CHECK(uri_of_path("/a/b c/é.tex") == "file:///a/b%20c/%C3%A9.tex");
  for (const char* path : {"/x", "/a%20b", "/ñ/ℕ.tex", "/a b/c#d?e"}) CHECK(path_of_uri(uri_of_path(path)) == path);
}
