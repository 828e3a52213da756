// durero render SCENE -o OUT.png: Algorithm II.1, with the options of render_options.hpp.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "commands.hpp"
#include "description.hpp"
#include "durero/contract/contract.hpp"
#include "durero/io/output_file.hpp"
#include "durero/io/standard_output.hpp"
#include "durero/polygon/convex.hpp"
#include "durero/render/bundle/beams.hpp"
#include "durero/render/bundle/caustics.hpp"
#include "durero/render/bundle/cones.hpp"
#include "durero/render/light/whitted.hpp"
#include "durero/render/output/exr.hpp"
#include "durero/render/sample/refined.hpp"
#include "durero/render/sample/seen.hpp"
#include "durero/scene/motion.hpp"
#include "durero/scene/stage.hpp"
#include "engines.hpp"
#include "file_error.hpp"
#include "interrupted.hpp"
#include "progress.hpp"
#include "render_options.hpp"
#include "scene_tracer.hpp"

namespace durero::cli {
namespace {

/// The exception that ends a pass that the user does not wait for.
struct Stopped {};

/// A drawing: a picture to be rendered, and its file.
class Drawing {
  const scene::Scene& scene() const { return tracer_.scene(); }

  /// Calls draw(), and adds the name of the scene or the crop to its errors.
  template <class Draw>
  auto in_words(Draw&& draw) const {
    try {
      return naming_file<std::domain_error>(options_.scene, draw);
    } catch (const std::out_of_range&) {
      const scene::Resolution size = size_of(options_, scene().stage());
      throw std::runtime_error(fmt::format("render: --crop {}: it is not inside the picture; expected pixels of {}x{}",
                                           options_.crop, size.width, size.height));
    }
  }

 public:
  explicit Drawing(const RenderOptions& options)
      : options_(options),
        frame_(frame_of(options)),
        tracer_(options.scene, options.engine, options.hierarchy, options.with, frame_.size, Pictures::read) {
    tracer_.require_origins("shadow rays start on elements");
    if (options.wide.kind() != RayKind::lines) tracer_.require_tables("wide rays");
    frame_.prepare = [this](const scene::Scene& then) { return tracer_.prepare(then); };
  }

  int draw(io::OutputFile& out) const {
    render::PathStatistics reach;
    std::optional<Progress> progress(std::in_place, options_.quiet, "render");
    std::optional<io::OutputFile> tree;
    if (!options_.wide.tree.empty()) tree.emplace(options_.wide.tree);
    const render::Picture picture = in_words([&] {
      const auto show = [&](double share) { progress->set_share(share); };
      return drawn(show, reach, tree);
    });
    const std::string bytes = encoded(picture, channels());
    progress.reset();
    out.write(bytes);
    if (tree) tree->commit();
    if (options_.min_weight) io::print(reach_text(reach));
    if (options_.is_statistical()) io::print(doubt_text(reach));
    if (options_.is_allotted()) io::print(rays_text(reach) + "\n");
    out.commit();
    return 0;
  }

  int preview() const {
    const std::atomic<bool>& stop = interrupted();
    const std::uint32_t most = options_.samples.value_or(render::Refined::most_passes);
    const auto refined = in_words([&] { return std::make_unique<render::Refined>(scene(), tracer_.engine(), frame_); });
    const std::optional<render::Channels> seen = channels();
    while (!stop && refined->passes() < most) {
      if (!pass(*refined, stop)) break;
      io::write_file(options_.out, encoded(refined->picture(), seen, refined->passes()));
    }
    if (refined->passes() == 0)
      throw std::runtime_error("render: it was interrupted before there was a picture; expected a pass at least");
    io::print(fmt::format("{} pass{}\n", refined->passes(), refined->passes() == 1 ? "" : "es"));
    return 0;
  }

 private:
  /// The picture by the rays that are asked for.
  render::Picture drawn(const render::Progress& show, render::PathStatistics& reach,
                        std::optional<io::OutputFile>& tree) const {
    switch (options_.wide.kind()) {
      case RayKind::lines:
        return render::render(scene(), tracer_.engine(), show, frame_, &reach);
      case RayKind::cones:
        return render::by_cones(scene(), tracer_.engine(), show, frame_, options_.wide.spread.value_or(1));
      case RayKind::beams: {
        render::BeamPicture beams = render::by_beams(scene(), tracer_.engine(), show, frame_);
        if (tree) tree->write(render::svg(beams.tree, scene(), size_of(options_, scene().stage())));
        io::print(beams_text(beams));
        return std::move(beams.picture);
      }
      case RayKind::pencils: {
        if (scene::moves(scene())) throw std::domain_error("the scene moves; expected one at rest with pencils");
        const std::uint32_t depth = frame_.max_depth.value_or(render::depth_of(scene().stage()));
        const render::Caustics caustics(scene(), tracer_.engine(), depth);
        render::RenderSettings frame = frame_;
        frame.caustics = &caustics;
        io::print(fmt::format("{} pencils, {} spots of light; left out: {:.2g} of the light\n", caustics.pencils(),
                              caustics.spots().all().size(), caustics.left_out()));
        return render::render(scene(), tracer_.engine(), show, frame, &reach);
      }
    }
    contract::unreachable();
  }

  /// Makes a pass. Returns whether it was done to its end.
  bool pass(render::Refined& refined, const std::atomic<bool>& stop) const {
    Progress progress(options_.quiet, fmt::format("render: pass {}", refined.passes() + 1));
    try {
      refined.pass([&](double share) {
        if (stop) throw Stopped{};
        progress.set_share(share);
      });
    } catch (const Stopped&) {
      return false;
    }
    return true;
  }

  std::optional<render::Channels> channels() const {
    if (!options_.aov) return std::nullopt;
    return in_words([&] {
      return render::Channels{render::seen(scene(), tracer_.engine(), frame_), render::numbered(scene())};
    });
  }

  std::string encoded(const render::Picture& picture, const std::optional<render::Channels>& seen,
                      std::optional<std::uint32_t> passes = {}) const {
    const std::vector<render::Note> notes = notes_of(options_, scene().stage(), passes);
    return options_.is_exr() ? render::encode_exr(picture, notes, seen)
                             : render::encode_png(render::toned(picture, tone_of(options_)), notes);
  }

  std::string reach_text(const render::PathStatistics& reach) const {
    const auto pixels = static_cast<double>(reach.pixels);
    return fmt::format("mean depth {:.3f} of {}, {:.3f} rays a pixel; left out: at most {:.3g} of a linear component\n",
                       static_cast<double>(reach.depths) / pixels, reach.max_depth,
                       static_cast<double>(reach.rays) / pixels, reach.left_out);
  }

  static std::string beams_text(const render::BeamPicture& beams) {
    polygon::Rational area = 0;
    std::uint32_t depth = 0;
    for (const render::BeamRegion& region : beams.tree) {
      if (region.depth == 1) area += render::area(region.outline);
      depth = std::max(depth, region.depth);
    }
    return fmt::format(
        "{} regions, up to {} beams in a row; the areas of the first add up to {} pixels; {} rays on lines\n",
        beams.tree.size(), depth, area.str(), beams.asked);
  }

  static std::string rays_text(const render::PathStatistics& reach) {
    return fmt::format("{:.3f} rays from the eye a pixel",
                       static_cast<double>(reach.samples) / static_cast<double>(reach.pixels));
  }

  std::string doubt_text(const render::PathStatistics& reach) const {
    const render::Samples& samples = frame_.samples;
    return fmt::format("{}; {} of {} pixels not known within {} with confidence {}\n", rays_text(reach), reach.in_doubt,
                       reach.pixels, samples.width, samples.confidence);
  }

  const RenderOptions& options_;
  render::RenderSettings frame_;
  SceneTracer tracer_;
};

int run(const RenderOptions& options) {
  check_together(options);
  const ThreadLimit limit(options.threads);
  if (options.preview) return Drawing(options).preview();
  io::OutputFile out(options.out);
  return Drawing(options).draw(out);
}

}  // namespace

void add_render(CLI::App& app, int& status) {
  auto* command = app.add_subcommand("render", "Draw the scene: camera, lights and shadows, mirrors and glass");
  const auto options = std::make_shared<RenderOptions>();
  add_render_options(*command, *options);
  command->footer(exit_status("the picture is written", "the call or the scene is bad") +
                  examples({"render demo/still-life.json -o still-life.png",
                            "render demo/still-life.json -o smooth.png --sampling statistical",
                            "render demo/still-life.json -o middle.png --size 1920x1080 --crop 480,270,960,540",
                            "render demo/still-life.json -o linear.exr --aov",
                            "render demo/gallery/beams.json -o beams.png --rays beams --tree beams.svg",
                            "render demo/surfaces/torus.json -o torus.png --with demo/surfaces/torus.tex"}));
  command->callback([options, &status] { status = run(*options); });
}

}  // namespace durero::cli
