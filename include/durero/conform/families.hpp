#pragma once
/// The families of cases: scenes and rays of the kinds that renderers were seen to get wrong, and a generic one. Each
/// is a generator with a name, a reason and a parameter, the same from the same seed on every platform, and says by
/// exact arithmetic which of its rays are truly of its kind: a ray that was built to be tangent need not be.

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "durero/conform/random.hpp"
#include "durero/scene/scene.hpp"
#include "durero/trace/analytic.hpp"

namespace durero::conform {

/// A number that a generator draws afresh for each ray or scene, from least … greatest.
struct Range {
  std::string_view name;
  int least, greatest;
};

/// A scene and rays for it, with the elements that each starts on.
struct Case {
  scene::Scene scene;
  std::vector<scene::Query> rays;
};

/// What a case has to do with its family.
struct Membership {
  bool member = false;  ///< the ray is of the family's kind
  bool exact = false;   ///< and a coincidence holds in it exactly: the family's own, or where that is none, any
};

struct Body;         // an element under construction (src/conform/bodies.hpp)
struct Shot;         // a ray under construction
struct Ray_And_Hit;  // a ray and its exact answer (src/conform/members.hpp)

/// One line of the table of families.
struct Family {
  std::string_view name;
  std::string_view kind;    ///< what its rays are
  std::string_view reason;  ///< where such rays were seen to go wrong, or what they are for
  Range parameter;
  double member_floor;  ///< at least this part of its rays are members
  double exact_floor;   ///< and at least this part exact ones; both hold for each seed of 20 scenes of 100 rays

  std::vector<Body> (*bodies)(Random&, int parameter);
  Shot (*shot)(Random&, int parameter, std::span<const Body>);
  bool (*is_member)(const Ray_And_Hit&);
  bool (*is_exact)(const Ray_And_Hit&);
};

/// Every family, in the order of the table of the design.
std::span<const Family> families();

/// The family of that name; null where there is none.
const Family* find_family(std::string_view name);

/// A scene of the family and that many rays. The same for the same arguments.
Case generate(const Family& family, std::uint64_t seed, std::size_t rays);

/// By surface::exact. Precondition: the case is the family's, and the ray is its own.
Membership membership(const Family& family, const Case& the_case, const scene::Query& ray);

/// How many rays of a case are truly of its family.
struct Count {
  std::size_t rays = 0, members = 0, exact = 0;
  Count& operator+=(const Count& other);
};
Count count(const Family& family, const Case& the_case);

}  // namespace durero::conform
