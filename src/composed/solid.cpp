#include "durero/composed/solid.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "composed/solid_walk.hpp"
#include "durero/composed/moved_shape.hpp"

namespace durero::composed {
namespace {

using scene::Compound;
using surface::Box;
using surface::exact::Segment;

constexpr double unbounded = std::numeric_limits<double>::infinity();

SpaceForm<Dyadic> opposite(const SpaceForm<Dyadic>& form) {
  std::array<Dyadic, matrix_places> m = form.coefficients();
  for (Dyadic& each : m) each = -each;
  return SpaceForm<Dyadic>(std::move(m));
}

/// Of a plane across an axis: what lies behind it, up to a number next to its own.
Box box_of_half_space(const SpaceForm<Dyadic>& power) {
  Box box{glm::dvec3(-unbounded), glm::dvec3(unbounded)};
  const auto at = [&](std::size_t axis) -> const Dyadic& { return power.coefficients()[matrix_place(axis, 3)]; };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (sign(at(axis)) == 0 || sign(at((axis + 1) % 3)) != 0 || sign(at((axis + 2) % 3)) != 0) continue;
    const double bound = number::round_to_binary64(
        number::DyadicSurd{.x = -power.coefficients()[matrix_place(3, 3)], .w = number::shifted(at(axis), 1)});
    const auto i = static_cast<int>(axis);
    (sign(at(axis)) > 0 ? box.high : box.low)[i] = std::nextafter(bound, sign(at(axis)) > 0 ? unbounded : -unbounded);
  }
  return box;
}

Box box_of(const scene::Body& body);

Box box_of(const scene::Instance& instance) {
  const MovedShape shape(instance);
  return std::holds_alternative<scene::Plane>(instance.shape) ? box_of_half_space(shape.power()) : shape.box();
}

Box box_of(const Compound& solid) {
  Box box = box_of(solid.parts[0]);
  if (solid.operation == Compound::Operation::subtracted) return box;
  for (const scene::Body& part : solid.parts) {
    const Box other = box_of(part);
    const bool is_union = solid.operation == Compound::Operation::united;
    box.low = is_union ? glm::min(box.low, other.low) : glm::max(box.low, other.low);
    box.high = is_union ? glm::max(box.high, other.high) : glm::min(box.high, other.high);
  }
  return {box.low, glm::max(box.low, box.high)};
}

Box box_of(const scene::Body& body) {
  return std::visit([](const auto& form) { return box_of(form); }, body.form);
}

/// The walk from crossing to crossing: visit(t, place at t, place after t), the origin first without a t, until the
/// visit answers true.
template <class Visit>
void walk(const FacesAlong& along, const SideTree& tree, Visit visit) {
  std::vector<std::int8_t> sides = along.sides;
  const SolidPlace at_first = tree.place(sides);
  if (visit(nullptr, at_first, at_first)) return;
  const auto end = along.crossings.end();
  for (auto from = along.crossings.begin(); from != end;) {
    const auto to = std::find_if(from, end, [&](const FaceCrossing& each) { return each.t != from->t; });
    const std::vector<std::int8_t> before = sides;
    for (auto each = from; each != to; ++each) sides[each->face] = 0;
    const SolidPlace here = tree.place(sides);
    for (auto each = from; each != to; ++each)
      sides[each->face] = static_cast<std::int8_t>(each->turns ? -before[each->face] : before[each->face]);
    if (visit(&from->t, here, tree.place(sides))) return;
    from = to;
  }
}

First first_of(const FacesAlong& along, const SideTree& tree) {
  First first;
  walk(along, tree, [&](const Parameter* t, SolidPlace here, SolidPlace) {
    if (here != SolidPlace::surface) return false;
    if (t != nullptr)
      first.t = *t;
    else
      first.no_minimum = true;
    return true;
  });
  return first;
}

}  // namespace

SolidFigure::SolidFigure(const Compound& solid) : tree_(tree_of(solid)), box_(box_of(solid)) {}

SolidFigure::~SolidFigure() = default;

std::size_t SolidFigure::size() const { return faces_.size(); }

SideTree SolidFigure::side_of(const SpaceForm<Dyadic>& form) {
  for (std::size_t i = 0; i < faces_.size(); ++i)
    if (const int sign = multiple(form, faces_[i].form()); sign != 0) return SideTree::face(i, sign < 0);
  faces_.emplace_back(form);
  return SideTree::face(faces_.size() - 1, false);
}

SideTree SolidFigure::tree_of(const scene::Body& body) {
  return std::visit([&](const auto& form) { return tree_of(form); }, body.form);
}

// A bound is not negative inside, and a power not positive.
SideTree SolidFigure::tree_of(const scene::Instance& instance) {
  const MovedShape shape(instance);
  std::vector<SideTree> parts{side_of(shape.power())};
  for (const SpaceForm<Dyadic>& bound : shape.bounds()) parts.push_back(side_of(opposite(bound)));
  return SideTree::all(std::move(parts));
}

SideTree SolidFigure::tree_of(const Compound& solid) {
  std::vector<SideTree> parts;
  for (const scene::Body& part : solid.parts) {
    const bool is_taken = solid.operation == Compound::Operation::subtracted && !parts.empty();
    const SideTree tree = tree_of(part);
    parts.push_back(is_taken ? tree.complement() : tree);
  }
  const bool is_union = solid.operation == Compound::Operation::united;
  return is_union ? SideTree::any(std::move(parts)) : SideTree::all(std::move(parts));
}

Starts SolidFigure::starts(const model::Rayo& rayo, bool on) const {
  Starts starts(faces_.size(), 0);
  if (on)
    std::ranges::transform(faces_, starts.begin(),
                           [&](const SolidFace& face) { return face.may_hold_near(rayo.p().xyz()) ? 1 : 0; });
  return starts;
}

First SolidFigure::first(const model::Rayo& rayo, bool on) const {
  const Starts starts = this->starts(rayo, on);
  if (const auto quick = quick_first(faces_, tree_, rayo, starts)) {
    if (!quick->is_met) return {};
    return {.t = parameter(faces_[quick->face], starts[quick->face] != 0, quick->is_upper, rayo)};
  }
  return first_of(faces_along(faces_, rayo, starts), tree_);
}

std::optional<std::vector<Parameter>> SolidFigure::parameters(const model::Rayo& rayo, bool on,
                                                              surface::exact::RayStretch stretch) const {
  std::vector<Parameter> met;
  bool runs_along = false;
  walk(faces_along(faces_, rayo, starts(rayo, on)), tree_, [&](const Parameter* t, SolidPlace here, SolidPlace after) {
    const bool is_beyond = t != nullptr && !lies_on(stretch, *t);
    runs_along = !is_beyond && after == SolidPlace::surface;
    if (!is_beyond && t != nullptr && here == SolidPlace::surface) met.push_back(*t);
    return is_beyond || runs_along;
  });
  if (runs_along) return std::nullopt;
  return met;
}

// first() itself begins with the quick answer.
bool SolidFigure::may_meet(const model::Rayo&, bool) const { return true; }

std::vector<Segment> SolidFigure::inside(const model::Rayo& rayo, bool on) const {
  std::vector<Segment> stretches;
  bool is_open = false;
  walk(faces_along(faces_, rayo, starts(rayo, on)), tree_, [&](const Parameter* t, SolidPlace here, SolidPlace after) {
    const std::optional<Parameter> at = t != nullptr ? std::optional(*t) : std::nullopt;
    if (here != SolidPlace::outside && !is_open) stretches.push_back({at, std::nullopt});
    is_open = is_open || here != SolidPlace::outside;
    if (is_open && after == SolidPlace::outside) {
      stretches.back().end = at;
      is_open = false;
    }
    return false;
  });
  return stretches;
}

// Nearest to the point is the face that it was computed as a point of, up to rounding; but of several that are near,
// one that the surface is not on may be as near.
glm::dvec3 SolidFigure::normal(const glm::dvec3& point) const {
  std::vector<std::int8_t> sides;
  std::vector<std::pair<double, std::size_t>> by_distance;
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    const double value = faces_[i].value(point), length = glm::length(faces_[i].gradient(point));
    sides.push_back(value < 0 ? -1 : 1);
    by_distance.emplace_back(length > 0 ? std::abs(value) / length : unbounded, i);
  }
  std::ranges::sort(by_distance);
  for (const auto& [distance, face] : by_distance) {
    const std::int8_t own = sides[face];
    sides[face] = -1;
    const SolidPlace within = tree_.place(sides);
    sides[face] = 1;
    const SolidPlace beyond = tree_.place(sides);
    sides[face] = own;
    if (within == beyond || distance == unbounded) continue;
    const glm::dvec3 outwards = glm::normalize(faces_[face].gradient(point));
    return within == SolidPlace::inside ? outwards : -outwards;
  }
  return glm::dvec3(0);
}

}  // namespace durero::composed
