#include "conform/families/members.hpp"
#include "durero/composed/figure.hpp"

namespace durero::conform {
namespace {

/// Whether the line of the ray has points of the body on both sides of its origin.
bool is_between(const scene::Body& body, const model::Rayo& rayo) {
  const auto figure = composed::figure(body);
  const auto ahead = figure->first(rayo, false),
             behind = figure->first({rayo.p(), model::Vector(-rayo.v().xyz())}, false);
  return (ahead.t || ahead.no_minimum) && (behind.t || behind.no_minimum);
}

}  // namespace

bool starts_in_body(const AnsweredQuery& q) {
  return q.scene.any_of([&](scene::ElementRef e, const auto&) {
    const scene::Body* const body = q.scene.body(e);
    return body != nullptr && is_between(*body, q.query.rayo);
  });
}

bool coincides_with_body(const AnsweredQuery& q) {
  const auto is_touched = [&](scene::ElementRef e, const auto&) {
    const scene::Body* const body = q.scene.body(e);
    if (body == nullptr || is_between(*body, q.query.rayo)) return false;
    const auto points = composed::figure(*body)->parameters(q.query.rayo, false, surface::exact::RayStretch::whole);
    return !points || points->size() == 1;
  };
  return q.hit.elementos.size() > 1 || exactly_aligned(q) || q.scene.any_of(is_touched);
}

}  // namespace durero::conform
