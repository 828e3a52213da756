#include "durero/accel/structure.hpp"

#include "durero/accel/linear.hpp"
#include "support/catch.hpp"

using namespace durero;

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

TEST_CASE("a structure is a source that counts") {
  STATIC_REQUIRE(accel::Structure<accel::Linear>);
  STATIC_REQUIRE(trace::Candidates<Uncounted>);
  STATIC_REQUIRE_FALSE(accel::Structure<Uncounted>);
}
