#include "conform/judge/mutation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace durero::conform {
namespace {

/// The elements of a scene up to which they are changed, and joined by others: of a mesh only the ray is.
constexpr std::size_t most_changed = 12;

bool is_mesh(const Draft& draft) { return draft.elements.size() > most_changed; }

/// The numbers of a draft that are no coordinates of unit vectors.
std::vector<double*> free_numbers(Draft& draft) {
  std::vector<double*> all = {&draft.p.x, &draft.p.y, &draft.p.z, &draft.v.x, &draft.v.y, &draft.v.z};
  for (Draft::Element& element : draft.elements) {
    const Places of = places(element.shape);
    for (glm::dvec3* point : of.points) all.insert(all.end(), {&point->x, &point->y, &point->z});
    all.insert(all.end(), of.lengths.begin(), of.lengths.end());
    all.insert(all.end(), of.ratios.begin(), of.ratios.end());
  }
  const std::vector<double*> of_range = numbers_behind(draft);
  all.insert(all.end(), of_range.begin(), of_range.end());
  return all;
}

double& some_number(Draft& draft, Random& random) {
  const std::vector<double*> all = free_numbers(draft);
  const std::size_t of_a_ray = 6;
  return *all[random.below(is_mesh(draft) ? of_a_ray : all.size())];
}

void scale_scene(Draft& draft, const MeasuredQuestion&, Random& random) {
  scale_with_t(draft, random.integer(-24, 24));
}

void scale_v(Draft& draft, const MeasuredQuestion&, Random& random) {
  const int k = random.integer(-24, 24);
  draft.v *= std::ldexp(random.chance(1, 2) ? 1 : random.uniform(1, 2), k);
}

/// Moves the origin along the ray: before the point by a power of two of the size, or on the point.
void move_origin(Draft& draft, const MeasuredQuestion& question, Random& random) {
  const double before = random.chance(1, 8) ? 0 : question.size * random.number(-30, 30);
  draft.p += (question.distance - std::abs(before)) * question.unit;
}

/// Puts an end of the range near the point, where there is one.
void move_end(Draft& draft, const MeasuredQuestion& question, Random& random) {
  const double factor = 1 + random.signed_power(-50, -1);
  const std::vector<double*> all = ends(draft);
  if (!all.empty()) *all[all.size() == 1 ? 0 : random.below(all.size())] = question.distance / question.length * factor;
}

/// Makes the ball of another radius, where one is cast: of the order of the target, or so that it nearly touches.
void change_radius(Draft& draft, const MeasuredQuestion& question, Random& random) {
  if (draft.question != QuestionKind::cast) return;
  const double to = random.chance(1, 2) ? question.size : std::max(question.distance, question.size);
  draft.range->radio = to * (random.chance(1, 2) ? 1 + random.signed_power(-50, -1) : random.uniform(0, 2));
}

void move_scene(Draft& draft, const MeasuredQuestion& question, Random& random) {
  const double by = question.size * std::ldexp(1, random.integer(-4, 30));
  translate(draft, random.in_cube(by));
}

/// Makes a number another: a little off, 0, rounder, of the other sign, or equal to another or nearly so.
void change_number(Draft& draft, const MeasuredQuestion&, Random& random) {
  double& number = some_number(draft, random);
  switch (random.below(6)) {
    case 0:
      number += number * random.signed_power(-50, -1);
      break;
    case 1:
      number = random.chance(1, 2) ? 0.0 : -0.0;
      break;
    case 2:
      number = std::ldexp(1, number == 0 ? 0 : std::ilogb(number));
      break;
    case 3:
      number = -number;
      break;
    case 4:
      number = some_number(draft, random);
      break;
    default:
      number = some_number(draft, random);
      number += number * random.signed_power(-40, -2);
  }
}

/// Aims at the target: at its middle, or so far beside that a ray may just pass.
void aim(Draft& draft, const MeasuredQuestion& question, Random& random) {
  const glm::dvec3 aside = random.direction();
  const double nearly = 1 + random.signed_power(-40, -2);
  const double by = random.chance(1, 4) ? 0 : question.size * (random.chance(1, 2) ? nearly : random.uniform(0, 1.5));
  const glm::dvec3 way = question.middle + by * aside - draft.p;
  if (glm::length(way) > 0) draft.v = question.length / glm::length(way) * way;
}

/// Makes v parallel to an axis of coordinates or to the axis of the target, or nearly so.
void align_v(Draft& draft, const MeasuredQuestion& question, Random& random) {
  const Places of = places(draft.elements[question.target].shape);
  glm::dvec3 to(0);
  to[random.integer(0, 2)] = random.sign();
  if (!of.axes.empty() && random.chance(2, 3)) to = *of.axes[0];
  const double off = random.chance(1, 3) ? 0 : std::ldexp(1, random.integer(-40, -2));
  const glm::dvec3 v = question.length * (to + off * random.direction());
  if (random.chance(1, 2)) draft.p += question.distance * (question.unit - v / question.length);
  draft.v = v;
}

void straighten_target(Draft& draft, const MeasuredQuestion& question, Random& random) {
  for (glm::dvec3* axis : places(draft.elements[question.target].shape).axes) {
    *axis = glm::dvec3(0);
    (*axis)[random.integer(0, 2)] = random.sign();
  }
}

/// Makes a length of the target much larger or smaller, or a triangle of it a needle.
void stretch_target(Draft& draft, const MeasuredQuestion& question, Random& random) {
  const Places of = places(draft.elements[question.target].shape);
  if (!of.lengths.empty()) {
    double& length = *of.lengths[random.below(of.lengths.size())];
    length = std::ldexp(length, random.integer(-20, 20));
  } else if (of.points.size() == 3) {
    const glm::dvec3 &a = *of.points[0], &b = *of.points[1];
    const double along = random.uniform(-1, 2), off = question.size * std::ldexp(1, random.integer(-30, 0));
    *of.points[2] = a + along * (b - a) + off * random.direction();
  }
}

void leave_out_one(Draft& draft, const MeasuredQuestion&, Random& random) {
  if (draft.elements.size() < 2) return;
  draft.elements.erase(draft.elements.begin() + static_cast<std::ptrdiff_t>(random.below(draft.elements.size())));
}

/// A name that no element of the draft has.
std::string new_name(const Draft& draft) {
  std::size_t number = draft.elements.size();
  const auto name = [&] { return fmt::format("x{}", number); };
  while (std::ranges::find(draft.elements, name(), &Draft::Element::name) != draft.elements.end()) ++number;
  return name();
}

/// Adds an element of the question itself, a little off, so that the two nearly coincide.
void double_one(Draft& draft, const MeasuredQuestion& question, Random& random) {
  Draft::Element added = draft.elements[random.below(draft.elements.size())];
  added.name = new_name(draft);
  const double by = random.chance(1, 4) ? 0 : question.size * std::ldexp(1, random.integer(-50, 2));
  for (glm::dvec3* point : places(added.shape).points) *point += by * random.direction();
  draft.elements.push_back(std::move(added));
}

using Mutation = void (*)(Draft&, const MeasuredQuestion&, Random&);
constexpr std::array<Mutation, 10> of_rays = {scale_scene,   scale_v,       move_origin, move_scene, move_end,
                                              change_number, change_number, aim,         aim,        align_v};
/// Of a cast the radius takes the place of the ends.
Mutation of_question(Mutation mutation, QuestionKind question) {
  return mutation == move_end && question == QuestionKind::cast ? change_radius : mutation;
}
constexpr std::array<Mutation, 5> of_elements = {straighten_target, stretch_target, leave_out_one, double_one,
                                                 change_number};

/// Puts an element of another question where the ray goes.
void take_one(Draft& draft, const MeasuredQuestion& question, const Draft& other, Random& random) {
  Draft::Element taken = other.elements[random.below(other.elements.size())];
  taken.name = new_name(draft);
  const std::vector<glm::dvec3*> points = places(taken.shape).points;
  const glm::dvec3 at = question.draft.p + question.distance * random.uniform(0.25, 2) * question.unit;
  const glm::dvec3 by = at - *points.front();
  for (glm::dvec3* point : points) *point += by;
  draft.elements.push_back(std::move(taken));
}

void mutate_once(Draft& draft, const MeasuredQuestion& question, const Draft& other, Random& random) {
  const bool changes_elements = random.chance(1, 3) && !is_mesh(draft);
  const bool takes_one = changes_elements && random.chance(1, 8) && !is_mesh(other);
  if (takes_one) return take_one(draft, question, other, random);
  const Mutation mutation = changes_elements ? random.any_of(of_elements) : random.any_of(of_rays);
  of_question(mutation, draft.question)(draft, question, random);
}

}  // namespace

Draft mutated(const MeasuredQuestion& question, const Draft& other, Random& random) {
  Draft draft = question.draft;
  const int times = random.integer(1, 3);
  for (int i = 0; i < times; ++i) {
    if (draft.elements.size() <= question.target) break;  // the target was left out
    mutate_once(draft, question, other, random);
  }
  return draft;
}

void round_to_binary32(Draft& draft) {
  for (double* number : free_numbers(draft)) *number = static_cast<double>(static_cast<float>(*number));
}

}  // namespace durero::conform
