#include "durero/io/operations_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "attribute_words.hpp"
#include "durero/io/json_writer.hpp"
#include "durero/io/lines.hpp"
#include "durero/text/shown.hpp"
#include "operation_inputs.hpp"

namespace durero::io {
namespace {

// What a script may say of one operation, and the operation that it then means.
struct Schema {
  Signature signature;
  model::Operation (*read)(const Inputs& in);
};

constexpr std::string_view material = "material";

template <class Shape>
model::Operation read_addition(const Inputs& in) {
  const model::Elemento e = in.element();
  Shape shape{};
  scene::for_each_attribute<Shape>([&](const auto& attribute) { in.read(attribute.word, shape.*attribute.field); });
  return scene::addition(e, shape);
}

template <class Removal>
model::Operation read_removal(const Inputs& in) {
  return Removal{in.element()};
}

/// An input of the general addition, as the shapes store it.
template <class Value>
void read_optional(const Inputs& in, std::string_view name, std::optional<Value>& value) {
  std::remove_cvref_t<decltype(scene::stored(std::declval<const Value&>()))> written{};
  in.read(name, written);
  value = scene::input_of<Value>(written);
}

model::Operation read_general_addition(const Inputs& in) {
  const model::Elemento e = in.element();
  const model::Tipo tipo = in.tipo();
  scene::with_shape(tipo, [&]<class Shape>(std::type_identity<Shape>) {
    scene::for_each_attribute<Shape>([&](const auto& attribute) { in.require(attribute.word); });
  });
  model::Agregar_Elemento added{e, tipo};
  model::for_each_attribute([&](const auto& attribute) {
    if (in.has(attribute.word)) read_optional(in, attribute.word, attribute.input(added));
  });
  return added;
}

// The additions and removals of each shape, each followed by the general one, as the text has them.
std::vector<Schema> all_schemas() {
  std::vector<Schema> all;
  Signature general{"Agregar_Elemento", {"e", "t"}, {attribute_words.begin(), attribute_words.end()}};
  scene::for_each_shape([&]<class Shape>(std::type_identity<Shape>) {
    Signature signature{Shape::Addition::schema, {"e"}, {material}};
    scene::for_each_attribute<Shape>([&](const auto& attribute) { signature.required.push_back(attribute.word); });
    all.push_back({std::move(signature), read_addition<Shape>});
  });
  general.optional.push_back(material);
  all.push_back({std::move(general), read_general_addition});
  scene::for_each_shape([&]<class Shape>(std::type_identity<Shape>) {
    all.push_back({{Shape::Removal::schema, {"e"}, {}}, read_removal<typename Shape::Removal>});
  });
  all.push_back({{"Eliminar_Elemento", {"e"}, {}}, read_removal<model::Eliminar_Elemento>});
  return all;
}

const std::vector<Schema>& schemas() {
  static const std::vector<Schema> all = all_schemas();
  return all;
}

const Schema& schema_of(const Source& source, const Call& call) {
  std::vector<std::string_view> known;
  for (const Schema& schema : schemas()) {
    if (schema.signature.name == call.schema) return schema;
    known.push_back(schema.signature.name);
  }
  source.fail(call.offset, fmt::format("unknown operation {}", text::shown(call.schema)),
              fmt::format("expected one of {}", fmt::join(known, ", ")));
}

std::optional<std::uint32_t> read_material(const Inputs& in, const scene::Stage& stage) {
  if (!in.has(material)) return std::nullopt;
  const auto found = std::ranges::find(stage.materials, in.word(material), &scene::Material::name);
  if (found == stage.materials.end()) {
    in.fail(material, fmt::format("unknown material {}", text::shown(in.word(material))),
            "expected one of the scene's materials");
  }
  return static_cast<std::uint32_t>(found - stage.materials.begin());
}

scene::Edit read_edit(const Source& source, const Call& call, const scene::Stage& stage) {
  const Schema& schema = schema_of(source, call);
  const Inputs in(source, call, schema.signature);
  model::Operation operation = schema.read(in);
  return {std::move(operation), read_material(in, stage)};
}

}  // namespace

std::vector<Instruction> read_operations(const Source& source, const scene::Stage& stage) {
  std::vector<Instruction> script;
  Lines lines(source.text());
  while (const auto line = lines.next()) {
    if (const auto call = read_call(source, *line)) script.push_back({line->number, read_edit(source, *call, stage)});
  }
  return script;
}

std::string answer_text(std::size_t line, const model::Answer& answer) {
  std::string text;
  json::Writer out(text);
  out.begin_object().member("line", line).member("ok", answer.ok()).member("r", model::name(answer.r));
  if (!answer.ok()) out.member("violated", answer.violated->label).member("predicate", answer.violated->predicate);
  out.end_object();
  return text;
}

}  // namespace durero::io
