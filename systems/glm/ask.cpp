// Asks the functions of GLM_GTX_intersect, in binary32 or binary64. Their directions must be of unit length; of several
// elements the one with the least distance is nearest, as whoever uses them writes it.
#define GLM_ENABLE_EXPERIMENTAL
#include "../ask.hpp"

#include <glm/glm.hpp>
#include <glm/gtx/intersect.hpp>

template <class T>
class Asked {
 public:
  explicit Asked(const ask::Scene& of) : of_(&of) {}

  void ask(const ask::Ray& ray) const {
    const V p = vec(ray.p), v = vec(ask::unit(ray.v));
    const ask::Element* nearest = nullptr;
    T least = 0;
    for (const ask::Element& e : of_->elements) {
      T t = 0;
      if (!meets(e, p, v, t) || (nearest != nullptr && t >= least)) continue;
      nearest = &e;
      least = t;
    }
    nearest == nullptr ? ask::miss() : ask::hit(nearest->name, double(least));
  }

 private:
  using V = glm::vec<3, T, glm::defaultp>;

  static V vec(const ask::Vec& a) { return V(a[0], a[1], a[2]); }

  static bool meets(const ask::Element& e, const V& p, const V& v, T& t) {
    if (e.is("esfera")) return glm::intersectRaySphere(p, v, vec(e.centro()), T(e.numbers[3]) * T(e.numbers[3]), t);
    if (e.is("plano")) return glm::intersectRayPlane(p, v, vec(e.centro()), vec(e.vector()), t);
    glm::vec<2, T, glm::defaultp> where;
    return glm::intersectRayTriangle(p, v, vec(e.vec(0)), vec(e.vec(3)), vec(e.vec(6)), where, t);
  }

  const ask::Scene* of_;
};

template <class T>
int answer(const std::string& format) {
  const std::string version = std::to_string(GLM_VERSION_MAJOR) + "." + std::to_string(GLM_VERSION_MINOR) + "." +
                              std::to_string(GLM_VERSION_PATCH) + "." + std::to_string(GLM_VERSION_REVISION);
  return ask::answer("GLM " + version + " " + format, [](const ask::Scene& scene) { return Asked<T>(scene); });
}

int main(int, char** argv) { return std::string(argv[1]) == "f32" ? answer<float>("f32") : answer<double>("f64"); }
