#pragma once
/// The families of cases: scenes and rays of the kinds that renderers were seen to get wrong, and a generic one. Each
/// is a generator with a name, a reason and a parameter, the same from the same seed on every platform, and says by
/// exact arithmetic which of its rays are truly of its kind: a ray that was built to be tangent need not be.

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "durero/conform/profile.hpp"
#include "durero/conform/random.hpp"
#include "durero/scene/query.hpp"
#include "durero/scene/scene.hpp"

namespace durero::conform {

/// A number that a generator draws, from least … greatest.
struct Range {
  std::string_view name;  ///< what it is, such as "log2 of the distance"
  int least, greatest;    ///< either may be drawn itself
};

/// A scene and rays for it, with the elements that each starts on.
struct Case {
  scene::Scene scene;              ///< what all its rays are asked of
  std::vector<scene::Query> rays;  ///< in the order in which they were drawn
};

/// What a case has to do with its family.
struct Membership {
  bool member = false;  ///< the ray is of the family's kind
  bool exact = false;   ///< and a coincidence holds in it exactly: the family's own, or where that is none, any
};

/// What there is to know of a family of cases.
struct Family {
  std::string_view name;    ///< no other family's; cases and the folders of suites are named by it
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

/// What cases are made of.
struct CaseOptions {
  Format numbers = Format::binary64;  ///< every number of the scene, but of discs that close solids, and of the rays
  std::vector<model::Tipo> tipos{};   ///< of the elements; none: all
  Caps caps = Caps::open;             ///< solid: discs close the cylinders, cones and truncated cones
};

/// An element that discs close, and those discs: a system with solids knows them as one. The disc NAME.base lies at
/// centro, NAME.top at the other end where that is no apex. Discs are the model's own, numbers like all others: where
/// the radius or the centre of an end is no binary64 it is rounded, whatever the format of the case, and where
/// |vector|² is not 1 exactly a point with avance = altura is not at centro + altura·vector. So a disc closes its
/// element exactly only where nothing of that was rounded, and otherwise up to such a rounding: there the exact model
/// has a gap or a ledge of that size.
struct Solid {
  scene::ElementRef wall;                ///< a cylinder, a cone or a truncated cone
  std::vector<scene::ElementRef> discs;  ///< at its base, then at its top where it has one
};

/// A case, and what was drawn for it.
struct DrawnCase {
  Case the_case;                ///< the scene, with the discs that close solids, and its rays
  int parameter = 0;            ///< drawn from parameter(family, CaseOptions::numbers)
  std::vector<Solid> solids{};  ///< with Caps::solid one for each element with an axis; otherwise none
};

/// The same with options: nothing where the scenes of the family have elements of other types. With solids one ray in
/// three has to do with one: to its rims and across its discs, from outside and from inside.
std::optional<DrawnCase> generate(const Family& family, std::uint64_t seed, std::size_t rays,
                                  const CaseOptions& options);

/// What the family's parameter is drawn from: less than family.parameter where that leaves the format.
Range parameter(const Family& family, Format numbers);

/// By surface::exact. Precondition: the case is of the family, and the ray is of the case.
Membership membership(const Family& family, const Case& the_case, const scene::Query& ray);

/// How many rays of a case are truly of its family.
struct Count {
  std::size_t rays = 0, members = 0, exact = 0;  ///< all; the members (Membership); the members that are exact
  /// Adds number by number.
  Count& operator+=(const Count& other);
};
/// Counts the rays of a case by their membership. Precondition: the case is of the family.
Count count(const Family& family, const Case& the_case);

}  // namespace durero::conform
