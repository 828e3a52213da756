#include "durero/engine/arrays.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "c/handles.hpp"
#include "durero/distance/distances.hpp"

using namespace durero;
using c::guarded;

namespace {

/// How many rays are answered at a time: what is kept beside the caller's arrays is of as many.
constexpr std::size_t at_a_time = std::size_t{1} << 16;

/// Elements as numbers: ascending, as they lie in the tables of their types one behind the other.
class ElementNumbers {
 public:
  explicit ElementNumbers(const scene::Scene& scene) {
    scene::for_each_shape([&]<class Shape>(std::type_identity<Shape>) {
      first_[static_cast<std::size_t>(Shape::tipo)] = size_;
      size_ += static_cast<std::uint32_t>(scene.shapes<Shape>().size());
    });
  }
  std::uint32_t of(scene::ElementRef element) const {
    return first_[static_cast<std::size_t>(element.tipo)] + element.index;
  }
  /// Nothing where no element has the number.
  std::optional<scene::ElementRef> element(std::uint32_t number) const {
    if (number >= size_) return std::nullopt;
    const auto after = std::ranges::upper_bound(first_, number);
    const auto type = static_cast<std::size_t>(after - first_.begin()) - 1;
    return scene::ElementRef{model::Tipo(type), number - first_[type]};
  }

 private:
  std::array<std::uint32_t, model::tipo_count> first_{};
  std::uint32_t size_ = 0;
};

/// The i-th ray, where it is one.
void require_ray(const durero_ray_arrays& rays, std::size_t i, const ElementNumbers& numbers) {
  bool finite = true, still = true;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    finite = finite && std::isfinite(rays.p[axis][i]) && std::isfinite(rays.v[axis][i]);
    still = still && rays.v[axis][i] == 0;
  }
  if (!finite || still)
    throw std::invalid_argument("ray " + std::to_string(i) + ": no ray; expected finite numbers and v other than 0");
  if (rays.start != nullptr && rays.start[i] != DURERO_NO_ELEMENT && !numbers.element(rays.start[i]))
    throw std::invalid_argument("ray " + std::to_string(i) + ": start is " + std::to_string(rays.start[i]) +
                                ", the number of no element; expected one, or DURERO_NO_ELEMENT");
}

/// The rays of a call, of which some at a time are asked.
class Rays {
 public:
  /// Throws std::invalid_argument where one of them is none.
  Rays(const durero_ray_arrays& rays, std::size_t count, const ElementNumbers& numbers)
      : rays_(rays), count_(count), numbers_(numbers) {
    for (std::size_t i = 0; i < count; ++i) require_ray(rays, i, numbers);
  }
  /// answer(begin, rays) for all of them, in order.
  template <class Answer>
  void some_at_a_time(Answer answer) {
    for (std::size_t begin = 0; begin < count_; begin += at_a_time)
      answer(begin, of(begin, std::min(at_a_time, count_ - begin)));
  }
  /// As many as are asked at a time, at most.
  std::size_t most() const { return std::min(at_a_time, count_); }

 private:
  engine::RayArrays of(std::size_t begin, std::size_t count) {
    engine::RayArrays some;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      some.p[axis] = {rays_.p[axis] + begin, count};
      some.v[axis] = {rays_.v[axis] + begin, count};
    }
    if (rays_.start == nullptr) return some;
    start_.resize(count);
    std::transform(rays_.start + begin, rays_.start + begin + count, start_.begin(),
                   [&](std::uint32_t number) { return numbers_.element(number); });
    some.start = start_;
    return some;
  }

  const durero_ray_arrays& rays_;
  std::size_t count_;
  const ElementNumbers& numbers_;
  std::vector<std::optional<scene::ElementRef>> start_;
};

/// Places for `count` numbers: those of the caller's array, from `begin` on, or where it is NULL a part of `spare`.
std::span<double> places(double* array, std::size_t begin, std::size_t count, std::vector<double>& spare) {
  if (array != nullptr) return {array + begin, count};
  spare.resize(std::max(spare.size(), count));
  return std::span(spare).first(count);
}

/// Whether the caller asks for t or for a coordinate of the point.
bool asks_where(const durero_hit_arrays& hits) {
  return hits.t != nullptr || std::ranges::any_of(hits.point, [](const double* of) { return of != nullptr; });
}

void write(const durero_hit_arrays& hits, std::size_t i, const trace::FirstElement& found,
           const ElementNumbers& numbers) {
  if (hits.outcome != nullptr) hits.outcome[i] = static_cast<std::uint8_t>(c::outcome(found.resultado));
  if (hits.elements != nullptr) hits.elements[i] = found.count;
  if (hits.element != nullptr) hits.element[i] = found.count == 0 ? DURERO_NO_ELEMENT : numbers.of(found.least);
}

}  // namespace

durero_answer durero_first_hits_of_arrays(const durero_engine* engine, const durero_ray_arrays* rays, size_t count,
                                          const durero_hit_arrays* hits) {
  return guarded(DURERO_FAILED, [&] {
    const ElementNumbers numbers(*engine->scene);
    Rays asked(*rays, count, numbers);
    std::vector<trace::FirstElement> found(asked.most());
    std::array<std::vector<double>, 4> spare;
    asked.some_at_a_time([&](std::size_t begin, const engine::RayArrays& some) {
      const std::span<trace::FirstElement> elements = std::span(found).first(some.size());
      if (asks_where(*hits)) {
        engine::PointArrays where{places(hits->t, begin, some.size(), spare[3]), {}};
        for (std::size_t axis = 0; axis < 3; ++axis)
          where.point[axis] = places(hits->point[axis], begin, some.size(), spare[axis]);
        engine::first_hits(*engine->value, some, elements, where);
      } else {
        engine::first_elements(*engine->value, some, elements);
      }
      for (std::size_t i = 0; i < some.size(); ++i) write(*hits, begin + i, elements[i], numbers);
    });
    return DURERO_DONE;
  });
}

durero_answer durero_occluded_segments(const durero_engine* engine, const durero_ray_arrays* rays, size_t count,
                                       uint8_t* occluded) {
  return guarded(DURERO_FAILED, [&] {
    const ElementNumbers numbers(*engine->scene);
    Rays asked(*rays, count, numbers);
    const auto found = std::make_unique<bool[]>(asked.most());
    asked.some_at_a_time([&](std::size_t begin, const engine::RayArrays& some) {
      engine::occluded_segments(*engine->value, some, {found.get(), some.size()});
      std::copy_n(found.get(), some.size(), occluded + begin);
    });
    return DURERO_DONE;
  });
}

const char* durero_element_name(const durero_engine* engine, uint32_t element) {
  return guarded<const char*>(nullptr, [&]() -> const char* {
    const auto named = ElementNumbers(*engine->scene).element(element);
    if (!named) return nullptr;
    const std::lock_guard lock(engine->names_in_use);
    const auto [name, is_new] = engine->names.try_emplace(element);
    if (is_new) name->second = engine->scene->name(*named).name();
    return name->second.c_str();
  });
}

uint32_t durero_face_number(const durero_engine* engine, uint32_t element, const char** mesh) {
  const auto named = ElementNumbers(*engine->scene).element(element);
  const auto face = named ? engine->scene->face(*named) : std::nullopt;
  if (mesh != nullptr) *mesh = face ? face->mesh.m.name().c_str() : nullptr;
  return face ? face->number : DURERO_NO_ELEMENT;
}

uint32_t durero_element_number(const durero_engine* engine, const char* name) {
  const auto element = engine->scene->find(name);
  return element ? ElementNumbers(*engine->scene).of(*element) : DURERO_NO_ELEMENT;
}

durero_answer durero_distances(const durero_scene* scene, const double* xyz, size_t count, durero_proximity* answers) {
  return guarded(DURERO_FAILED, [&] {
    if (scene->value.text() != nullptr)
      throw std::invalid_argument("the scene was read by a Z text, which tells no distances; expected another");
    for (std::size_t i = 0; i < 3 * count; ++i)
      if (!std::isfinite(xyz[i]))
        throw std::invalid_argument("point " + std::to_string(i / 3) + ": no point; expected finite numbers");
    const scene::Scene& of = scene->value.of().scene;
    std::vector<glm::dvec3> points;
    points.reserve(count);
    for (std::size_t i = 0; i < count; ++i) points.emplace_back(xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]);
    std::vector<scene::Proximity> found(count);
    distance::Distances(of).nearest(points, found);
    const ElementNumbers numbers(of);
    for (std::size_t i = 0; i < count; ++i) {
      const auto& [nearest, distance, point, elementos] = found[i];
      answers[i] = {static_cast<durero_count>(nearest),
                    static_cast<std::uint32_t>(elementos.size()),
                    elementos.empty() ? DURERO_NO_ELEMENT : numbers.of(elementos.front()),
                    distance,
                    {point.x, point.y, point.z}};
    }
    return DURERO_DONE;
  });
}
