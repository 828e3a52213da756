#include "durero/zed/syntax/reader.hpp"

#include <fmt/core.h>

#include <fstream>
#include <map>
#include <regex>

#include "support/catch.hpp"
#include "support/tree.hpp"

using namespace durero::zed;

namespace {

std::vector<std::pair<std::string, Place>> labels_of(const Section& section) {
  std::vector<std::pair<std::string, Place>> found;
  const auto all = [&found](const SchemaText& text) {
    for (const Predicate& one : text.predicates)
      if (!one.label.empty()) found.emplace_back(one.label, one.place);
  };
  for (const Paragraph& one : section.paragraphs) {
    if (const auto* box = std::get_if<Schema>(&one.form)) all(box->text);
    if (const auto* box = std::get_if<Axiomatic>(&one.form)) all(box->text);
    const auto* made = std::get_if<Definition>(&one.form);
    if (made && !made->label.empty()) found.emplace_back(made->label, one.place);
  }
  return found;
}

}  // namespace

TEST_CASE("the Z text of spec/ is read without a defect") {
  std::vector<std::string> files;
  for (const char* stem : {"tipos", "escena", "operaciones", "puntos", "interseccion"})
    files.push_back(fmt::format("{}/spec/{}.tex", durero::test::source_dir(), stem));
  const Specification spec = read_files(files);
  for (const Defect& one : spec.defects) UNSCOPED_INFO(one.text());
  CHECK(spec.ok());
  CHECK(spec.sections.size() == 5);
}

TEST_CASE("each label of spec/ is that of one conjunct or definition, which ends on its line") {
  std::size_t labels = 0, lines = 0;
  for (const char* stem : {"tipos", "escena", "operaciones", "puntos", "interseccion"}) {
    const std::string file = fmt::format("{}/spec/{}.tex", durero::test::source_dir(), stem);
    std::ifstream in(file);
    std::map<std::string, unsigned> where;
    const std::regex pattern(R"(% (\w+\.(pre|post|inv|def|axiom)\.\d+)$)");
    std::string text;
    for (unsigned line = 1; std::getline(in, text); ++line)
      if (std::smatch found; std::regex_search(text, found, pattern)) where[found[1]] = line;
    lines += where.size();
    const Specification spec = read_files({file});
    unsigned before = 0;  // the line of the label before, which this predicate begins behind
    for (const auto& [label, place] : labels_of(*spec.find(stem))) {
      CAPTURE(label);
      CHECK(place.line > before);
      CHECK(place.line <= where.at(label));
      before = where.at(label);
      ++labels;
    }
  }
  CHECK(labels == lines);
  CHECK(labels > 100);
}
