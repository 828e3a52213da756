#include "durero/io/json/operation_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <optional>

#include "durero/io/json/json_writer.hpp"
#include "durero/io/number_text.hpp"
#include "durero/model/escena.hpp"
#include "durero/number/rational.hpp"
#include "durero/scene/addition.hpp"

namespace durero::io {
namespace {

using Place = std::optional<std::uint32_t>;

/// Whether a text reads as the value of an input that is a word.
bool is_word_of_text(std::string_view text) {
  return !text.empty() && text.front() != '(' && text.find_first_of(" \t\v\f\r\n") == text.npos;
}

/// The line of an operation, in one of the two syntaxes.
class OperationLine {
 public:
  /// With the name of a material, or null.
  OperationLine(std::string_view name, const std::string* material) : material_(material) {
    if (material_ == nullptr || is_word_of_text(*material_))
      text_ = name;
    else
      json_.emplace(text_).begin_object().member("op", name);
  }
  OperationLine(const OperationLine&) = delete;
  OperationLine& operator=(const OperationLine&) = delete;

  template <class Value>
  OperationLine& input(std::string_view name, const Value& value) {
    if (json_) {
      write(json_->key(name), value);
    } else {
      fmt::format_to(std::back_inserter(text_), " {}?=", name);
      append(value);
    }
    return *this;
  }

  /// The line, with the material behind all other inputs.
  std::string done() {
    if (material_ != nullptr) input("material", *material_);
    if (json_) json_->end_object();
    return std::move(text_);
  }

 private:
  void append(double value) { append_number(text_, value); }
  void append(model::Ordinal value) { text_ += fmt::format_int(value).c_str(); }
  void append(const std::string& name) { text_ += name; }
  void append(std::string_view name) { text_ += name; }
  void append(const glm::dvec3& v) { append_list(std::array{v.x, v.y, v.z}); }
  void append(const model::Cara& c) { append_list(std::array{c.i, c.j, c.k}); }
  void append(const std::vector<std::string>& names) { text_ += fmt::format("{}", fmt::join(names, ",")); }
  void append(const scene::Names& names) { text_ += fmt::format("{}", fmt::join(names, ",")); }
  template <class List>
  void append(const List& list) {
    append_list(list);
  }

  template <class List>
  void append_list(const List& list) {
    char before = '(';
    for (const auto& item : list) {
      text_ += std::exchange(before, ',');
      append(item);
    }
    text_ += before == '(' ? "()" : ")";
  }

  static void write(json::Writer& out, double value) { out.value(value); }
  static void write(json::Writer& out, model::Ordinal value) { out.value(std::uint64_t{value}); }
  static void write(json::Writer& out, const std::string& name) { out.value(std::string_view(name)); }
  static void write(json::Writer& out, std::string_view name) { out.value(name); }
  static void write(json::Writer& out, const glm::dvec3& v) { out.value(v); }
  static void write(json::Writer& out, const model::Cara& c) { write(out, std::array{c.i, c.j, c.k}); }
  template <class List>
  static void write(json::Writer& out, const List& list) {
    out.begin_array();
    for (const auto& item : list) write(out, item);
    out.end_array();
  }

  const std::string* material_;
  std::string text_;
  std::optional<json::Writer> json_{};
};

/// The lines of the edits of one script.
class EditLines {
 public:
  EditLines(const scene::Stage& stage, std::span<const WrittenType> types) : stage_(stage), types_(types) {}

  std::string operator()(const scene::Edit& edit) const {
    return std::visit([&](const auto& in) { return line(in, edit.material); }, edit.operation);
  }
  std::string operator()(const scene::GroupEdit& edit) const {
    return std::visit([&](const auto& in) { return line(in); }, edit);
  }
  std::string operator()(const scene::MeshEdit& edit) const {
    return std::visit([&](const auto& in) { return line(in); }, edit);
  }
  std::string operator()(const WrittenEdit& edit) const {
    return std::visit([&](const auto& in) { return line(in); }, edit);
  }
  std::string operator()(const scene::Closing& in) const {
    return begin("close").input("e", in.e).input("base", in.base).input("top", in.top).done();
  }
  std::string operator()(const scene::Copying& in) const {
    OperationLine out = begin("Agregar_Instancia", in.material);
    out.input("e", in.e).input("de", in.de).input("centro", rounded(in.mapa.centro));
    return out.input("x", rounded(in.mapa.x)).input("y", rounded(in.mapa.y)).input("z", rounded(in.mapa.z)).done();
  }
  std::string operator()(const scene::CopyRemoval& in) const {
    return begin("Eliminar_Instancia").input("e", in.e).done();
  }
  std::string operator()(const scene::Joining& in) const {
    return begin(joining_name(in.operation), in.material).input("e", in.e).input("de", in.de).done();
  }
  std::string operator()(const scene::SolidRemoval& in) const {
    return begin("Eliminar_Solido").input("e", in.e).done();
  }
  std::string operator()(const model::AttributeChange& change) const {
    return std::visit(
        [&]<class Change>(const Change& in) {
          const auto& attribute = model::attribute_of<Change::component>();
          OperationLine out = begin(model::schema_name(change));
          return out.input("e", in.e.name()).input(attribute.word, scene::stored(attribute.input(in))).done();
        },
        change);
  }
  std::string operator()(const model::LookChange& change) const {
    return std::visit([&](const auto& in) { return line(in); }, change);
  }

 private:
  OperationLine begin(std::string_view name, Place material = {}) const {
    return {name, material ? &stage_.materials.at(*material).name : nullptr};
  }

  static glm::dvec3 rounded(const model::ExactVector& v) {
    return {number::round_to_binary64(v.x), number::round_to_binary64(v.y), number::round_to_binary64(v.z)};
  }

  static std::string_view joining_name(scene::Compound::Operation operation) {
    switch (operation) {
      case scene::Compound::Operation::united:
        return "Agregar_Union";
      case scene::Compound::Operation::intersected:
        return "Agregar_Interseccion";
      case scene::Compound::Operation::subtracted:
        return "Agregar_Diferencia";
    }
    __builtin_unreachable();  // an operation is one of its enumerators
  }

  /// Of an addition of one shape, or of a removal of one.
  template <class Operation>
  std::string line(const Operation& in, Place material) const {
    using Shape = scene::ShapeAddedBy<Operation>;
    OperationLine out = begin(Operation::schema, material);
    out.input("e", in.e.name());
    if constexpr (!std::is_void_v<Shape>)
      scene::for_each_input<Shape>(
          [&](const auto& attribute) { out.input(attribute.word, scene::stored(in.*attribute.input)); });
    return out.done();
  }
  std::string line(const model::Agregar_Elemento& in, Place material) const {
    OperationLine out = begin("Agregar_Elemento", material);
    out.input("e", in.e.name()).input("t", std::string_view(model::name(in.t)));
    model::for_each_attribute([&](const auto& attribute) {
      if (const auto& value = attribute.input(in)) out.input(attribute.word, scene::stored(*value));
    });
    return out.done();
  }
  std::string line(const model::Eliminar_Elemento& in, Place) const {
    return begin("Eliminar_Elemento").input("e", in.e.name()).done();
  }

  static std::string line(const model::Cambiar_Material& in) {
    return OperationLine(in.schema, &in.material).input("e", in.e.name()).done();
  }
  std::string line(const model::Cambiar_Grupo& in) const {
    return begin(in.schema).input("e", in.e.name()).input("g", in.g).done();
  }
  std::string line(const model::Quitar_Material& in) const { return begin(in.schema).input("e", in.e.name()).done(); }
  std::string line(const model::Quitar_Grupo& in) const { return begin(in.schema).input("e", in.e.name()).done(); }

  std::string line(const scene::Grouping& in) const {
    OperationLine out = begin("group");
    out.input("g", in.g);
    if (!in.of.elementos.empty()) out.input("elementos", in.of.elementos);
    if (!in.of.groups.empty()) out.input("groups", in.of.groups);
    return out.done();
  }
  std::string line(const scene::Ungrouping& in) const { return begin("ungroup").input("g", in.g).done(); }

  std::string mesh_line(std::string_view name, const scene::Mesh& mesh) const {
    Place material;
    if (mesh.material != scene::no_material) material = mesh.material;
    return begin(name, material)
        .input("m", mesh.m.name())
        .input("puntos", mesh.puntos)
        .input("caras", mesh.caras)
        .done();
  }
  std::string line(const scene::MeshAddition& in) const { return mesh_line("Agregar_Malla", in.mesh); }
  std::string line(const scene::MeshReplacement& in) const { return mesh_line("Reemplazar_Malla", in.mesh); }
  std::string line(const scene::MeshRemoval& in) const {
    return begin("Eliminar_Malla").input("m", in.m.name()).done();
  }
  std::string line(const scene::VertexMove& in) const {
    return begin("Mover_Vertice").input("m", in.m.name()).input("n", in.n).input("punto", in.punto.xyz()).done();
  }

  std::string line(const WrittenAddition& in) const {
    const WrittenType& type = types_[in.element.type];
    OperationLine out = begin(addition_name(type.word), in.material);
    out.input("e", in.element.id);
    for (std::size_t i = 0; i < type.attributes.size(); ++i)
      std::visit([&](const auto& value) { out.input(type.attributes[i].word, value); }, in.element.values[i]);
    return out.done();
  }
  std::string line(const WrittenRemoval& in) const {
    return begin(removal_name(types_[in.type].word)).input("e", in.e).done();
  }

  const scene::Stage& stage_;
  std::span<const WrittenType> types_;
};

}  // namespace

std::string operation_text(const ScriptStep& step, const scene::Stage& stage, std::span<const WrittenType> types) {
  return std::visit(EditLines(stage, types), step.edit);
}

}  // namespace durero::io
