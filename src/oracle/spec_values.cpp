/// The program's values as those of the text.

#include <algorithm>

#include "durero/oracle/spec.hpp"

namespace durero::oracle::spec {
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

Value rmas(const model::Rmas& value) { return Real(value.value()); }

Name input(const char* word) { return {word, "?"}; }

struct Inputs {
  Named named;
  template <class T>
  Inputs& add(const char* word, const T& part) {
    named.emplace_back(input(word), value(part));
    return *this;
  }
  Inputs& number(const char* word, double part) {
    named.emplace_back(input(word), Real(part));
    return *this;
  }

  void operator()(const model::Agregar_Esfera& in) {
    add("e", in.e).add("t", in.t).add("centro", in.centro).number("radio", in.radio);
  }
  void operator()(const model::Agregar_Cilindro& in) {
    add("e", in.e).add("t", in.t).add("centro", in.centro).number("radio", in.radio);
    add("vector", in.vector).number("altura", in.altura);
  }
  void operator()(const model::Agregar_Cono& in) {
    add("e", in.e).add("t", in.t).add("centro", in.centro).number("proporcion", in.proporcion);
    add("vector", in.vector).number("altura", in.altura);
  }
  void operator()(const model::Agregar_Elemento& in) {
    add("e", in.e).add("t", in.t).add("centro", in.centro);
    // The schema of each type declares the inputs of its own type; the sides of the disjunction for other types are
    // false by t?, so what an absent attribute would be is of no account.
    number("radio", in.radio.value_or(1)).number("proporcion", in.proporcion.value_or(1));
    add("vector", in.vector.value_or(model::Vector(1, 0, 0))).number("altura", in.altura.value_or(1));
  }
  template <class Removal>
  void operator()(const Removal& in) {
    add("e", in.e);
  }
};

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

Value value(const model::Rayo& rayo) {
  static const zed::Signature names = zed::signature({{"p", ""}, {"v", ""}});
  return Value::binding(names, {value(rayo.p()), value(rayo.v())});
}

Named components(const model::Escena& escena) {
  const Names names(escena.elementos);
  std::vector<Value> tipos;
  tipos.reserve(escena.tipos.size());
  for (const model::Tipo tipo : escena.tipos) tipos.push_back(value(tipo));
  const Value of_tipo[] = {value(model::Tipo::soy_esfera), value(model::Tipo::soy_cilindro),
                           value(model::Tipo::soy_cono)};
  const auto tipo_value = [&](model::Tipo tipo) { return of_tipo[static_cast<int>(tipo)]; };
  const auto punto = [](const model::Punto& p) { return value(p); };
  const auto vector = [](const model::Vector& v) { return value(v); };
  return {{{"elementos", ""}, Value::set(names.all())},
          {{"tipos", ""}, Value::set(std::move(tipos))},
          {{"de_que_tipo", ""}, names.function(escena.de_que_tipo, tipo_value)},
          {{"mi_centro", ""}, names.function(escena.mi_centro, punto)},
          {{"mi_radio", ""}, names.function(escena.mi_radio, rmas)},
          {{"mi_vector", ""}, names.function(escena.mi_vector, vector)},
          {{"mi_altura", ""}, names.function(escena.mi_altura, rmas)},
          {{"mi_proporcion", ""}, names.function(escena.mi_proporcion, rmas)}};
}

Value value(const model::Escena& escena) {
  Named parts = components(escena);
  std::sort(parts.begin(), parts.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  static const zed::Signature names = [&] {
    std::vector<Name> names_of_parts;
    for (const auto& [name, part] : parts) names_of_parts.push_back(name);
    return zed::signature(std::move(names_of_parts));
  }();
  std::vector<Value> values;
  for (auto& [name, part] : parts) values.push_back(std::move(part));
  return Value::binding(names, std::move(values));
}

Named inputs(const model::Operation& operation) {
  Inputs inputs;
  std::visit(inputs, operation);
  return std::move(inputs.named);
}

}  // namespace durero::oracle::spec
