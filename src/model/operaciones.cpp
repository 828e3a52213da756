#include "durero/model/operaciones.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <type_traits>
#include <utility>

#include "durero/model/operaciones_errors.hpp"

namespace durero::model {
namespace {

using contract::cost;

static_assert(std::is_nothrow_move_assignable_v<Escena>);

// The values that a violation is printed with.

std::string text(const Punto& p) { return fmt::format("({}, {}, {})", p.x(), p.y(), p.z()); }
std::string text(const Vector& v) { return fmt::format("({}, {}, {})", v.x(), v.y(), v.z()); }

std::string values(const Agregar_Esfera& in) {
  return fmt::format("e? = {}, t? = {}, centro? = {}, radio? = {}", in.e.name(), name(in.t), text(in.centro), in.radio);
}

std::string values(const Agregar_Cilindro& in) {
  return fmt::format("e? = {}, t? = {}, centro? = {}, radio? = {}, vector? = {}, altura? = {}", in.e.name(), name(in.t),
                     text(in.centro), in.radio, text(in.vector), in.altura);
}

std::string values(const Agregar_Cono& in) {
  return fmt::format("e? = {}, t? = {}, centro? = {}, proporcion? = {}, vector? = {}, altura? = {}", in.e.name(),
                     name(in.t), text(in.centro), in.proporcion, text(in.vector), in.altura);
}

std::string values(const Agregar_Elemento& in) {
  return std::visit([](const auto& addition) { return values(addition); }, specific(in));
}

template <class Removal>
std::string values(const Removal& in) {
  return fmt::format("e? = {}", in.e.name());
}

// The after-state of an operation.

template <class Op>
Escena with_element(Escena s, const Op& in) {
  s.elementos.insert(in.e);
  s.tipos.insert(in.t);
  s.de_que_tipo.emplace(in.e, in.t);
  s.mi_centro.emplace(in.e, in.centro);
  return s;
}

Escena after_of(const Escena& before, const Agregar_Esfera& in) {
  Escena s = with_element(before, in);
  s.mi_radio.emplace(in.e, in.radio);
  return s;
}

Escena after_of(const Escena& before, const Agregar_Cilindro& in) {
  Escena s = with_element(before, in);
  s.mi_radio.emplace(in.e, in.radio);
  s.mi_vector.emplace(in.e, in.vector);
  s.mi_altura.emplace(in.e, in.altura);
  return s;
}

Escena after_of(const Escena& before, const Agregar_Cono& in) {
  Escena s = with_element(before, in);
  s.mi_vector.emplace(in.e, in.vector);
  s.mi_altura.emplace(in.e, in.altura);
  s.mi_proporcion.emplace(in.e, in.proporcion);
  return s;
}

Escena after_of(const Escena& before, const Agregar_Elemento& in) {
  return std::visit([&](const auto& addition) { return after_of(before, addition); }, specific(in));
}

/// Every removal forgets the name in every component; the types are those that are left.
template <class Removal>
Escena after_of(const Escena& before, const Removal& in) {
  Escena s = before;
  s.elementos.erase(in.e);
  s.de_que_tipo.erase(in.e);
  s.mi_centro.erase(in.e);
  s.mi_radio.erase(in.e);
  s.mi_vector.erase(in.e);
  s.mi_altura.erase(in.e);
  s.mi_proporcion.erase(in.e);
  s.tipos.clear();
  for (const auto& [e, t] : s.de_que_tipo) s.tipos.insert(t);
  return s;
}

template <class Op>
void check_before(const Escena& before, const Op& in) {
  if (contract::evaluated(cost::audit)) check(inv(before), cost::audit, values(in));
  if (contract::evaluated(cost::normal)) check(pre(before, in), cost::normal, values(in));
}

template <class Op>
void check_after(const Escena& before, const Op& in, const Escena& after, Respuesta r) {
  if (contract::evaluated(cost::normal)) {
    check(post(before, in, after, r, cost::normal), cost::normal, values(in));
    check(inv_at(after, in.e), cost::normal, values(in));
  }
  if (contract::evaluated(cost::audit)) {
    check(post(before, in, after, r, cost::audit), cost::audit, values(in));
    check(inv(after), cost::audit, values(in));
  }
}

template <class Op>
Respuesta perform(Escena& escena, const Op& in) {
  check_before(escena, in);
  Escena after = after_of(escena, in);
  check_after(escena, in, after, in.answer);
  escena = std::move(after);  // from here on nothing can fail
  return in.answer;
}

/// \hide (t?): the name of a specific addition says the type, so some t? will do, and its own does.
template <class Op>
Op hide_t(Op in) {
  return in;
}
Agregar_Esfera hide_t(const Agregar_Esfera& in) { return {in.e, in.centro, in.radio}; }
Agregar_Cilindro hide_t(const Agregar_Cilindro& in) { return {in.e, in.centro, in.radio, in.vector, in.altura}; }
Agregar_Cono hide_t(const Agregar_Cono& in) { return {in.e, in.centro, in.proporcion, in.vector, in.altura}; }

template <class Op>
Answer perform_total(Escena& escena, const Op& in) {
  if (all_hold(pre(escena, in))) return {perform(escena, in)};
  for (const Refusal& refusal : refusals(in))
    if (std::visit([&](const auto& error) { return all_hold(pre(escena, error)); }, refusal.error))
      return {model::apply(std::as_const(escena), refusal.error), refusal.violated};
  throw std::logic_error("a precondition is broken that no error denies");
}

}  // namespace

std::variant<Agregar_Esfera, Agregar_Cilindro, Agregar_Cono> specific(const Agregar_Elemento& in) {
  const auto required = [](const auto& attribute, const char* what) {
    if (!attribute) throw std::invalid_argument(fmt::format("Agregar_Elemento: {} is absent", what));
    return *attribute;
  };
  switch (in.t) {
    case Tipo::soy_esfera:
      return Agregar_Esfera{in.e, in.centro, required(in.radio, "radio?")};
    case Tipo::soy_cilindro:
      return Agregar_Cilindro{in.e, in.centro, required(in.radio, "radio?"), required(in.vector, "vector?"),
                              required(in.altura, "altura?")};
    case Tipo::soy_cono:
      break;
  }
  return Agregar_Cono{in.e, in.centro, required(in.proporcion, "proporcion?"), required(in.vector, "vector?"),
                      required(in.altura, "altura?")};
}

std::variant<Eliminar_Esfera, Eliminar_Cilindro, Eliminar_Cono> specific(const Escena& s, const Eliminar_Elemento& in) {
  contract::require(Eliminar_Elemento_pre_1, s.elementos.contains(in.e));
  switch (s.de_que_tipo.at(in.e)) {
    case Tipo::soy_esfera:
      return Eliminar_Esfera{in.e};
    case Tipo::soy_cilindro:
      return Eliminar_Cilindro{in.e};
    case Tipo::soy_cono:
      break;
  }
  return Eliminar_Cono{in.e};
}

Respuesta apply(Escena& escena, const Operation& operation) {
  return std::visit([&](const auto& in) { return perform(escena, in); }, operation);
}

Answer apply_total(Escena& escena, const Operation& operation) {
  return std::visit([&](const auto& in) { return perform_total(escena, hide_t(in)); }, operation);
}

}  // namespace durero::model
