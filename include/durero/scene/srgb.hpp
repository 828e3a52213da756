#pragma once
/// The curve of sRGB (IEC 61966-2-1), from linear light to the values of a picture and back.

#include <cstdint>
#include <glm/vec3.hpp>
#include <string>

namespace durero::scene {

/// The value on the curve of a component of linear light, 0 to 1: 12.92·c up to 0.0031308, and 1.055·c^(1/2.4) − 0.055
/// above.
double srgb_of_linear(double linear) noexcept;

/// The linear light of a value on the curve: x/12.92 up to 0.04045, and ((x + 0.055)/1.055)^2.4 above.
double linear_of_srgb(double value) noexcept;

/// The byte of a component of a linear colour: its value on the curve, scaled to 0 … 255 and rounded to the nearest,
/// halves up. A component below 0, and NaN (the product of a black material and an infinite light), is 0; a component
/// above 1 is 255.
std::uint8_t srgb_byte(double linear) noexcept;

/// A linear colour as SVG has it: `#`, and the bytes of red, green and blue as two hexadecimal digits each.
std::string srgb_text(const glm::dvec3& linear);

}  // namespace durero::scene
