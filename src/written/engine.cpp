#include "durero/written/engine.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "durero/scene/attributes.hpp"
#include "mixed_engine.hpp"
#include "surface_search.hpp"

namespace durero::written {
namespace {

using scene::ElementRef;

class WrittenEngine final : public engine::Engine {
 public:
  explicit WrittenEngine(std::vector<SurfaceElement> elements) : elements_(std::move(elements)) {}

  void first_hits(std::span<const scene::Query> queries, std::span<scene::Hit> hits) const override {
    tbb::parallel_for(std::size_t{0}, queries.size(), [&](std::size_t i) {
      SurfaceSearch search(queries[i]);
      for (const SurfaceElement& element : elements_) search.ask(element);
      hits[i] = search.hit();
    });
  }

  void occluded_segments(std::span<const scene::Query> queries, std::span<bool> occluded) const override {
    tbb::parallel_for(std::size_t{0}, queries.size(), [&](std::size_t i) {
      occluded[i] = std::ranges::any_of(elements_, [&](const SurfaceElement& element) {
        return element.surface.hides(queries[i].rayo, element.has_origin_of(queries[i]));
      });
    });
  }

  std::optional<std::vector<surface::exact::ElementPoint>> points_between(
      const scene::Scene& scene, const scene::Query& query, surface::exact::RayStretch stretch,
      const surface::exact::Passes& passes) const override {
    std::vector<surface::exact::ElementPoint> points;
    if (!add_points(elements_, query, stretch, passes, points)) return std::nullopt;
    std::ranges::stable_sort(points, {}, [&](const auto& each) { return scene.name(each.element); });
    return points;
  }

  glm::dvec3 normal(const scene::Scene&, ElementRef element, const glm::dvec3& point) const override {
    return std::ranges::lower_bound(elements_, element, {}, &SurfaceElement::place)->surface.normal(point);
  }

 private:
  std::vector<SurfaceElement> elements_;  // ascending
};

/// The attributes of an element that the program has a shape for.
std::vector<io::WrittenValue> attributes_of(const scene::Scene& scene, ElementRef element) {
  std::vector<io::WrittenValue> values;
  scene.visit(element, [&]<class Shape>(const Shape& shape) {
    scene::for_each_attribute<Shape>([&](const auto& attribute) { values.emplace_back(shape.*attribute.field); });
  });
  return values;
}

std::string_view word_of(ElementRef element) {
  return scene::with_shape(element.tipo, []<class Shape>(std::type_identity<Shape>) { return Shape::word; });
}

/// The surface of an element of the file.
Surface surface_of(const io::Source& source, const Text& text, const io::WrittenElement& element) {
  const io::WrittenType& type = text.types()[element.type];
  try {
    return surface_of(text, element);
  } catch (const NotInDomain& refused) {
    std::size_t offset = element.offset;
    for (std::size_t i = 0; i < type.attributes.size(); ++i)
      if (type.attributes[i].word == refused.attribute) offset = element.offsets[i];
    source.fail(offset, fmt::format("{} is not in the domain of puntos_{}", element.id, type.word),
                fmt::format("expected {}", refused.expected));
  }
}

Surface surface_of(const io::Source& source, const Text& text, const scene::Scene& scene, ElementRef element) {
  try {
    return surface_of(text, scene, element);
  } catch (const NotInDomain& refused) {
    const std::string& name = scene.name(element).name();
    throw io::InputError(source.name(), io::element_place(source, name).place,
                         fmt::format("{} is not in the domain of puntos_{}", name, word_of(element)),
                         fmt::format("expected {}", refused.expected));
  }
}

/// The elements that the text defines: all of them, or those of its own types, where all others are the program's.
template <class SurfaceOf>
std::vector<SurfaceElement> surfaces_of(const scene::Scene& scene, const io::WrittenByName& elements, const Text& text,
                                        SurfaceOf surface) {
  std::vector<SurfaceElement> surfaces;
  scene.for_each([&](ElementRef place, const auto&) {
    const auto written = elements.find(scene.name(place).name());
    const io::WrittenElement* const own = written == elements.end() ? nullptr : &written->second;
    if (own != nullptr || text.declares_shapes()) surfaces.push_back({place, surface(place, own)});
  });
  return surfaces;
}

std::unique_ptr<const engine::Engine> engine_of(const scene::Scene& scene, const Text& text,
                                                std::vector<SurfaceElement> surfaces) {
  if (!text.declares_shapes()) return mixed_engine(scene, std::move(surfaces));
  return std::make_unique<const WrittenEngine>(std::move(surfaces));
}

}  // namespace

Surface surface_of(const Text& text, const scene::Scene& scene, ElementRef element) {
  return text.surface(std::string(word_of(element)), attributes_of(scene, element));
}

Surface surface_of(const Text& text, const io::WrittenElement& element) {
  return text.surface(text.types()[element.type].word, element.values);
}

std::unique_ptr<const engine::Engine> prepared(const scene::Scene& scene, const Text& text) {
  return prepared(scene, {}, text);
}

std::unique_ptr<const engine::Engine> prepared(const scene::Scene& scene, const io::WrittenByName& elements,
                                               const Text& text) {
  return engine_of(scene, text,
                   surfaces_of(scene, elements, text, [&](ElementRef place, const io::WrittenElement* own) {
                     return own == nullptr ? surface_of(text, scene, place) : surface_of(text, *own);
                   }));
}

io::Bodies bodies_beside(const Text& text) { return text.declares_shapes() ? io::Bodies::refused : io::Bodies::read; }

Written read(const io::Source& source, const Text& text) { return read(source, text, bodies_beside(text)); }

Written read(const io::Source& source, const Text& text, io::Bodies bodies) {
  std::vector<io::WrittenElement> own;
  Written result{io::read_scene(source, text.types(), own, bodies), {}, nullptr};
  for (io::WrittenElement& element : own) {
    std::string id = element.id;
    result.elements.emplace(std::move(id), std::move(element));
  }
  result.engine = engine_of(
      result.scene, text,
      surfaces_of(result.scene, result.elements, text, [&](ElementRef place, const io::WrittenElement* element) {
        return element == nullptr ? surface_of(source, text, result.scene, place) : surface_of(source, text, *element);
      }));
  return result;
}

}  // namespace durero::written
