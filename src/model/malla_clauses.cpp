#include "durero/model/malla_clauses.hpp"

#include <algorithm>
#include <iterator>
#include <ranges>

namespace durero::model {
namespace {

/// dom f
std::set<Elemento> names_of(const Family& f) {
  const auto names = f | std::views::keys;
  return {names.begin(), names.end()};
}

/// The family of a mesh, with its names; where it is undefined, nothing that is said of it holds.
struct NamedFamily {
  std::optional<Family> family;
  std::set<Elemento> names;

  NamedFamily(const Elemento& m, const std::optional<Red>& red)
      : family(red ? familia(m, *red) : std::nullopt), names(names_of(family.value_or(Family()))) {}
};

bool has_mesh(const Mallas& s, const Elemento& m) { return s.mallas.contains(m); }

/// mallas(m), where it is defined.
std::optional<Red> red_of(const Mallas& s, const Elemento& m) {
  const auto maplet = s.mallas.find(m);
  return maplet == s.mallas.end() ? std::nullopt : std::optional(maplet->second.red());
}

/// n ∈ dom (mallas(m)).puntos
bool has_vertex(const Mallas& s, const Elemento& m, Ordinal n) {
  const auto red = red_of(s, m);
  return red && red->puntos().contains(n);
}

/// movida(mallas(m), n, p), where it is defined.
std::optional<Red> moved(const Mallas& s, const Elemento& m, Ordinal n, const Punto& p) {
  const auto red = red_of(s, m);
  return red ? movida(*red, n, p) : std::nullopt;
}

/// Whether two sets of names have none in common.
template <class Set>
bool are_apart(const std::set<Elemento>& a, const Set& b) {
  return std::ranges::none_of(a, [&](const Elemento& e) { return b.contains(e); });
}

/// a ∖ b
std::set<Elemento> without(const std::set<Elemento>& a, const std::set<Elemento>& b) {
  std::set<Elemento> left;
  std::ranges::set_difference(a, b, std::inserter(left, left.end()));
  return left;
}

/// a ∪ b
std::set<Elemento> together(const std::set<Elemento>& a, const std::set<Elemento>& b) {
  std::set<Elemento> all;
  std::ranges::set_union(a, b, std::inserter(all, all.end()));
  return all;
}

/// names ⩤ f
template <class Value>
std::map<Elemento, Value> without(const std::map<Elemento, Value>& f, const std::set<Elemento>& names) {
  std::map<Elemento, Value> left;
  std::ranges::copy_if(f, std::inserter(left, left.end()),
                       [&](const auto& maplet) { return !names.contains(maplet.first); });
  return left;
}

/// c' = f ∪ g; false where f and g are no function together, as c' is.
template <class Value>
bool is_union(const std::map<Elemento, Value>& c, const std::map<Elemento, Value>& f,
              const std::map<Elemento, Value>& g) {
  const auto is_in = [](const auto& some, const auto& all) {
    return std::ranges::all_of(some, [&](const auto& maplet) {
      const auto found = all.find(maplet.first);
      return found != all.end() && found->second == maplet.second;
    });
  };
  return is_in(f, c) && is_in(g, c) && std::ranges::all_of(c, [&](const auto& maplet) {
           return f.contains(maplet.first) || g.contains(maplet.first);
         });
}

/// c' = f ⊕ g
template <class Value>
bool is_override(const std::map<Elemento, Value>& c, const std::map<Elemento, Value>& f,
                 const std::map<Elemento, Value>& g) {
  const auto names = g | std::views::keys;
  return is_union(c, without(f, {names.begin(), names.end()}), g);
}

/// names × { soy_triangulo }
std::map<Elemento, Tipo> triangles(const std::set<Elemento>& names) {
  std::map<Elemento, Tipo> types;
  for (const Elemento& e : names) types.emplace_hint(types.end(), e, Tipo::soy_triangulo);
  return types;
}

// The preconditions.

using Preconditions = std::vector<MeshPrecondition>;

/// What Agregar_Malla and Reemplazar_Malla ask of what is to be a mesh, beside the names that `others` has.
Preconditions of_mesh(const Elemento& m, const Red& red, const std::set<Elemento>& others,
                      const std::array<const clause*, 4>& what) {
  const NamedFamily named(m, red);
  return {{{what[0], is_complete(red)}, Cara_Incompleta{red}},
          {{what[1], Malla::contains(red)}, Caras_Alineadas{red}},
          {{what[2], named.family.has_value()}, Cara_Sin_Nombre{m, red}},
          {{what[3], named.family && are_apart(named.names, others)}, Cara_Ya_Existe{m, red}}};
}

Preconditions before(const Agregar_Malla& in, const Mallas& s) {
  Preconditions all{{{&Agregar_Malla_pre_1, !has_mesh(s, in.m)}, Malla_Ya_Existe{in.m}}};
  std::ranges::move(of_mesh(in.m, in.red, s.escena.elementos,
                            {&Agregar_Malla_pre_2, &Agregar_Malla_pre_3, &Agregar_Malla_pre_4, &Agregar_Malla_pre_5}),
                    std::back_inserter(all));
  return all;
}

Preconditions before(const Eliminar_Malla& in, const Mallas& s) {
  return {{{&Eliminar_Malla_pre_1, has_mesh(s, in.m)}, Malla_No_Existe{in.m}}};
}

Preconditions before(const Reemplazar_Malla& in, const Mallas& s) {
  Preconditions all{{{&Reemplazar_Malla_pre_1, has_mesh(s, in.m)}, Malla_No_Existe{in.m}}};
  std::ranges::move(
      of_mesh(in.m, in.red, without(s.escena.elementos, suyos(s, in.m)),
              {&Reemplazar_Malla_pre_2, &Reemplazar_Malla_pre_3, &Reemplazar_Malla_pre_4, &Reemplazar_Malla_pre_5}),
      std::back_inserter(all));
  return all;
}

Preconditions before(const Mover_Vertice& in, const Mallas& s) {
  const auto red = moved(s, in.m, in.n, in.punto);
  return {{{&Mover_Vertice_pre_1, has_mesh(s, in.m)}, Malla_No_Existe{in.m}},
          {{&Mover_Vertice_pre_2, has_vertex(s, in.m, in.n)}, Vertice_No_Existe{in.m, in.n}},
          {{&Mover_Vertice_pre_3, red && Malla::contains(*red)}, Vertice_Alineado{in.m, in.n, in.punto}}};
}

// The postconditions.

Judgements only_triangles(const Escena& before, const Escena& after) {
  return {{&Solo_Triangulos_post_1, after.mi_centro == before.mi_centro},
          {&Solo_Triangulos_post_2, after.mi_radio == before.mi_radio},
          {&Solo_Triangulos_post_3, after.mi_vector == before.mi_vector},
          {&Solo_Triangulos_post_4, after.mi_altura == before.mi_altura},
          {&Solo_Triangulos_post_5, after.mi_proporcion == before.mi_proporcion}};
}

Judgements after(const Agregar_Malla& in, const Mallas& s, const Mallas& t, Respuesta r) {
  const NamedFamily own(in.m, in.red);
  return {{&Agregar_Malla_post_1, t.escena.elementos == together(s.escena.elementos, own.names)},
          {&Agregar_Malla_post_2, is_union(t.escena.de_que_tipo, s.escena.de_que_tipo, triangles(own.names))},
          {&Agregar_Malla_post_3, is_union(t.escena.mi_vertices, s.escena.mi_vertices, *own.family)},
          {&Agregar_Malla_post_4, is_union(t.mallas, s.mallas, {{in.m, Malla(in.red)}})},
          {&Agregar_Malla_post_5, r == Respuesta::malla_agregada}};
}

Judgements after(const Eliminar_Malla& in, const Mallas& s, const Mallas& t, Respuesta r) {
  const std::set<Elemento> own = suyos(s, in.m);
  return {{&Eliminar_Malla_post_1, t.escena.elementos == without(s.escena.elementos, own)},
          {&Eliminar_Malla_post_2, t.escena.de_que_tipo == without(s.escena.de_que_tipo, own)},
          {&Eliminar_Malla_post_3, t.escena.mi_vertices == without(s.escena.mi_vertices, own)},
          {&Eliminar_Malla_post_4, t.mallas == without(s.mallas, {in.m})},
          {&Eliminar_Malla_post_5, r == Respuesta::malla_eliminada}};
}

Judgements after(const Reemplazar_Malla& in, const Mallas& s, const Mallas& t, Respuesta r) {
  const std::set<Elemento> own = suyos(s, in.m);
  const NamedFamily next(in.m, in.red);
  return {{&Reemplazar_Malla_post_1, t.escena.elementos == together(without(s.escena.elementos, own), next.names)},
          {&Reemplazar_Malla_post_2,
           is_union(t.escena.de_que_tipo, without(s.escena.de_que_tipo, own), triangles(next.names))},
          {&Reemplazar_Malla_post_3, is_union(t.escena.mi_vertices, without(s.escena.mi_vertices, own), *next.family)},
          {&Reemplazar_Malla_post_4, is_override(t.mallas, s.mallas, {{in.m, Malla(in.red)}})},
          {&Reemplazar_Malla_post_5, r == Respuesta::malla_reemplazada}};
}

Judgements after(const Mover_Vertice& in, const Mallas& s, const Mallas& t, Respuesta r) {
  const Red red = moved(s, in.m, in.n, in.punto).value();
  const NamedFamily next(in.m, red);
  return {{&Mover_Vertice_post_1, t.escena.elementos == s.escena.elementos},
          {&Mover_Vertice_post_2, t.escena.de_que_tipo == s.escena.de_que_tipo},
          {&Mover_Vertice_post_3, is_override(t.escena.mi_vertices, s.escena.mi_vertices, *next.family)},
          {&Mover_Vertice_post_4, is_override(t.mallas, s.mallas, {{in.m, Malla(red)}})},
          {&Mover_Vertice_post_5, r == Respuesta::vertice_movido}};
}

// The errors.

Judgements of_error(const Malla_Ya_Existe& in, const Mallas& s, Respuesta r) {
  return {{&Malla_Ya_Existe_pre_1, has_mesh(s, in.m)}, {&Malla_Ya_Existe_post_1, r == Respuesta::malla_ya_existe}};
}
Judgements of_error(const Malla_No_Existe& in, const Mallas& s, Respuesta r) {
  return {{&Malla_No_Existe_pre_1, !has_mesh(s, in.m)}, {&Malla_No_Existe_post_1, r == Respuesta::malla_no_existe}};
}
Judgements of_error(const Cara_Incompleta& in, const Mallas&, Respuesta r) {
  return {{&Cara_Incompleta_pre_1, !is_complete(in.red)}, {&Cara_Incompleta_post_1, r == Respuesta::cara_incompleta}};
}
Judgements of_error(const Caras_Alineadas& in, const Mallas&, Respuesta r) {
  return {{&Caras_Alineadas_pre_1, is_complete(in.red)},
          {&Caras_Alineadas_pre_2, !Malla::contains(in.red)},
          {&Caras_Alineadas_post_1, r == Respuesta::vertices_alineados}};
}
Judgements of_error(const Cara_Sin_Nombre& in, const Mallas&, Respuesta r) {
  return {{&Cara_Sin_Nombre_pre_1, Malla::contains(in.red)},
          {&Cara_Sin_Nombre_pre_2, !familia(in.m, in.red)},
          {&Cara_Sin_Nombre_post_1, r == Respuesta::cara_sin_nombre}};
}
Judgements of_error(const Cara_Ya_Existe& in, const Mallas& s, Respuesta r) {
  const NamedFamily named(in.m, in.red);
  return {{&Cara_Ya_Existe_pre_1, named.family.has_value()},
          {&Cara_Ya_Existe_pre_2, named.family && !are_apart(named.names, without(s.escena.elementos, suyos(s, in.m)))},
          {&Cara_Ya_Existe_post_1, r == Respuesta::elemento_ya_existe}};
}
Judgements of_error(const Vertice_No_Existe& in, const Mallas& s, Respuesta r) {
  return {{&Vertice_No_Existe_pre_1, has_mesh(s, in.m)},
          {&Vertice_No_Existe_pre_2, has_mesh(s, in.m) && !has_vertex(s, in.m, in.n)},
          {&Vertice_No_Existe_post_1, r == Respuesta::vertice_no_existe}};
}
Judgements of_error(const Vertice_Alineado& in, const Mallas& s, Respuesta r) {
  const auto red = moved(s, in.m, in.n, in.punto);
  return {{&Vertice_Alineado_pre_1, has_mesh(s, in.m)},
          {&Vertice_Alineado_pre_2, has_vertex(s, in.m, in.n)},
          {&Vertice_Alineado_pre_3, red && !Malla::contains(*red)},
          {&Vertice_Alineado_post_1, r == Respuesta::vertices_alineados}};
}
Judgements of_error(const Es_De_Malla& in, const Mallas& s, Respuesta r) {
  return {{&Es_De_Malla_pre_1, de_malla(s).contains(in.e)}, {&Es_De_Malla_post_1, r == Respuesta::es_de_malla}};
}

}  // namespace

Judgements judgements(const Mallas& s, const MeshError& error, Respuesta r) {
  return std::visit([&](const auto& in) { return of_error(in, s, r); }, error);
}

std::vector<MeshPrecondition> preconditions(const Mallas& s, const MeshOperation& operation) {
  return std::visit([&](const auto& in) { return before(in, s); }, operation);
}

Judgements post(const Mallas& s, const MeshOperation& operation, const Mallas& t, Respuesta r) {
  Judgements all = only_triangles(s.escena, t.escena);
  std::ranges::copy(std::visit([&](const auto& in) { return after(in, s, t, r); }, operation), std::back_inserter(all));
  return all;
}

}  // namespace durero::model
