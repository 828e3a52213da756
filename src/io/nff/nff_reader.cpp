#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <tuple>

#include "durero/io/json/whole_number.hpp"
#include "durero/io/nff/nff.hpp"
#include "durero/scene/stage.hpp"
#include "durero/text/shown.hpp"
#include "io/axis.hpp"
#include "io/json/stage_fields.hpp"
#include "io/letters.hpp"
#include "io/losses.hpp"
#include "io/mesh/numbered_materials.hpp"
#include "io/mesh/polygons.hpp"
#include "nff_words.hpp"

namespace durero::io {
namespace {

class NffReader {
 public:
  explicit NffReader(const Source& source) : in_(source) {}

  Imported read() {
    while (!in_.done()) read_entity();
    finish_lights();
    materials_.finish();
    return {std::move(scene_), losses()};
  }

 private:
  struct Counts {
    std::size_t smooth = 0, inward = 0, near_planes = 0, settings = 0;
  };

  void read_entity() {
    const std::size_t at = in_.offset();
    const std::string_view entity = in_.word();
    if (entity == "v") {
      read_view(at);
    } else if (entity == "b") {
      read_background(at);
    } else if (entity == "l") {
      read_light();
    } else if (entity == "f") {
      read_fill();
    } else if (entity == "s") {
      read_sphere();
    } else if (entity == "c") {
      read_cone();
    } else if (entity == "p" || entity == "pp") {
      read_polygon(entity == "pp");
    } else if (entity == "Q" || entity == "Z") {
      in_.number(entity);
      ++counts_.settings;
    } else {
      in_.fail(at, fmt::format("unknown entity {}", text::shown(entity)),
               "expected one of v, b, l, f, s, c, p, pp, Q, Z");
    }
  }

  void read_view(std::size_t at) {
    if (scene_.stage().camera) in_.fail(at, "a second view", "expected one");
    scene::Camera camera{};
    std::set<std::string_view> seen;
    for (int i = 0; i < 6; ++i) {
      const std::size_t key_at = in_.offset();
      const std::string_view key = in_.done() ? "" : in_.word();
      if (!read_view_part(key, camera) || !seen.insert(key).second) {
        in_.fail(key_at, fmt::format("{} in a view", text::shown(key)),
                 "expected each of from, at, up, angle, hither, resolution once");
      }
    }
    if (camera.eye == camera.look_at) in_.fail(at, "from is at", "expected two points");
    scene_.stage().camera = camera;
  }

  // False where the key is unknown.
  bool read_view_part(std::string_view key, scene::Camera& camera) {
    if (key == "hither") {
      if (in_.number(key) != 0) ++counts_.near_planes;
      return true;
    }
    if (key == "resolution") {
      read_resolution();
      return true;
    }
    const auto read = [&](const auto& field) { return field.key == key && (read_field(field, camera), true); };
    return std::apply([&](const auto&... field) { return (read(field) || ...); }, view_fields);
  }

  template <class Part, class Value>
  void read_field(const Field<Part, Value>& field, Part& part) {
    const std::size_t at = in_.offset();
    Value& value = part.*field.member;
    if constexpr (std::is_same_v<Value, double>) {
      value = in_.number(field.key);
    } else {
      value = in_.triple(field.key);
    }
    check_rule(in_, at, field.key, field.rule, value);
  }

  void read_resolution() {
    const std::size_t at = in_.offset();
    const double width = in_.number("resolution"), height = in_.number("resolution");
    if (!is_whole(width, 1, most_pixels) || !is_whole(height, 1, most_pixels)) {
      in_.fail(at, fmt::format("resolution is {} {}", width, height), "expected whole numbers of pixels, 1 to 65535");
    }
    scene_.stage().resolution = {static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)};
  }

  void read_background(std::size_t at) {
    if (scene_.stage().background) in_.fail(at, "a second background", "expected one");
    scene_.stage().background = read_color("b");
  }

  glm::dvec3 read_color(std::string_view what) {
    const std::size_t at = in_.offset();
    const glm::dvec3 color = in_.triple(what);
    check_rule(in_, at, fmt::format("the colour of {}", what), light_color, color);
    return color;
  }

  void read_light() {
    const glm::dvec3 position = in_.triple("l");
    const bool colored = in_.same_line();
    if (!colored) colorless_.push_back(scene_.stage().lights.size());
    scene_.stage().lights.push_back({position, colored ? read_color("l") : glm::dvec3{}});
  }

  void read_fill() {
    const std::size_t at = in_.offset();
    const glm::dvec3 color = read_color("f");
    scene::Material look{.color = color * in_.number("f")};
    check_rule(in_, at, "the colour of f, times Kd,", share, look.color);
    look.k_s = look.k_ps = read_ruled("Ks", share_of_all);
    // How sharp a highlight is that there is not, and what light is bent by where none shines through, is nobody's to
    // ask.
    const double shine = look.k_s > 0 ? read_ruled("Shine", exponent) : in_.number("f");
    if (look.k_s > 0) look.e = shine;
    look.k_t = read_ruled("T", share_of_all);
    const double index = look.k_t > 0 ? read_ruled("the index of refraction", refractive_index) : in_.number("f");
    if (look.k_t > 0) look.index = index;
    fill_ = materials_.number(std::move(look));
  }

  double read_ruled(std::string_view what, const Rule<double>& rule) {
    const std::size_t at = in_.offset();
    const double value = in_.number("f");
    check_rule(in_, at, what, rule, value);
    return value;
  }

  void read_sphere() {
    const glm::dvec3 center = in_.triple("s");
    const std::size_t at = in_.offset();
    const double radius = in_.number("s");
    if (radius < 0) ++counts_.inward;
    add(at, scene::Sphere{center, std::abs(radius)});
  }

  void read_cone() {
    const std::size_t at = in_.offset();
    RoundEnd base{in_.triple("c"), in_.number("c")}, end{in_.triple("c"), in_.number("c")};
    if (std::min(base.radius, end.radius) < 0) ++counts_.inward;
    base.radius = std::abs(base.radius);
    end.radius = std::abs(end.radius);
    const auto surface = surface_between(base, end, rounded_);
    if (!surface) in_.fail(at, "the ends of c give no axis", "expected two points, a finite distance apart");
    std::visit([&](const auto& shape) { add(at, shape); }, *surface);
  }

  void read_polygon(bool has_normals) {
    const std::size_t at = in_.offset();
    const double count = in_.number("p");
    if (!is_whole(count, 3, std::numeric_limits<double>::max())) {
      in_.fail(at, fmt::format("a polygon of {} vertices", count), "expected a whole number from 3");
    }
    std::vector<glm::dvec3> vertices;
    CornerLooks looks;
    // A double counts exactly, far beyond the length of any file. NOLINTNEXTLINE(*FloatLoopCounter)
    for (double i = 0; i < count; ++i) {
      vertices.push_back(in_.triple("p"));
      if (has_normals) looks.normals.push_back(in_.triple("p"));
    }
    polygons_.add(vertices, fill_, looks);
  }

  template <class Shape>
  void add(std::size_t at, const Shape& shape) {
    const std::size_t number = ++numbered_[scene::place_of<Shape>];
    const model::Elemento name(fmt::format("{}{}", letter_of<Shape>(), number));
    const model::Answer answer = scene_.add(name, shape, fill_);
    if (!answer.ok()) {
      in_.fail(at, std::string(model::name(answer.r)),
               fmt::format("expected {} ({})", answer.violated->predicate, answer.violated->label));
    }
  }

  void finish_lights() {
    auto& lights = scene_.stage().lights;
    const double share = 1 / std::sqrt(static_cast<double>(lights.size()));
    for (const std::size_t i : colorless_) lights[i].color = {share, share, share};
  }

  std::vector<std::string> losses() const {
    std::vector<std::string> lost;
    polygons_.name_losses(lost);
    rounded_.name_losses(lost);
    add_loss(lost, counts_.inward, "surface", "surfaces", "seen from inside only: kept, seen from both sides");
    add_loss(lost, counts_.near_planes, "near plane", "near planes", "(hither) left out: a scene's camera has none");
    add_loss(lost, counts_.settings, "setting", "settings", "of another tracer (Q, Z) left out");
    return lost;
  }

  NffWords in_;
  scene::Scene scene_;
  Polygons polygons_{scene_, "p"};
  Counts counts_;
  EndRoundings rounded_;
  std::vector<std::size_t> colorless_;  // lights
  NumberedMaterials materials_{scene_};
  std::optional<std::uint32_t> fill_;  // of what follows
  std::array<std::size_t, std::tuple_size_v<scene::Shapes>> numbered_{};
};

}  // namespace

Imported read_nff(const Source& source) { return NffReader(source).read(); }

}  // namespace durero::io
