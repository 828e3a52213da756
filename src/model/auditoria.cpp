#include "durero/model/auditoria.hpp"

#include <algorithm>
#include <ranges>

#include "durero/model/proyeccion.hpp"
#include "means.hpp"

namespace durero::model {
namespace {

using number::Rational;

/// The edges of all faces, the lesser number first; an edge from a point to itself is none.
std::set<Arista> undirected(const Red& red) {
  std::set<Arista> all;
  for (const Cara& c : red.caras() | std::views::values)
    for (const auto& [i, j] : aristas(c))
      if (i != j) all.emplace(std::min(i, j), std::max(i, j));
  return all;
}

template <class Holds>
std::set<Arista> edges_where(const Red& red, const Holds& holds) {
  std::set<Arista> found;
  for (const Arista& each : undirected(red))
    if (holds(de_arista(red, each.first, each.second).size())) found.insert(each);
  return found;
}

template <class Holds>
std::set<Ordinal> faces_where(const Red& red, const Holds& holds) {
  std::set<Ordinal> found;
  for (const auto& [n, c] : red.caras())
    if (holds(n, c)) found.insert(n);
  return found;
}

std::size_t count_walks(const Red& red, const Arista& edge) {
  return faces_where(red, [&](Ordinal, const Cara& c) { return aristas(c).contains(edge); }).size();
}

/// The point of a number, which a complete mesh has.
const Punto& point(const Red& red, Ordinal n) { return red.puntos().at(n); }

std::size_t count_common(const Red& red, Ordinal n, Ordinal m) {
  const std::set<Ordinal> of_m = esquinas(red.caras().at(m));
  return static_cast<std::size_t>(
      std::ranges::count_if(esquinas(red.caras().at(n)), [&](Ordinal each) { return of_m.contains(each); }));
}

bool have_common(const Cara& a, const Cara& b) {
  const std::set<Ordinal> of_b = esquinas(b);
  return std::ranges::any_of(esquinas(a), [&](Ordinal n) { return of_b.contains(n); });
}

std::vector<Punto> points(const Red& red, const std::set<Ordinal>& numbers) {
  std::vector<Punto> all;
  for (const Ordinal n : numbers) all.push_back(point(red, n));
  return all;
}

/// Whether two faces have more points in common than the corners that both have, or what is between these.
bool cross(const Red& red, const std::set<Ordinal>& a, const std::set<Ordinal>& b) {
  std::set<Ordinal> common;
  std::ranges::set_intersection(a, b, std::inserter(common, common.end()));
  return common.size() < 3 && have_mean_outside(points(red, a), points(red, b), points(red, common));
}

/// Whether some of the faces of a point share that point alone with the others: those that are reached from the first
/// by two common points, where these are not all.
bool fall_apart(const Red& red, const std::set<Ordinal>& faces) {
  std::set<Ordinal> part, next{*faces.begin()};
  while (!next.empty()) {
    part.merge(next);
    next.clear();
    for (const Ordinal n : faces)
      if (!part.contains(n) && std::ranges::any_of(part, [&](Ordinal m) { return count_common(red, n, m) > 1; }))
        next.insert(n);
  }
  return part != faces;
}

/// The ray from a point towards (1, k, k²).
struct CurveRay {
  Punto from;
  std::array<int, 3> direction;
  bool meets(const Red& red, const std::set<Ordinal>& corners) const {
    return meets_mean(from, direction, points(red, corners));
  }
};

bool meets_edge(const Red& red, const CurveRay& ray) {
  return std::ranges::any_of(undirected(red), [&](const Arista& e) { return ray.meets(red, {e.first, e.second}); });
}

/// The least closed set that has a face: what touches it, and what touches that.
std::set<Ordinal> closure(const Red& red, Ordinal from) {
  std::set<Ordinal> reached{from};
  while (!is_closed(red, reached))
    for (const auto& [m, c] : red.caras())
      if (std::ranges::any_of(reached, [&](Ordinal n) { return have_common(red.caras().at(n), c); })) reached.insert(m);
  return reached;
}

}  // namespace

std::set<Arista> aristas(const Cara& c) { return {{c.i, c.j}, {c.j, c.k}, {c.k, c.i}}; }

std::set<Ordinal> de_arista(const Red& red, Ordinal i, Ordinal j) {
  return faces_where(red, [&](Ordinal, const Cara& c) {
    const std::set<Arista> edges = aristas(c);
    return edges.contains({i, j}) || edges.contains({j, i});
  });
}

std::set<Arista> abiertas(const Red& red) {
  return edges_where(red, [](std::size_t faces) { return faces == 1; });
}

std::set<Arista> multiples(const Red& red) {
  return edges_where(red, [](std::size_t faces) { return faces > 2; });
}

std::set<Arista> discordes(const Red& red) {
  std::set<Arista> found;
  for (const auto& [i, j] : undirected(red))
    for (const Arista& way : {Arista{i, j}, Arista{j, i}})
      if (count_walks(red, way) > 1) found.insert(way);
  return found;
}

std::set<Ordinal> repetidas(const Red& red) {
  return faces_where(red, [&](Ordinal n, const Cara& c) {
    return std::ranges::any_of(
        red.caras(), [&](const auto& other) { return other.first < n && esquinas(other.second) == esquinas(c); });
  });
}

std::set<Ordinal> degeneradas(const Red& red) {
  return faces_where(red, [&](Ordinal, const Cara& c) { return !Vertices::contains(terna(red, c).value()); });
}

std::set<std::array<Ordinal, 3>> uniones_en_t(const Red& red) {
  std::set<Ordinal> used;
  for (const Cara& c : red.caras() | std::views::values) used.merge(esquinas(c));
  std::set<std::array<Ordinal, 3>> found;
  for (const Ordinal v : used)
    for (const auto& [i, j] : undirected(red))
      if (point(red, i) != point(red, j) && entre(point(red, i), point(red, j), point(red, v))) found.insert({v, i, j});
  return found;
}

std::set<Ordinal> esquinas(const Cara& c) { return {c.i, c.j, c.k}; }

bool is_in_envolvente(const Red& red, const std::set<Ordinal>& s, const Punto& w) { return is_mean(points(red, s), w); }

std::set<std::pair<Ordinal, Ordinal>> cruzadas(const Red& red) {
  std::set<std::pair<Ordinal, Ordinal>> found;
  for (const auto& [m, a] : red.caras())
    for (const auto& [n, b] : red.caras())
      if (m < n && cross(red, esquinas(a), esquinas(b))) found.insert({m, n});
  return found;
}

std::set<Ordinal> de_punto(const Red& red, Ordinal v) {
  return faces_where(red, [&](Ordinal, const Cara& c) { return esquinas(c).contains(v); });
}

std::set<Ordinal> singulares(const Red& red) {
  std::set<Ordinal> found;
  for (const Cara& c : red.caras() | std::views::values)
    for (const Ordinal v : esquinas(c))
      if (fall_apart(red, de_punto(red, v))) found.insert(v);
  return found;
}

bool is_closed(const Red& red, const std::set<Ordinal>& s) {
  return !s.empty() && std::ranges::all_of(red.caras(), [&](const auto& m) {
    return s.contains(m.first) ||
           std::ranges::none_of(s, [&](Ordinal n) { return have_common(red.caras().at(n), m.second); });
  });
}

std::set<std::set<Ordinal>> piezas(const Red& red) {
  std::set<std::set<Ordinal>> all;
  for (const Ordinal n : red.caras() | std::views::keys) all.insert(closure(red, n));
  return all;
}

Rational determinante(const Terna& v) {
  const auto r = [](double x) { return Rational(x); };
  return r(v.a.x()) * (r(v.b.y()) * r(v.c.z()) - r(v.b.z()) * r(v.c.y())) +
         r(v.a.y()) * (r(v.b.z()) * r(v.c.x()) - r(v.b.x()) * r(v.c.z())) +
         r(v.a.z()) * (r(v.b.x()) * r(v.c.y()) - r(v.b.y()) * r(v.c.x()));
}

Rational volumen(const Red& red) {
  Rational sum = 0;
  for (const Cara& c : red.caras() | std::views::values) sum += determinante(terna(red, c).value());
  return sum / 6;
}

bool is_even(const Red& red) {
  return Malla::contains(red) && std::ranges::all_of(undirected(red), [&](const Arista& e) {
           return de_arista(red, e.first, e.second).size() % 2 == 0;
         });
}

bool is_in_piel(const Red& red, const Punto& w) {
  return std::ranges::any_of(red.caras() | std::views::values,
                             [&](const Cara& c) { return is_in_envolvente(red, esquinas(c), w); });
}

/// The plane of a point and an edge has two of the directions at most, since no three of them lie in one plane: the
/// search for a ray that meets no edge ends.
bool is_enclosed(const Red& red, const Punto& w) {
  if (!is_even(red) || is_in_piel(red, w)) return false;
  CurveRay ray{w, {1, 1, 1}};
  for (int k = 2; meets_edge(red, ray); ++k) ray.direction = {1, k, k * k};
  return faces_where(red, [&](Ordinal, const Cara& c) { return ray.meets(red, esquinas(c)); }).size() % 2 == 1;
}

}  // namespace durero::model
