// durero spec show NAME: a paragraph in Unicode, and for each label in it the clause, the tests and the theorems.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "durero/io/output_file.hpp"
#include "durero/io/source.hpp"
#include "durero/oracle/spec.hpp"
#include "durero/zed/print/print.hpp"
#include "durero/zed/syntax/parser.hpp"
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

bool has_component(const zed::Paragraph& paragraph, const std::string& name) {
  const auto* schema = std::get_if<zed::Schema>(&paragraph.form);
  if (!schema) return false;
  const auto& declared = schema->text.declarations;
  return std::any_of(declared.begin(), declared.end(), [&](const zed::Declaration& one) {
    return std::any_of(one.names.begin(), one.names.end(),
                       [&](const auto& component) { return component.text() == name; });
  });
}

// What declares the name; else the first schema with a component of that name.
std::string found(const zed::Specification& text, const std::string& name) {
  for (const auto& declares : {is_named, has_component}) {
    for (const zed::Section& section : text.sections) {
      for (const zed::Paragraph& paragraph : section.paragraphs) {
        if (declares(paragraph, name)) return shown(section, paragraph, name);
      }
    }
  }
  return {};
}

// ΔS and ΞS, which no paragraph declares: what they stand for, then S.
std::string found_change(const zed::Specification& text, const std::string& name) {
  const std::string_view delta = "Δ", xi = "Ξ";
  const bool change = name.starts_with(delta), none = name.starts_with(xi);
  const std::string of = change || none ? name.substr(delta.size()) : "";
  const std::string said = of.empty() ? "" : found(text, of);
  if (said.empty()) return {};
  return fmt::format("{0} == [{1}; {1} '{2}]\n\n{3}", name, of, none ? fmt::format(" | θ {0} = θ {0} '", of) : "",
                     said);
}

// A name as the mark-up writes it, `mi\_radio` or `\real`, in Unicode; any other text as it is.
std::string plain(const zed::Specification& text, const std::string& name) {
  if (name.find('\\') == name.npos) return name;
  zed::Markup markup;
  for (const auto& one : text.markup) markup.insert(one.second.begin(), one.second.end());
  try {
    const zed::Term term = zed::parse_latex(name, markup);
    return term->kind == zed::Kind::reference ? term->name.text() : name;
  } catch (const zed::ZError&) {
    return name;
  }
}

}  // namespace

int spec_show(const std::string& name) {
  const zed::Specification& text = oracle::spec::text();
  const std::string in_unicode = plain(text, name);
  std::string said = found(text, in_unicode);
  if (said.empty()) said = found_change(text, in_unicode);
  if (said.empty())
    throw io::InputError("NAME", {1, 1}, "the text declares no " + in_unicode,
                         "expected a name of spec/, such as Escena, or a label, such as Escena.inv.1");
  io::write_file("-", said);
  return 0;
}

}  // namespace durero::cli
