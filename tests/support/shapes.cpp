#include "support/shapes.hpp"

#include "durero/scene/addition.hpp"

namespace durero::test {

template <class Shape>
scene::ElementRef add(scene::Scene& scene, const model::Elemento& name, const Shape& shape) {
  scene.apply(scene::addition(name, shape));
  return *scene.find(name.name());
}

template scene::ElementRef add(scene::Scene&, const model::Elemento&, const scene::Sphere&);
template scene::ElementRef add(scene::Scene&, const model::Elemento&, const scene::Cylinder&);
template scene::ElementRef add(scene::Scene&, const model::Elemento&, const scene::Cone&);
template scene::ElementRef add(scene::Scene&, const model::Elemento&, const scene::TruncatedCone&);
template scene::ElementRef add(scene::Scene&, const model::Elemento&, const scene::Plane&);
template scene::ElementRef add(scene::Scene&, const model::Elemento&, const scene::Disc&);
template scene::ElementRef add(scene::Scene&, const model::Elemento&, const scene::Triangle&);

}  // namespace durero::test
