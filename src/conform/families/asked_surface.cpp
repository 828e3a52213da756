#include "durero/conform/families/asked_surface.hpp"

#include <algorithm>

namespace durero::conform {

const AskedSurface* OtherElements::surface(scene::ElementRef element) const {
  const auto found = std::ranges::lower_bound(surfaces, element, {}, &NamedSurface::element);
  return found != surfaces.end() && found->element == element ? &found->surface : nullptr;
}

std::vector<NamedSurface> surfaces_of(const scene::Scene& scene, const io::WrittenByName& elements,
                                      const std::shared_ptr<const written::Text>& text) {
  std::vector<NamedSurface> all;
  for (const auto& [name, element] : elements) {
    const std::string& type = text->types()[element.type].word;
    all.push_back({scene.find(name).value(), {text, type, element.values, text->surface(type, element.values)}});
  }
  std::ranges::sort(all, {}, &NamedSurface::element);
  return all;
}

}  // namespace durero::conform
