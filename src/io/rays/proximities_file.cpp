#include "durero/io/rays/proximities_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "durero/contract/contract.hpp"
#include "durero/io/json/json_writer.hpp"
#include "durero/io/rays/npy.hpp"

namespace durero::io {
namespace {

using scene::NearestCount;
using scene::Proximity;

constexpr std::size_t count_width = 4;  // of the longest word

std::vector<std::string> names(const Proximity& proximity, const scene::Scene& scene) {
  std::vector<std::string> all;
  for (const scene::ElementRef element : proximity.elementos) all.push_back(scene.name(element).name());
  std::ranges::sort(all);
  return all;
}

}  // namespace

std::string_view word(NearestCount count) {
  switch (count) {
    case NearestCount::none:
      return "none";
    case NearestCount::one:
      return "one";
    case NearestCount::many:
      return "many";
  }
  contract::unreachable();
}

std::string proximity_text(std::size_t point, const Proximity& proximity, const scene::Scene& scene,
                           std::optional<double> with_sign) {
  std::string text;
  json::Writer out(text);
  out.begin_object().member("point", point).member("count", word(proximity.count)).key("elementos").begin_array();
  for (const std::string& name : names(proximity, scene)) out.value(name);
  out.end_array();
  if (proximity.count != NearestCount::none)
    out.member("distance", proximity.distance).member("nearest", proximity.point);
  if (with_sign) out.member("signed", *with_sign);
  out.end_object();
  return text;
}

std::string proximities_npy(std::span<const Proximity> proximities, const scene::Scene& scene) {
  std::vector<std::string> joined;
  std::size_t width = 1;  // NumPy's least
  for (const Proximity& proximity : proximities) {
    joined.push_back(fmt::format("{}", fmt::join(names(proximity, scene), ",")));
    width = std::max(width, joined.back().size());
  }
  std::string out =
      npy_head(fmt::format("[('count', 'S{}'), ('distance', '<f8'), ('nearest', '<f8', (3,)), ('elementos', 'S{}')]",
                           count_width, width),
               fmt::format("({},)", proximities.size()));
  for (std::size_t i = 0; i < proximities.size(); ++i) {
    const auto& [count, distance, point, elementos] = proximities[i];
    out.append(word(count)).append(count_width - word(count).size(), '\0');
    for (const double x : {distance, point.x, point.y, point.z})
      append_binary64(out, count == NearestCount::none ? std::numeric_limits<double>::quiet_NaN() : x);
    out.append(joined[i]).append(width - joined[i].size(), '\0');
  }
  return out;
}

}  // namespace durero::io
