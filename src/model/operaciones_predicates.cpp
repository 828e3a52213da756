#include "durero/model/operaciones_predicates.hpp"

#include <utility>

namespace durero::model {
namespace {

using contract::cost;

/// Both states of an operation on e?. Each member says one form of predicate of the text, at the price asked for:
/// the whole one, or what changed of it, which is the size of a component and its value at e?.
class Delta {
 public:
  Delta(const Escena& before, const Elemento& e, const Escena& after, cost price)
      : before_(before), e_(e), after_(after), whole_(price == cost::audit) {}

  /// elementos' = elementos ∪ { e? }
  bool added() const {
    if (!whole_) return after_.elementos.contains(e_) && grown(&Escena::elementos);
    auto expected = before_.elementos;
    expected.insert(e_);
    return after_.elementos == expected;
  }

  /// elementos' = elementos ∖ { e? }
  bool removed() const {
    if (!whole_) return !after_.elementos.contains(e_) && shrunk(&Escena::elementos);
    auto expected = before_.elementos;
    expected.erase(e_);
    return after_.elementos == expected;
  }

  /// c' = c ∪ { e? ↦ x }; false where x is no value of c's, and where c has another value at e?: the union is then no
  /// function, as c' is.
  template <class T, class X>
  bool with(std::map<Elemento, T> Escena::*c, const X& x) const {
    if (!whole_) return maps(after_.*c, x) && grown(c);
    if (!maps(after_.*c, x)) return false;
    if ((before_.*c).contains(e_)) return after_.*c == before_.*c;
    auto others = after_.*c;
    others.erase(e_);
    return others == before_.*c;
  }

  /// c' = { e? } ⩤ c
  template <class T>
  bool without(std::map<Elemento, T> Escena::*c) const {
    if (!whole_) return !(after_.*c).contains(e_) && shrunk(c);
    auto expected = before_.*c;
    expected.erase(e_);
    return after_.*c == expected;
  }

  /// c' = c
  template <class T>
  bool same(std::map<Elemento, T> Escena::*c) const {
    if (whole_) return after_.*c == before_.*c;
    return (after_.*c).size() == (before_.*c).size() && (after_.*c).contains(e_) == (before_.*c).contains(e_);
  }

 private:
  template <class C>
  bool grown(C Escena::*c) const {
    return (after_.*c).size() == (before_.*c).size() + !(before_.*c).contains(e_);
  }
  template <class C>
  bool shrunk(C Escena::*c) const {
    return (after_.*c).size() + (before_.*c).contains(e_) == (before_.*c).size();
  }

  bool maps(const std::map<Elemento, Rmas>& c, double x) const {
    const auto maplet = c.find(e_);
    return maplet != c.end() && maplet->second.value() == x;
  }
  template <class T>
  bool maps(const std::map<Elemento, T>& c, const T& x) const {
    const auto maplet = c.find(e_);
    return maplet != c.end() && maplet->second == x;
  }

  const Escena& before_;
  const Elemento& e_;
  const Escena& after_;
  bool whole_;
};

}  // namespace

bool is_of_type(const Escena& escena, const Elemento& e, Tipo t) {
  const auto maplet = escena.de_que_tipo.find(e);
  return maplet != escena.de_que_tipo.end() && maplet->second == t;
}

Judgements pre(const Escena& s, const Agregar_Esfera& in) {
  return {{&Agregar_Elemento_pre_1, !s.elementos.contains(in.e)},
          {&Agregar_Esfera_pre_1, in.t == Tipo::soy_esfera},
          {&Agregar_Esfera_pre_2, Rmas::contains(in.radio)}};
}

Judgements pre(const Escena& s, const Agregar_Cilindro& in) {
  return {{&Agregar_Elemento_pre_1, !s.elementos.contains(in.e)},
          {&Agregar_Cilindro_pre_1, in.t == Tipo::soy_cilindro},
          {&Agregar_Cilindro_pre_2, Rmas::contains(in.radio)},
          {&Agregar_Cilindro_pre_3, Unitario::contains(in.vector)},
          {&Agregar_Cilindro_pre_4, Rmas::contains(in.altura)}};
}

Judgements pre(const Escena& s, const Agregar_Cono& in) {
  return {{&Agregar_Elemento_pre_1, !s.elementos.contains(in.e)},
          {&Agregar_Cono_pre_1, in.t == Tipo::soy_cono},
          {&Agregar_Cono_pre_2, Rmas::contains(in.proporcion)},
          {&Agregar_Cono_pre_3, Unitario::contains(in.vector)},
          {&Agregar_Cono_pre_4, Rmas::contains(in.altura)}};
}

Judgements post(const Escena& before, const Agregar_Esfera& in, const Escena& after, Respuesta r, cost price) {
  const Delta delta(before, in.e, after, price);
  return {{&Agregar_Elemento_post_1, delta.added()},
          {&Agregar_Elemento_post_2, delta.with(&Escena::de_que_tipo, in.t)},
          {&Agregar_Esfera_post_1, delta.with(&Escena::mi_centro, in.centro)},
          {&Agregar_Esfera_post_2, delta.with(&Escena::mi_radio, in.radio)},
          {&Agregar_Esfera_post_3, delta.same(&Escena::mi_vector)},
          {&Agregar_Esfera_post_4, delta.same(&Escena::mi_altura)},
          {&Agregar_Esfera_post_5, delta.same(&Escena::mi_proporcion)},
          {&Agregar_Esfera_post_6, r == Respuesta::esfera_agregada}};
}

Judgements post(const Escena& before, const Agregar_Cilindro& in, const Escena& after, Respuesta r, cost price) {
  const Delta delta(before, in.e, after, price);
  return {{&Agregar_Elemento_post_1, delta.added()},
          {&Agregar_Elemento_post_2, delta.with(&Escena::de_que_tipo, in.t)},
          {&Agregar_Cilindro_post_1, delta.with(&Escena::mi_centro, in.centro)},
          {&Agregar_Cilindro_post_2, delta.with(&Escena::mi_radio, in.radio)},
          {&Agregar_Cilindro_post_3, delta.with(&Escena::mi_vector, in.vector)},
          {&Agregar_Cilindro_post_4, delta.with(&Escena::mi_altura, in.altura)},
          {&Agregar_Cilindro_post_5, delta.same(&Escena::mi_proporcion)},
          {&Agregar_Cilindro_post_6, r == Respuesta::cilindro_agregado}};
}

Judgements post(const Escena& before, const Agregar_Cono& in, const Escena& after, Respuesta r, cost price) {
  const Delta delta(before, in.e, after, price);
  return {{&Agregar_Elemento_post_1, delta.added()},
          {&Agregar_Elemento_post_2, delta.with(&Escena::de_que_tipo, in.t)},
          {&Agregar_Cono_post_1, delta.with(&Escena::mi_centro, in.centro)},
          {&Agregar_Cono_post_2, delta.same(&Escena::mi_radio)},
          {&Agregar_Cono_post_3, delta.with(&Escena::mi_vector, in.vector)},
          {&Agregar_Cono_post_4, delta.with(&Escena::mi_altura, in.altura)},
          {&Agregar_Cono_post_5, delta.with(&Escena::mi_proporcion, in.proporcion)},
          {&Agregar_Cono_post_6, r == Respuesta::cono_agregado}};
}

Judgements pre(const Escena& s, const Eliminar_Esfera& in) {
  return {{&Eliminar_Elemento_pre_1, s.elementos.contains(in.e)},
          {&Eliminar_Esfera_pre_1, is_of_type(s, in.e, Tipo::soy_esfera)}};
}

Judgements pre(const Escena& s, const Eliminar_Cilindro& in) {
  return {{&Eliminar_Elemento_pre_1, s.elementos.contains(in.e)},
          {&Eliminar_Cilindro_pre_1, is_of_type(s, in.e, Tipo::soy_cilindro)}};
}

Judgements pre(const Escena& s, const Eliminar_Cono& in) {
  return {{&Eliminar_Elemento_pre_1, s.elementos.contains(in.e)},
          {&Eliminar_Cono_pre_1, is_of_type(s, in.e, Tipo::soy_cono)}};
}

Judgements post(const Escena& before, const Eliminar_Esfera& in, const Escena& after, Respuesta r, cost price) {
  const Delta delta(before, in.e, after, price);
  return {{&Eliminar_Elemento_post_1, delta.removed()},
          {&Eliminar_Elemento_post_2, delta.without(&Escena::de_que_tipo)},
          {&Eliminar_Esfera_post_1, delta.without(&Escena::mi_centro)},
          {&Eliminar_Esfera_post_2, delta.without(&Escena::mi_radio)},
          {&Eliminar_Esfera_post_3, delta.same(&Escena::mi_vector)},
          {&Eliminar_Esfera_post_4, delta.same(&Escena::mi_altura)},
          {&Eliminar_Esfera_post_5, delta.same(&Escena::mi_proporcion)},
          {&Eliminar_Esfera_post_6, r == Respuesta::esfera_eliminada}};
}

Judgements post(const Escena& before, const Eliminar_Cilindro& in, const Escena& after, Respuesta r, cost price) {
  const Delta delta(before, in.e, after, price);
  return {{&Eliminar_Elemento_post_1, delta.removed()},
          {&Eliminar_Elemento_post_2, delta.without(&Escena::de_que_tipo)},
          {&Eliminar_Cilindro_post_1, delta.without(&Escena::mi_centro)},
          {&Eliminar_Cilindro_post_2, delta.without(&Escena::mi_radio)},
          {&Eliminar_Cilindro_post_3, delta.without(&Escena::mi_vector)},
          {&Eliminar_Cilindro_post_4, delta.without(&Escena::mi_altura)},
          {&Eliminar_Cilindro_post_5, delta.same(&Escena::mi_proporcion)},
          {&Eliminar_Cilindro_post_6, r == Respuesta::cilindro_eliminado}};
}

Judgements post(const Escena& before, const Eliminar_Cono& in, const Escena& after, Respuesta r, cost price) {
  const Delta delta(before, in.e, after, price);
  return {{&Eliminar_Elemento_post_1, delta.removed()},
          {&Eliminar_Elemento_post_2, delta.without(&Escena::de_que_tipo)},
          {&Eliminar_Cono_post_1, delta.without(&Escena::mi_centro)},
          {&Eliminar_Cono_post_2, delta.same(&Escena::mi_radio)},
          {&Eliminar_Cono_post_3, delta.without(&Escena::mi_vector)},
          {&Eliminar_Cono_post_4, delta.without(&Escena::mi_altura)},
          {&Eliminar_Cono_post_5, delta.without(&Escena::mi_proporcion)},
          {&Eliminar_Cono_post_6, r == Respuesta::cono_eliminado}};
}

Judgements pre(const Escena& s, const Agregar_Elemento& in) {
  return std::visit([&](const auto& addition) { return pre(s, addition); }, specific(in));
}

Judgements post(const Escena& before, const Agregar_Elemento& in, const Escena& after, Respuesta r, cost price) {
  Judgements all = std::visit(
      [&](const auto& addition) { return post(before, addition, after, addition.answer, price); }, specific(in));
  all.pop_back();  // \hide (r!): the answer of the specific addition, the last of its clauses, is hidden
  all.push_back({&Elemento_Agregado_post_1, r == Respuesta::elemento_agregado});
  return all;
}

Judgements pre(const Escena& s, const Eliminar_Elemento& in) {
  return {{&Eliminar_Elemento_pre_1, s.elementos.contains(in.e)}};  // one of the three types is then its own
}

Judgements post(const Escena& before, const Eliminar_Elemento& in, const Escena& after, Respuesta r, cost price) {
  Judgements all = std::visit([&](const auto& removal) { return post(before, removal, after, removal.answer, price); },
                              specific(before, in));
  all.pop_back();
  all.push_back({&Elemento_Eliminado_post_1, r == Respuesta::elemento_eliminado});
  return all;
}

Judgements pre(const Escena& before, const Operation& operation) {
  return std::visit([&](const auto& in) { return pre(before, in); }, operation);
}

Judgements post(const Escena& before, const Operation& operation, const Escena& after, Respuesta r, cost price) {
  return std::visit([&](const auto& in) { return post(before, in, after, r, price); }, operation);
}

}  // namespace durero::model
