// Asks CGAL by AABB_tree of the triangles, in the kernel that KERNEL names.
#include "../ask.hpp"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/version.h>

using namespace ask;
using Kernel = KERNEL;
using Point = Kernel::Point_3;
using Triangle = Kernel::Triangle_3;
using Triangles = std::vector<Triangle>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

static Point point(const Vec& a) { return {a[0], a[1], a[2]}; }
static Vec vec(const Point& a) {
  return {CGAL::to_double(CGAL::exact(a.x())), CGAL::to_double(CGAL::exact(a.y())),
          CGAL::to_double(CGAL::exact(a.z()))};
}

// A ray within the plane of a triangle meets a stretch of it.
template <class Met>
static Point begin_of(const Met& met, const Point& origin) {
  if (const Point* place = boost::get<Point>(&met)) return *place;
  const auto& stretch = boost::get<Kernel::Segment_3>(met);
  const bool is_begin = CGAL::has_smaller_distance_to_point(origin, stretch.source(), stretch.target());
  return is_begin ? stretch.source() : stretch.target();
}

class Asked {
 public:
  explicit Asked(const Scene& of) : of_(&of) {
    for (const Element& e : of.elements) triangles_.emplace_back(point(e.vec(0)), point(e.vec(3)), point(e.vec(6)));
    tree_.insert(triangles_.begin(), triangles_.end());
    tree_.build();
  }

  void ask(const Ray& asked) const {
    if (asked.is_point) {
      const auto [place, met] = tree_.closest_point_and_primitive(point(asked.p));
      return hit_at(name(met), vec(place));
    }
    const Kernel::Ray_3 ray(point(asked.p), Kernel::Vector_3(asked.v[0], asked.v[1], asked.v[2]));
    if (asked.is_count)
      return void(std::printf("count %zu\n", std::size_t(tree_.number_of_intersected_primitives(ray))));
    const auto first = tree_.first_intersection(ray);
    if (!first) return miss();
    hit_at(name(first->second), vec(begin_of(first->first, ray.source())));
  }

 private:
  std::string name(Triangles::const_iterator met) const {
    return of_->elements[std::size_t(met - triangles_.begin())].name;
  }

  const Scene* of_;
  Triangles triangles_;
  Tree tree_;
};

int main(int, char** argv) {
  return answer(std::string("CGAL " CGAL_VERSION_STR " ") + argv[1], [](const Scene& scene) { return Asked(scene); });
}
