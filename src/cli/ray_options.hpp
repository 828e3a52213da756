#pragma once
/// The options of `durero render` for rays that are more than lines.

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>

namespace durero::cli {

/// The kinds of rays, in the order of their names.
enum class RayKind : std::uint8_t { lines, cones, beams, pencils };

/// The options as they stand in the call.
struct RayOptions {
  std::string rays, tree;
  std::optional<double> spread;  ///< of cones, in parts of their part of a pixel

  RayKind kind() const;
};

/// Declares the options.
void add_ray_options(CLI::App& command, RayOptions& options);

/// Checks that the options go together, among themselves and with those of rays that are lines alone, of which `named`
/// is one that stands in the call, or empty. Throws std::invalid_argument with one line.
void check_together(const RayOptions& options, const std::string& named);

}  // namespace durero::cli
