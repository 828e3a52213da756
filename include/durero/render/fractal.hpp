#pragma once
/// Pictures of fractals, path traced: the eye's rays are followed by sphere tracing; the sun, which is a small disc,
/// and the sky light what they meet, directly and from surface to surface, so that shadows and hollows are soft.

#include <cstdint>
#include <variant>

#include "durero/distance/fractals.hpp"
#include "durero/render/output/picture.hpp"
#include "durero/render/render.hpp"

namespace durero::render {

/// A fractal on a floor.
using Fractal = std::variant<distance::MengerSponge, distance::QuaternionJulia>;

/// The picture of a fractal, of so many paths a pixel: at most 2¹⁶. It has the same numbers for any number of threads.
Picture draw_fractal(const Fractal& fractal, scene::Resolution size, std::uint32_t samples, const Progress& progress);

}  // namespace durero::render
