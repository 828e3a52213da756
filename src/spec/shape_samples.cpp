#include "shape_samples.hpp"

#include <variant>

#include "durero/model/operaciones.hpp"
#include "durero/scene/attributes.hpp"
#include "durero/scene/promocion.hpp"
#include "durero/spec/spec.hpp"

namespace durero::spec {
namespace {

using model::Operation;

zed::Value part_value(double x) { return zed::Real(x); }
zed::Value part_value(const model::Punto& p) { return value(p); }
zed::Value part_value(const model::Vector& v) { return value(v); }
zed::Value part_value(const model::Terna& v) { return value(v); }

/// A value of Forma: the constructor of the shape's type, applied to the attributes that it has. The constructors stand
/// in the text in the order of Tipo, which is that of AnyShape.
zed::Value shape_value(const scene::AnyShape& shape) {
  const auto of_type = [&]<class Shape>(const Shape& one) -> zed::Value {
    Named attributes;
    scene::for_each_attribute<Shape, model::Escena>([&]<class TableRow>(const TableRow& row) {
      attributes.emplace_back(zed::Name{std::string(row.word), ""},
                              part_value(scene::input_of<typename TableRow::Input>(one.*row.field)));
    });
    const zed::Value constructor =
        zed::Value::atom("Forma", std::string(Shape::word), static_cast<std::uint32_t>(shape.index()));
    return std::make_shared<const zed::Constructed>(
        zed::Constructed{*constructor.get<zed::Atom>(), binding(std::move(attributes))});
  };
  return std::visit(of_type, shape);
}

/// The component of Formas, with a stroke behind its name.
std::pair<zed::Name, zed::Value> forma(const scene::Formas& formas, const std::string& stroke) {
  std::vector<zed::Value> members;
  for (const auto& [e, shape] : formas.forma) members.push_back(zed::Value::pair(value(e), shape_value(shape)));
  return {zed::Name{"forma", stroke}, zed::Value::set(std::move(members))};
}

std::vector<scene::Formas> scenes_after(const std::vector<Operation>& edits) {
  std::vector<scene::Formas> found(1);
  for (const Operation& edit : edits) {
    scene::Formas next = found.back();
    apply_lifted(next, edit);
    found.push_back(std::move(next));
  }
  return found;
}

/// The edits that go on from a scene, and the removals of what is in it.
std::vector<Operation> operations_on(const scene::Formas& formas, const std::vector<Operation>& edits) {
  std::vector<Operation> operations = edits;
  const model::Escena escena = retrieve(formas);
  for (const auto& [e, shape] : formas.forma)
    std::visit([&](const auto& removal) { operations.emplace_back(removal); },
               model::specific(escena, model::Eliminar_Elemento{e}));
  return operations;
}

}  // namespace

void add_lifted_samples(const std::vector<Operation>& edits, zed::Samples& to) {
  for (const scene::Formas& before : scenes_after(edits))
    for (const Operation& operation : operations_on(before, edits)) {
      scene::Formas after = before;
      const auto answer = apply_lifted(after, operation);
      if (!answer) continue;
      Named all = inputs(operation);
      std::erase_if(all, [](const auto& each) {
        return each.first == zed::Name{"t", "?"};
      });  // the schema's name says it
      all.push_back(forma(before, ""));
      all.push_back(forma(after, "'"));
      all.emplace_back(zed::Name{"r", "!"}, value(*answer));
      to[schema_name(operation) + "_Formas"].push_back(binding(std::move(all)));
    }
}

}  // namespace durero::spec
