// The judgement on what a hit says beside its place: normals, sides, u and v.
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>

#include "conform/drafted.hpp"
#include "conform/judged.hpp"
#include "durero/conform/judge/judge.hpp"
#include "durero/surface/normal.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::conform;

namespace {

Profile profile_of_besides(NormalSide side = NormalSide::outward, NormalLength length = NormalLength::unit) {
  Profile profile = test::profile_of_all();
  profile.normal = side;
  profile.normal_length = length;
  profile.faces = profile.uv = true;
  return profile;
}

/// A hit of a ball around (0, 0, 4) at t = 3.
const SuiteCase& ball() {
  static const SuiteCase of = test::sphere_case({0, 0, 0}, {0, 0, 1});
  return of;
}

Verdict of_normal(const glm::dvec3& normal, NormalSide side = NormalSide::outward,
                  NormalLength length = NormalLength::unit, const SuiteCase& of = ball(), double t = 3) {
  Claim claim = test::hit_at(t);
  claim.normal = normal;
  return judge(of, 0, claim, profile_of_besides(side, length)).verdict;
}

/// A triangle whose front faces the origin, met at u = 1/4, v = 1/2.
SuiteCase triangle() {
  return test::drafted({{"e0", scene::Triangle{{{{-1, -2, 4}, {-1, 2, 4}, {1, -2, 4}}}}}}, {0, -1, 0}, {0, 0, 1});
}

Verdict of_uv(const glm::dvec2& uv) {
  Claim claim = test::hit_at(4);
  claim.uv = uv;
  return judge(triangle(), 0, claim, profile_of_besides()).verdict;
}

/// A right answer with all that it may say, in binary64.
Claim full_claim(const SuiteCase& of, std::size_t ray) {
  Claim claim = test::right_claim(of.truths[ray]);
  if (of.truths[ray].hit.resultado != model::Resultado::hit) return claim;
  const glm::dvec3 w = of.truths[ray].hit.punto;
  claim.normal = surface::normal(of.the_case.scene, *claim.element, w);
  claim.is_front = glm::dot(*claim.normal, of.the_case.rays[ray].rayo.v().xyz()) < 0;
  if (claim.element->tipo != scene::Triangle::tipo) return claim;
  const auto& [a, b, c] = of.the_case.scene.shapes<scene::Triangle>()[claim.element->index].vertices;
  const glm::dvec3 n = glm::cross(b - a, c - a);
  claim.uv = glm::dvec2(glm::dot(glm::cross(w - a, c - a), n), glm::dot(glm::cross(b - a, w - a), n)) / glm::dot(n, n);
  return claim;
}

/// A fault in what is said besides: it changes the claim about an element.
struct BesidesFault {
  const char* name;
  Verdict seen;
  std::function<void(Claim&, const SuiteCase&, std::size_t ray)> change;
};

bool is_of_triangle(const Claim& claim) { return claim.element->tipo == scene::Triangle::tipo; }

std::vector<BesidesFault> besides_faults() {
  const auto nothing = [](Claim&, const SuiteCase&, std::size_t) {};
  std::vector<BesidesFault> all{{"right", Verdict::right, nothing}};
  const auto add = [&](const char* name, Verdict seen, auto change) { all.push_back({name, seen, change}); };
  add("flipped", Verdict::wrong_normal, [](Claim& claim, const auto&, auto) { claim.normal = -*claim.normal; });
  add("facing the ray where it should point outward", Verdict::wrong_normal, [](Claim& claim, const auto&, auto) {
    if (!*claim.is_front) claim.normal = -*claim.normal;
  });
  add("not normalised: of the length of the way", Verdict::wrong_normal,
      [](Claim& claim, const auto&, auto) { *claim.normal *= 1.5; });
  add("of the other order of vertices", Verdict::wrong_normal, [](Claim& claim, const auto&, auto) {
    if (is_of_triangle(claim)) claim.normal = -*claim.normal;
  });
  add("of an instance, transformed as a vector", Verdict::wrong_normal,
      [](Claim& claim, const auto&, auto) { claim.normal = glm::normalize(*claim.normal * glm::dvec3(1, 1, 2)); });
  add("of a cone without its slope", Verdict::wrong_normal, [](Claim& claim, const SuiteCase& of, auto) {
    of.the_case.scene.visit(*claim.element, [&]<class Shape>(const Shape& shape) {
      if constexpr (requires { shape.proporcion; })
        claim.normal = glm::normalize(*claim.normal - glm::dot(*claim.normal, shape.vector) * shape.vector);
    });
  });
  add("by binary16", Verdict::off, [](Claim& claim, const auto&, auto) {
    for (int i = 0; i < 3; ++i) (*claim.normal)[i] = std::nearbyint(std::ldexp((*claim.normal)[i], 12)) / 4096;
  });
  add("an axis swapped", Verdict::wrong_normal,
      [](Claim& claim, const auto&, auto) { std::swap(claim.normal->y, claim.normal->z); });
  add("no number", Verdict::non_finite, [](Claim& claim, const auto&, auto) { claim.normal->x = NAN; });
  add("nothing", Verdict::wrong_normal, [](Claim& claim, const auto&, auto) { claim.normal = glm::dvec3(0); });
  add("front for back", Verdict::wrong_face,
      [](Claim& claim, const auto&, auto) { claim.is_front = !*claim.is_front; });
  add("always front", Verdict::wrong_face, [](Claim& claim, const auto&, auto) { claim.is_front = true; });
  add("u and v swapped", Verdict::wrong_uv, [](Claim& claim, const auto&, auto) {
    if (claim.uv) claim.uv = glm::dvec2(claim.uv->y, claim.uv->x);
  });
  add("w and u for u and v", Verdict::wrong_uv, [](Claim& claim, const auto&, auto) {
    if (claim.uv) claim.uv = glm::dvec2(1 - claim.uv->x - claim.uv->y, claim.uv->x);
  });
  add("u and v of no number", Verdict::non_finite, [](Claim& claim, const auto&, auto) {
    if (claim.uv) claim.uv->y = INFINITY;
  });
  add("u and v by bytes", Verdict::wrong_uv, [](Claim& claim, const auto&, auto) {
    if (claim.uv) claim.uv = glm::dvec2(std::floor(claim.uv->x * 256), std::floor(claim.uv->y * 256)) / 256.0;
  });
  return all;
}

/// The families whose sizes binary64 has room for in a cross product.
bool is_of_moderate_size(const Family& family) {
  for (const std::string_view wild : {"degenerate_numbers", "scale", "tiny", "distance_limit", "mesh_inside", "nested"})
    if (family.name == wild) return false;
  return true;
}

}  // namespace

TEST_CASE("a normal is right within the declared error of its direction, its side and its length") {
  CHECK(of_normal({0, 0, -1}) == Verdict::exact);
  CHECK(of_normal({0, 0, 1}) == Verdict::wrong_normal);
  CHECK(of_normal({0x1p-50, 0, -1}) == Verdict::exact);
  CHECK(of_normal({0x1p-30, 0, -1}) == Verdict::off);
  CHECK(of_normal({0x1p-9, 0, -1}) == Verdict::wrong_normal);
  CHECK(of_normal({0, 0, -1 - 0x1p-30}) == Verdict::off);
  CHECK(of_normal({0, 0, -2}) == Verdict::wrong_normal);
  CHECK(of_normal({0, 0, -2}, NormalSide::outward, NormalLength::any) == Verdict::exact);
  CHECK(of_normal({0, 0, 0}, NormalSide::outward, NormalLength::any) == Verdict::wrong_normal);
  CHECK(of_normal({0, NAN, -1}) == Verdict::non_finite);
}

TEST_CASE("the side of a normal is the one that the profile says") {
  const SuiteCase inside = test::sphere_case({0, 0, 4}, {0, 0, 1});
  const auto from_inside = [&](double z, NormalSide side) {
    return of_normal({0, 0, z}, side, NormalLength::unit, inside, 1);
  };
  CHECK(from_inside(1, NormalSide::outward) == Verdict::exact);
  CHECK(from_inside(-1, NormalSide::outward) == Verdict::wrong_normal);
  CHECK(from_inside(-1, NormalSide::facing) == Verdict::exact);
  CHECK(from_inside(1, NormalSide::facing) == Verdict::wrong_normal);
  CHECK(from_inside(1, NormalSide::either) == Verdict::exact);
  CHECK(from_inside(-1, NormalSide::either) == Verdict::exact);
  CHECK(of_normal({0, 0, 1}, NormalSide::facing) == Verdict::wrong_normal);
  CHECK(of_normal({0, 0, 1}, NormalSide::none) == Verdict::exact);
}

TEST_CASE("the side that the ray comes from, and u and v of a triangle") {
  Claim front = test::hit_at(4);
  front.is_front = true;
  CHECK(judge(triangle(), 0, front, profile_of_besides()).verdict == Verdict::exact);
  front.is_front = false;
  CHECK(judge(triangle(), 0, front, profile_of_besides()).verdict == Verdict::wrong_face);
  CHECK(judge(triangle(), 0, front, test::profile_of_all()).verdict == Verdict::exact);
  CHECK(of_uv({0.25, 0.5}) == Verdict::exact);
  CHECK(of_uv({0.25 + 0x1p-51, 0.5}) == Verdict::exact);
  CHECK(of_uv({0.25 + 0x1p-30, 0.5}) == Verdict::off);
  CHECK(of_uv({0.5, 0.25}) == Verdict::wrong_uv);
  CHECK(of_uv({0.25, NAN}) == Verdict::non_finite);
}

TEST_CASE("a hit at a wrong place is judged by its place, and the element that is named counts") {
  Claim wrong = test::hit_at(2);
  wrong.normal = glm::dvec3(0, 0, 1);
  CHECK(judge(ball(), 0, wrong, profile_of_besides()).verdict == Verdict::misplaced);
  Claim far = test::hit_at(5);
  far.normal = glm::dvec3(0, 0, -1);
  CHECK(judge(ball(), 0, far, profile_of_besides()).verdict == Verdict::far_root);
  Claim right = test::hit_at(3);
  right.normal = glm::dvec3(0, 0, -1);
  right.element = scene::ElementRef{scene::Sphere::tipo, 0};
  CHECK(judge(ball(), 0, right, profile_of_besides()).verdict == Verdict::exact);
}

TEST_CASE("right normals are never wrong, and each fault in what is said besides is seen") {
  const Profile profile = profile_of_besides();
  for (const BesidesFault& fault : besides_faults()) {
    std::array<std::size_t, verdict_count> counts{};
    for (const Family& family : families()) {
      if (!is_of_moderate_size(family) || is_of_bodies(family)) continue;
      for (std::uint64_t number = 0; number < (is_of_meshes(family) ? 1U : 3U); ++number) {
        const SuiteCase of = test::answered_case(std::string(family.name).c_str(), number, {.rays = 64});
        for (std::size_t ray = 0; ray < of.truths.size(); ray += is_of_meshes(family) ? 8 : 1) {
          Claim claim = full_claim(of, ray);
          if (!claim.normal || claim.normal == glm::dvec3(0)) continue;
          fault.change(claim, of, ray);
          const Verdict is = judge(of, ray, claim, profile).verdict;
          INFO(fault.name << ", " << of.name() << " ray " << ray);
          if (fault.seen == Verdict::right) CHECK_FALSE(is_failure(is));
          ++counts[static_cast<std::size_t>(is)];
        }
      }
    }
    INFO(fault.name << ": " << counts[static_cast<std::size_t>(fault.seen)]);
    if (fault.seen != Verdict::right) CHECK(counts[static_cast<std::size_t>(fault.seen)] > 20);
  }
}
