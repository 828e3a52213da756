#include "conform/families/members.hpp"
#include "conform/judge/scene_tree.hpp"
#include "durero/composed/figure.hpp"

namespace durero::conform {
namespace {

/// Whether the ray begins within a torus, and whether its line touches one.
bool starts_in(const Torus& torus, const model::Rayo& rayo) {
  const glm::dvec3& p = rayo.p().xyz();
  return number::sign(torus.at({p.x, p.y, p.z}, torus.radio())) <= 0;
}
bool touches(const Torus& torus, const model::Rayo& rayo) {
  const auto roots = tube_roots(torus.along(rayo, torus.radio()));
  return std::ranges::any_of(roots, [](const TubeRoot& root) { return root.is_touched; });
}

/// Whether the line of the ray has points of the convex body on both sides of its origin.
bool is_between(const composed::Figure& figure, const model::Rayo& rayo) {
  const auto ahead = figure.first(rayo, false),
             behind = figure.first({rayo.p(), model::Vector(-rayo.v().xyz())}, false);
  return (ahead.t || ahead.no_minimum) && (behind.t || behind.no_minimum);
}

}  // namespace

bool starts_in_body(const AnsweredQuery& q) {
  return q.tree && q.scene.any_of([&](scene::ElementRef e, const auto&) {
    if (const Torus* const torus = q.tree->torus(e)) return starts_in(*torus, q.query.rayo);
    const composed::Figure* const figure = q.tree->figure(e);
    return figure != nullptr && is_between(*figure, q.query.rayo);
  });
}

bool coincides_with_body(const AnsweredQuery& q) {
  const auto is_touched = [&](scene::ElementRef e, const auto&) {
    if (const Torus* const torus = q.tree->torus(e)) return touches(*torus, q.query.rayo);
    const composed::Figure* const figure = q.tree->figure(e);
    if (figure == nullptr || is_between(*figure, q.query.rayo)) return false;
    const auto points = figure->parameters(q.query.rayo, false, surface::exact::RayStretch::whole);
    return !points || points->size() == 1;
  };
  return q.hit.elementos.size() > 1 || exactly_aligned(q) || (q.tree && q.scene.any_of(is_touched));
}

}  // namespace durero::conform
