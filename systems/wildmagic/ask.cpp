// Asks Wild Magic by IntrRay3Triangle3, triangle by triangle.
#include "../ask.hpp"

#include <libwildmagic/Wm5IntrRay3Triangle3.h>

using namespace ask;

static Wm5::Vector3d in(const Vec& a) { return {a[0], a[1], a[2]}; }

class Asked {
 public:
  explicit Asked(const Scene& of) : of_(&of) {
    for (const Element& e : of.elements) triangles_.emplace_back(in(e.vec(0)), in(e.vec(3)), in(e.vec(6)));
  }

  void ask(const Ray& asked) const {
    const Wm5::Ray3d ray(in(asked.p), in(unit(asked.v)));
    const Element* nearest = nullptr;
    double least = 0;
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
      Wm5::IntrRay3Triangle3d both(ray, triangles_[i]);
      if (!both.Find() || (nearest != nullptr && both.GetRayParameter() >= least)) continue;
      nearest = &of_->elements[i];
      least = both.GetRayParameter();
    }
    nearest == nullptr ? miss() : hit(nearest->name, least);
  }

 private:
  const Scene* of_;
  std::vector<Wm5::Triangle3d> triangles_;
};

int main() {
  return answer("Wild Magic 5.17", [](const Scene& scene) { return Asked(scene); });
}
