#pragma once
/// What the numbers of colours in a POV-Ray text are of light. A scene's are linear.

#include <cstddef>
#include <optional>

#include "durero/scene/stage.hpp"

namespace durero::io {

/// The curve that POV-Ray sends its sums of light through before it makes bytes of sRGB of them.
struct PovGamma {
  /// assumed_gamma: light is a number to this power. Nothing where the sums are bytes of sRGB, over 255, as they stand.
  std::optional<double> power{};

  /// The light of a number. Precondition: number ≥ 0.
  double light(double number) const;
};

/// The gamma of a text that names none: of one whose version is below 3.7, or untold, POV-Ray corrects nothing.
PovGamma default_gamma(std::optional<double> version);

/// Replaces the colours and the shares of light of a stage by their light. So a surface that is seen in one term of
/// light alone, at its full, is as POV-Ray shows it; sums and slopes of light are not, since the power of a sum is no
/// sum of powers. Returns how many of them changed; nothing where one is then beyond binary64.
std::optional<std::size_t> make_linear(const PovGamma& gamma, scene::Stage& stage);

}  // namespace durero::io
