#include "durero/render/output/tone.hpp"

#include <limits>

#include "support/catch.hpp"

using namespace durero;
using render::Tone;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

render::Picture of(std::vector<glm::dvec3> rgb) {
  render::Picture picture({static_cast<std::uint32_t>(rgb.size()), 1});
  picture.rgb = std::move(rgb);
  return picture;
}

using Bytes = std::vector<std::uint8_t>;

}  // namespace

TEST_CASE("clamp cuts, max divides by the greatest component, reinhard bends") {
  const render::Picture picture = of({{0, 0.5, 1}, {2, 4, 0.001}});
  CHECK(render::toned(picture, Tone::clamp).rgb == Bytes{0, 188, 255, 255, 255, 3});
  // Over 4: 0, 0.125, 0.25 and 0.5, 1, 0.00025; on the curve 0.3890, 0.5371, 0.7354, 0.00323.
  CHECK(render::toned(picture, Tone::max).rgb == Bytes{0, 99, 137, 188, 255, 1});
  // c/(1 + c): 0, 1/3, 1/2 and 2/3, 4/5, 0.000999; on the curve 0.6129, 0.7354, 0.8361, 0.9063, 0.01291.
  CHECK(render::toned(picture, Tone::reinhard).rgb == Bytes{0, 156, 188, 213, 231, 3});
}

TEST_CASE("the greatest component becomes the greatest byte, however small or great it is") {
  for (const double most : {1e-300, 0.3, 1.0, 7.0, 1e300}) {
    CHECK(render::toned(of({{most, most / 2, 0}}), Tone::max).rgb == Bytes{255, 188, 0});
  }
  CHECK(render::toned(of({{0, 0, 0}}), Tone::max).rgb == Bytes{0, 0, 0});
}

TEST_CASE("what is infinite is white in every tone, and does not count for the greatest") {
  for (const Tone tone : {Tone::clamp, Tone::max, Tone::reinhard}) {
    CHECK(render::toned(of({{infinity, -infinity, 0}}), tone).rgb[0] == 255);
  }
  CHECK(render::toned(of({{infinity, 2, 1}}), Tone::max).rgb == Bytes{255, 255, 188});
}

TEST_CASE("each tone is monotone") {
  std::vector<glm::dvec3> rising;
  for (double c = 1e-6; c < 1e6; c *= 1.07) rising.emplace_back(c);
  for (const Tone tone : {Tone::clamp, Tone::max, Tone::reinhard}) {
    const Bytes bytes = render::toned(of(rising), tone).rgb;
    CHECK(std::is_sorted(bytes.begin(), bytes.end()));
    CHECK(bytes.front() < bytes.back());
  }
}

TEST_CASE("each tone has a name") {
  CHECK(render::tone_names[std::size_t(Tone::clamp)] == "clamp");
  CHECK(render::tone_names[std::size_t(Tone::max)] == "max");
  CHECK(render::tone_names[std::size_t(Tone::reinhard)] == "reinhard");
}
