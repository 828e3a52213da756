#include "durero/zed/reader.hpp"

#include <fmt/core.h>

#include <filesystem>

#include "support/catch.hpp"

using namespace durero::zed;

TEST_CASE("the Z text of spec/ is read without a defect") {
  std::vector<std::string> files;
  for (const char* stem : {"tipos", "escena", "operaciones", "puntos", "interseccion"})
    files.push_back(fmt::format("{}/spec/{}.tex", DURERO_SOURCE_DIR, stem));
  const Specification spec = read_files(files);
  for (const Defect& one : spec.defects) UNSCOPED_INFO(one.text());
  CHECK(spec.ok());
  CHECK(spec.sections.size() == 5);
}
