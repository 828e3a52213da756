#pragma once
/// The options of `durero render`.

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>

#include "durero/engine/engine.hpp"
#include "durero/io/file_name.hpp"
#include "durero/render/output/image.hpp"
#include "durero/render/output/tone.hpp"
#include "durero/render/render.hpp"
#include "durero/scene/stage.hpp"
#include "ray_options.hpp"

namespace durero::cli {

/// The options as they stand in the call.
struct RenderOptions {
  std::string scene, out, size, crop;
  std::string engine{engine::default_engine}, hierarchy{"automatic"}, with;
  std::string tone, sampling, integrator, shadows;
  std::optional<std::uint32_t> samples, max_depth, seed;
  std::optional<double> min_weight, width, confidence;
  std::size_t threads = 0;
  bool aov = false, preview = false, quiet = false;
  RayOptions wide{};

  bool is_exr() const { return io::ends_in(out, ".exr"); }
  bool is_statistical() const { return sampling == "statistical"; }
  bool is_allotted() const { return sampling == "allotted"; }
  bool is_as_needed() const { return is_statistical() || is_allotted(); }
};

/// The option --size of a command that draws.
void add_size(CLI::App& command, std::string& size);

/// Declares the options.
void add_render_options(CLI::App& command, RenderOptions& options);

/// Checks that the options go together. Throws std::invalid_argument with one line.
void check_together(const RenderOptions& options);

/// The frame that the options ask for.
render::RenderSettings frame_of(const RenderOptions& options);
render::Tone tone_of(const RenderOptions& options);

/// The size in pixels of the whole picture.
scene::Resolution size_of(const RenderOptions& options, const scene::Stage& stage);

/// The notes of a file: the program, and a call that draws the same picture again from a scene of that name. The call
/// has no folder and no time, nor an option that does not change the picture; the program's defaults stand for the
/// rest. `passes` are those of a preview.
std::vector<render::Note> notes_of(const RenderOptions& options, const scene::Stage& stage,
                                   std::optional<std::uint32_t> passes = {});

}  // namespace durero::cli
