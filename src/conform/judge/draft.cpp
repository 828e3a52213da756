#include "conform/judge/draft.hpp"

#include <algorithm>
#include <cmath>

#include "conform/families/solids.hpp"
#include "conform/judge/allowance.hpp"
#include "durero/number/quotient.hpp"
#include "durero/scene/attributes.hpp"
#include "durero/surface/surfaces.hpp"

namespace durero::conform {
namespace {

bool is_finite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// Whether every number of the shape is one: a change may have left the range of binary64.
bool is_finite(AskedShape shape) {
  const Places of = places(shape);
  const auto is = [](const auto* number) {
    if constexpr (std::is_same_v<decltype(number), const double*>)
      return std::isfinite(*number);
    else
      return is_finite(*number);
  };
  return std::ranges::all_of(of.points, is) && std::ranges::all_of(of.axes, is) && std::ranges::all_of(of.sides, is) &&
         std::ranges::all_of(of.lengths, is) && std::ranges::all_of(of.ratios, is);
}

/// The disc at an end of an element, with its numbers rounded to binary64, as those of a suite are; nothing at an apex.
template <surface::Axial Shape>
std::optional<scene::Disc> closing_disc(const Shape& wall, bool at_base) {
  scene::Disc disc{wall.centro, number::round_to_binary64(radius_at_centre(wall)), wall.vector};
  if (at_base) return disc;
  disc.centro += wall.altura * wall.vector;
  disc.radio = 0;
  if constexpr (scene::has_attribute<Shape, &scene::AnyEscena::mi_radio>()) disc.radio = wall.radio;
  return disc.radio > 0 ? std::optional(disc) : std::nullopt;
}

/// Adds the discs that close an element with an axis. Returns whether the model takes them.
bool close(SuiteCase& of, const Draft::Element& element) {
  scene::Scene& scene = of.the_case.scene;
  Solid solid{*scene.find(element.name), {}};
  const auto add_disc = [&]<class Shape>(const Shape& wall) {
    if constexpr (surface::Axial<Shape>) {
      for (const bool at_base : {true, false}) {
        const std::optional<scene::Disc> disc = closing_disc(wall, at_base);
        const std::string name = element.name + (at_base ? ".base" : ".top");
        if (disc && !(is_finite(*disc) && scene.add(model::Elemento(name), *disc).ok())) return false;
        if (disc) solid.discs.push_back(*scene.find(name));
      }
    }
    return true;
  };
  if (!std::visit(add_disc, element.shape)) return false;
  if (!solid.discs.empty()) of.solids.push_back(std::move(solid));
  return true;
}

/// Adds an element of a draft. Returns whether the model takes it.
template <class Shape>
bool add_to(SuiteCase& of, const model::Elemento& name, const Shape& shape) {
  return of.the_case.scene.add(name, shape).ok();
}
bool add_to(SuiteCase& of, const model::Elemento& name, const AskedBody& body) {
  if (!add_body(of.the_case.scene, name, body)) return false;
  of.bodies.push_back({of.the_case.scene.find(name.name()).value(), body});
  return true;
}
bool add(SuiteCase& of, const Draft::Element& element) {
  const model::Elemento name(element.name);
  return std::visit([&](const auto& shape) { return add_to(of, name, shape); }, element.shape);
}

/// Whether the numbers behind a ray are ends, or a radius.
bool is_asked_of(QuestionKind question, const AskedRange& range) {
  if (question == QuestionKind::cast) return std::isfinite(range.radio) && range.radio > 0;
  return std::isfinite(range.end) && range.end >= 0 && range.begin >= 0;
}

}  // namespace

std::string_view word_of(const AskedShape& any) {
  return std::visit(
      []<class Shape>(const Shape& shape) {
        if constexpr (std::is_same_v<Shape, AskedBody>)
          return word(shape.kind);
        else
          return Shape::word;
      },
      any);
}

Draft::Draft(const SuiteCase& of)
    : p(of.the_case.rays[0].rayo.p().xyz()),
      v(of.the_case.rays[0].rayo.v().xyz()),
      are_closed(!of.solids.empty()),
      is_grid(of.is_grid) {
  const scene::Scene& scene = of.the_case.scene;
  scene.for_each([&](scene::ElementRef e, const auto& shape) {
    if (solid_closed_by(of.solids, e) != nullptr) return;
    const AskedBody* const body = find_body(of.bodies, e);
    elements.push_back({std::string(scene.name(e).name()), body ? AskedShape(*body) : AskedShape(shape)});
  });
  question = of.question;
  if (has_numbers(question)) range = of.ranges[0];
  for (const scene::ElementRef e : of.the_case.rays[0].en) on.emplace_back(scene.name(e).name());
}

bool Draft::are_of(const scene::Scene& scene) const {
  const auto is_same = [&](const Element& element) {
    const auto e = scene.find(element.name);
    const auto* const triangle = std::get_if<scene::Triangle>(&element.shape);
    return e && triangle && e->tipo == scene::Triangle::tipo &&
           scene.shapes<scene::Triangle>()[e->index].vertices == triangle->vertices;
  };
  return elements.size() == scene.size() && std::ranges::all_of(elements, is_same);
}

std::optional<SuiteCase> Draft::built(const SuiteCase& like) const {
  if (!is_finite(p) || !is_finite(v) || v == glm::dvec3(0)) return std::nullopt;
  if (range && !is_asked_of(question, *range)) return std::nullopt;
  SuiteCase of{
      .family = like.family, .number = like.number, .parameter = like.parameter, .the_case = {}, .question = question};
  of.is_grid = is_grid;
  if (is_grid) {
    if (!are_of(like.the_case.scene)) return std::nullopt;
    of.the_case.scene = like.the_case.scene;
  }
  for (const Element& element : elements) {
    if (is_grid) break;
    if (!is_finite(element.shape)) return std::nullopt;
    if (!add(of, element)) return std::nullopt;
  }
  for (const Element& element : elements) {
    if (are_closed && !close(of, element)) return std::nullopt;
  }
  scene::Query ray{{model::Punto(p), model::Vector(v)}, {}};
  for (const std::string& name : on) {
    if (const auto e = of.the_case.scene.find(name)) ray.en.push_back(*e);
  }
  std::ranges::sort(ray.en);
  of.the_case.rays.push_back(std::move(ray));
  if (range) of.ranges = {*range};
  answer(of);
  return of;
}

namespace {

template <class Shape>
void add_places(Places& all, Shape& shape) {
  scene::for_each_attribute<Shape>([&]<class Row>(const Row& attribute) {
    auto& stored = shape.*attribute.field;
    if constexpr (std::is_same_v<typename Row::Stored, scene::Corners>) {
      for (glm::dvec3& corner : stored) all.points.push_back(&corner);
    } else if constexpr (std::is_same_v<typename Row::Input, model::Punto>) {
      all.points.push_back(&stored);
    } else if constexpr (std::is_same_v<typename Row::Input, model::Vector>) {
      all.axes.push_back(&stored);
    } else {
      const bool is_ratio = attribute.component == &scene::AnyEscena::mi_proporcion;
      (is_ratio ? all.ratios : all.lengths).push_back(&stored);
    }
  });
}

void add_places(Places& all, AskedBody& body) {
  all.points.push_back(&body.centro);
  for (glm::dvec3& side : body.sides) all.sides.push_back(&side);
  if (has_radius(body.kind)) all.lengths.push_back(&body.radio);
}

}  // namespace

Places places(AskedShape& any) {
  Places all;
  std::visit([&](auto& shape) { add_places(all, shape); }, any);
  return all;
}

std::vector<double*> ends(Draft& draft) {
  if (draft.question == QuestionKind::shadow) return {&draft.range->end};
  if (draft.question == QuestionKind::range) return {&draft.range->begin, &draft.range->end};
  return {};
}

std::vector<double*> numbers_behind(Draft& draft) {
  if (draft.question == QuestionKind::cast) return {&draft.range->radio};
  return ends(draft);
}

void scale_range(Draft& draft, double factor) {
  for (double* const end : ends(draft)) *end *= factor;
}

void scale_direction(Draft& draft, double factor) {
  draft.v *= factor;
  scale_range(draft, 1 / factor);
}

void move_along(Draft& draft, double t) {
  draft.p += t * draft.v;
  for (double* const end : ends(draft)) *end -= t;
  if (draft.range) draft.range->begin = std::max(0.0, draft.range->begin);
}

void scale(Draft& draft, int k) {
  scale_with_t(draft, k);
  scale_direction(draft, std::ldexp(1, k));
}

void scale_with_t(Draft& draft, int k) {
  const double factor = std::ldexp(1, k);
  draft.p *= factor;
  scale_range(draft, factor);
  if (draft.range) draft.range->radio *= factor;
  for (Draft::Element& element : draft.elements) {
    const Places of = places(element.shape);
    for (glm::dvec3* point : of.points) *point *= factor;
    for (glm::dvec3* side : of.sides) *side *= factor;
    for (double* length : of.lengths) *length *= factor;
  }
}

void translate(Draft& draft, const glm::dvec3& by) {
  draft.p += by;
  for (Draft::Element& element : draft.elements)
    for (glm::dvec3* point : places(element.shape).points) *point += by;
}

double size_of(const Draft& draft) {
  AskedShape first = draft.elements.front().shape;
  const Places of = places(first);
  if (!of.lengths.empty()) return *of.lengths.front();
  double size = 0;
  for (const glm::dvec3* point : of.sides.empty() ? of.points : of.sides) size = std::max(size, largest(*point));
  return size > 0 ? size : 1;
}

}  // namespace durero::conform
