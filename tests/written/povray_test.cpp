// POV-Ray's surfaces by demo/surfaces/algebraic.tex: what is imported is met where POV-Ray's own rules put it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "durero/algebra/root.hpp"
#include "durero/io/pov/algebraic.hpp"
#include "durero/io/pov/pov.hpp"
#include "durero/written/text.hpp"
#include "support/catch.hpp"
#include "support/tree.hpp"

namespace durero::written {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

const Text& algebraic_text() {
  static const Text text(test::source_dir() + "/demo/surfaces/algebraic.tex");
  return text;
}

/// The surfaces of a text, asked by rays.
class Imported {
 public:
  explicit Imported(const std::string& text) : read_(import_text(text)) {
    for (const auto& [name, element] : read_.surfaces)
      surfaces_.push_back(algebraic_text().surface(io::algebraic_types()[element.type].word, element.values));
  }

  /// How many elements of the Z text there are.
  std::size_t size() const { return surfaces_.size(); }
  const std::vector<std::string>& lost() const { return read_.lost; }
  const io::Imported& all() const { return read_; }
  /// Whether some line of what is lost begins so.
  bool loses(std::string_view begin) const {
    return std::ranges::any_of(read_.lost, [&](const std::string& line) { return line.starts_with(begin); });
  }
  /// The least t at which a ray meets one of them.
  double first(const glm::dvec3& p, const glm::dvec3& v) const {
    double least = never;
    const model::Rayo rayo{model::Punto(p), model::Vector(v)};
    for (const Surface& surface : surfaces_) {
      const First first = surface.first(rayo, false);
      if (const auto* const root = std::get_if<algebra::Root>(&first))
        least = std::min(least, algebra::rounded_linear(0, 1, *root));
    }
    return least;
  }

 private:
  static io::Imported import_text(const std::string& text) {
    io::Source source("f", text + "\n#version 3.7;");
    source.set_keeps_surfaces(true);
    return io::read_pov(source);
  }

  io::Imported read_;
  std::vector<Surface> surfaces_;
};

using V = glm::dvec3;

TEST_CASE("A clip cuts what lies outside of it, and moves with what stands behind it") {
  const Imported half("sphere { 0, 2 clipped_by { plane { y, 1 } } translate 4*x }");
  REQUIRE(half.size() == 1);
  CHECK(half.first(V(4, 9, 0), V(0, -1, 0)) == 11);  // through the hole, to the bottom
  CHECK(half.first(V(4, -9, 0), V(0, 1, 0)) == 7);
  CHECK(half.first(V(-9, 1, 0), V(1, 0, 0)) == 13 - std::sqrt(3.0));
  CHECK(half.first(V(-9, 1.0000001, 0), V(1, 0, 0)) == never);
  const Imported moved_first("sphere { 0, 2 translate 4*x clipped_by { plane { x, 4 } } }");
  CHECK(moved_first.first(V(9, 0, 0), V(-1, 0, 0)) == 7);
  const Imported turned("sphere { 0, 2 clipped_by { plane { y, 0 } rotate 180*x } }");
  CHECK(turned.first(V(0, -9, 0), V(0, 1, 0)) == 11);
  const Imported with_it("sphere { 0, 2 clipped_by { plane { y, 0 } } rotate 180*x }");
  CHECK(with_it.first(V(0, -9, 0), V(0, 1, 0)) == 11);
  const Imported inverse("sphere { 0, 2 clipped_by { plane { y, 0 inverse } } }");
  CHECK(inverse.first(V(0, -9, 0), V(0, 1, 0)) == 11);
}

TEST_CASE("A box clips by its inside, and an inverse one by its outside") {
  const Imported within("sphere { 0, 2 clipped_by { box { -1.5, <3, 3, 3> } } }");
  CHECK(within.first(V(9, 0, 0), V(-1, 0, 0)) == 7);
  CHECK(within.first(V(-9, 0, 0), V(1, 0, 0)) == 11);
  const Imported outside("sphere { 0, 2 clipped_by { box { -1.5, <3, 3, 3> inverse } } }");
  CHECK(outside.first(V(9, 0, 0), V(-1, 0, 0)) == 11);
  CHECK(outside.first(V(-9, 0, 0), V(1, 0, 0)) == 7);
  CHECK(outside.first(V(0, 9, 0), V(0, -1, 0)) == 11);
}

TEST_CASE("A closed thing that is clipped keeps its faces, walls and lids") {
  const Imported box("box { <-1, -1, -1>, <1, 1, 1> clipped_by { sphere { x, 1.25 } } }");
  CHECK(box.size() == 6);
  CHECK(box.first(V(9, 0, 0), V(-1, 0, 0)) == 8);
  CHECK(box.first(V(-9, 0, 0), V(1, 0, 0)) == 10);
  const Imported can("cylinder { -y, y, 1 clipped_by { plane { x, 0 } } }");
  CHECK(can.size() == 3);
  CHECK(can.first(V(-0.5, 9, 0), V(0, -1, 0)) == 8);
  CHECK(can.first(V(0.5, 9, 0), V(0, -1, 0)) == never);
  CHECK(can.first(V(9, 0, 0), V(-1, 0, 0)) == 10);
  CHECK(can.first(V(-9, 1.5, 0), V(1, 0, 0)) == never);
  const Imported open("cylinder { -y, y, 1 open clipped_by { plane { x, 0 } } }");
  CHECK(open.size() == 1);
  const Imported cone("cone { 0, 2, 2*y, 1 clipped_by { box { <-9, 0.5, -9>, <9, 9, 9> } } }");
  CHECK(cone.size() == 3);
  CHECK(cone.first(V(-9, 1, 0), V(1, 0, 0)) == 7.5);
  CHECK(cone.first(V(-9, 0.25, 0), V(1, 0, 0)) == never);
  CHECK(cone.first(V(0, 9, 0), V(0, -1, 0)) == 7);
  CHECK(cone.first(V(1.25, 9, 0), V(0, -1, 0)) == 7.5);
}

TEST_CASE("A clip of several things is where all of them are, and that of a union clips its parts") {
  const Imported two(
      "sphere { 0, 2 clipped_by { plane { x, 0 } plane { y, 0 rotate 90*z } } clipped_by { plane { z, 1 } } }");
  REQUIRE(two.size() == 1);
  CHECK(two.first(V(9, 0, 0), V(-1, 0, 0)) == never);  // x ≤ 0 and −x ≤ 0
  CHECK(two.first(V(0, 9, 0), V(0, -1, 0)) == 7);
  CHECK(two.first(V(0, 0, 9), V(0, 0, -1)) == 11);
  const Imported parts("union { sphere { 0, 2 } sphere { 4*x, 2 } clipped_by { plane { x, 0 } } translate z }");
  CHECK(parts.size() == 2);
  CHECK(parts.first(V(9, 0, 1), V(-1, 0, 0)) == 11);
}

TEST_CASE("A clip that no quadrics hold leaves a thing out") {
  for (const char* const clip :
       {"union { plane { x, 0 } plane { y, 0 } }", "torus { 2, 1 }", "mesh { triangle { x, y, z } }",
        "plane { x, 0 } plane { y, 0 } plane { z, 0 } plane { x, 1 }"}) {
    const Imported none("sphere { 0, 2 clipped_by { " + std::string(clip) + " } }");
    CHECK(none.size() == 0);
    CHECK(none.loses("1 object left out: clipped_by"));
  }
  const Imported solid("intersection { sphere { 0, 1 } plane { y, 0 } clipped_by { plane { x, 0 } } }");
  CHECK(solid.size() == 0);
  CHECK(solid.loses("1 object left out: clipped_by"));
  const Imported in_solid("difference { sphere { 0, 1 clipped_by { plane { x, 0 } } } sphere { y, 1 } }");
  CHECK(in_solid.loses("1 solid left out"));
}

TEST_CASE("A disc may have a hole") {
  const Imported ring("disc { y, y, 2, 0.5 translate x }");
  REQUIRE(ring.size() == 1);
  CHECK(ring.first(V(2, 9, 0), V(0, -1, 0)) == 8);
  CHECK(ring.first(V(1.5, 9, 0), V(0, -1, 0)) == 8);
  CHECK(ring.first(V(1.25, 9, 0), V(0, -1, 0)) == never);
  CHECK(ring.first(V(3.5, 9, 0), V(0, -1, 0)) == never);
}

TEST_CASE("A bound that holds a thing shows nothing; another one may cut, which is told") {
  const auto bound = [](const std::string& object, const std::string& by) {
    return Imported(object + " bounded_by { " + by + " } }").loses("1 bounded_by left out: it may cut");
  };
  CHECK_FALSE(bound("sphere { 0, 2", "sphere { 0, 2 }"));
  CHECK_FALSE(bound("sphere { y, 2", "sphere { 2*y, 3 }"));
  CHECK(bound("sphere { y, 2", "sphere { 2*y, 2.9999999 }"));
  CHECK(bound("sphere { y, 2", "sphere { y, 1 }"));
  CHECK_FALSE(bound("sphere { 0, 2 translate 3*x", "box { <1, -2, -2>, <5, 2, 2> }"));
  CHECK(bound("sphere { 0, 2 translate 3*x", "box { <1, -2, -2>, <5, 2, 1.5> }"));
  CHECK_FALSE(bound("box { -1, 1 rotate 45*y", "box { -1.5, 1.5 }"));
  CHECK(bound("box { -1, 1 rotate 45*y", "box { -1.25, 1.25 }"));
  CHECK_FALSE(bound("cylinder { 0, 3*x, 1", "box { <-1, -1, -1>, <4, 1, 1> }"));
  CHECK(bound("cylinder { 0, 3*x, 1", "box { <-1, -1, -1>, <3, 0.5, 1> }"));
  CHECK_FALSE(bound("torus { 2, 1", "sphere { 0, 3 }"));
  CHECK_FALSE(bound("union { sphere { 0, 1 } triangle { x, y, 2*z }", "plane { y, 1 }"));
  CHECK(bound("union { sphere { 0, 1 } triangle { x, 2*y, z }", "plane { y, 1 }"));
  CHECK_FALSE(bound("intersection { plane { x, 0 } sphere { 0, 1 }", "box { -1, 1 }"));
  CHECK(bound("difference { plane { x, 0 } sphere { 0, 1 }", "box { -1, 1 }"));
  CHECK(bound("sphere { 0, 1", "box { -2, 2 inverse }"));
  CHECK(bound("sphere { 0, 1", "cylinder { -9*y, 9*y, 9 }"));  // of which nothing is known
  CHECK_FALSE(bound("sphere { 0, 2", "box { -1, 1 } } clipped_by { bounded_by"));
}

TEST_CASE("A thing may be clipped by its own bound, or bounded by its clip") {
  const Imported both("sphere { 0, 2 bounded_by { plane { y, 1 } } rotate 90*z clipped_by { bounded_by } }");
  REQUIRE(both.size() == 1);
  CHECK(both.first(V(-9, 0, 0), V(1, 0, 0)) == 11);  // y ≤ 1 has become −x ≤ 1
  CHECK(both.first(V(9, 0, 0), V(-1, 0, 0)) == 7);
  const Imported other("sphere { 0, 2 clipped_by { plane { y, 1 } } bounded_by { clipped_by } }");
  CHECK(other.size() == 1);
  CHECK(Imported("sphere { 0, 2 clipped_by { bounded_by } }").loses("1 object left out: clipped_by"));
}

TEST_CASE("A lathe of lines is cones, cylinders and discs, without lids") {
  const Imported all("lathe { linear_spline 5, <0, 0>, <2, 2>, <2, 3>, <1, 3>, <1, 3> translate x }");
  const scene::Scene& scene = all.all().scene;
  CHECK(scene.shapes<scene::Cone>().size() == 1);
  CHECK(scene.shapes<scene::Cylinder>().size() == 1);
  CHECK(scene.shapes<scene::Disc>().size() == 0);
  REQUIRE(all.size() == 1);  // a ring from 1 to 2
  CHECK(all.first(V(2.5, 9, 0), V(0, -1, 0)) == 6);
  CHECK(all.first(V(1.5, 9, 0), V(0, -1, 0)) == never);
  CHECK(all.all().groups.table().contains("u1"));
  const Imported lid("lathe { 3, <0, 1>, <-2, 1>, <-2, 0> }");
  CHECK(lid.all().scene.shapes<scene::Disc>().size() == 1);
  CHECK(lid.all().scene.shapes<scene::Cylinder>().size() == 1);
  CHECK(Imported("lathe { 2, <-1, 0>, <1, 2> }")
            .loses("1 lathe with a line that crosses its axis or turns back left out"));
  CHECK(Imported("difference { sphere { 0, 1 } lathe { 3, <0, 1>, <2, 1>, <0, 0> } }").loses("1 solid left out"));
}

TEST_CASE("A lathe of curves turns each stretch from its first parameter to its last") {
  // From (1, 0) to (1, 2) by (3, 1): at the height 2·t the radius is 1 + 4·t − 4·t².
  const Imported bow(
      "lathe { bezier_spline 4, <1, 0>, <2.3333333333333335, 0.66666666666666663>, "
      "<2.3333333333333335, 1.3333333333333333>, <1, 2> translate y }");
  REQUIRE(bow.size() == 1);
  CHECK(std::abs(bow.first(V(-9, 2, 0), V(1, 0, 0)) - 7) < 1e-14);
  CHECK(std::abs(bow.first(V(-9, 1.5, 0), V(1, 0, 0)) - 7.25) < 1e-14);
  CHECK(bow.first(V(-9, 3.0000001, 0), V(1, 0, 0)) == never);
  CHECK(bow.first(V(-9, 0.9999999, 0), V(1, 0, 0)) == never);
  CHECK(bow.first(V(0, 9, 0), V(0, -1, 0)) == never);
  // A parabola with the weights of quadratic_spline: from (1, 0) to (1, 1), with (2, −1) before them. Halfway its
  // radius is that of 1 − t/2 + t²/2, 7/8.
  const Imported parabola("lathe { quadratic_spline 3, <2, -1>, <1, 0>, <1, 1> }");
  CHECK(parabola.first(V(-9, 0.5, 0), V(1, 0, 0)) == 9 - 0.875);
  CHECK(parabola.first(V(-9, -0.5, 0), V(1, 0, 0)) == never);
  CHECK(parabola.first(V(-9, 1.5, 0), V(1, 0, 0)) == never);
  // Halfway a cubic has −1/16, 9/16, 9/16 and −1/16 of its points.
  const Imported cubic("lathe { cubic_spline 4, <2, -1>, <1, 0>, <2, 1>, <5, 3> }");
  CHECK(std::abs(cubic.first(V(-9, 0.4375, 0), V(1, 0, 0)) - (9 - 1.25)) < 1e-14);
  const Imported line("lathe { cubic_spline 4, <1, 0>, <1, 1>, <1, 2>, <1, 3> }");
  CHECK(line.all().scene.shapes<scene::Cylinder>().size() == 1);
  CHECK(Imported("lathe { bezier_spline 4, <1, 0>, <1, 3>, <1, -1>, <1, 2> }").loses("1 lathe with a line that "));
  const std::string two = "<0, -1>, <1, -1>, <2, -1>, <2, 0>, <2, 0>, <1, 0.5>, <2, 1>, <1, 1>";
  CHECK(Imported("lathe { bezier_spline 8, " + two + " }").size() == 2);
  CHECK_THROWS_AS(Imported("lathe { bezier_spline 5, <1, 0>, <1, 1>, <1, 2>, <1, 3>, <1, 4> }"), io::InputError);
}

TEST_CASE("A curve that crosses itself is there once, and its crossing belongs to it where it gets there") {
  // (2 + (t² − 1), t·(t² − 1)) for t = −2 + 4·s, which passes (2, 0) at t = 1 and at t = −1; and parts of it.
  const auto nodal = [](double from, double to) {
    const auto at = [](double t) { return V(1 + t * t, t * t * t - t, 0); };
    const auto slope = [](double t) { return V(2 * t, 3 * t * t - 1, 0); };
    const double third = (to - from) / 3;
    const V a = at(from), b = a + third * slope(from), d = at(to), c = d - third * slope(to);
    std::string text = "lathe { bezier_spline 4";
    for (const V& p : {a, b, c, d}) text += fmt::format(", <{}, {}>", p.x, p.y);
    return Imported(text + " }");
  };
  CHECK(nodal(-4, 2).first(V(-9, 0, 0), V(1, 0, 0)) == 7);
  CHECK(nodal(-0.5, 4).first(V(-9, 0, 0), V(1, 0, 0)) == 7);
  CHECK(nodal(-0.5, 0.25).first(V(-9, 0, 0), V(1, 0, 0)) == 8);  // the point of t = 0
  CHECK(nodal(2, 5).first(V(-9, 0, 0), V(1, 0, 0)) == never);
  CHECK(nodal(-2, 2).first(V(-9, 0, 0), V(1, 0, 0)) == 7);
}

TEST_CASE("A sor has its radii at its points, slopes by their neighbours, and lids unless it is open") {
  const std::string points = "<1, -1>, <1, 0>, <2, 1>, <1, 3>, <0, 4>";
  const Imported vase("sor { 5, " + points + " open }");
  CHECK(vase.size() == 2);
  CHECK(vase.first(V(-9, 0, 0), V(1, 0, 0)) == 8);
  CHECK(vase.first(V(-9, 1, 0), V(1, 0, 0)) == 7);
  CHECK(vase.first(V(-9, 3, 0), V(1, 0, 0)) == 8);
  CHECK(vase.first(V(-9, 3.0000001, 0), V(1, 0, 0)) == never);
  CHECK(vase.first(V(0.5, 9, 0), V(0, -1, 0)) == never);
  // r² goes from 1 to 4 with the slopes 2·1·½ = 1 and 2·2·0 = 0: in the middle it is 5/2 + 1/8.
  CHECK(vase.first(V(-9, 0.5, 0), V(1, 0, 0)) == 9 - std::sqrt(2.625));
  // From 4 to 1 over a length of 2, with the slopes 0 and 2·1·(−2/3): in the middle 5/2 + 2·(4/3)/8.
  CHECK(std::abs(vase.first(V(-9, 2, 0), V(1, 0, 0)) - (9 - std::sqrt(2.5 + 1 / 3.0))) < 1e-15 * 9);
  const Imported closed("sor { 5, " + points + " }");
  CHECK(closed.all().scene.shapes<scene::Disc>().size() == 2);
  CHECK(Imported("sor { 5, " + points + " clipped_by { plane { x, 0 } } }").size() == 4);
  for (const char* const wrong :
       {"<1, -1>, <1, 0>, <2, 0>, <1, 3>", "<1, -1>, <1, 0>, <2, -1>, <1, 3>", "<1, -1>, <-1, 0>, <2, 1>, <1, 3>"})
    CHECK_THROWS_AS(Imported("sor { 4, " + std::string(wrong) + " }"), io::InputError);
}

TEST_CASE("An open prism of curves has a side for each stretch, straight up or as a cone") {
  // The parabola of quadratic_spline from (1, 0) to (1, 1) by (2, −1) before them, and back to its begin.
  const std::string points = "<2, -1>, <1, 0>, <1, 1>, <1, 0>";
  const Imported straight("prism { linear_sweep quadratic_spline 1, -1, 4, " + points + " open translate y }");
  CHECK(straight.size() == 1);  // the way back is a line
  CHECK(straight.all().scene.shapes<scene::Triangle>().size() == 2);
  CHECK(straight.first(V(-9, 1, 0.5), V(1, 0, 0)) == 9.875);
  CHECK(straight.first(V(-9, 2.0000001, 0.5), V(1, 0, 0)) == never);
  CHECK(straight.first(V(-9, -0.0000001, 0.5), V(1, 0, 0)) == never);
  CHECK(straight.first(V(-9, 1, 1.5), V(1, 0, 0)) == never);
  const Imported cone("prism { conic_sweep quadratic_spline 0, 4, 4, " + points + " open }");
  CHECK(cone.first(V(-9, 2, 1), V(1, 0, 0)) == 10.75);
  CHECK(cone.first(V(-9, 0, 0), V(1, 0, 0)) == 9);  // its point
  CHECK(cone.first(V(-9, 0, 0.25), V(1, 0, 0)) == never);
  const std::string bow = "<1, 0>, <3, 0>, <3, 2>, <1, 2>, <1, 2>, <1, 1>, <1, 1>, <1, 0>";
  const Imported bezier("prism { bezier_spline 0, 1, 8, " + bow + " open }");
  CHECK(bezier.size() == 1);
  CHECK(bezier.first(V(9, 0.5, 1), V(-1, 0, 0)) == 6.5);
  const Imported cubic("prism { cubic_spline 0, 1, 6, <0, -1>, <1, 0>, <2, 1>, <0, 3>, <1, 0>, <2, 1> open }");
  CHECK(cubic.size() == 3);
  CHECK(Imported("prism { bezier_spline 0, 1, 8, " + bow + " }").loses("1 prism of curves that is closed, or whose o"));
  CHECK(Imported("prism { quadratic_spline 0, 1, 4, <0, 1>, <1, 0>, <1, 1>, <2, 3> open }").loses("1 prism of curves"));
}

TEST_CASE("A superellipsoid has the exponents of POV-Ray, whichever are odd or below 1") {
  // (x⁴ + y⁴)² + z⁸ = 1: a = 4, b = 8.
  const Imported even("superellipsoid { <0.5, 0.25> translate 4*x }");
  REQUIRE(even.size() == 1);
  CHECK(even.first(V(-9, 0, 0), V(1, 0, 0)) == 12);
  CHECK(std::abs(even.first(V(-9, 0.5, 0.5), V(1, 0, 0)) -
                 (13 - std::pow(std::sqrt(1 - std::pow(0.5, 8)) - 0.0625, 0.25))) < 1e-14);
  // (|x| + |y|)² + |z| = 1: a = 1, b = 1 times 2, and the square root of both sides is of no use.
  const Imported odd("superellipsoid { <2, 1> }");
  CHECK(std::abs(odd.first(V(-9, -0.25, -0.5), V(1, 0, 0)) - (9 - (std::sqrt(0.75) - 0.25))) < 1e-14);
  CHECK(odd.first(V(-9, 0.75, 0.75), V(1, 0, 0)) == never);
  // √(x² + y²) + |z| = 1, two cones: a = 2, b = 1, the exponent is 1/2.
  const Imported cones("superellipsoid { <1, 2> scale <1, 1, -2> }");
  CHECK(cones.first(V(-9, 0, -1), V(1, 0, 0)) == 8.5);
  CHECK(cones.first(V(-9, 0, 1), V(1, 0, 0)) == 8.5);
  CHECK(cones.first(V(-9, 0, 2.5), V(1, 0, 0)) == never);  // a cone has another half
  const Imported octahedron("superellipsoid { <2, 2> }");
  CHECK(octahedron.first(V(-9, 0.25, -0.25), V(1, 0, 0)) == 8.5);
  for (const char* const exponents : {"0.3, 1", "1, 0.01", "0.4, 0.25"})
    CHECK(
        Imported("superellipsoid { <" + std::string(exponents) + "> }").loses("1 superellipsoid of too high a degree"));
  CHECK_THROWS_AS(Imported("superellipsoid { <0, 1> }"), io::InputError);
}

TEST_CASE("A blob is where densities add up to its threshold, and each ends at its radius") {
  // (1 − x²/4)² = 9/16 at x = 1.
  const Imported one("blob { threshold 0.5625 sphere { 0, 2, 1 } translate x }");
  REQUIRE(one.size() == 1);
  CHECK(one.first(V(-9, 0, 0), V(1, 0, 0)) == 9);
  // With a second one about (3, 0, 0): at 3/2 both have (1 − 9/16)², beyond 2 the first one has none.
  const Imported two("blob { threshold 0.5625 sphere { 0, 2, 1 } component 1, 2, <3, 0, 0> }");
  CHECK(two.first(V(-9, 0, 0), V(1, 0, 0)) == 8);
  // At 1.5 the sum is 2·(7/16)², less than the threshold; at 2 the second alone has that.
  CHECK(two.first(V(1.5, 0, 0), V(1, 0, 0)) == 0.5);
  const Imported strong("blob { threshold 0.5625 sphere { 0, 2, strength 2 } sphere { 0, 2, -1 scale 1 } }");
  CHECK(strong.first(V(-9, 0, 0), V(1, 0, 0)) == 8);
  const Imported rod("blob { threshold 0.5625 cylinder { -x, 3*x, 2, 1 } translate x rotate 90*z }");
  CHECK(rod.first(V(9, 2, 0), V(-1, 0, 0)) == 8);
  CHECK(rod.first(V(0, -9, 0), V(0, 1, 0)) == 8);
  CHECK(rod.first(V(0, 9, 0), V(0, -1, 0)) == 4);
  const Imported scaled(
      "blob { threshold 0.5625 sphere { 0, 1, 1 scale 2 translate 3*y texture { pigment { rgb 1 } } } }");
  CHECK(scaled.first(V(-9, 3, 0), V(1, 0, 0)) == 8);
  CHECK(scaled.loses("1 texture of parts of a blob left out"));
  const std::string ball = " sphere { 0, 2, 0.5 }";
  CHECK(Imported("blob {" + ball + ball + ball + ball + ball + ball + " }").size() == 1);
  CHECK(Imported("blob {" + ball + ball + ball + ball + ball + ball + ball + " }").loses("1 blob of too many parts"));
  CHECK(
      Imported("blob {" + ball + " sphere { 0, 2, 1 scale <1, 2, 1> } }").loses("1 blob of too many parts, or one m"));
  CHECK(Imported("difference { sphere { 0, 1 } blob {" + ball + " } }").loses("1 solid left out"));
}

TEST_CASE(
    "An isosurface of a polynomial is where it has its threshold, with the lids of its container unless it is open") {
  const std::string bowl = "function { x*x + pow(z, 2) - y } contained_by { box { <-2, 0, -2>, <2, 1, 2> } }";
  const Imported open("isosurface { " + bowl + " open max_gradient 5 accuracy 0.001 translate 3*x }");
  REQUIRE(open.size() == 1);
  CHECK(open.first(V(3, 9, 0.5), V(0, -1, 0)) == 8.75);
  CHECK(open.first(V(3, 9, 1.5), V(0, -1, 0)) == never);
  CHECK(open.first(V(-9, 0.25, 0), V(1, 0, 0)) == 11.5);
  const Imported closed("isosurface { " + bowl + " }");
  CHECK(closed.size() == 7);
  CHECK(closed.first(V(0, 9, 0.5), V(0, -1, 0)) == 8);
  CHECK(closed.first(V(0, 9, 1.5), V(0, -1, 0)) == never);
  CHECK(closed.first(V(-9, 0.25, 0), V(1, 0, 0)) == 8.5);
  const Imported ball(
      "#declare K = -4; isosurface { function { -K*(x*x + y*y)/4 + z*z*z*z + K - -1 } threshold -2 contained_by { "
      "sphere { 0, 0.75 } } }");
  CHECK(ball.size() == 2);
  CHECK(ball.first(V(-9, 0, 0), V(1, 0, 0)) == 8.25);  // 9/16 − 3 is below −2
  const Imported own("isosurface { function { x } }");
  CHECK(own.first(V(-9, 0.5, 0), V(1, 0, 0)) == 8);
  CHECK(own.first(V(9, 0.5, 0), V(-1, 0, 0)) == 9);
  CHECK(own.first(V(9, 1.5, 0), V(-1, 0, 0)) == never);
  CHECK(Imported("isosurface { function { x } threshold 0.5 }").first(V(9, 0.5, 0), V(-1, 0, 0)) == 8.5);
  CHECK(Imported("isosurface { " + bowl + " clipped_by { plane { x, 0 } } }").loses("1 object left out: clipped_by"));
  for (const char* const other : {"sin(x)", "x/y", "pow(x, 1.5)", "pow(x, y)", "x*x*x*x*x", "sqrt(x)", "2",
                                  "x*(y)*z*z*z", "f_sphere(x, y, z, 1)"})
    CHECK(Imported("isosurface { function { " + std::string(other) + " } }")
              .loses("1 isosurface of no polynomial, or of a degree above four, left out"));
  CHECK_THROWS_AS(Imported("isosurface { function { x } contained_by { plane { y, 0 } } }"), io::InputError);
}

}  // namespace
}  // namespace durero::written
