#include "durero/io/json/operations_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <iterator>

#include "durero/io/json/json_writer.hpp"
#include "durero/io/lines.hpp"
#include "durero/scene/addition.hpp"
#include "durero/scene/stage.hpp"
#include "durero/text/nearest.hpp"
#include "durero/text/shown.hpp"
#include "durero/text/spanish.hpp"
#include "io/attribute_words.hpp"
#include "operation_inputs.hpp"
#include "texture_fields.hpp"
#include "written_value.hpp"

namespace durero::io {
namespace {

using AnyEdit = decltype(ScriptStep::edit);

// What a script may say of one operation, and the edit that it then means.
struct OperationSchema {
  Signature signature;
  std::function<AnyEdit(const Inputs& in, const scene::Stage& stage)> read;
  bool is_listed = true;  // a message that lists the operations names Cambiar_Radio, and not each Cambiar_Radio_TIPO
};

constexpr std::string_view material_word = "material";

std::string operation_name(std::string_view verb, std::string_view word) {
  std::string name = fmt::format("{}_{}", verb, word);
  char& first = name[verb.size() + 1];
  if ('a' <= first && first <= 'z') first = static_cast<char>(first - 'a' + 'A');
  return name;
}

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

std::optional<std::uint32_t> read_material(const Inputs& in, const scene::Stage& stage) {
  if (!in.has(material_word)) return std::nullopt;
  const auto found = std::ranges::find(stage.materials, in.word(material_word), &scene::Material::name);
  if (found == stage.materials.end()) {
    in.fail(material_word, fmt::format("unknown material {}", text::shown(in.word(material_word))),
            "expected one of the scene's materials");
  }
  return static_cast<std::uint32_t>(found - stage.materials.begin());
}

/// An edit of the elements, by what reads its operation.
template <model::Operation (*read)(const Inputs& in)>
AnyEdit read_edit(const Inputs& in, const scene::Stage& stage) {
  model::Operation operation = read(in);
  return scene::Edit{std::move(operation), read_material(in, stage)};
}

/// The change of an attribute, of an element of this type, or of any.
template <class Change>
AnyEdit read_change(const Inputs& in, std::optional<model::Tipo> of_type) {
  const auto& attribute = model::attribute_of<Change::component>();
  using Input = std::remove_cvref_t<decltype(attribute.input(std::declval<Change&>()))>;
  std::remove_cvref_t<decltype(scene::stored(std::declval<const Input&>()))> written{};
  const model::Elemento e = in.element();
  in.read(attribute.word, written);
  return model::AttributeChange(Change{e, scene::input_of<Input>(written), of_type});
}

/// The name that a change of an attribute has, of a type or of any.
template <class Change>
std::string change_name(std::optional<model::Tipo> of_type) {
  if (!of_type) return std::string(Change::schema);
  const std::string_view type = model::name(*of_type).substr(std::string_view("soy_").size());
  return operation_name(Change::schema, type);
}

/// Of each attribute its change, and that of each type that has it.
void add_changes(std::vector<OperationSchema>& all) {
  const auto add = [&]<class Change>(std::type_identity<Change>) {
    const auto& attribute = model::attribute_of<Change::component>();
    const auto add_one = [&](std::optional<model::Tipo> of_type) {
      all.push_back({{change_name<Change>(of_type), {"e", attribute.word}, {}},
                     [=](const Inputs& in, const scene::Stage&) { return read_change<Change>(in, of_type); },
                     !of_type});
    };
    add_one(std::nullopt);
    scene::for_each_shape([&]<class Shape>(std::type_identity<Shape>) {
      if (attribute.types.contains(Shape::tipo)) add_one(Shape::tipo);
    });
  };
  [&]<class... Change>(std::type_identity<std::variant<Change...>>) {
    (add(std::type_identity<Change>()), ...);
  }(std::type_identity<model::AttributeChange>());
}

AnyEdit read_material_change(const Inputs& in, const scene::Stage&) {
  return model::LookChange(model::Cambiar_Material{in.element(), in.word(material_word)});
}
AnyEdit read_group_change(const Inputs& in, const scene::Stage&) {
  return model::LookChange(model::Cambiar_Grupo{in.element(), in.name("g")});
}
template <class Change>
AnyEdit read_look_removal(const Inputs& in, const scene::Stage&) {
  return model::LookChange(Change{in.element()});
}

scene::Names read_names(const Inputs& in, std::string_view input) {
  if (!in.has(input)) return {};
  std::vector<std::string> names = in.names(input);
  return {std::make_move_iterator(names.begin()), std::make_move_iterator(names.end())};
}

AnyEdit read_grouping(const Inputs& in, const scene::Stage&) {
  return scene::Grouping{in.name("g"), {read_names(in, "elementos"), read_names(in, "groups")}};
}

AnyEdit read_ungrouping(const Inputs& in, const scene::Stage&) { return scene::Ungrouping{in.name("g")}; }

/// Without names of their own the discs are called after the element.
AnyEdit read_closing(const Inputs& in, const scene::Stage&) {
  const std::string e = in.element().name();
  const auto name = [&](std::string_view input) {
    if (in.has(input)) return in.name(input);
    const std::string after = fmt::format("{}:{}", e, input);
    if (!model::Elemento::is_name(after))
      in.fail("e", fmt::format("{} is too long a name", text::shown(after)), "expected base and top");
    return after;
  };
  return scene::Closing{e, name("base"), name("top")};
}

/// Neither of what a Z text declares nor of a copy has the material textures, as in a scene file.
std::optional<std::uint32_t> read_plain_material(const Inputs& in, const scene::Stage& stage) {
  const auto place = read_material(in, stage);
  if (place && has_textures(stage.materials[*place]))
    in.fail(material_word, fmt::format("material {} has textures", text::shown(in.word(material_word))),
            "expected one without: neither what a text declares nor a copy has coordinates (u, v)");
  return place;
}

AnyEdit read_copying(const Inputs& in, const scene::Stage& stage) {
  const auto vector = [&](std::string_view input) {
    glm::dvec3 value{};
    in.read(input, value);
    return model::ExactVector(model::Vector(value));
  };
  const std::string e = in.element().name(), de = in.name("de");
  return scene::Copying{
      e, de, {vector("centro"), vector("x"), vector("y"), vector("z")}, read_plain_material(in, stage)};
}

AnyEdit read_copy_removal(const Inputs& in, const scene::Stage&) { return scene::CopyRemoval{in.element().name()}; }

template <scene::Compound::Operation operation>
AnyEdit read_joining(const Inputs& in, const scene::Stage& stage) {
  scene::Joining joining{operation, in.element().name(), in.names("de"), read_plain_material(in, stage)};
  if (joining.de.size() < 2) in.fail("de", "de has fewer than two parts", "expected two or more");
  return joining;
}

AnyEdit read_solid_removal(const Inputs& in, const scene::Stage&) { return scene::SolidRemoval{in.element().name()}; }

scene::Mesh read_whole_mesh(const Inputs& in, const scene::Stage& stage) {
  scene::Mesh mesh{model::Elemento(in.name("m"))};
  std::vector<glm::dvec3> points;
  in.read("puntos", points);
  mesh.puntos = points;
  in.read("caras", mesh.caras);
  mesh.material = read_material(in, stage).value_or(scene::no_material);
  return mesh;
}

AnyEdit read_mesh_addition(const Inputs& in, const scene::Stage& stage) {
  return scene::MeshEdit(scene::MeshAddition{read_whole_mesh(in, stage)});
}
AnyEdit read_mesh_replacement(const Inputs& in, const scene::Stage& stage) {
  return scene::MeshEdit(scene::MeshReplacement{read_whole_mesh(in, stage)});
}
AnyEdit read_mesh_removal(const Inputs& in, const scene::Stage&) {
  return scene::MeshEdit(scene::MeshRemoval{model::Elemento(in.name("m"))});
}
AnyEdit read_vertex_move(const Inputs& in, const scene::Stage&) {
  model::Ordinal n{};
  glm::dvec3 punto{};
  in.read("n", n);
  in.read("punto", punto);
  return scene::MeshEdit(scene::VertexMove{model::Elemento(in.name("m")), n, model::Punto(punto)});
}

// The additions and removals of each shape, each followed by the general one, as the text has them.
std::vector<OperationSchema> all_schemas() {
  std::vector<OperationSchema> all;
  Signature general{"Agregar_Elemento", {"e", "t"}, {attribute_words.begin(), attribute_words.end()}};
  scene::for_each_shape([&]<class Shape>(std::type_identity<Shape>) {
    Signature signature{std::string(Shape::Addition::schema), {"e"}, {material_word}};
    scene::for_each_attribute<Shape>([&](const auto& attribute) { signature.required.push_back(attribute.word); });
    all.push_back({std::move(signature), read_edit<read_addition<Shape>>});
  });
  general.optional.push_back(material_word);
  all.push_back({std::move(general), read_edit<read_general_addition>});
  scene::for_each_shape([&]<class Shape>(std::type_identity<Shape>) {
    all.push_back({{std::string(Shape::Removal::schema), {"e"}, {}}, read_edit<read_removal<typename Shape::Removal>>});
  });
  all.push_back({{"Eliminar_Elemento", {"e"}, {}}, read_edit<read_removal<model::Eliminar_Elemento>>});
  add_changes(all);
  all.push_back({{"Cambiar_Material", {"e", material_word}, {}}, read_material_change});
  all.push_back({{"Quitar_Material", {"e"}, {}}, read_look_removal<model::Quitar_Material>});
  all.push_back({{"Cambiar_Grupo", {"e", "g"}, {}}, read_group_change});
  all.push_back({{"Quitar_Grupo", {"e"}, {}}, read_look_removal<model::Quitar_Grupo>});
  all.push_back({{"Agregar_Instancia", {"e", "de", "centro", "x", "y", "z"}, {material_word}}, read_copying});
  all.push_back({{"Eliminar_Instancia", {"e"}, {}}, read_copy_removal});
  using enum scene::Compound::Operation;
  all.push_back({{"Agregar_Union", {"e", "de"}, {material_word}}, read_joining<united>});
  all.push_back({{"Agregar_Interseccion", {"e", "de"}, {material_word}}, read_joining<intersected>});
  all.push_back({{"Agregar_Diferencia", {"e", "de"}, {material_word}}, read_joining<subtracted>});
  all.push_back({{"Eliminar_Solido", {"e"}, {}}, read_solid_removal});
  all.push_back({{"Agregar_Malla", {"m", "puntos", "caras"}, {material_word}}, read_mesh_addition});
  all.push_back({{"Eliminar_Malla", {"m"}, {}}, read_mesh_removal});
  all.push_back({{"Reemplazar_Malla", {"m", "puntos", "caras"}, {material_word}}, read_mesh_replacement});
  all.push_back({{"Mover_Vertice", {"m", "n", "punto"}, {}}, read_vertex_move});
  all.push_back({{"group", {"g"}, {"elementos", "groups"}}, read_grouping});
  all.push_back({{"ungroup", {"g"}, {}}, read_ungrouping});
  all.push_back({{"close", {"e"}, {"base", "top"}}, read_closing});
  return all;
}

const std::vector<OperationSchema>& schemas() {
  static const std::vector<OperationSchema> all = all_schemas();
  return all;
}

/// The operations of one type that a Z text declares.
class WrittenSchemas {
 public:
  WrittenSchemas(const WrittenType& type, std::size_t place)
      : type_(type), place_(place), addition_(addition_name(type.word)), removal_(removal_name(type.word)) {}

  void list(std::vector<std::string_view>& known) const {
    known.push_back(addition_);
    known.push_back(removal_);
  }

  /// Nothing where the call is of another type.
  std::optional<AnyEdit> read(const Source& source, const Call& call, const scene::Stage& stage) const {
    if (call.schema == addition_) return read_addition(source, call, stage);
    if (call.schema != removal_) return std::nullopt;
    const Signature signature{removal_, {"e"}, {}};
    return WrittenEdit(WrittenRemoval{Inputs(source, call, signature).element().name(), place_});
  }

 private:
  AnyEdit read_addition(const Source& source, const Call& call, const scene::Stage& stage) const {
    Signature signature{addition_, {"e"}, {material_word}};
    for (const WrittenAttribute& attribute : type_.attributes) signature.required.push_back(attribute.word);
    const Inputs in(source, call, signature);
    WrittenElement element{in.element().name(), place_, call.offset, {}, {}};
    for (const WrittenAttribute& attribute : type_.attributes)
      element.values.push_back(read_written_value(attribute.kind, [&](auto& to) { in.read(attribute.word, to); }));
    return WrittenEdit(WrittenAddition{std::move(element), read_plain_material(in, stage)});
  }

  const WrittenType& type_;
  std::size_t place_;
  std::string addition_, removal_;
};

[[noreturn]] void refuse_unknown(const Source& source, const Call& call, const std::vector<WrittenSchemas>& written) {
  std::vector<std::string_view> known, listed;
  for (const OperationSchema& schema : schemas()) {
    known.push_back(schema.signature.name);
    if (schema.is_listed) listed.push_back(schema.signature.name);
  }
  for (const WrittenSchemas& of : written) {
    of.list(known);
    of.list(listed);
  }
  const auto near = text::nearest(call.schema, {known.begin(), known.end()});
  source.fail(
      call.offset, fmt::format("unknown operation {}", text::shown(call.schema)),
      fmt::format("expected {}one of {}", near ? text::with_english(*near) + ", or " : "", fmt::join(listed, ", ")));
}

AnyEdit edit_of(const Source& source, const Call& call, const scene::Stage& stage,
                const std::vector<WrittenSchemas>& written) {
  for (const OperationSchema& schema : schemas())
    if (schema.signature.name == call.schema) return schema.read(Inputs(source, call, schema.signature), stage);
  for (const WrittenSchemas& of : written)
    if (auto edit = of.read(source, call, stage)) return *std::move(edit);
  refuse_unknown(source, call, written);
}

}  // namespace

std::string addition_name(std::string_view word) { return operation_name("Agregar", word); }
std::string removal_name(std::string_view word) { return operation_name("Eliminar", word); }

std::vector<OperationWords> operation_words(std::span<const WrittenType> types) {
  std::vector<OperationWords> all;
  for (const OperationSchema& schema : schemas()) {
    const auto& [name, required, optional] = schema.signature;
    OperationWords& words = all.emplace_back(
        std::string(name), std::vector<std::string>(required.begin(), required.end()), required.size());
    words.inputs.insert(words.inputs.end(), optional.begin(), optional.end());
  }
  for (const WrittenType& type : types) {
    OperationWords& addition =
        all.emplace_back(addition_name(type.word), std::vector<std::string>{"e"}, 1 + type.attributes.size());
    for (const WrittenAttribute& attribute : type.attributes) addition.inputs.push_back(attribute.word);
    addition.inputs.emplace_back(material_word);
    all.push_back({removal_name(type.word), {"e"}, 1});
  }
  return all;
}

std::vector<ScriptStep> read_script(const Source& source, const scene::Stage& stage,
                                    std::span<const WrittenType> types) {
  std::vector<WrittenSchemas> written;
  for (std::size_t i = 0; i < types.size(); ++i) written.emplace_back(types[i], i);
  std::vector<ScriptStep> script;
  Lines lines(source.text());
  while (const auto line = lines.next()) {
    const auto call = read_call(source, *line);
    if (call) script.push_back({line->number, edit_of(source, *call, stage, written)});
  }
  return script;
}

EditAnswer edit_answer(const model::Answer& answer) {
  return edit_answer(scene::Outcome{model::name(answer.r), answer.violated});
}

EditAnswer edit_answer(const scene::Outcome& answer) {
  if (answer.ok()) return {std::string(answer.r)};
  return {std::string(answer.r), std::string(answer.violated->label), std::string(answer.violated->predicate)};
}

std::string answer_text(std::size_t line, const EditAnswer& answer, std::string_view for_each) {
  std::string text;
  json::Writer out(text);
  out.begin_object().member("line", line);
  if (!for_each.empty()) out.member("for", for_each);
  out.member("ok", answer.ok()).member("r", answer.r);
  if (!answer.left_group.empty()) out.member("left_group", answer.left_group);
  if (!answer.ok()) out.member("violated", answer.violated).member("predicate", answer.predicate);
  out.end_object();
  return text;
}

}  // namespace durero::io
