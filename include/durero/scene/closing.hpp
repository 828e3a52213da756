#pragma once
/// Closing a solid: cylinders, cones and truncated cones are open, and discs close them (realism seed, 10.1 and 10.3;
/// theorem discs_close_cylinders_and_cones). One step adds those that an element needs, or none of them.

#include <string>
#include <vector>

#include "durero/contract/contract.hpp"
#include "durero/scene/edit.hpp"
#include "durero/scene/scene.hpp"

namespace durero::scene {

/// Closes an element by discs of its own material, whose normals point outwards: one at its base and, but for a cone,
/// which ends in a point, one at its top.
struct Closing {
  std::string e;     ///< which element
  std::string base;  ///< what the disc at its base is to be called
  std::string top;   ///< and the one at its top, where it has one
};

/// @{ Its preconditions. What else an addition of a disc asks, it asks of these as well.
inline constexpr contract::clause close_pre_1{"close.pre.1", "e? ∈ elementos"};
inline constexpr contract::clause close_pre_2{"close.pre.2",
                                              "de_que_tipo(e?) ∈ { soy_cilindro, soy_cono, soy_tronco }"};
inline constexpr contract::clause close_pre_3{"close.pre.3", "base? ≠ top?"};
inline constexpr contract::clause close_pre_4{"close.pre.4",
                                              "centro + altura * vector < 2¹⁰²⁴, each coordinate rounded"};
/// @}

/// What closes an element.
struct Lids {
  std::vector<Edit> additions{};               ///< of one disc or two
  const contract::clause* violated = nullptr;  ///< the precondition that does not hold; there are no additions then
  /// Whether the discs end where the element does, exactly: else the centre of the top or the radius of the base was
  /// rounded, each number once.
  bool exact = true;
};

/// The additions that a closing makes, base first. Nothing is changed. Precondition: the names are names.
Lids lids(const Scene& scene, const Closing& in);

}  // namespace durero::scene
