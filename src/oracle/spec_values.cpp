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

template <class Pairs, class Make>
Value function(const Pairs& pairs, Make&& make) {
  std::vector<Value> members;
  members.reserve(pairs.size());
  for (const auto& [e, image] : pairs) members.push_back(Value::pair(value(e), make(image)));
  return Value::set(std::move(members));
}

Value rmas(const model::Rmas& value) { return Real(value.value()); }

Name input(const char* word) { return {word, "?"}; }

struct Inputs {
  Named made;
  template <class T>
  Inputs& add(const char* word, const T& part) {
    made.emplace_back(input(word), value(part));
    return *this;
  }
  Inputs& number(const char* word, double part) {
    made.emplace_back(input(word), Real(part));
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

Value value(const model::ExactPoint& p) { return Value::binding(xyz(), {Real(p.x), Real(p.y), Real(p.z)}); }

Value value(const model::Punto& p) { return Value::binding(xyz(), {Real(p.x()), Real(p.y()), Real(p.z())}); }

Value value(const model::Vector& v) { return Value::binding(xyz(), {Real(v.x()), Real(v.y()), Real(v.z())}); }

Value value(const model::Rayo& rayo) {
  static const zed::Signature names = zed::signature({{"p", ""}, {"v", ""}});
  return Value::binding(names, {value(rayo.p()), value(rayo.v())});
}

Named components(const model::Escena& escena) {
  std::vector<Value> elementos, tipos;
  for (const model::Elemento& e : escena.elementos) elementos.push_back(value(e));
  for (const model::Tipo tipo : escena.tipos) tipos.push_back(value(tipo));
  const auto punto = [](const model::Punto& p) { return value(p); };
  const auto vector = [](const model::Vector& v) { return value(v); };
  return {{{"elementos", ""}, Value::set(std::move(elementos))},
          {{"tipos", ""}, Value::set(std::move(tipos))},
          {{"de_que_tipo", ""}, function(escena.de_que_tipo, [](model::Tipo tipo) { return value(tipo); })},
          {{"mi_centro", ""}, function(escena.mi_centro, punto)},
          {{"mi_radio", ""}, function(escena.mi_radio, rmas)},
          {{"mi_vector", ""}, function(escena.mi_vector, vector)},
          {{"mi_altura", ""}, function(escena.mi_altura, rmas)},
          {{"mi_proporcion", ""}, function(escena.mi_proporcion, rmas)}};
}

Value value(const model::Escena& escena) {
  Named parts = components(escena);
  std::sort(parts.begin(), parts.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  static const zed::Signature names = [&] {
    std::vector<Name> found;
    for (const auto& one : parts) found.push_back(one.first);
    return zed::signature(std::move(found));
  }();
  std::vector<Value> values;
  for (auto& one : parts) values.push_back(std::move(one.second));
  return Value::binding(names, std::move(values));
}

Named inputs(const model::Operation& operation) {
  Inputs made;
  std::visit(made, operation);
  return std::move(made.made);
}

}  // namespace durero::oracle::spec
