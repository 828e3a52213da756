#include "durero/accel/structure.hpp"

#include "support/catch.hpp"

using namespace durero;

namespace {

/// A source of candidates that counts nothing.
struct Uncounted {
  explicit Uncounted(const scene::Scene&);
  const scene::Scene& scene() const;
  std::span<const scene::ElementRef> extraordinary() const;
  template <class Limit, class Visit>
  bool any(const trace::Ray&, Limit, Visit) const;
};

/// And one that does.
struct Counts : Uncounted {
  using Uncounted::any;
  using Uncounted::Uncounted;
  template <class Limit, class Visit>
  bool any(const trace::Ray&, Limit, Visit, accel::Work&) const;
  accel::Size size() const;
};

}  // namespace

TEST_CASE("a structure is a source of candidates that counts what it does") {
  STATIC_REQUIRE(trace::Candidates<Uncounted>);
  STATIC_REQUIRE_FALSE(accel::Structure<Uncounted>);
  STATIC_REQUIRE(accel::Structure<Counts>);
  STATIC_REQUIRE_FALSE(trace::PairCandidates<Counts>);
}
