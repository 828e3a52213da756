// durero spec show NAME: a paragraph in Unicode, and for each label in it the clause, the tests and the theorems.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "durero/io/output_file.hpp"
#include "durero/io/source.hpp"
#include "durero/oracle/spec.hpp"
#include "durero/zed/print.hpp"
#include "spec.hpp"

namespace durero::embedded {
const std::map<std::string, std::string>& labels();
}

namespace durero::cli {
namespace {

struct Entry {
  std::string kind, place, name;
};

// What cmake/label_index.sh found when the program was built.
std::multimap<std::string, Entry> label_index() {
  std::multimap<std::string, Entry> index;
  std::istringstream lines(embedded::labels().begin()->second);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream cells(line);
    std::string label;
    Entry entry;
    std::getline(cells, label, '\t');
    std::getline(cells, entry.kind, '\t');
    std::getline(cells, entry.place, '\t');
    std::getline(cells, entry.name, '\t');
    index.emplace(label, entry);
  }
  return index;
}

std::vector<std::string> labels_of(const zed::Paragraph& paragraph) {
  std::vector<std::string> labels;
  const auto add = [&](const zed::SchemaText& text) {
    for (const zed::Predicate& one : text.predicates) labels.push_back(one.label);
  };
  if (const auto* schema = std::get_if<zed::Schema>(&paragraph.form)) add(schema->text);
  if (const auto* axiomatic = std::get_if<zed::Axiomatic>(&paragraph.form)) add(axiomatic->text);
  if (const auto* definition = std::get_if<zed::Definition>(&paragraph.form)) labels.push_back(definition->label);
  std::erase(labels, std::string());
  return labels;
}

std::vector<zed::Name> names_of(const zed::Paragraph& paragraph) {
  std::vector<zed::Name> names;
  if (const auto* given = std::get_if<zed::GivenTypes>(&paragraph.form)) names = given->names;
  if (const auto* free = std::get_if<zed::FreeType>(&paragraph.form)) {
    names.push_back(free->name);
    for (const zed::Branch& one : free->branches) names.push_back(one.name);
  }
  if (const auto* definition = std::get_if<zed::Definition>(&paragraph.form)) names.push_back(definition->name);
  if (const auto* schema = std::get_if<zed::Schema>(&paragraph.form)) names.push_back(schema->name);
  if (const auto* axiomatic = std::get_if<zed::Axiomatic>(&paragraph.form)) {
    for (const zed::Declaration& one : axiomatic->text.declarations) {
      names.insert(names.end(), one.names.begin(), one.names.end());
    }
  }
  return names;
}

bool is_named(const zed::Paragraph& paragraph, const std::string& name) {
  const auto names = names_of(paragraph);
  const auto labels = labels_of(paragraph);
  return std::any_of(names.begin(), names.end(), [&](const auto& one) { return one.text() == name; }) ||
         std::find(labels.begin(), labels.end(), name) != labels.end();
}

std::string places(const std::string& label, const std::multimap<std::string, Entry>& index) {
  std::string said = label + "\n";
  const auto [first, last] = index.equal_range(label);
  for (const char* kind : {"text", "clause", "function", "test", "theorem"}) {
    for (auto at = first; at != last; ++at) {
      if (at->second.kind != kind) continue;
      said +=
          fmt::format("  {:<8}  {}{}\n", kind, at->second.place, at->second.name.empty() ? "" : "  " + at->second.name);
    }
  }
  return said;
}

std::string shown(const zed::Section& section, const zed::Paragraph& paragraph, const std::string& only) {
  std::string said = fmt::format("{}:{}\n{}", section.file, paragraph.place.line, zed::to_unicode(paragraph));
  const auto index = label_index();
  const auto labels = labels_of(paragraph);
  const bool one = std::find(labels.begin(), labels.end(), only) != labels.end();
  for (const std::string& label : labels) {
    if (!one || label == only) said += "\n" + places(label, index);
  }
  return said;
}

}  // namespace

int spec_show(const std::string& name) {
  for (const zed::Section& section : oracle::spec::text().sections) {
    for (const zed::Paragraph& paragraph : section.paragraphs) {
      if (!is_named(paragraph, name)) continue;
      io::write_file("-", shown(section, paragraph, name));
      return 0;
    }
  }
  throw io::InputError("NAME", {1, 1}, "the text declares no " + io::shown(name),
                       "expected a name of spec/, such as Escena, or a label, such as Escena.inv.1");
}

}  // namespace durero::cli
