#include <fmt/format.h>

#include <algorithm>

#include "durero/scene/body.hpp"
#include "durero/text/shown.hpp"
#include "durero/text/spanish.hpp"
#include "element_reader.hpp"
#include "field.hpp"
#include "written_value.hpp"

namespace durero::io {
namespace {

constexpr std::size_t id = 0, tipo = 1, first_attribute = 2;

}  // namespace

void add_stand_in(const json::Reader& in, scene::Scene& scene, const Placed<std::string_view>& name) {
  const model::Answer answer = scene.add(model::Elemento{std::string(name.value)}, scene::stand_in);
  if (answer.ok()) return;
  in.fail(name.offset, fmt::format("id is {}: {}", text::shown(name.value), text::with_english(model::name(answer.r))),
          fmt::format("expected {} ({})", answer.violated->predicate, answer.violated->label), answer.violated);
}

std::optional<std::size_t> written_type(const json::Reader& in, std::span<const WrittenType> types) {
  auto tipo_here = in.member("tipo");
  if (types.empty() || !tipo_here || tipo_here->kind() != json::TokenKind::string) return std::nullopt;
  const auto found = std::ranges::find(types, tipo_here->string("tipo"), &WrittenType::word);
  if (found == types.end()) return std::nullopt;
  return static_cast<std::size_t>(found - types.begin());
}

void read_written_element(json::Reader& in, std::size_t type, scene::Scene& scene, std::vector<MaterialUse>& uses,
                          const WrittenElements& written) {
  const std::vector<WrittenAttribute>& attributes = written.types[type].attributes;
  std::vector<std::string_view> keys{"id", "tipo"};
  for (const WrittenAttribute& attribute : attributes) keys.push_back(attribute.word);
  const std::size_t required = keys.size(), material = required;
  keys.push_back("material");
  WrittenElement element{"", type, in.offset(), std::vector<WrittenValue>(attributes.size()),
                         std::vector<std::size_t>(attributes.size())};
  Placed<std::string_view> name;
  std::optional<Placed<std::string_view>> of;
  const auto read_field = [&](std::size_t key) {
    const std::size_t at = in.offset();
    if (key == id) {
      name = {read_id(in), at};
    } else if (key == tipo) {
      in.skip();
    } else if (key == material) {
      of = {in.string("material"), at};
    } else {
      const WrittenAttribute& attribute = attributes[key - first_attribute];
      element.offsets[key - first_attribute] = at;
      element.values[key - first_attribute] =
          read_written_value(attribute.kind, [&](auto& to) { read_json(in, attribute.word, to); });
    }
  };
  in.object(fmt::format("an element of tipo {}", written.types[type].word), keys, required, read_field);
  add_stand_in(in, scene, name);
  if (of) uses.push_back({name.value, *of});
  element.id = name.value;
  written.elements->push_back(std::move(element));
}

}  // namespace durero::io
