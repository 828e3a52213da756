#pragma once
/// A suite is a set of cases of every family, the same from the same options on any machine. A case is one scene and
/// its rays; it has a random stream of its own, so that any ray can be made alone.

#include <cstdint>
#include <string>
#include <vector>

#include "durero/conform/ask/profile.hpp"
#include "durero/conform/families/families.hpp"
#include "durero/conform/judge/truth.hpp"

namespace durero::conform {

/// The options of a suite.
struct SuiteOptions {
  std::vector<const Family*> families{};  ///< none: all
  std::uint64_t seed = 1;                 ///< the seed of all random streams: another seed, other cases
  std::size_t rays = 1024;                ///< the number of rays of each family
  std::vector<model::Tipo> tipos{};       ///< the types of elements; none, and no bodies: all
  std::vector<BodyKind> bodies{};  ///< the kinds of bodies, and the height field; none, and no types: all but that
  Caps caps = Caps::open;          ///< solid: discs close the cylinders, cones and truncated cones
  NumberFormat numbers = NumberFormat::binary32;  ///< the format of scenes and rays, except discs that close solids
  std::size_t faces = usual_faces;                ///< about so many faces has a mesh
  QuestionKind question = QuestionKind::first;    ///< the question about the rays
};

/// The number of rays of a case, of which the last of a family may have fewer. It is small, for radii and poses differ
/// between cases alone.
inline constexpr std::size_t rays_of_a_case = 16;
/// The number of rays of a case that is a mesh, whose many faces differ among themselves.
inline constexpr std::size_t rays_of_a_mesh = 256;
/// The number of rays of each case of the family but the last.
std::size_t rays_of(const Family& family);

/// A scene with its rays and its place in the suite, and the exact answers once answer() has found them.
struct SuiteCase {
  const Family* family = nullptr;               ///< one of families(), or own_family
  std::uint64_t number = 0;                     ///< its number among the cases of its family, from 0
  int parameter = 0;                            ///< the parameter of the family, as drawn
  Case the_case;                                ///< the scene and its rays, which in a suite start on no elements
  std::vector<Solid> solids{};                  ///< with Caps::solid, the elements that discs close
  std::vector<NamedBody> bodies{};              ///< the elements that are bodies
  std::vector<NamedSurface> surfaces{};         ///< the elements that a text defines, in a case of one's own
  std::vector<ExactAnswer> truths{};            ///< the truths of the rays, in their order
  QuestionKind question = QuestionKind::first;  ///< the question about each ray
  bool is_grid = false;                         ///< the scene is asked about as the grid that its mesh is (grid_of)
  /// The ranges of the rays, in their order, where has_numbers(question); a shadow ray's begins at 0.
  std::vector<AskedRange> ranges{};

  std::string name() const;  ///< FAMILY/0000
  /// The elements that are no shapes of the model; the case must outlive them.
  OtherElements others() const { return {bodies, surfaces}; }
};

/// The families of the options, all where they name none, in the order of families().
std::vector<const Family*> chosen_families(const SuiteOptions& options);

/// The number of cases of a family under the options: 0 where none of its scenes has elements of the
/// options' types alone.
std::size_t cases(const SuiteOptions& options, const Family& family);

/// A case of the suite, without its truths. No ray of it names elements that its origin lies on, for no system is told
/// of them; where an origin lies on one exactly, the answer is that of t > 0. Precondition: number < cases(options,
/// family).
SuiteCase suite_case(const SuiteOptions& options, const Family& family, std::uint64_t number);

/// The family of the cases that users bring: none of families(), and in no suite.
extern const Family own_family;

/// The case of a user's scene and rays, without its truths: `own/0000`. Throws std::invalid_argument where a ray names
/// elements that it starts on, as no system is told of them.
SuiteCase own_case(scene::Scene scene, std::vector<scene::Query> rays);

/// Answers the rays of the case exactly. Each truth is that of truth(), the first hit, also of a shadow ray; where the
/// question is the first hit within a range it is that of SceneTruths::within(), where it is about all hits that of
/// SceneTruths::with_all(), where it is the nearest point that of truths_of_nearest(), and where a ball is cast that of
/// truths_of_casts().
void answer(SuiteCase& of);

/// Makes the question of the options of a case of first hits, and answers it. The ends of ranges lie before, at and
/// behind crossings, often by little. Points that the nearest is asked to take the place of the rays, near them and
/// their crossings; each ray then goes from there to the nearest point. A ball that is cast has a radius of any order,
/// often so that it just touches. All is the same for the same options.
/// Precondition: the case was answered.
void ask_question(SuiteCase& of, const SuiteOptions& options);

}  // namespace durero::conform
