#pragma once
/// A family is a kind of scenes and rays that renderers were seen to get wrong; one is generic. Each family is a
/// generator with a name, a reason and a parameter, and gives the same cases from the same seed on every platform.
/// Exact arithmetic tells which of its rays are truly of its kind: a ray that was built to be tangent need not be.

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "durero/conform/ask/profile.hpp"
#include "durero/conform/random.hpp"
#include "durero/scene/query.hpp"
#include "durero/scene/scene.hpp"

namespace durero::conform {

/// The range of a number that a generator draws.
struct Range {
  std::string_view name;  ///< the meaning of the number, such as "log2 of the distance"
  int least, greatest;    ///< the bounds, which may be drawn themselves
};

/// A scene and rays for it, with the elements that each starts on.
struct Case {
  scene::Scene scene;              ///< the scene of all rays
  std::vector<scene::Query> rays;  ///< in the order in which they were drawn
};

/// The membership of a ray in its family.
struct Membership {
  bool member = false;  ///< the ray is of the family's kind
  bool exact = false;   ///< and a coincidence holds exactly: the family's own, or any where it has none
};

/// The public description of a family of cases.
struct Family {
  std::string_view name;    ///< its unique name, which names cases and the folders of suites
  std::string_view kind;    ///< the kind of its rays
  std::string_view reason;  ///< the failures seen on such rays, or their purpose
  Range parameter;          ///< drawn once for each scene
};

/// Every family, the generic one first: families_of_few(), families_of_meshes(), then families_of_bodies().
std::span<const Family> families();
/// The generic family, whose rays are those that anybody would trace.
const Family& ordinary_family();
/// The families whose scenes have a few elements of any type.
std::span<const Family> families_of_few();
/// The families whose scenes are one mesh of many triangles.
std::span<const Family> families_of_meshes();
/// The families whose scenes are a few bodies.
std::span<const Family> families_of_bodies();
/// Whether the family is one of families_of_meshes().
bool is_of_meshes(const Family& family);
/// Whether the family is one of families_of_bodies().
bool is_of_bodies(const Family& family);

/// The family of that name; null where there is none.
const Family* find_family(std::string_view name);

/// A scene of the family and that many rays, the same for the same arguments. Throws std::invalid_argument where the
/// family is none of families().
Case generate(const Family& family, std::uint64_t seed, std::size_t rays);

/// The number of faces that a mesh has about, where nothing else is said.
inline constexpr std::size_t usual_faces = 1000;
/// The number of faces that may be asked for at most.
inline constexpr std::size_t most_faces = 4'000'000;

/// The options of generated cases.
struct CaseOptions {
  NumberFormat numbers = NumberFormat::binary64;  ///< the format of scenes and rays, except discs that close solids
  std::vector<model::Tipo> tipos{};               ///< the types of elements; none, and no bodies: all
  std::vector<BodyKind> bodies{};   ///< the kinds of bodies, and the height field; none, and no types: all but that
  bool has_bodies = true;           ///< no bodies are drawn otherwise, whatever is named
  Caps caps = Caps::open;           ///< solid: discs close the cylinders, cones and truncated cones
  std::size_t faces = usual_faces;  ///< about so many faces has a mesh
};

/// Whether height fields are asked about as grids under these options: they are asked for, and triangles are not.
bool asks_grids(const std::vector<model::Tipo>& tipos, const std::vector<BodyKind>& kinds);

/// A solid is an element together with the discs that close it: a system with solids knows them as one. The disc
/// NAME.base lies at centro, NAME.top at the other end where that is no apex. Discs are the model's own, with numbers
/// like all others: a radius or a centre of an end that is no binary64 number is rounded, whatever the format of the
/// case, and where |vector|² is not exactly 1 a point with avance = altura is not at centro + altura·vector. A disc
/// closes its element exactly only where nothing of that was rounded, and otherwise up to such a rounding: there the
/// exact model has a gap or a ledge of that size.
struct Solid {
  scene::ElementRef wall;                ///< a cylinder, a cone or a truncated cone
  std::vector<scene::ElementRef> discs;  ///< the disc at its base, then the disc at its top where it has one
};

/// A case, with the parameter and the solids that were drawn for it.
struct DrawnCase {
  Case the_case;                    ///< the scene, with the discs that close solids, and its rays
  int parameter = 0;                ///< drawn from parameter(family, CaseOptions::numbers)
  std::vector<Solid> solids{};      ///< with Caps::solid one for each element with an axis; otherwise none
  std::vector<NamedBody> bodies{};  ///< the elements that are bodies
};

/// The generator with options: nothing where the scenes of the family have elements of other types. With solids one ray
/// in three goes to the rims or across the discs of one, from outside or from inside.
std::optional<DrawnCase> generate(const Family& family, std::uint64_t seed, std::size_t rays,
                                  const CaseOptions& options);

/// Whether generate() with that seed gives a case; of meshes it draws none to find out.
bool has_scenes(const Family& family, std::uint64_t seed, const CaseOptions& options);

/// The range of the family's parameter, narrower than family.parameter where that leaves the format.
Range parameter(const Family& family, NumberFormat numbers);

/// The membership of a ray, decided by surface::exact. Precondition: the case is of the family, and the ray is of the
/// case.
Membership membership(const Family& family, const Case& the_case, const scene::Query& ray);

/// The numbers of rays, members and exact members of a case.
struct Count {
  std::size_t rays = 0, members = 0, exact = 0;  ///< all rays; members (Membership); exact members
  /// Adds number by number.
  Count& operator+=(const Count& other);
};
/// Counts the rays of a case by their membership. Precondition: the case is of the family.
Count count(const Family& family, const Case& the_case, std::span<const NamedBody> bodies = {});

}  // namespace durero::conform
