#pragma once
/// A suite: cases of every family, the same from the same options on any machine. A case is one scene and its rays; it
/// has a random stream of its own, so that any ray can be made alone.

#include <cstdint>
#include <string>
#include <vector>

#include "durero/conform/families.hpp"
#include "durero/conform/profile.hpp"
#include "durero/conform/truth.hpp"

namespace durero::conform {

/// What a suite is made of.
struct SuiteOptions {
  std::vector<const Family*> families{};  ///< none: all
  std::uint64_t seed = 1;                 ///< of all random streams: another seed, other cases
  std::size_t rays = 1024;                ///< of each family
  std::vector<model::Tipo> tipos{};       ///< of the elements; none: all
  Caps caps = Caps::open;                 ///< solid: discs close the cylinders, cones and truncated cones
  Format numbers = Format::binary32;      ///< of scenes, but for discs that close solids, and of rays
};

/// How many rays a case has; the last of a family may have less. Few, for radii and poses differ between cases alone.
inline constexpr std::size_t rays_of_a_case = 16;

/// A scene with its rays, where it is from, and the exact answers once answer() has found them.
struct SuiteCase {
  const Family* family = nullptr;  ///< one of families()
  std::uint64_t number = 0;        ///< among the cases of its family, from 0
  int parameter = 0;               ///< of the family, as it was drawn
  Case the_case;                   ///< in a suite its rays start on no elements
  std::vector<Solid> solids{};     ///< with Caps::solid, the elements that discs close
  std::vector<Truth> truths{};     ///< of the rays, in their order

  std::string name() const;  ///< FAMILY/0000
};

/// Those of the options, in the order of families().
std::vector<const Family*> chosen_families(const SuiteOptions& options);

/// Cases of a family under the options: 0 where none of its scenes has elements of options.tipos alone.
std::size_t cases(const SuiteOptions& options, const Family& family);

/// One case, without its truths. No ray of it names elements that its origin lies on, for nobody tells a system of
/// such; where an origin lies on one exactly, the answer is that of t > 0. Precondition: number < cases(options,
/// family).
SuiteCase suite_case(const SuiteOptions& options, const Family& family, std::uint64_t number);

/// Answers its rays exactly: each truth is that of truth().
void answer(SuiteCase& of);

}  // namespace durero::conform
