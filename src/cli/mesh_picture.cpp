#include "mesh_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <memory>
#include <set>
#include <stdexcept>
#include <string_view>
#include <unordered_set>
#include <utility>
#include <vector>

#include "durero/composed/engine.hpp"
#include "durero/model/operaciones.hpp"
#include "durero/render/output/tone.hpp"
#include "durero/render/render.hpp"
#include "durero/scene/edit.hpp"
#include "durero/scene/mesh_edit.hpp"
#include "durero/scene/stage.hpp"

namespace durero::cli {
namespace {

constexpr scene::Resolution view_size{800, 800};
/// The sizes of what is drawn: the squares of lengths, and products of two, have then neither overflow nor underflow.
constexpr double least_radius = 1e-70, greatest_radius = 1e70;
/// The materials of the stage, by name.
enum class MarkLook : std::uint32_t { found, mark, sound };

std::vector<scene::Material> looks() {
  return {{.name = "found", .color = {0.8, 0.1, 0.06}, .k_a = 0.25, .k_d = 0.75},
          {.name = "mark", .color = {1, 0.75, 0}, .k_a = 0.6, .k_d = 0.4},
          {.name = "sound", .color = {0.55, 0.58, 0.62}, .k_a = 0.25, .k_d = 0.75}};
}

/// A ball about the box of the vertices: its middle, and half of its diagonal.
struct ViewBall {
  glm::dvec3 middle;
  double radius;
};

ViewBall ball_of(const std::vector<glm::dvec3>& vertices) {
  glm::dvec3 least = vertices.front(), greatest = least;
  for (const glm::dvec3& p : vertices) {
    least = glm::min(least, p);
    greatest = glm::max(greatest, p);
  }
  const glm::dvec3 half = greatest / 2.0 - least / 2.0;
  const double radius = std::hypot(half.x, half.y, half.z);
  if (!(least_radius <= radius && radius <= greatest_radius))
    throw std::domain_error(fmt::format("half of the diagonal of its box is {}; expected {} to {}, to draw it", radius,
                                        least_radius, greatest_radius));
  return {least / 2.0 + greatest / 2.0, radius};
}

/// The mesh and the marks of its findings.
class MarkedMesh {
 public:
  MarkedMesh(const io::SceneMesh& mesh, const io::MeshCheck& check) : ball_(ball_of(mesh.vertices)) {
    scene_.stage().materials = looks();
    add_faces(mesh, check);
    for (const io::MeshDefect& defect : check.findings) mark(defect.places);
    engine_ = composed::prepared(*engine::find(engine::default_engine), scene_);
  }

  /// The picture from that side: `way` points from the middle towards the eye.
  render::Picture seen_from(const glm::dvec3& way) {
    scene::Stage& stage = scene_.stage();
    const glm::dvec3 eye = ball_.middle + glm::normalize(way) * (3 * ball_.radius);
    stage.camera = {.eye = eye, .look_at = ball_.middle, .up = {0, 0, 1}, .fov_y = 40};
    stage.background = glm::dvec3(1);
    stage.directional_lights = {{ball_.middle - eye, glm::dvec3(0.7)}, {{1, 2, -3}, glm::dvec3(0.4)}};
    return render::render(scene_, *engine_, {}, {.size = view_size, .samples = {.most = 4}});
  }

 private:
  void add_faces(const io::SceneMesh& mesh, const io::MeshCheck& check) {
    std::unordered_set<std::string_view> named;
    for (const io::MeshDefect& defect : check.findings) named.insert(defect.faces.begin(), defect.faces.end());
    scene::Mesh found{model::Elemento("found"), mesh.vertices}, sound{model::Elemento("sound"), mesh.vertices};
    for (std::size_t n = 0; n < mesh.faces.size(); ++n) {
      const auto [i, j, k] = mesh.faces[n];
      const auto& p = mesh.vertices;
      if (!model::Vertices::contains({model::Punto(p[i]), model::Punto(p[j]), model::Punto(p[k])})) continue;
      (named.contains(mesh.names[n]) ? found : sound).caras.push_back({i, j, k});
    }
    add(std::move(found), MarkLook::found);
    add(std::move(sound), MarkLook::sound);
  }

  void add(scene::Mesh mesh, MarkLook look) {
    mesh.material = static_cast<std::uint32_t>(look);
    scene_.apply_total(scene::MeshEdit(scene::MeshAddition{std::move(mesh)}));
  }

  /// Balls at the places, and rods between them, each once.
  void mark(const std::vector<glm::dvec3>& places) {
    const double radius = ball_.radius / 100;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const Key here = key_of(places[i]), next = key_of(places[(i + 1) % places.size()]);
      const auto& [from, to] = std::minmax(here, next);
      if (balls_.insert(here).second) add(model::Agregar_Esfera{next_name(), model::Punto(places[i]), radius});
      const double length = glm::distance(place_of(from), place_of(to));
      if (length > radius && rods_.insert({from, to}).second)
        add(model::Agregar_Cilindro{next_name(), model::Punto(place_of(from)), radius / 2,
                                    model::Vector((place_of(to) - place_of(from)) / length), length});
    }
  }

  void add(model::Operation operation) {
    scene_.apply_total(scene::Edit{std::move(operation), static_cast<std::uint32_t>(MarkLook::mark)});
  }
  model::Elemento next_name() { return model::Elemento(std::to_string(marks_++)); }

  using Key = std::array<double, 3>;
  static Key key_of(const glm::dvec3& place) { return {place.x, place.y, place.z}; }
  static glm::dvec3 place_of(const Key& key) { return {key[0], key[1], key[2]}; }

  ViewBall ball_;
  scene::Scene scene_;
  std::unique_ptr<const engine::Engine> engine_{};
  std::set<Key> balls_;
  std::set<std::pair<Key, Key>> rods_;  // by their ends, the lesser one first
  std::size_t marks_ = 0;
};

/// Pictures of the same height side by side.
render::Picture beside(const render::Picture& left, const render::Picture& right) {
  const std::uint32_t width = left.resolution.width, both = width + right.resolution.width;
  render::Picture whole({both, left.resolution.height});
  for (std::uint32_t y = 0; y < left.resolution.height; ++y) {
    const auto row = whole.rgb.begin() + std::ptrdiff_t(y) * both;
    std::copy_n(left.rgb.begin() + std::ptrdiff_t(y) * width, width, row);
    std::copy_n(right.rgb.begin() + std::ptrdiff_t(y) * right.resolution.width, right.resolution.width, row + width);
  }
  return whole;
}

}  // namespace

std::string mesh_picture(const io::SceneMesh& mesh, const io::MeshCheck& check) {
  if (mesh.vertices.empty()) throw std::domain_error("there is no triangle; expected some to draw");
  MarkedMesh marked(mesh, check);
  const render::Picture above = marked.seen_from({2, -3, 2}), below = marked.seen_from({-2, 3, -2});
  return render::encode_png(render::toned(beside(above, below), render::Tone::clamp));
}

}  // namespace durero::cli
