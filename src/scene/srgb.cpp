#include "durero/scene/srgb.hpp"

#include <array>
#include <cmath>

namespace durero::scene {
namespace {

/// The value of the sRGB curve for a component from 0 to 1, in steps of the byte and half a step more: the byte is its
/// whole part.
double in_steps(double linear) { return srgb_of_linear(linear) * 255 + 0.5; }

/// The bytes of equal parts of 0 … 1, for the parts in which all components have the same byte. The curve rises, but
/// for 7.3·10⁻⁶ of a step where its line ends, and its computed value errs by less than 2⁻⁴⁰ of one: the value of any
/// component between two others is, in steps, between their computed values, up to less than the margin.
class Parts {
 public:
  Parts() {
    constexpr double margin = 0x1p-10;
    for (std::size_t i = 0; i < count; ++i) {
      const double first = std::floor(in_steps(double(i) / count) - margin);
      const double last = std::floor(in_steps(double(i + 1) / count) + margin);
      bytes_[i] = static_cast<std::int16_t>(first == last ? first : -1);
    }
  }
  /// The byte of a component from 0 to 1, below 1; less than 0 where its part does not tell it.
  int byte(double linear) const { return bytes_[static_cast<std::size_t>(linear * count)]; }

 private:
  static constexpr std::size_t count = 4096;
  std::array<std::int16_t, count> bytes_{};
};

}  // namespace

double srgb_of_linear(double linear) noexcept {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

double linear_of_srgb(double value) noexcept {
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

std::uint8_t srgb_byte(double linear) noexcept {
  static const Parts parts;
  if (!(linear > 0)) return 0;
  if (linear >= 1) return 255;
  const int byte = parts.byte(linear);
  return static_cast<std::uint8_t>(byte >= 0 ? byte : std::floor(in_steps(linear)));
}

std::string srgb_text(const glm::dvec3& linear) {
  constexpr char digits[] = "0123456789abcdef";
  std::string text = "#";
  for (int i = 0; i < 3; ++i) {
    const unsigned byte = srgb_byte(linear[i]);
    text += {digits[byte >> 4U], digits[byte & 15U]};
  }
  return text;
}

}  // namespace durero::scene
