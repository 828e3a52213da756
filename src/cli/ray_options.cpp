#include "ray_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "commands.hpp"
#include "durero/io/file_name.hpp"
#include "numbers.hpp"

namespace durero::cli {
namespace {

constexpr std::array<std::string_view, 4> ray_names{"lines", "cones", "beams", "pencils"};

}  // namespace

RayKind RayOptions::kind() const {
  if (rays.empty()) return RayKind::lines;
  return static_cast<RayKind>(std::ranges::find(ray_names, rays) - ray_names.begin());
}

void add_ray_options(CLI::App& command, RayOptions& options) {
  command
      .add_option(
          "--rays", options.rays,
          "What is traced: lines; cones, as wide as pixels, lights and dull mirrors; beams, pyramids that triangles "
          "and planes cut; or besides lines pencils, which carry light through glass and over mirrors to matt "
          "surfaces; without it, lines")
      ->check(one_of("rays", std::vector<std::string>(ray_names.begin(), ray_names.end())));
  command
      .add_option("--spread", options.spread,
                  "Of cones: how wide one is, as a part of a pixel's side, or of a sample's; 0 is a ray; without it, 1")
      ->check(number(0, 16));
  command.add_option("--tree", options.tree, "Of beams: the regions that they cut the picture into, OUT.svg");
}

void check_together(const RayOptions& options, const std::string& named) {
  const auto refuse = [](bool wrong, const std::string& what) {
    if (wrong) throw std::invalid_argument(what);
  };
  refuse(!options.tree.empty() && options.kind() != RayKind::beams,
         "--tree: of one kind of rays; expected --rays beams");
  refuse(!options.tree.empty() && !io::ends_in(options.tree, ".svg"),
         fmt::format("--tree {}: not a drawing's name; expected OUT.svg", options.tree));
  refuse(options.spread && options.kind() != RayKind::cones, "--spread: of one kind of rays; expected --rays cones");
  const bool is_refused = options.kind() == RayKind::beams
                              ? !named.empty()
                              : options.kind() == RayKind::cones && !named.empty() && !named.starts_with("--samples ");
  refuse(is_refused, fmt::format("{}: of rays that are lines; expected it without --rays {}", named, options.rays));
  refuse(options.kind() == RayKind::pencils && named == "--preview",
         fmt::format("{}: not with pencils, which come before all else; expected it without --rays pencils", named));
}

}  // namespace durero::cli
