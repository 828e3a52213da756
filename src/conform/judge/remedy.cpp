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
    all.insert(all.end(), of.sides.begin(), of.sides.end());
  }
  return all;
}

template <class Change>
Draft changed(const MeasuredQuestion& question, Change change) {
  Draft draft = question.draft;
  change(draft);
  return draft;
}

Remedy plus_zeros(const MeasuredQuestion& question) {
  bool has = false;
  Draft draft = question.draft;
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

/// Sets v to one that is `longer` times as long, and the range so that it stays where it is.
void turn(Draft& draft, const glm::dvec3& v, double longer) {
  draft.v = v;
  scale_range(draft, 1 / longer);
}

/// v/|v|, and as a control a v whose direction was rounded as v/|v| is and whose length is no nearer to 1.
Remedy unit_direction(const MeasuredQuestion& question, const Profile& profile) {
  constexpr double nearly_1 = 0x1p-20;
  if (!std::isfinite(question.length) || std::abs(question.length - 1) < nearly_1) return {};
  const glm::dvec3 rounded =
      profile.format == NumberFormat::binary32 ? glm::dvec3(glm::vec3(question.unit)) : question.unit;
  const double length = question.length * (question.length > 1 ? 1.5 : 0.75);
  return {{changed(question, [&](Draft& draft) { turn(draft, question.unit, 1 / question.length); })},
          changed(question, [&](Draft& draft) { turn(draft, length * rounded, length / question.length); })};
}

Remedy size_near_1(const MeasuredQuestion& question) {
  return {{changed(question, [&](Draft& draft) { scale_with_t(draft, -std::ilogb(question.size)); })}};
}

Remedy moved_to_zero(const MeasuredQuestion& question) {
  return {{changed(question, [&](Draft& draft) { translate(draft, -question.middle); })}};
}

/// The origin two sizes before the point.
Remedy nearer(const MeasuredQuestion& question) {
  return {{changed(
      question, [&](Draft& draft) { move_along(draft, (question.distance - 2 * question.size) / question.length); })}};
}

/// The way by which farther_back() moves the origin, to before the whole target.
double way_back(const MeasuredQuestion& question) {
  return glm::length(question.middle - question.draft.p) + 2 * question.extent;
}

Remedy farther_back(const MeasuredQuestion& question) {
  return {{changed(question, [&](Draft& draft) { move_along(draft, -way_back(question) / question.length); })}};
}

Remedy target_alone(const MeasuredQuestion& question) {
  return {{changed(question, [&](Draft& draft) { draft.elements = {question.draft.elements[question.target]}; })}};
}

Remedy turned_round(const MeasuredQuestion& question) {
  return {{changed(question, [](Draft& draft) {
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

Remedy turned(const MeasuredQuestion& question) {
  return {{changed(question, [](Draft& draft) {
    for (glm::dvec3* of : vectors(draft)) *of = rotated(*of);
  })}};
}

/// x, y and z in the two other orders that keep their orientation.
Remedy permuted(const MeasuredQuestion& question) {
  const auto once = [](Draft& draft) {
    for (glm::dvec3* of : vectors(draft)) *of = glm::dvec3(of->y, of->z, of->x);
  };
  const Draft first = changed(question, once);
  Draft second = first;
  once(second);
  return {{first, std::move(second)}};
}

/// The ray from the same origin to the middle of the target.
Remedy aimed(const MeasuredQuestion& question) {
  const glm::dvec3 way = question.middle - question.draft.p;
  if (way == glm::dvec3(0)) return {};
  return {{changed(question, [&](Draft& draft) { draft.v = question.length / glm::length(way) * way; })}};
}

bool has_zero(const glm::dvec3& w) { return w.x == 0 || w.y == 0 || w.z == 0; }

bool is_parallel(const MeasuredQuestion& question) {
  Draft draft = question.draft;
  const Places of = places(draft.elements[question.target].shape);
  const auto has = [](const glm::dvec3* axis) { return has_zero(*axis); };
  return has_zero(draft.v) || std::ranges::any_of(of.axes, has) || std::ranges::any_of(of.sides, has);
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
double way_to_point(const MeasuredQuestion& question, const SuiteCase& back) {
  return back.truths[0].hit.t * question.length - way_back(question);
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

Remedy remedy_of(Trait trait, const MeasuredQuestion& question, const SuiteCase& of, const Profile& profile) {
  const auto where = [](bool has, Remedy remedy) { return has ? std::move(remedy) : Remedy{}; };
  switch (trait) {
    case Trait::minus_zero:
      return plus_zeros(question);
    case Trait::not_unit:
      return unit_direction(question, profile);
    case Trait::small:
      return where(question.size < 1 / far, size_near_1(question));
    case Trait::large:
      return where(question.size > far, size_near_1(question));
    case Trait::far_from_zero:
      return where(largest(question.middle) > far * question.size, moved_to_zero(question));
    case Trait::far_origin:
      return where(question.distance > far * question.size, nearer(question));
    case Trait::inside:
    case Trait::near_surface:
      return farther_back(question);
    case Trait::several:
      return where(question.draft.elements.size() > 1, target_alone(question));
    case Trait::one_sided:
      return where(question.has_sides, turned_round(question));
    case Trait::coincidence:
      return where(of.truths[0].ambiguity != Ambiguity::none, Remedy{shaken(question.draft, profile)});
    case Trait::parallel:
      return where(is_parallel(question), turned(question));
    case Trait::one_axis:
      return permuted(question);
    case Trait::grazing:
      return aimed(question);
    case Trait::none:
      return {};
  }
  contract::unreachable();
}

bool corresponds(Trait trait, const MeasuredQuestion& question, const SuiteCase& of, const SuiteCase& cured) {
  const double near = question.size / far;
  const auto is_target = [&] { return meets(cured, question.draft.elements[question.target].name); };
  if (trait == Trait::coincidence) return true;
  if (trait == Trait::grazing) return cured.truths[0].hit.resultado == model::Resultado::hit;
  if (trait == Trait::inside) return is_target() && way_to_point(question, cured) < -near;
  if (trait == Trait::near_surface) return is_target() && std::abs(way_to_point(question, cured)) <= near;
  return is_same_answer(of, cured);
}

}  // namespace durero::conform
