// The operations of a script, with the declarations of their inputs in the text.
#include <algorithm>
#include <array>
#include <optional>
#include <span>

#include "calls.hpp"
#include "durero/io/json/operations_file.hpp"
#include "durero/spec/spec.hpp"
#include "durero/written/text.hpp"
#include "durero/zed/print/print.hpp"
#include "durero/zed/syntax/paragraphs.hpp"
#include "json_text.hpp"
#include "labelled.hpp"

namespace durero::web {
namespace {

constexpr std::array<std::string_view, 1> operations_keys{"with"};

/// The set of an input that no schema of the text declares; of names that no set of the text has, a word.
struct InputSet {
  std::string_view input, set;
};
constexpr std::array<InputSet, 20> program_sets{{{"material", "material"},
                                                 {"g", "group"},
                                                 {"elementos", "ℙ Elemento"},
                                                 {"groups", "ℙ group"},
                                                 {"e", "Elemento"},
                                                 {"base", "Elemento"},
                                                 {"top", "Elemento"},
                                                 {"de", "Elemento"},
                                                 {"centro", "Punto"},
                                                 {"x", "Vector"},
                                                 {"y", "Vector"},
                                                 {"z", "Vector"},
                                                 {"vector", "Vector"},
                                                 {"radio", "ℝ"},
                                                 {"altura", "ℝ"},
                                                 {"proporcion", "ℝ"},
                                                 {"vertices", "Terna"},
                                                 {"puntos", "seq Punto"},
                                                 {"caras", "seq (ℕ × ℕ × ℕ)"},
                                                 {"m", "mesh"}}};

/// The schema's box of that name in the text; null without one.
const zed::Paragraph* schema_of(const std::string& name) {
  for (const zed::Section& section : spec::text().sections)
    for (const zed::Paragraph& paragraph : section.paragraphs)
      if (const auto* const box = std::get_if<zed::Schema>(&paragraph.form); box && box->name.text() == name)
        return &paragraph;
  return nullptr;
}

/// Visits the boxes of a schema and of what it includes by name, the included first.
template <class Visit>
void each_box(const std::string& name, const Visit& visit, int depth = 0) {
  constexpr int most = 16;  // deeper than any text of spec/
  const zed::Paragraph* const paragraph = schema_of(name);
  if (paragraph == nullptr || depth > most) return;
  for (const zed::Declaration& declaration : std::get<zed::Schema>(paragraph->form).text.declarations)
    if (declaration.form == zed::Declaration::Form::included && declaration.term->kind == zed::Kind::reference)
      each_box(declaration.term->name.text(), visit, depth + 1);
  visit(*paragraph);
}

/// The set that the schema declares an input from; empty where it declares none of that name.
std::string declared_set(const std::string& schema, const std::string& input) {
  std::string set;
  each_box(schema, [&](const zed::Paragraph& box) {
    for (const zed::Declaration& declaration : std::get<zed::Schema>(box.form).text.declarations)
      for (const zed::Name& name : declaration.names)
        if (name.text() == input + "?") set = zed::to_unicode(declaration.term);
  });
  return set;
}

std::string kind_word(io::WrittenKind kind) {
  constexpr std::array<std::string_view, 3> words{"ℝ", "Punto", "Terna"};
  return std::string(words[static_cast<std::size_t>(kind)]);
}

/// The set of an input: as the text declares it, as a type of another text has it, or as the program takes it.
std::string set_of(const io::OperationWords& operation, const std::string& input,
                   std::span<const io::WrittenType> types) {
  if (const std::string set = declared_set(operation.name, input); !set.empty()) return set;
  for (const io::WrittenType& type : types)
    for (const io::WrittenAttribute& attribute : type.attributes)
      if (operation.name == io::addition_name(type.word) && attribute.word == input) return kind_word(attribute.kind);
  const auto own = std::ranges::find(program_sets, std::string_view(input), &InputSet::input);
  return own == program_sets.end() ? "name" : std::string(own->set);
}

std::string operation_json(const io::OperationWords& operation, std::span<const io::WrittenType> types) {
  ArrayText inputs, labels;
  for (std::size_t i = 0; i < operation.inputs.size(); ++i)
    inputs.raw(ObjectText()
                   .member("name", operation.inputs[i])
                   .member("type", set_of(operation, operation.inputs[i], types))
                   .member("required", i < operation.required)
                   .text());
  each_box(operation.name, [&](const zed::Paragraph& box) {
    for (const std::string& label : zed::labels_of(box)) labels.raw(json_of(label));
  });
  const bool in_text = schema_of(operation.name) != nullptr;
  return ObjectText()
      .member("name", operation.name)
      .raw("inputs", inputs.text())
      .raw("schema", in_text ? json_of(operation.name) : "null")
      .raw("labels", labels.text())
      .text();
}

}  // namespace

std::string answer_operations(const AskedCall& asked) {
  asked.require(operations_keys, 0);
  std::optional<written::Text> text;
  if (asked.has("with")) text.emplace(asked.part("with"));
  const std::span<const io::WrittenType> types = text ? text->types() : std::span<const io::WrittenType>{};
  return ObjectText()
      .raw("operations",
           array_of(io::operation_words(types),
                    [&](const io::OperationWords& operation) { return operation_json(operation, types); }))
      .text();
}

}  // namespace durero::web
