#include "raster_techniques.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "durero/io/number_text.hpp"
#include "durero/io/pictures/picture_file.hpp"
#include "durero/io/source.hpp"
#include "durero/raster/mirror.hpp"
#include "durero/raster/shadow_pictures.hpp"
#include "durero/raster/transparency.hpp"
#include "durero/raster/vector_drawing.hpp"
#include "durero/render/light/whitted.hpp"
#include "durero/render/render.hpp"
#include "numbers.hpp"

namespace durero::cli {
namespace {

/// The picture by rays, as `durero render` draws it.
render::Picture by_rays(const RasterOptions& options, const SceneTracer& tracer, scene::Resolution size) {
  render::RenderSettings frame;
  frame.size = size;
  frame.max_depth = options.max_depth;
  return render::render(tracer.scene(), tracer.engine(), {}, frame);
}

std::string count(std::uint64_t number, std::string_view one) {
  return fmt::format("{} {}{}", number, one, number == 1 ? "" : "s");
}

scene::TexelImage picture_in(const std::string& file) {
  const io::Source source = io::read_source(file);
  try {
    return io::picture_of(source.text(), scene::TransferFunction::srgb);
  } catch (const io::PictureError& error) {
    throw io::FileError(file, error.what(), "expected a PNG or JPEG file");
  }
}

/// The camera of the projector: at the first light, towards the point that the call names, or else as the eye looks.
scene::Camera projector_of(const RasterOptions& options, const scene::Stage& stage) {
  if (stage.lights.empty()) throw std::domain_error("no point light can throw a picture; expected one");
  const auto named = numbers_in<3>(options.towards, ',', io::read_finite);
  const glm::dvec3 towards = named ? glm::dvec3((*named)[0], (*named)[1], (*named)[2]) : stage.camera.value().look_at;
  return {stage.lights[0].position, towards, stage.camera.value().up, options.height};
}

/// The mean length of the runs of one texel along the row through the middle of the picture; 0 where there is none.
double measured_pixels(const raster::RasterScene& scene, const raster::Projector& projector) {
  const auto [width, height] = scene.view().resolution();
  std::uint64_t pixels = 0, runs = 0;
  std::optional<scene::Pixel> last;
  for (std::uint32_t x = 0; x < width; ++x) {
    const std::uint32_t nearest = scene.nearest(std::size_t(height / 2) * width + x);
    const auto texel =
        nearest == raster::ZBuffer::none ? std::nullopt : projector.texel_on(scene.point(nearest, x, height / 2).point);
    pixels += texel ? 1 : 0;
    runs += texel && texel != last ? 1 : 0;
    last = texel;
  }
  return runs == 0 ? 0 : double(pixels) / double(runs);
}

std::string texel_figures(const raster::RasterScene& scene, const raster::Projector& projector, std::uint32_t finer) {
  const auto [width, height] = scene.view().resolution();
  const std::uint32_t nearest = scene.nearest(std::size_t(height / 2) * width + width / 2);
  if (nearest == raster::ZBuffer::none) return "nothing in the middle of the picture";
  const double predicted = projector.predicted_pixels(scene.point(nearest, width / 2, height / 2).point,
                                                      *scene.scene().stage().camera, scene.view().resolution());
  return fmt::format("a texel of {:.2f} pixels predicted in the middle, {:.2f} measured along its row",
                     predicted / finer, measured_pixels(scene, projector) / finer);
}

}  // namespace

std::string shadows_drawing(const SceneTracer& tracer, scene::Resolution size) {
  const raster::RasterScene scene(tracer.scene(), size, raster::Opacity::opaque);
  return raster::svg(scene, raster::lit_by_shadows(scene));
}

std::string weiler_drawing(const SceneTracer& tracer, scene::Resolution size) {
  const raster::RasterScene scene(tracer.scene(), size, raster::Opacity::opaque);
  return raster::svg(scene, raster::lit_by_visibility(scene));
}

RasterResult shadows_technique(const RasterOptions& options, const SceneTracer& tracer, scene::Resolution size) {
  const raster::RasterScene scene(tracer.scene(), size, raster::Opacity::opaque);
  raster::DrawnShadows drawn = raster::by_shadow_polygons(scene);
  return {std::move(drawn.picture), by_rays(options, tracer, size),
          fmt::format("{}, {} of them projected, {}", count(scene.polygons().size(), "polygon"),
                      count(drawn.operations, "pair"), count(drawn.polygons, "shadow polygon"))};
}

RasterResult weiler_technique(const RasterOptions& options, const SceneTracer& tracer, scene::Resolution size) {
  const raster::RasterScene scene(tracer.scene(), size, raster::Opacity::opaque);
  raster::DrawnShadows drawn = raster::by_lit_polygons(scene);
  return {std::move(drawn.picture), by_rays(options, tracer, size),
          fmt::format("{}, {} clipped, {}", count(scene.polygons().size(), "polygon"), count(drawn.operations, "part"),
                      count(drawn.polygons, "lit part"))};
}

RasterResult depth_map_technique(const RasterOptions& options, const SceneTracer& tracer, scene::Resolution size) {
  const raster::RasterScene scene(tracer.scene(), size, raster::Opacity::opaque);
  const raster::DepthBias bias = options.bias == "none" ? raster::DepthBias::none : raster::DepthBias::texel;
  return {raster::by_depth_maps(scene, options.map, bias), by_rays(options, tracer, size),
          fmt::format("{}, depth maps of six pictures of {}x{}, bias {}", count(scene.polygons().size(), "polygon"),
                      options.map, options.map, options.bias)};
}

RasterResult projected_technique(const RasterOptions& options, const SceneTracer& tracer, scene::Resolution size) {
  const raster::RasterScene scene(tracer.scene(), size, raster::Opacity::opaque);
  const raster::Projector projector(projector_of(options, tracer.scene().stage()), picture_in(options.picture));
  return {raster::by_projector(scene, projector, options.map),
          raster::projected_by_rays(scene, tracer.engine(), projector),
          texel_figures(scene, projector, options.finer())};
}

RasterResult transparent_technique(const RasterOptions& options, const SceneTracer& tracer, scene::Resolution size) {
  const raster::RasterScene scene(tracer.scene(), size, raster::Opacity::transparent);
  std::vector<std::size_t> order = raster::transparent_of(scene);
  if (options.order == "depth") {
    std::vector<polygon::Polygon> corners;
    for (const std::size_t place : order) corners.push_back(scene.corners()[place]);
    std::vector<std::size_t> sorted;
    for (const std::size_t place : raster::far_to_near(corners, {polygon::exact(scene.view().eye())}))
      sorted.push_back(order[place]);
    order = std::move(sorted);
  }
  return {raster::with_transparency(scene, tracer.engine(), order), by_rays(options, tracer, size),
          fmt::format("{}, {} of them transparent, drawn by {}", count(scene.polygons().size(), "polygon"),
                      order.size(), options.order)};
}

RasterResult mirror_technique(const RasterOptions& options, const SceneTracer& tracer, scene::Resolution size) {
  const std::uint32_t depth = options.max_depth.value_or(render::depth_of(tracer.scene().stage()));
  return {raster::by_second_camera(tracer.scene(), tracer.engine(), size, options.mirror, depth),
          by_rays(options, tracer, size), fmt::format("the mirror {} by a second camera", options.mirror)};
}

}  // namespace durero::cli
