#include "durero/zed/syntax/paragraphs.hpp"

#include <algorithm>

namespace durero::zed {
namespace {

std::vector<Name> declared(const SchemaText& text) {
  std::vector<Name> names;
  for (const Declaration& declaration : text.declarations)
    names.insert(names.end(), declaration.names.begin(), declaration.names.end());
  return names;
}

struct NamesOf {
  std::vector<Name> operator()(const GivenTypes& given) const { return given.names; }
  std::vector<Name> operator()(const FreeType& type) const {
    std::vector<Name> names = {type.name};
    for (const Branch& branch : type.branches) names.push_back(branch.name);
    return names;
  }
  std::vector<Name> operator()(const Definition& definition) const { return {definition.name}; }
  std::vector<Name> operator()(const Axiomatic& box) const { return declared(box.text); }
  std::vector<Name> operator()(const Schema& box) const { return {box.name}; }
  std::vector<Name> operator()(const Conjecture&) const { return {}; }
};

}  // namespace

std::vector<Name> names_of(const Paragraph& paragraph) { return std::visit(NamesOf(), paragraph.form); }

std::vector<std::string> labels_of(const Paragraph& paragraph) {
  std::vector<std::string> labels;
  const auto add = [&labels](const SchemaText& text) {
    for (const Predicate& predicate : text.predicates) labels.push_back(predicate.label);
  };
  if (const auto* schema = std::get_if<Schema>(&paragraph.form)) add(schema->text);
  if (const auto* axiomatic = std::get_if<Axiomatic>(&paragraph.form)) add(axiomatic->text);
  if (const auto* definition = std::get_if<Definition>(&paragraph.form)) labels.push_back(definition->label);
  if (const auto* conjecture = std::get_if<Conjecture>(&paragraph.form)) labels.push_back(conjecture->claim.label);
  std::erase(labels, std::string());
  return labels;
}

bool is_named(const Paragraph& paragraph, const std::string& name) {
  const std::vector<Name> names = names_of(paragraph);
  const std::vector<std::string> labels = labels_of(paragraph);
  return std::any_of(names.begin(), names.end(), [&](const Name& declared) { return declared.text() == name; }) ||
         std::find(labels.begin(), labels.end(), name) != labels.end();
}

bool has_component(const Paragraph& paragraph, const std::string& name) {
  const auto* schema = std::get_if<Schema>(&paragraph.form);
  if (!schema) return false;
  const std::vector<Name> components = declared(schema->text);
  return std::any_of(components.begin(), components.end(),
                     [&](const Name& component) { return component.text() == name; });
}

}  // namespace durero::zed
