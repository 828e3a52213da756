#include "durero/accel/structure.hpp"

#include "durero/accel/linear.hpp"
#include "support/catch.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;

namespace {

/// A source that counts nothing.
struct Uncounted {
  explicit Uncounted(const scene::Scene& scene);
  const scene::Scene& scene() const;
  std::span<const scene::ElementRef> extraordinary() const;
  template <class Limit, class Visit>
  bool any(const trace::Ray&, Limit, Visit) const;
};

}  // namespace

TEST_CASE("a structure counts, and is a source of candidates for who asks what it does and who does not") {
  STATIC_REQUIRE(accel::Structure<accel::LinearList>);
  STATIC_REQUIRE_FALSE(trace::Candidates<accel::LinearList>);
  STATIC_REQUIRE(trace::Candidates<accel::CandidateSource<accel::LinearList>>);
  STATIC_REQUIRE(trace::Candidates<accel::Counted<accel::LinearList>>);
  STATIC_REQUIRE(trace::Candidates<Uncounted>);
  STATIC_REQUIRE_FALSE(accel::Structure<Uncounted>);
}

TEST_CASE("rays are counted, and those for which nothing is left to test") {
  scene::Scene scene;
  const scene::ElementRef ball = add(scene, scene::Sphere{{0, 0, 5}, 1});
  const accel::LinearList linear(scene);
  accel::Work work;
  trace::Counts unseen;
  const accel::Counted counted(linear, work);
  const model::Rayo forwards = ray({0, 0, 0}, {0, 0, 1}), aside = ray({0, 9, 0}, {0, 0, 1});
  CHECK(trace::first_hit_among(counted, forwards, {}, unseen).elementos == scene::ElementSet{ball});
  CHECK(work == accel::Work{.rays = 1, .volumes = 1, .candidates = 1});
  CHECK(trace::first_hit_among(counted, aside, {}, unseen).elementos.empty());
  CHECK(work == accel::Work{.rays = 2, .volumes = 2, .candidates = 1, .untested = 1});
  CHECK(trace::first_hit_among(accel::CandidateSource(linear), forwards, {}, unseen).elementos ==
        scene::ElementSet{ball});
}
