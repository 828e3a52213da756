#include "durero/io/operations_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <span>

#include "durero/io/json_writer.hpp"
#include "durero/io/lines.hpp"
#include "durero/io/number_text.hpp"
#include "durero/text/shown.hpp"
#include "operation_call.hpp"

namespace durero::io {
namespace {

using model::Tipo;

enum Name : std::size_t { e, t, centro, radio, vector, altura, proporcion, material };
constexpr std::array<std::string_view, 8> names = {"e",      "t",      "centro",     "radio",
                                                   "vector", "altura", "proporcion", "material"};

// The inputs that each schema declares: the required ones, then those it may go without.
struct Schema {
  std::string_view name;
  std::span<const Name> required;
  std::span<const Name> optional;
};

constexpr Name esfera[] = {e, centro, radio};
constexpr Name cilindro[] = {e, centro, radio, vector, altura};
constexpr Name cono[] = {e, centro, proporcion, vector, altura};
constexpr Name elemento[] = {e, t, centro};
constexpr Name attributes[] = {radio, vector, altura, proporcion, material};
constexpr Name look[] = {material};
constexpr Name removed[] = {e};
constexpr std::array<Schema, 8> schemas = {{{"Agregar_Esfera", esfera, look},
                                            {"Agregar_Cilindro", cilindro, look},
                                            {"Agregar_Cono", cono, look},
                                            {"Agregar_Elemento", elemento, attributes},
                                            {"Eliminar_Esfera", removed, {}},
                                            {"Eliminar_Cilindro", removed, {}},
                                            {"Eliminar_Cono", removed, {}},
                                            {"Eliminar_Elemento", removed, {}}}};

// The inputs of a call by name, and their values by type.
class Inputs {
 public:
  Inputs(const Source& source, const Call& call, const Schema& schema) : source_(source), call_(call) {
    for (const Input& input : call.inputs) place(input, schema);
    require(schema.required);
  }

  void require(std::span<const Name> required) const {
    for (const Name name : required) {
      if (!has(name)) source_.fail(call_.offset, fmt::format("{} lacks {}?", call_.schema, names[name]), "expected it");
    }
  }

  bool has(Name name) const { return by_name_[name] != nullptr; }

  model::Elemento element() const {
    const std::string& text = word(e);
    if (!model::Elemento::is_name(text)) {
      fail(e, fmt::format("e? is {}", text::shown(text)), "expected a name, 1 to 128 of A-Z a-z 0-9 _ . : -");
    }
    return model::Elemento{text};
  }

  Tipo tipo() const {
    for (const Tipo tipo : {Tipo::soy_esfera, Tipo::soy_cilindro, Tipo::soy_cono}) {
      if (word(t) == model::name(tipo)) return tipo;
    }
    fail(t, fmt::format("t? is {}", text::shown(word(t))), "expected soy_esfera, soy_cilindro or soy_cono");
  }

  double real(Name name) const {
    const auto& value = by_name_[name]->value;
    if (const auto* number = std::get_if<double>(&value)) return *number;
    if (const auto* text = std::get_if<Word>(&value)) {
      if (const auto number = read_finite(text->text)) return *number;
      fail(name, fmt::format("{}? is {}", names[name], text::shown(text->text)), "expected a finite number");
    }
    fail(name, fmt::format("{}? is no number", names[name]), "expected a finite number");
  }

  glm::dvec3 triple(Name name) const {
    if (const auto* v = std::get_if<glm::dvec3>(&by_name_[name]->value)) return *v;
    fail(name, fmt::format("{}? is no triple", names[name]), "expected (x,y,z), or [x,y,z] in JSON");
  }

  const std::string& word(Name name) const {
    const auto& value = by_name_[name]->value;
    if (const auto* text = std::get_if<std::string>(&value)) return *text;
    if (const auto* text = std::get_if<Word>(&value)) return text->text;
    fail(name, fmt::format("{}? is no name", names[name]), "expected a name");
  }

  [[noreturn]] void fail(Name name, const std::string& wrong, const std::string& expected) const {
    source_.fail(by_name_[name]->value_offset, wrong, expected);
  }

 private:
  void place(const Input& input, const Schema& schema) {
    const auto found = std::ranges::find(names, input.name);
    const auto name = static_cast<Name>(found - names.begin());
    const auto declares = [&](std::span<const Name> some) { return std::ranges::find(some, name) != some.end(); };
    if (found == names.end() || !(declares(schema.required) || declares(schema.optional))) {
      std::vector<std::string_view> known;
      for (const Name n : schema.required) known.push_back(names[n]);
      for (const Name n : schema.optional) known.push_back(names[n]);
      source_.fail(input.name_offset, fmt::format("unknown input {} of {}", text::shown(input.name), schema.name),
                   fmt::format("expected one of {}", fmt::join(known, ", ")));
    }
    if (has(name)) source_.fail(input.name_offset, fmt::format("{}? stands twice", input.name), "expected it once");
    by_name_[name] = &input;
  }

  const Source& source_;
  const Call& call_;
  std::array<const Input*, names.size()> by_name_{};
};

model::Operation general_addition(const Inputs& in) {
  static constexpr std::array<std::span<const Name>, 3> required = {esfera, cilindro, cono};
  model::Agregar_Elemento added{in.element(), in.tipo(), model::Punto{in.triple(centro)}};
  in.require(required[static_cast<std::size_t>(added.t)]);
  if (in.has(radio)) added.radio = in.real(radio);
  if (in.has(vector)) added.vector = model::Vector{in.triple(vector)};
  if (in.has(altura)) added.altura = in.real(altura);
  if (in.has(proporcion)) added.proporcion = in.real(proporcion);
  return added;
}

model::Operation operation(std::size_t schema, const Inputs& in) {
  const auto axis = [&] { return model::Vector{in.triple(vector)}; };
  const auto center = [&] { return model::Punto{in.triple(centro)}; };
  switch (schema) {
    case 0:
      return model::Agregar_Esfera{in.element(), center(), in.real(radio)};
    case 1:
      return model::Agregar_Cilindro{in.element(), center(), in.real(radio), axis(), in.real(altura)};
    case 2:
      return model::Agregar_Cono{in.element(), center(), in.real(proporcion), axis(), in.real(altura)};
    case 3:
      return general_addition(in);
    case 4:
      return model::Eliminar_Esfera{in.element()};
    case 5:
      return model::Eliminar_Cilindro{in.element()};
    case 6:
      return model::Eliminar_Cono{in.element()};
    default:
      return model::Eliminar_Elemento{in.element()};
  }
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

Edit read_edit(const Source& source, std::size_t line, const Call& call, const scene::Stage& stage) {
  const auto schema = std::ranges::find(schemas, call.schema, &Schema::name);
  if (schema == schemas.end()) {
    std::vector<std::string_view> known;
    known.reserve(schemas.size());
    for (const Schema& s : schemas) known.push_back(s.name);
    source.fail(call.offset, fmt::format("unknown operation {}", text::shown(call.schema)),
                fmt::format("expected one of {}", fmt::join(known, ", ")));
  }
  const Inputs in(source, call, *schema);
  return {line, operation(static_cast<std::size_t>(schema - schemas.begin()), in), read_material(in, stage)};
}

}  // namespace

std::vector<Edit> read_operations(const Source& source, const scene::Stage& stage) {
  std::vector<Edit> edits;
  Lines lines(source.text());
  while (const auto line = lines.next()) {
    if (const auto call = read_call(source, *line)) edits.push_back(read_edit(source, line->number, *call, stage));
  }
  return edits;
}

model::Answer run(scene::Scene& scene, const Edit& edit) {
  const model::Answer answer = scene.apply_total(edit.operation);
  if (answer.ok() && edit.material) {
    const auto& name = std::visit([](const auto& o) -> const model::Elemento& { return o.e; }, edit.operation);
    scene.set_material(scene.find(name.name()).value(), edit.material);
  }
  return answer;
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
