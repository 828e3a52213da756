/// The program's values as those of the text.

#include <algorithm>
#include <array>
#include <optional>

#include "durero/model/malla.hpp"
#include "durero/model/operaciones.hpp"
#include "durero/model/vista.hpp"
#include "durero/scene/tablas.hpp"
#include "durero/spec/spec.hpp"

namespace durero::spec {
namespace {

using zed::Name;
using zed::Real;
using zed::Value;

const zed::Signature& xyz() {
  static const zed::Signature names = zed::signature({{"x", ""}, {"y", ""}, {"z", ""}});
  return names;
}

/// The names of a scene's elements, one value each however many components name it.
class Names {
 public:
  explicit Names(const std::set<model::Elemento>& elementos) {
    known_.reserve(elementos.size());
    for (const model::Elemento& e : elementos) known_.emplace_back(&e, value(e));
  }
  std::vector<Value> all() const {
    std::vector<Value> names;
    names.reserve(known_.size());
    for (const auto& [e, name] : known_) names.push_back(name);
    return names;
  }
  /// A component as a function. Its keys ascend, as the names do.
  template <class Image, class Make>
  Value function(const std::map<model::Elemento, Image>& pairs, Make&& make) const {
    std::vector<Value> members;
    members.reserve(pairs.size());
    auto at = known_.begin();
    for (const auto& [e, image] : pairs) {
      while (at != known_.end() && *at->first < e) ++at;
      const bool found = at != known_.end() && *at->first == e;
      members.push_back(Value::pair(found ? at->second : value(e), make(image)));
    }
    return Value::set(std::move(members));
  }

 private:
  std::vector<std::pair<const model::Elemento*, Value>> known_;
};

Name input(std::string_view word) { return {std::string(word), "?"}; }

Value number(std::uint32_t n) { return Real(static_cast<double>(n)); }

Value image(const model::Rmas& x) { return Real(x.value()); }
Value image(const model::Punto& p) { return value(p); }
Value image(const model::Vector& v) { return value(v); }
Value image(const model::Vertices& v) { return value(v.terna()); }

Value attribute_value(double x) { return Real(x); }
Value attribute_value(const model::Punto& p) { return value(p); }
Value attribute_value(const model::Vector& v) { return value(v); }
Value attribute_value(const model::Terna& v) { return value(v); }
/// The schema of each type declares the inputs of its own type; the sides of the disjunction for other types are false
/// by t?, so what an absent attribute would be is of no account.
Value attribute_value(const std::optional<double>& x) { return Real(x.value_or(1)); }
Value attribute_value(const std::optional<model::Punto>& p) { return value(p.value_or(model::Punto(0, 0, 0))); }
Value attribute_value(const std::optional<model::Vector>& v) { return value(v.value_or(model::Vector(1, 0, 0))); }
Value attribute_value(const std::optional<model::Terna>& v) {
  const model::Punto origin(0, 0, 0);
  return value(v.value_or(model::Terna{origin, origin, origin}));
}

void in_name_order(Named& parts) {
  std::sort(parts.begin(), parts.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
}
std::vector<Name> names_of(const Named& parts) {
  std::vector<Name> names;
  names.reserve(parts.size());
  for (const auto& [name, part] : parts) names.push_back(name);
  return names;
}
std::vector<Value> values_of(Named parts) {
  std::vector<Value> values;
  values.reserve(parts.size());
  for (auto& part : parts) values.push_back(std::move(part.second));
  return values;
}

/// A component that is a function of numbers.
template <class Image>
Value numbered(const std::map<model::Ordinal, Image>& pairs) {
  std::vector<Value> members;
  members.reserve(pairs.size());
  for (const auto& [n, image] : pairs) members.push_back(Value::pair(number(n), value(image)));
  return Value::set(std::move(members));
}

template <class Op>
Named inputs_of_mesh(const Op& in) {
  Named named{{input("m"), value(in.m)}};
  if constexpr (requires { in.red; }) named.emplace_back(input("red"), value(in.red));
  if constexpr (requires { in.punto; }) {
    named.emplace_back(input("n"), number(in.n));
    named.emplace_back(input("punto"), value(in.punto));
  }
  return named;
}

template <class Op>
Named inputs_of(const Op& in) {
  Named named{{input("e"), value(in.e)}};
  if constexpr (requires { in.t; }) {
    named.emplace_back(input("t"), value(in.t));
    model::for_each_attribute([&](const auto& attribute) {
      if constexpr (requires { attribute.input(in); })
        named.emplace_back(input(attribute.word), attribute_value(attribute.input(in)));
    });
  }
  return named;
}

}  // namespace

Value value(const model::Elemento& e) { return Value::atom("Elemento", e.name()); }

Value value(model::Tipo tipo) {
  return Value::atom("Tipo", std::string(model::name(tipo)), static_cast<std::uint32_t>(tipo));
}

Value value(model::Respuesta r) {
  return Value::atom("Respuesta", std::string(model::name(r)), static_cast<std::uint32_t>(r));
}

Value value(const model::ExactPoint& p) { return Value::point(xyz(), Real(p.x), Real(p.y), Real(p.z)); }

Value value(const model::Punto& p) { return Value::point(xyz(), Real(p.x()), Real(p.y()), Real(p.z())); }

Value value(const model::Vector& v) { return Value::point(xyz(), Real(v.x()), Real(v.y()), Real(v.z())); }

Value value(const model::Terna& v) {
  static const zed::Signature names = zed::signature({{"a", ""}, {"b", ""}, {"c", ""}});
  return Value::binding(names, {value(v.a), value(v.b), value(v.c)});
}

Value value(const model::Rayo& rayo) {
  static const zed::Signature names = zed::signature({{"p", ""}, {"v", ""}});
  return Value::binding(names, {value(rayo.p()), value(rayo.v())});
}

Named components(const model::Escena& escena) {
  const Names names(escena.elementos);
  std::vector<Value> tipos;
  tipos.reserve(escena.tipos.size());
  for (const model::Tipo tipo : escena.tipos) tipos.push_back(value(tipo));
  std::array<Value, model::tipo_count> of_tipo;  // one value each, however many elements are of the type
  for (std::size_t i = 0; i < of_tipo.size(); ++i) of_tipo[i] = value(static_cast<model::Tipo>(i));
  const auto tipo_value = [&](model::Tipo tipo) { return of_tipo[static_cast<std::size_t>(tipo)]; };
  Named named{{{"elementos", ""}, Value::set(names.all())},
              {{"tipos", ""}, Value::set(std::move(tipos))},
              {{"de_que_tipo", ""}, names.function(escena.de_que_tipo, tipo_value)}};
  model::for_each_attribute([&](const auto& attribute) {
    const auto of_each = [](const auto& x) { return image(x); };
    named.emplace_back(Name{"mi_" + std::string(attribute.word), ""},
                       names.function(escena.*attribute.component, of_each));
  });
  return named;
}

Value binding(Named parts) {
  in_name_order(parts);
  const zed::Signature names = zed::signature(names_of(parts));
  return Value::binding(names, values_of(std::move(parts)));
}

Value value(const model::Escena& escena) {
  Named parts = components(escena);
  in_name_order(parts);
  static const zed::Signature names = zed::signature(names_of(parts));
  return Value::binding(names, values_of(std::move(parts)));
}

Value value(const model::Cara& c) {
  static const zed::Signature names = zed::signature({{"i", ""}, {"j", ""}, {"k", ""}});
  return Value::binding(names, {number(c.i), number(c.j), number(c.k)});
}

Value value(const model::Red& red) {
  static const zed::Signature names = zed::signature({{"caras", ""}, {"puntos", ""}});
  return Value::binding(names, {numbered(red.caras()), numbered(red.puntos())});
}

Named components(const model::Mallas& s) {
  std::vector<Value> members;
  members.reserve(s.mallas.size());
  for (const auto& [m, malla] : s.mallas) members.push_back(Value::pair(value(m), value(malla.red())));
  Named named = components(s.escena);
  named.emplace_back(Name{"mallas", ""}, Value::set(std::move(members)));
  return named;
}

namespace {

Value named_value(const model::Nombre& name) { return Value::atom("Nombre", name); }

Value names_value(const std::set<model::Nombre>& names) {
  std::vector<Value> members;
  for (const model::Nombre& name : names) members.push_back(named_value(name));
  return Value::set(std::move(members));
}

Value names_value(const std::map<model::Elemento, model::Nombre>& names) {
  std::vector<Value> members;
  for (const auto& [e, name] : names) members.push_back(Value::pair(value(e), named_value(name)));
  return Value::set(std::move(members));
}

}  // namespace

Named components(const model::Vista& s) {
  Named named = components(s.escena);
  named.emplace_back(Name{"grupos", ""}, names_value(s.grupos));
  named.emplace_back(Name{"materiales", ""}, names_value(s.materiales));
  named.emplace_back(Name{"mi_grupo", ""}, names_value(s.mi_grupo));
  named.emplace_back(Name{"mi_material", ""}, names_value(s.mi_material));
  return named;
}

Value names_of_faces(const std::set<model::Elemento>& meshes, model::Ordinal count) {
  std::vector<Value> members;
  for (const model::Elemento& m : meshes)
    for (model::Ordinal n = 0; n < count; ++n)
      if (const auto name = model::nombre_cara(m, n))
        members.push_back(Value::pair(Value::pair(value(m), number(n)), value(*name)));
  return Value::set(std::move(members));
}

Value value(scene::ElementRef place) { return Value::pair(value(place.tipo), number(place.index)); }

Named components(const scene::Tablas& tables) {
  const auto function = [](const auto& pairs, auto&& argument, auto&& result) {
    std::vector<Value> members;
    members.reserve(pairs.size());
    for (const auto& [from, to] : pairs) members.push_back(Value::pair(argument(from), result(to)));
    return Value::set(std::move(members));
  };
  const auto name_value = [](const auto& x) { return value(x); };
  const auto of_each = [](const auto& x) { return image(x); };
  Named named{{{"lugar", ""}, function(tables.lugar, name_value, name_value)},
              {{"cuantos", ""}, function(tables.cuantos, name_value, [](std::uint32_t n) { return number(n); })},
              {{"nombres", ""}, function(tables.nombres, name_value, name_value)}};
  scene::for_each_column([&](const auto& column) {
    named.emplace_back(Name{std::string(column.word), ""}, function(tables.*column.values, name_value, of_each));
  });
  return named;
}

Named inputs(const model::MeshOperation& operation) {
  return std::visit([](const auto& in) { return inputs_of_mesh(in); }, operation);
}

Named change_inputs(const model::AttributeChange& change) {
  return std::visit(
      []<class Change>(const Change& in) {
        const auto& attribute = model::attribute_of<Change::component>();
        return Named{{input("e"), value(in.e)}, {input(attribute.word), attribute_value(attribute.input(in))}};
      },
      change);
}

Named change_inputs(const model::LookChange& change) {
  return std::visit(
      [](const auto& in) {
        Named named{{input("e"), value(in.e)}};
        if constexpr (requires { in.material; }) named.emplace_back(input("material"), named_value(in.material));
        if constexpr (requires { in.g; }) named.emplace_back(input("g"), named_value(in.g));
        return named;
      },
      change);
}

Named inputs(const model::Operation& operation) {
  return std::visit([](const auto& in) { return inputs_of(in); }, operation);
}

}  // namespace durero::spec
