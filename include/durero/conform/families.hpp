#pragma once
/// The families of cases: scenes and rays of the kinds that renderers were seen to get wrong, and a generic one. Each
/// is a generator with a name, a reason and a parameter, the same from the same seed on every platform, and says by
/// exact arithmetic which of its rays are truly of its kind: a ray that was built to be tangent need not be.

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "durero/conform/random.hpp"
#include "durero/scene/query.hpp"
#include "durero/scene/scene.hpp"

namespace durero::conform {

/// A number that a generator draws, from least … greatest.
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

/// What there is to know of a family of cases.
struct Family {
  std::string_view name;
  std::string_view kind;    ///< what its rays are
  std::string_view reason;  ///< where such rays were seen to go wrong, or what they are for
  Range parameter;          ///< drawn once for each scene
};

/// Every family, the generic one first.
std::span<const Family> families();

/// The family of that name; null where there is none.
const Family* find_family(std::string_view name);

/// A scene of the family and that many rays. The same for the same arguments. Throws std::invalid_argument where the
/// family is none of families().
Case generate(const Family& family, std::uint64_t seed, std::size_t rays);

/// By surface::exact. Precondition: the case is of the family, and the ray is of the case.
Membership membership(const Family& family, const Case& the_case, const scene::Query& ray);

/// How many rays of a case are truly of its family.
struct Count {
  std::size_t rays = 0, members = 0, exact = 0;
  Count& operator+=(const Count& other);
};
Count count(const Family& family, const Case& the_case);

}  // namespace durero::conform
