#include "conform/judge/remedy.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "conform/judge/allowance.hpp"

namespace durero::conform {
namespace {

/// The ratio from which on sizes and ways are small or large. Scenes of the generic family are within it.
constexpr double far = 32;

/// The numbers of a draft's points, its origin and its v.
std::vector<glm::dvec3*> vectors(Draft& draft) {
  std::vector<glm::dvec3*> all = {&draft.p, &draft.v};
  for (Draft::Element& element : draft.elements) {
    const Places of = places(element.shape);
    all.insert(all.end(), of.points.begin(), of.points.end());
    all.insert(all.end(), of.axes.begin(), of.axes.end());
  }
  return all;
}

template <class Change>
Draft changed(const FailedQuestion& failed, Change change) {
  Draft draft = failed.draft;
  change(draft);
  return draft;
}

Remedy plus_zeros(const FailedQuestion& failed) {
  bool has = false;
  Draft draft = failed.draft;
  for (glm::dvec3* of : vectors(draft)) {
    for (int i = 0; i < 3; ++i) {
      const bool is_minus_zero = (*of)[i] == 0 && std::signbit((*of)[i]);
      if (is_minus_zero) (*of)[i] = 0;
      has = has || is_minus_zero;
    }
  }
  if (!has) return {};
  return {{std::move(draft)}};
}

/// v/|v|, and as a control a v whose direction was rounded as v/|v| is and whose length is no nearer to 1.
Remedy unit_direction(const FailedQuestion& failed, const Profile& profile) {
  constexpr double nearly_1 = 0x1p-20;
  if (!std::isfinite(failed.length) || std::abs(failed.length - 1) < nearly_1) return {};
  const glm::dvec3 rounded =
      profile.format == NumberFormat::binary32 ? glm::dvec3(glm::vec3(failed.unit)) : failed.unit;
  const double length = failed.length * (failed.length > 1 ? 1.5 : 0.75);
  return {{changed(failed, [&](Draft& draft) { draft.v = failed.unit; })},
          changed(failed, [&](Draft& draft) { draft.v = length * rounded; })};
}

Remedy size_near_1(const FailedQuestion& failed) {
  return {{changed(failed, [&](Draft& draft) { scale_with_t(draft, -std::ilogb(failed.size)); })}};
}

Remedy moved_to_zero(const FailedQuestion& failed) {
  return {{changed(failed, [&](Draft& draft) { translate(draft, -failed.middle); })}};
}

/// The origin two sizes before the point.
Remedy nearer(const FailedQuestion& failed) {
  return {{changed(failed, [&](Draft& draft) { draft.p += (failed.distance - 2 * failed.size) * failed.unit; })}};
}

/// The way by which farther_back() moves the origin, to before the whole target.
double way_back(const FailedQuestion& failed) {
  return glm::length(failed.middle - failed.draft.p) + 2 * failed.extent;
}

Remedy farther_back(const FailedQuestion& failed) {
  return {{changed(failed, [&](Draft& draft) { draft.p -= way_back(failed) * failed.unit; })}};
}

Remedy target_alone(const FailedQuestion& failed) {
  return {{changed(failed, [&](Draft& draft) { draft.elements = {failed.draft.elements[failed.target]}; })}};
}

Remedy turned_round(const FailedQuestion& failed) {
  return {{changed(failed, [](Draft& draft) {
    for (Draft::Element& element : draft.elements) {
      const Places of = places(element.shape);
      if (of.points.size() == 3) std::swap(*of.points[1], *of.points[2]);
    }
  })}};
}

/// A rotation whose matrix has no zeros, by ninths.
glm::dvec3 rotated(const glm::dvec3& w) {
  return glm::dvec3(8 * w.x + w.y - 4 * w.z, -4 * w.x + 4 * w.y - 7 * w.z, w.x + 8 * w.y + 4 * w.z) / 9.0;
}

Remedy turned(const FailedQuestion& failed) {
  return {{changed(failed, [](Draft& draft) {
    for (glm::dvec3* of : vectors(draft)) *of = rotated(*of);
  })}};
}

/// x, y and z in the two other orders that keep their orientation.
Remedy permuted(const FailedQuestion& failed) {
  const auto once = [](Draft& draft) {
    for (glm::dvec3* of : vectors(draft)) *of = glm::dvec3(of->y, of->z, of->x);
  };
  const Draft first = changed(failed, once);
  Draft second = first;
  once(second);
  return {{first, std::move(second)}};
}

/// The ray from the same origin to the middle of the target.
Remedy aimed(const FailedQuestion& failed) {
  const glm::dvec3 way = failed.middle - failed.draft.p;
  if (way == glm::dvec3(0)) return {};
  return {{changed(failed, [&](Draft& draft) { draft.v = failed.length / glm::length(way) * way; })}};
}

bool has_zero(const glm::dvec3& w) { return w.x == 0 || w.y == 0 || w.z == 0; }

bool is_parallel(const FailedQuestion& failed) {
  Draft draft = failed.draft;
  const Places of = places(draft.elements[failed.target].shape);
  return has_zero(draft.v) || std::ranges::any_of(of.axes, [](const glm::dvec3* axis) { return has_zero(*axis); });
}

bool meets(const SuiteCase& of, const std::string& element) {
  return std::ranges::any_of(of.truths[0].hit.elementos,
                             [&](scene::ElementRef e) { return of.the_case.scene.name(e).name() == element; });
}

/// Whether the two are hits of an element that both have first, or misses.
bool is_same_answer(const SuiteCase& a, const SuiteCase& b) {
  const scene::Hit &first = a.truths[0].hit, &second = b.truths[0].hit;
  if (first.resultado != second.resultado) return false;
  if (first.resultado == model::Resultado::miss) return true;
  return std::ranges::any_of(first.elementos,
                             [&](scene::ElementRef e) { return meets(b, a.the_case.scene.name(e).name()); });
}

/// The place of the first point of a ray that began farther back, as a way from the old origin.
double way_to_point(const FailedQuestion& failed, const SuiteCase& back) {
  return back.truths[0].hit.t * failed.length - way_back(failed);
}

}  // namespace

std::vector<Draft> shaken(const Draft& given, const Profile& profile) {
  const double by = 6 * unit(profile.format);
  std::vector<Draft> all;
  for (const glm::dvec3& way : {glm::dvec3(1, -1, 1), glm::dvec3(-1, 1, 1), glm::dvec3(1, 1, -1), glm::dvec3(-1)}) {
    Draft draft = given;
    draft.p += by * largest(draft.p) * way;
    draft.v += by * largest(draft.v) * glm::dvec3(way.y, way.z, way.x);
    all.push_back(std::move(draft));
  }
  return all;
}

Remedy remedy_of(Trait trait, const FailedQuestion& failed, const SuiteCase& of, const Profile& profile) {
  const auto where = [](bool has, Remedy remedy) { return has ? std::move(remedy) : Remedy{}; };
  switch (trait) {
    case Trait::minus_zero:
      return plus_zeros(failed);
    case Trait::not_unit:
      return unit_direction(failed, profile);
    case Trait::small:
      return where(failed.size < 1 / far, size_near_1(failed));
    case Trait::large:
      return where(failed.size > far, size_near_1(failed));
    case Trait::far_from_zero:
      return where(largest(failed.middle) > far * failed.size, moved_to_zero(failed));
    case Trait::far_origin:
      return where(failed.distance > far * failed.size, nearer(failed));
    case Trait::inside:
    case Trait::near_surface:
      return farther_back(failed);
    case Trait::several:
      return where(failed.draft.elements.size() > 1, target_alone(failed));
    case Trait::one_sided:
      return where(failed.has_sides, turned_round(failed));
    case Trait::coincidence:
      return where(of.truths[0].ambiguity != Ambiguity::none, Remedy{shaken(failed.draft, profile)});
    case Trait::parallel:
      return where(is_parallel(failed), turned(failed));
    case Trait::one_axis:
      return permuted(failed);
    case Trait::grazing:
      return aimed(failed);
    case Trait::none:
      return {};
  }
  contract::unreachable();
}

bool corresponds(Trait trait, const FailedQuestion& failed, const SuiteCase& of, const SuiteCase& cured) {
  const double near = failed.size / far;
  const auto is_target = [&] { return meets(cured, failed.draft.elements[failed.target].name); };
  if (trait == Trait::coincidence) return true;
  if (trait == Trait::grazing) return cured.truths[0].hit.resultado == model::Resultado::hit;
  if (trait == Trait::inside) return is_target() && way_to_point(failed, cured) < -near;
  if (trait == Trait::near_surface) return is_target() && std::abs(way_to_point(failed, cured)) <= near;
  return is_same_answer(of, cured);
}

}  // namespace durero::conform
