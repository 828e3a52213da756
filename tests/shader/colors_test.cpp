#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "durero/io/json/scene_file.hpp"
#include "durero/io/source.hpp"
#include "durero/model/operaciones.hpp"
#include "durero/render/output/tone.hpp"
#include "durero/render/render.hpp"
#include "durero/shader/fragment.hpp"
#include "shader/answers.hpp"
#include "support/catch.hpp"
#include "support/tree.hpp"

using namespace durero;
using namespace durero::test;

#ifndef DURERO_EGL
TEST_CASE("no colour is drawn where EGL and OpenGL ES were not found") { WARN("no colour is drawn"); }
#else

namespace {

scene::Scene scene_of(const std::string& path) { return io::read_scene(io::read_source(source_dir() + path)); }

/// How far the colours of a shader are from those of the renderer, in steps of 255, where the element is not in doubt.
struct ColorDifference {
  double mean = 0;
  double far = 0;  ///< the share of pixels that differ by more than eight in some component
};

ColorDifference difference_of(const scene::Scene& scene, scene::Resolution size) {
  const scene::PrimaryRays rays(*scene.stage().camera, size);
  const auto engine = engine::find("fast")->prepare(scene);
  DrawnShader color(shader::fragment_shader(scene, shader::ShaderOutput::color), false);
  DrawnShader answer(shader::fragment_shader(scene, shader::ShaderOutput::answer), true);
  color.draw(rays);
  answer.draw(rays);
  const auto colors = color.colors();
  const auto answers = answer.answers();
  const render::Image drawn = render::toned(render::render(scene, *engine, {}, {.size = size}), render::Tone::clamp);
  double sum = 0, far = 0, pixels = 0;
  for (std::size_t i = 0; i < colors.size(); ++i) {
    if (answers[i][1] != 0) continue;
    int most = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const int off = std::abs(int{colors[i][k]} - int{drawn.rgb[3 * i + k]});
      sum += off;
      most = std::max(most, off);
    }
    far += most > 8;
    ++pixels;
  }
  return {sum / (3 * pixels), far / pixels};
}

/// A floor in two colours of the pattern, with u along x and v against z, and nothing else that shines.
scene::Scene floor_of_p6m() {
  scene::Scene scene;
  scene.stage().textures = {{.name = "t", .pattern = scene::Pattern::p6m, .colors = {glm::dvec3(0), glm::dvec3(1)}}};
  scene::Material material{.name = "m", .k_d = 0, .ambient = glm::dvec3(1)};
  material.textures.names[static_cast<std::size_t>(scene::Coefficient::ambient)] = "t";
  scene.stage().materials = {material};
  scene.add(model::Elemento("floor"), scene::Plane{{0, 0, 0}, {0, 1, 0}}, 0);
  scene.stage().camera = scene::Camera{{0, 5, 0}, {0, 0, 0}, {0, 0, 1}, 60};
  return scene;
}

/// The share of pixels that two views of the floor differ in. The middle of the second is at (u, v) and it is turned by
/// so many degrees.
class FloorViews {
 public:
  FloorViews() : shader_(shader::fragment_shader(scene_, shader::ShaderOutput::color), false), first_(view(0, 0, 0)) {}

  double apart(double u, double v, double degrees) { return apart(view(u, v, degrees)); }
  double apart_mirrored() {
    auto mirrored = first_;
    for (auto row = mirrored.begin(); row != mirrored.end(); row += side) std::reverse(row, row + side);
    return apart(mirrored);
  }

 private:
  using Pixels = std::vector<std::array<std::uint8_t, 4> >;
  static constexpr int side = 320;  // over 10^5 points

  Pixels view(double u, double v, double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    shader_.draw({{{u, 5, -v}, {u, 0, -v}, {std::sin(angle), 0, std::cos(angle)}, 60}, {side, side}});
    return shader_.colors();
  }
  double apart(const Pixels& other) const {
    double count = 0;
    for (std::size_t i = 0; i < first_.size(); ++i) count += first_[i] != other[i];
    return count / double(first_.size());
  }

  scene::Scene scene_ = floor_of_p6m();
  DrawnShader shader_;
  Pixels first_;
};

}  // namespace

TEST_CASE("colours are those of the renderer: mirrors, glass, shadows, patterns, highlights, surroundings") {
  const Offscreen offscreen;
  for (const char* path :
       {"/demo/gallery/shader.json", "/demo/gallery/whitted.json", "/demo/still-life.json",
        "/demo/gallery/cylinders-in-glass.json", "/demo/gallery/facing-mirrors.json", "/tests/shader/patterns.json"}) {
    const ColorDifference off = difference_of(scene_of(path), {320, 240});
    INFO(path << ": mean " << off.mean << ", share of far pixels " << off.far);
    CHECK(off.mean < 0.1);
    CHECK(off.far < 0.002);
  }
}

TEST_CASE("the p6m of a shader is kept by the generators of its group at 10^5 pixels, and by no other motion") {
  const Offscreen offscreen;
  FloorViews floor;
  constexpr double at_edges = 0.01, at_large = 0.1;  // binary32 may put pixels next to an edge on either side
  CHECK(floor.apart(0, 0, 60) < at_edges);
  CHECK(floor.apart(1, 0, 0) < at_edges);
  CHECK(floor.apart(0.5, std::numbers::sqrt3 / 2, 0) < at_edges);
  CHECK(floor.apart_mirrored() < at_edges);
  CHECK(floor.apart(0, 0, 90) > at_large);
  CHECK(floor.apart(0, 0, 30) > at_large);
  CHECK(floor.apart(0.5, 0, 0) > at_large);
}

#endif
