#include <fmt/format.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "durero/io/radiance/radiance.hpp"
#include "durero/scene/stage.hpp"
#include "durero/text/shown.hpp"
#include "io/axis.hpp"
#include "io/letters.hpp"
#include "io/losses.hpp"
#include "io/mesh/polygons.hpp"
#include "rad_looks.hpp"
#include "rad_sun.hpp"
#include "rad_text.hpp"

namespace durero::io {
namespace {

/// Sources of light up to so many degrees wide are taken for ones that shine in one direction.
constexpr double widest_sun = 5;

class RadReader {
 public:
  explicit RadReader(const Source& source) : text_(source) {}

  Imported read() {
    text_.for_each([this](const RadPrimitive& primitive) {
      if (is_rad_surface(primitive.type))
        add(primitive);
      else
        looks_.define(primitive);
    });
    looks_.finish();
    scene::Groups groups = made_groups();
    return {std::move(scene_), losses(), std::move(groups)};
  }

 private:
  struct Counts {
    std::size_t lights = 0, skies = 0, holes = 0, refused = 0, unnamed = 0, moved = 0;
  };
  struct SurfaceRow {
    std::string_view type;
    std::size_t numbers;
    void (RadReader::*add)(const RadPrimitive&);
  };

  void add(const RadPrimitive& surface) {
    static constexpr SurfaceRow rows[] = {
        {"sphere", 4, &RadReader::add_sphere},     {"bubble", 4, &RadReader::add_sphere},
        {"cylinder", 7, &RadReader::add_cylinder}, {"tube", 7, &RadReader::add_cylinder},
        {"cone", 8, &RadReader::add_cone},         {"cup", 8, &RadReader::add_cone},
        {"ring", 8, &RadReader::add_ring},         {"source", 4, &RadReader::add_source}};
    if (surface.type == "polygon") return add_polygon(surface);
    for (const SurfaceRow& row : rows) {
      if (row.type != surface.type) continue;
      if (surface.numbers.size() != row.numbers)
        surface.fail(fmt::format("{} of {} numbers", surface.type, surface.numbers.size()),
                     fmt::format("expected {}", row.numbers));
      return (this->*row.add)(surface);
    }
    ++others_[surface.type];
  }

  static glm::dvec3 triple(const RadPrimitive& surface, std::size_t first) {
    const double* const n = &surface.numbers[first];
    return {n[0], n[1], n[2]};
  }
  static glm::dvec3 point(const RadPrimitive& surface, std::size_t first) {
    return surface.placed.point(triple(surface, first));
  }
  /// A negative radius turns a surface inside out, and it is seen from both sides.
  static double length(const RadPrimitive& surface, double told) { return std::abs(told) * *surface.placed.scale; }

  void add_sphere(const RadPrimitive& surface) {
    put(surface, scene::Sphere{point(surface, 0), length(surface, surface.numbers[3])});
  }
  void add_cylinder(const RadPrimitive& surface) { add_between(surface, surface.numbers[6], surface.numbers[6]); }
  void add_cone(const RadPrimitive& surface) { add_between(surface, surface.numbers[6], surface.numbers[7]); }

  void add_between(const RadPrimitive& surface, double first, double last) {
    const auto made = surface_between({point(surface, 0), length(surface, first)},
                                      {point(surface, 3), length(surface, last)}, rounded_);
    if (made)
      std::visit([&](const auto& shape) { put(surface, shape); }, *made);
    else
      ++counts_.refused;
  }

  void add_ring(const RadPrimitive& surface) {
    double outer = length(surface, surface.numbers[6]), hole = length(surface, surface.numbers[7]);
    if (outer < hole) std::swap(outer, hole);
    if (hole > 0) {
      ++counts_.holes;
      return;
    }
    const auto normal = axis_between(glm::dvec3(0), surface.placed.normal(triple(surface, 3)));
    if (!normal) {
      ++counts_.refused;
      return;
    }
    put(surface, scene::Disc{point(surface, 0), outer, normal->vector});
  }

  void add_polygon(const RadPrimitive& surface) {
    const std::size_t n = surface.numbers.size();
    if (n < 9 || n % 3 != 0)
      surface.fail(fmt::format("polygon of {} numbers", n),
                   "expected three for each vertex, of three vertices or more");
    std::vector<glm::dvec3> vertices;
    for (std::size_t i = 0; i < n; i += 3) vertices.push_back(point(surface, i));
    const std::size_t first = polygons_.number() + 1;
    polygons_.add(vertices, material_of(surface));
    for (std::size_t i = first; i <= polygons_.number(); ++i)
      if (std::string triangle = polygons_.name(i); scene_.find(triangle)) keep_name(surface, std::move(triangle));
  }

  /// The light of the whole sky is a background, and a narrow one a sun.
  void add_source(const RadPrimitive& surface) {
    const auto light = looks_.light_of(surface);
    const double angle = surface.numbers[3];
    const glm::dvec3 towards = surface.placed.direction(triple(surface, 0));
    if (light && angle >= 360 && !scene_.stage().background) {
      scene_.stage().background = *light;
    } else if (light && angle > 0 && angle <= widest_sun && towards != glm::dvec3(0)) {
      scene_.stage().directional_lights.push_back({-towards, *light * share_of_sun(angle)});
    } else {
      ++counts_.skies;
    }
  }

  std::optional<std::uint32_t> material_of(const RadPrimitive& surface) {
    if (looks_.light_of(surface)) ++counts_.lights;
    return looks_.of(surface);
  }

  template <class Shape>
  void put(const RadPrimitive& surface, const Shape& shape) {
    std::string name = fmt::format("{}{}", letter_of<Shape>(), ++numbered_[scene::place_of<Shape>]);
    const model::Answer answer = scene_.add(model::Elemento{name}, shape, material_of(surface));
    if (answer.ok())
      keep_name(surface, std::move(name));
    else
      ++counts_.refused;
  }

  void keep_name(const RadPrimitive& surface, std::string element) {
    if (model::Elemento::is_name(surface.identifier))
      members_[surface.identifier].insert(std::move(element));
    else
      ++counts_.unnamed;
  }

  scene::Groups made_groups() {
    scene::Groups groups;
    for (auto& [name, elements] : members_)
      groups.apply_total(scene::Grouping{name, {std::move(elements), {}}}, scene_);
    return groups;
  }

  std::vector<std::string> losses() const {
    std::vector<std::string> lost;
    polygons_.name_losses(lost);
    rounded_.name_losses(lost);
    add_loss(lost, counts_.refused, "surface", "surfaces",
             "left out: it breaks a rule of a scene, such as a radius of 0");
    add_loss(lost, counts_.holes, "ring", "rings", "left out: a scene's disc has no hole");
    for (const auto& [type, count] : others_)
      add_loss(lost, count, type, type + (type == "mesh" ? "es" : "s"),
               "left out: it is in a file that another program has made");
    text_.name_losses(lost);
    looks_.name_losses(lost);
    add_loss(lost, counts_.lights, "surface", "surfaces", "that shines lights no other: it is as bright as it says");
    add_loss(lost, counts_.skies, "source", "sources", "left out: neither a sun nor one light all around");
    add_loss(lost, counts_.unnamed, "element", "elements", "in no group: its identifier is no name");
    return lost;
  }

  RadText text_;
  scene::Scene scene_;
  RadLooks looks_{scene_};
  Polygons polygons_{scene_, "p"};
  std::map<std::string, scene::Names, std::less<>> members_;
  std::map<std::string, std::size_t, std::less<>> others_;
  Counts counts_;
  EndRoundings rounded_;
  std::array<std::size_t, std::tuple_size_v<scene::Shapes>> numbered_{};
};

}  // namespace

Imported read_radiance(const Source& source) { return RadReader(source).read(); }

}  // namespace durero::io
