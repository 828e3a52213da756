// CGAL 5.5.1 epeck: misplaced
// Expected m:147 at t = 2, point (0, -8, -1.25); got m:324 at (2, -8, -1.25).
// A ray along the line of an edge, away from the edge, counts as a hit at its origin.
// the exact answer: m:147 at t = 2
// m:147:
//   t = 2
//     = 2
// the first point:
//   x = 0
//   y = -8
//   z = -1.25
// ambiguous: edge
// as good: a miss
//
// c++ -std=c++17 edge-behind.cpp -lgmp -lmpfr && ./a.out
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <cstdio>
#include <vector>

using Kernel = CGAL::Epeck;
using Point = Kernel::Point_3;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::iterator>;

int main() {
  const std::vector<const char*> names = {
      "m:147",
      "m:324",
  };
  Triangles triangles = {
      {Point(0.0, 0.0, 0.0), Point(0.0, 0.0, -8.0), Point(0.0, -8.0, -1.25)},
      {Point(4.0, -8.0, -1.25), Point(5.0, -8.0, -1.25), Point(0.0, 0.0, 0.0)},
  };
  CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> tree(triangles.begin(), triangles.end());
  const auto first = tree.first_intersection(Kernel::Ray_3(Point(2.0, -8.0, -1.25), Kernel::Vector_3(-1.0, 0.0, 0.0)));
  if (!first) {
    std::puts("got: miss");
  } else {
    const Point* point = boost::get<Point>(&first->first);
    const Point x = point ? *point : boost::get<Kernel::Segment_3>(first->first).source();
    const auto number = [](const Kernel::FT& a) { return CGAL::to_double(CGAL::exact(a)); };
    std::printf("got: hit %s - %.17g %.17g %.17g\n", names[first->second - triangles.begin()], number(x.x()), number(x.y()),
                number(x.z()));
  }
  std::puts("expected: hit m:147 - 0 -8 -1.25");
}
