#include "conform/families/candidate.hpp"

namespace durero::conform {
namespace {

using model::Tipo;
using number::sign;

/// The measure for the bounds of a disc or a triangle where the ray crosses its plane: the square of a disc's radius,
/// times that of the slope; the sum of a triangle's lados.
Dyadic whole(const ElementQuadratic& c) {
  if (c.e.tipo == Tipo::soy_disco) return square(c.size * number::shifted(c.f.B, 1));
  Dyadic sum;
  for (const auto& bound : c.f.bounds) sum += bound.C;
  return sum;
}

/// Whether the ray crosses the plane of the element at its rim or an edge.
bool is_at_edge(const ElementQuadratic& c) {
  return any_root_ahead(c, [&](const Parameter& t) {
    return within_clip(c.f, t) &&
           std::any_of(c.f.bounds.begin(), c.f.bounds.end(), [&](const auto& bound) { return sign(bound.C) == 0; });
  });
}
bool is_nearly_at_edge(const ElementQuadratic& c) {
  return any_root_ahead(c, [&](const Parameter&) {
    const Dyadic all = whole(c);
    bool within = true, at_edge = false;
    for (const auto& bound : c.f.bounds) {
      at_edge = at_edge || negligible(bound.C, all);
      within = within && (sign(bound.C) >= 0 || negligible(bound.C, all));
    }
    return within && at_edge;
  });
}

bool is_bounded(const ElementQuadratic& c) { return !c.f.bounds.empty(); }
bool is_in_plane(const ElementQuadratic& c) { return is_bounded(c) && sign(c.f.B) == 0; }
bool is_disc(const ElementQuadratic& c) { return c.e.tipo == Tipo::soy_disco; }
bool is_triangle(const ElementQuadratic& c) { return c.e.tipo == Tipo::soy_triangulo; }

/// Whether the element is a triangle whose height is 2⁻⁸ of its length or less. |e1 × e2| is their product, and the
/// length at most twice the ball's radius.
bool is_thin(const ElementQuadratic& c) {
  const Dyadic squared_length = number::shifted(square(c.size), 2);
  return is_triangle(c) && number::shifted(c.normal, 16) <= square(squared_length);
}

/// Whether the element is a triangle, and the query's hit is nearer to the origin of the ray than 2⁻¹⁶ of its size.
bool is_huge(const AnsweredQuery& q, const ElementQuadratic& c) {
  return is_triangle(c) && hits(q) && !travels_at_least(q, number::shifted(c.size, -16));
}

bool is_extreme(const AnsweredQuery& q, const ElementQuadratic& c) { return is_thin(c) || is_huge(q, c); }

}  // namespace

bool nearly_disc(const AnsweredQuery& q) {
  return any_met_element(q, is_disc) ||
         any_element(q, [](const ElementQuadratic& c) { return is_disc(c) && is_nearly_at_edge(c); });
}

bool bound_of_disc(const AnsweredQuery& q) {
  return any_met_element(q, [](const ElementQuadratic& c) { return is_disc(c) && (is_in_plane(c) || is_at_edge(c)); });
}

bool nearly_cap(const AnsweredQuery& q) {
  return any_element(q, [](const ElementQuadratic& c) { return is_inside(c) || (is_disc(c) && is_nearly_at_edge(c)); });
}

bool cap(const AnsweredQuery& q) {
  return tie(q) && any_hit_element(q, [](const ElementQuadratic& c) { return is_disc(c) && is_at_edge(c); }) &&
         any_hit_element(q, [](const ElementQuadratic& c) { return c.is_axial() && c.is_at_end(c.first()); });
}

bool nearly_edge(const AnsweredQuery& q) {
  return any_element(
      q, [](const ElementQuadratic& c) { return is_triangle(c) && (is_in_plane(c) || is_nearly_at_edge(c)); });
}

bool shared_edge(const AnsweredQuery& q) {
  return q.hit.elementos.size() > 1 && any_met_element(q, [](const ElementQuadratic& c) {
           return is_triangle(c) && (is_in_plane(c) || is_at_edge(c));
         });
}

bool nearly_sliver(const AnsweredQuery& q) {
  return any_met_element(q, [&](const ElementQuadratic& c) { return is_extreme(q, c); }) ||
         any_element(q, [](const ElementQuadratic& c) { return is_thin(c) && is_nearly_at_edge(c); });
}

bool edge_of_sliver(const AnsweredQuery& q) {
  return any_met_element(
      q, [&](const ElementQuadratic& c) { return is_extreme(q, c) && (is_in_plane(c) || is_at_edge(c)); });
}

bool nearly_coplanar(const AnsweredQuery& q) { return tie(q) || nearly_parallel(q); }

bool coplanar(const AnsweredQuery& q) { return q.hit.elementos.size() > 1 && any_met_element(q, is_bounded); }

}  // namespace durero::conform
