#include "durero/written/engine.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "durero/io/json/scene_file.hpp"
#include "durero/scene/attributes.hpp"

namespace durero::written {
namespace {

using algebra::Root;
using number::Dyadic;
using scene::ElementRef;

struct Element {
  ElementRef place;
  Surface surface;
};

/// The search for the nearest elements that a ray meets, and for elements without a nearest point.
class PieceSearch {
 public:
  explicit PieceSearch(const scene::Query& query) : query_(query) {}

  void ask(const Element& element) {
    First first = element.surface.first(query_.rayo, scene::Origin(query_.en).contains(element.place));
    if (auto* const root = std::get_if<Root>(&first)) meet(element.place, std::move(*root));
    if (auto* const after = std::get_if<After>(&first)) approach(element.place, std::move(after->t));
  }

  /// The hit of the search. A point at t is nearest where no stretch begins before t: a stretch that begins behind t,
  /// or at t itself, leaves it so.
  scene::Hit hit() const {
    const bool is_nearest = nearest_ && (without_.empty() || (bound_ && algebra::compare(*nearest_, *bound_) <= 0));
    if (is_nearest) return at(*nearest_);
    scene::Hit none;
    none.resultado = without_.empty() ? model::Resultado::miss : model::Resultado::no_minimum;
    none.elementos.assign(without_.begin(), without_.end());
    return none;
  }

 private:
  void meet(ElementRef place, Root root) {
    const auto order = nearest_ ? algebra::compare(root, *nearest_) : std::strong_ordering::less;
    if (order > 0) return;
    if (order < 0) {
      nearest_ = std::move(root);
      met_.clear();
    }
    met_.push_back(place);
  }

  void approach(ElementRef place, std::optional<Root> from) {
    const bool is_less = without_.empty() || (bound_ && (!from || algebra::compare(*from, *bound_) < 0));
    if (is_less) bound_ = std::move(from);
    without_.push_back(place);
  }

  scene::Hit at(const Root& t) const {
    const auto& p = query_.rayo.p().xyz();
    const auto& v = query_.rayo.v().xyz();
    scene::Hit hit;
    hit.resultado = model::Resultado::hit;
    hit.t = algebra::rounded_linear(Dyadic(), Dyadic(1), t);
    for (int i = 0; i < 3; ++i) hit.punto[i] = algebra::rounded_linear(Dyadic(p[i]), Dyadic(v[i]), t);
    hit.elementos.assign(met_.begin(), met_.end());
    return hit;
  }

  const scene::Query& query_;
  std::optional<Root> nearest_, bound_;  // bound_: nothing is 0, where without_ is not empty
  scene::ElementSet met_, without_;
};

class WrittenEngine final : public engine::Engine {
 public:
  explicit WrittenEngine(std::vector<Element> elements) : elements_(std::move(elements)) {}

  void first_hits(std::span<const scene::Query> queries, std::span<scene::Hit> hits) const override {
    tbb::parallel_for(std::size_t{0}, queries.size(), [&](std::size_t i) {
      PieceSearch search(queries[i]);
      for (const Element& element : elements_) search.ask(element);
      hits[i] = search.hit();
    });
  }

  void occluded_segments(std::span<const scene::Query> queries, std::span<bool> occluded) const override {
    tbb::parallel_for(std::size_t{0}, queries.size(), [&](std::size_t i) {
      occluded[i] = std::ranges::any_of(elements_, [&](const Element& element) {
        return element.surface.hides(queries[i].rayo, scene::Origin(queries[i].en).contains(element.place));
      });
    });
  }

  glm::dvec3 normal(const scene::Scene&, ElementRef element, const glm::dvec3& point) const override {
    return std::ranges::lower_bound(elements_, element, {}, &Element::place)->surface.normal(point);
  }

 private:
  std::vector<Element> elements_;  // ascending
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

template <class SurfaceOf>
std::unique_ptr<const engine::Engine> engine_of(const scene::Scene& scene, SurfaceOf surface) {
  std::vector<Element> elements;
  elements.reserve(scene.size());
  scene.for_each([&](ElementRef place, const auto&) { elements.push_back({place, surface(place)}); });
  return std::make_unique<const WrittenEngine>(std::move(elements));
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
  return engine_of(scene, [&](ElementRef place) {
    const auto written = elements.find(scene.name(place).name());
    return written == elements.end() ? surface_of(text, scene, place) : surface_of(text, written->second);
  });
}

Written read(const io::Source& source, const Text& text) {
  std::vector<io::WrittenElement> own;
  Written result{io::read_scene(source, text.types(), own), {}, nullptr};
  for (io::WrittenElement& element : own) {
    std::string id = element.id;
    result.elements.emplace(std::move(id), std::move(element));
  }
  const scene::Scene& scene = result.scene;
  result.engine = engine_of(scene, [&](ElementRef place) {
    const auto written = result.elements.find(scene.name(place).name());
    return written == result.elements.end() ? surface_of(source, text, scene, place)
                                            : surface_of(source, text, written->second);
  });
  return result;
}

}  // namespace durero::written
