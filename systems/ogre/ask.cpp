// Asks OGRE by Math::intersects of a ray and a triangle, triangle by triangle, from both sides.
#include "../ask.hpp"

#include <OgreMath.h>
#include <OgrePrerequisites.h>
#include <OgreRay.h>
#include <OgreVector.h>

using namespace ask;

static Ogre::Vector3 in(const Vec& a) { return {float(a[0]), float(a[1]), float(a[2])}; }

class Asked {
 public:
  explicit Asked(const Scene& of) : of_(&of) {}

  void ask(const Ray& asked) const {
    const Ogre::Ray ray(in(asked.p), in(asked.v));
    const Element* nearest = nullptr;
    double least = 0;
    for (const Element& e : of_->elements) {
      const auto [is_met, t] = Ogre::Math::intersects(ray, in(e.vec(0)), in(e.vec(3)), in(e.vec(6)), true, true);
      if (!is_met || (nearest != nullptr && t >= least)) continue;
      nearest = &e;
      least = t;
    }
    nearest == nullptr ? miss() : hit(nearest->name, least);
  }

 private:
  const Scene* of_;
};

int main() {
  return answer("OGRE " + std::to_string(OGRE_VERSION_MAJOR) + "." + std::to_string(OGRE_VERSION_MINOR) + "." +
                    std::to_string(OGRE_VERSION_PATCH),
                [](const Scene& scene) { return Asked(scene); });
}
