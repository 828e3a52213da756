#include "durero/model/malla.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <ranges>
#include <utility>

#include "durero/model/malla_clauses.hpp"
#include "durero/model/operaciones.hpp"

namespace durero::model {
namespace {

using contract::cost;

/// dom f = 0 ‥ # f − 1
template <class Function>
bool is_numbered(const Function& f) {
  Ordinal next = 0;
  return std::ranges::all_of(f | std::views::keys, [&](Ordinal n) { return n == next++; });
}

template <class Value>
std::map<Ordinal, Value> in_order(const std::vector<Value>& values) {
  std::map<Ordinal, Value> numbered;
  for (const Value& each : values) numbered.emplace_hint(numbered.end(), static_cast<Ordinal>(numbered.size()), each);
  return numbered;
}

/// ∀ c : ran red.caras • terna(red, c) ∈ Vertices. Precondition: is_complete(red).
bool has_triangles(const Red& red) {
  return std::ranges::all_of(red.caras() | std::views::values,
                             [&](const Cara& c) { return Vertices::contains(*terna(red, c)); });
}

/// dom f ⊆ mi_vertices, maplet by maplet.
bool is_part_of(const Family& f, const std::map<Elemento, Vertices>& mi_vertices) {
  return std::ranges::all_of(f, [&](const auto& triangle) {
    const auto maplet = mi_vertices.find(triangle.first);
    return maplet != mi_vertices.end() && maplet->second == triangle.second;
  });
}

// The after-state of an operation, of which the preconditions hold.

void erase_triangles(Escena& s, const std::set<Elemento>& names) {
  for (const Elemento& e : names) {
    s.elementos.erase(e);
    s.de_que_tipo.erase(e);
    s.mi_vertices.erase(e);
  }
}

void insert_triangles(Escena& s, const Family& family) {
  for (const auto& [e, vertices] : family) {
    s.elementos.insert(e);
    s.de_que_tipo.insert_or_assign(e, Tipo::soy_triangulo);
    s.mi_vertices.insert_or_assign(e, vertices);
  }
}

void gather_types(Escena& s) {
  s.tipos.clear();
  for (const auto& [e, t] : s.de_que_tipo) s.tipos.insert(t);
}

/// The state in which the mesh m is `red`, whether there was one of that name or not; without `red`, none is.
Mallas with_mesh(const Mallas& before, const Elemento& m, const std::optional<Red>& red) {
  Mallas after = before;
  erase_triangles(after.escena, suyos(before, m));
  after.mallas.erase(m);
  if (red) {
    insert_triangles(after.escena, familia(m, *red).value());
    after.mallas.emplace(m, Malla(*red));
  }
  gather_types(after.escena);
  return after;
}

Mallas after_of(const Mallas& before, const Agregar_Malla& in) { return with_mesh(before, in.m, in.red); }
Mallas after_of(const Mallas& before, const Eliminar_Malla& in) { return with_mesh(before, in.m, std::nullopt); }
Mallas after_of(const Mallas& before, const Reemplazar_Malla& in) { return with_mesh(before, in.m, in.red); }
Mallas after_of(const Mallas& before, const Mover_Vertice& in) {
  return with_mesh(before, in.m, movida(before.mallas.at(in.m).red(), in.n, in.punto).value());
}

// The values that a violation is printed with.

std::string text(const Red& red) {
  return fmt::format(", red? of {} points and {} faces", red.puntos().size(), red.caras().size());
}
std::string values(const Agregar_Malla& in) { return fmt::format("m? = {}", in.m.name()) + text(in.red); }
std::string values(const Eliminar_Malla& in) { return fmt::format("m? = {}", in.m.name()); }
std::string values(const Reemplazar_Malla& in) { return fmt::format("m? = {}", in.m.name()) + text(in.red); }
std::string values(const Mover_Vertice& in) {
  return fmt::format("m? = {}, n? = {}, punto? = ({}, {}, {})", in.m.name(), in.n, in.punto.x(), in.punto.y(),
                     in.punto.z());
}

void check_preconditions(const Mallas& s, const MeshOperation& operation) {
  if (!contract::evaluated(cost::normal)) return;
  Judgements all;
  for (const MeshPrecondition& each : preconditions(s, operation)) all.push_back(each.judged);
  check(all, cost::normal, [&] { return std::visit([](const auto& in) { return values(in); }, operation); });
}

Answer refuse(const Mallas& s, const MeshError& error, const clause& violated) {
  const Respuesta r = std::visit([](const auto& in) { return in.answer; }, error);
  if (contract::evaluated(cost::normal)) check(judgements(s, error, r), cost::normal);
  return {r, &violated};
}

}  // namespace

Red::Red(Points puntos, Faces caras) : puntos_(std::move(puntos)), caras_(std::move(caras)) {
  for (const Judgement& each : inv(puntos_, caras_)) contract::require(*each.what, each.holds);
}

Red Red::of(const std::vector<Punto>& puntos, const std::vector<Cara>& caras) {
  return {in_order(puntos), in_order(caras)};
}

Judgements Red::inv(const Points& puntos, const Faces& caras) {
  return {{&Red_inv_1, is_numbered(puntos)}, {&Red_inv_2, is_numbered(caras)}};
}

std::optional<Terna> terna(const Red& red, const Cara& c) {
  const auto a = red.puntos().find(c.i), b = red.puntos().find(c.j), d = red.puntos().find(c.k);
  const auto none = red.puntos().end();
  if (a == none || b == none || d == none) return std::nullopt;
  return Terna{a->second, b->second, d->second};
}

bool is_complete(const Red& red) {
  return std::ranges::all_of(red.caras() | std::views::values, [&](const Cara& c) {
    return std::ranges::all_of(std::array{c.i, c.j, c.k}, [&](Ordinal n) { return red.puntos().contains(n); });
  });
}

Malla::Malla(Red red) : red_(std::move(red)) {
  contract::require(Completa_inv_1, is_complete(red_));
  contract::require(Malla_inv_1, has_triangles(red_));
}

bool Malla::contains(const Red& red) { return is_complete(red) && has_triangles(red); }

std::optional<Elemento> nombre_cara(const Elemento& m, Ordinal n) {
  std::string name = fmt::format("{}:{}", m.name(), n);
  if (!Elemento::is_name(name)) return std::nullopt;
  return Elemento(std::move(name));
}

std::optional<Family> familia(const Elemento& m, const Red& red) {
  if (!Malla::contains(red)) return std::nullopt;
  Family family;
  for (const auto& [n, c] : red.caras()) {
    const auto name = nombre_cara(m, n);
    if (!name) return std::nullopt;
    family.emplace(*name, Vertices(*terna(red, c)));
  }
  return family;
}

std::optional<Red> movida(const Red& red, Ordinal n, const Punto& p) {
  if (!red.puntos().contains(n)) return std::nullopt;
  Red::Points puntos = red.puntos();
  puntos.insert_or_assign(n, p);
  return Red(std::move(puntos), red.caras());
}

Judgements inv(const Mallas& s) {
  Judgements all = inv(s.escena);
  bool named = true, known = true;
  for (const auto& [m, malla] : s.mallas) {
    const auto family = familia(m, malla.red());
    named = named && family;
    known = known && family && is_part_of(*family, s.escena.mi_vertices);
  }
  all.push_back({&Mallas_inv_1, named});
  all.push_back({&Mallas_inv_2, known});
  return all;
}

std::set<Elemento> suyos(const Mallas& s, const Elemento& m) {
  std::set<Elemento> names;
  if (const auto maplet = s.mallas.find(m); maplet != s.mallas.end())
    for (const auto& [e, vertices] : familia(m, maplet->second.red()).value_or(Family())) names.insert(e);
  return names;
}

std::set<Elemento> de_malla(const Mallas& s) {
  std::set<Elemento> names;
  for (const auto& [m, malla] : s.mallas) names.merge(suyos(s, m));
  return names;
}

Escena sueltas(const Mallas& s) {
  Escena others = s.escena;
  erase_triangles(others, de_malla(s));
  gather_types(others);
  return others;
}

Judgements Init_Mallas_post(const Mallas& after) {
  Judgements all = Init_post(after.escena);
  all.push_back({&Init_Mallas_post_1, after.mallas.empty()});
  return all;
}

Mallas Init_Mallas() {
  Mallas after{Init(), {}};
  if (contract::evaluated(cost::normal)) {
    check(inv(after), cost::normal);
    check(Init_Mallas_post(after), cost::normal);
  }
  return after;
}

Respuesta apply(Mallas& s, const MeshOperation& operation) {
  check_preconditions(s, operation);
  Mallas after = std::visit([&](const auto& in) { return after_of(s, in); }, operation);
  const Respuesta r = std::visit([](const auto& in) { return in.answer; }, operation);
  if (contract::evaluated(cost::normal)) {
    check(post(s, operation, after, r), cost::normal);
    check(inv(after), cost::normal);
  }
  s = std::move(after);  // from here on nothing can fail
  return r;
}

Answer apply_total(Mallas& s, const MeshOperation& operation) {
  for (const MeshPrecondition& each : preconditions(s, operation))
    if (!each.judged.holds) return refuse(s, each.denial, *each.judged.what);
  return {apply(s, operation)};
}

Answer apply_total(Mallas& s, const Operation& operation) {
  const auto removed = [](const auto& in) -> const Elemento* {
    if constexpr (requires { in.t; })
      return nullptr;
    else
      return &in.e;
  };
  const Elemento* e = std::visit(removed, operation);
  if (e && de_malla(s).contains(*e)) return refuse(s, Es_De_Malla{*e}, Fuera_De_Malla_pre_1);
  Mallas after = s;
  const Answer answer = apply_total(after.escena, operation);
  if (contract::evaluated(cost::normal)) {
    check({{&Mismas_Mallas_post_1, after.mallas == s.mallas}}, cost::normal);
    check(inv(after), cost::normal);
  }
  s = std::move(after);
  return answer;
}

Surd giro(const Rayo& rayo, const ExactPoint& a, const ExactPoint& b) {
  const ExactPoint p = rayo.p();
  return rayo.v().x() * ((a.y - p.y) * (b.z - p.z) - (a.z - p.z) * (b.y - p.y)) +
         rayo.v().y() * ((a.z - p.z) * (b.x - p.x) - (a.x - p.x) * (b.z - p.z)) +
         rayo.v().z() * ((a.x - p.x) * (b.y - p.y) - (a.y - p.y) * (b.x - p.x));
}

Surd cruce(const Rayo& rayo, const Terna& v) {
  return giro(rayo, v.a, v.b) + giro(rayo, v.b, v.c) + giro(rayo, v.c, v.a);
}

bool are_neighbours(const Terna& v, const Terna& w) {
  return Vertices::contains(v) && Vertices::contains(w) && w.a == v.b && w.b == v.a;
}

Puntos recta(const Rayo& rayo) {
  return Puntos([=](const ExactPoint& w) { return parameter(rayo, w).has_value(); });
}

}  // namespace durero::model
