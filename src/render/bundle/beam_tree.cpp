#include "durero/render/bundle/beam_tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vec2.hpp>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "bounds_of_side.hpp"
#include "durero/render/light/whitted.hpp"
#include "durero/scene/srgb.hpp"
#include "pixel_view.hpp"
#include "render/light/front.hpp"

namespace durero::render {
namespace {

using polygon::PlaneSide;
using polygon::Polygon;
using polygon::Rational;
using polygon::RationalPoint;

PlaneSide difference(const PlaneSide& f, const PlaneSide& g) { return {f.normal - g.normal, f.offset - g.offset}; }
bool is_zero(const PlaneSide& f) { return f.normal == RationalPoint{} && f.offset == 0; }

/// The plane of an element, and its corners where it has some.
struct FlatElement {
  scene::ElementRef element;
  RationalPoint point, normal;
  std::vector<RationalPoint> corners{};
};

/// An element as a beam sees it.
struct SeenElement {
  scene::ElementRef element;
  PlaneSide nearness;           ///< 1/t
  std::vector<PlaneSide> body;  ///< positive where rays meet the element
  std::vector<SideBounds> about{};
};

/// A part of a beam while elements divide it.
struct BeamCell {
  explicit BeamCell(Polygon corners, scene::ElementSet met = {}, PlaneSide near = {})
      : outline(std::move(corners)), elementos(std::move(met)), nearness(std::move(near)) {
    for (const RationalPoint& corner : outline)
      about.emplace_back(number::round_to_binary64(corner.x), number::round_to_binary64(corner.y));
  }
  Polygon outline;
  scene::ElementSet elementos;
  PlaneSide nearness;
  std::vector<glm::dvec2> about{};  ///< the corners, rounded
};

[[noreturn]] void refuse(const std::string& what) { throw std::domain_error(what); }

void require_followed(const scene::Scene& scene) {
  for (const scene::Material& m : scene.stage().materials) {
    if (m.k_t > 0)
      refuse(fmt::format("material {} lets light through, which bends beams; expected k_t 0 with beams", m.name));
    if (m.k_ps > 0 && m.bump)
      refuse(fmt::format("material {} is a mirror with a relief; expected a flat mirror with beams", m.name));
    if (m.k_ps > 0 && std::isfinite(m.gloss))
      refuse(fmt::format("material {} is a dull mirror; expected none with beams", m.name));
  }
}

std::vector<FlatElement> flat_elements(const scene::Scene& scene) {
  std::vector<FlatElement> all;
  scene.for_each([&]<class Shape>(scene::ElementRef e, const Shape& shape) {
    if constexpr (std::is_same_v<Shape, scene::Plane>) {
      all.push_back({e, polygon::exact(shape.centro), polygon::exact(shape.vector)});
    } else if constexpr (std::is_same_v<Shape, scene::Triangle>) {
      const RationalPoint a = polygon::exact(shape.vertices[0]), b = polygon::exact(shape.vertices[1]),
                          c = polygon::exact(shape.vertices[2]);
      all.push_back({e, a, polygon::cross(b - a, c - a), {a, b, c}});
      const auto material = scene.material(e);
      if (material && scene.stage().materials[*material].k_ps > 0 && scene.vertex_normals(e))
        refuse(fmt::format("element {} is a smooth mirror; expected flat ones with beams", scene.name(e).name()));
    } else {
      refuse(fmt::format("element {} is neither a triangle nor a plane; expected these alone with beams",
                         scene.name(e).name()));
    }
  });
  return all;
}

/// The element as the beam of a view sees it; nothing where the origin lies in its plane.
std::optional<SeenElement> seen(const FlatElement& flat, const PixelView& view) {
  const Rational height = polygon::dot(flat.normal, flat.point - view.origin);
  if (height == 0) return std::nullopt;
  SeenElement of{flat.element, scaled(1 / height, view.along(flat.normal)), {}};
  // The three planes through the origin and an edge bound the pyramid over a triangle, on the side of its third corner.
  for (std::size_t i = 0; i < flat.corners.size(); ++i) {
    const RationalPoint side = polygon::cross(flat.corners[i] - view.origin, flat.corners[(i + 1) % 3] - view.origin);
    const int inwards = polygon::dot(side, flat.corners[(i + 2) % 3] - view.origin).sign();
    of.body.push_back(scaled(inwards, view.along(side)));
  }
  if (flat.corners.empty()) of.body.push_back(of.nearness);
  return of;
}

/// A beam on its way: its origin and directions, its outline, and the mirror that sent it.
struct TracedBeam {
  PixelView view;
  Polygon outline;
  std::optional<PlaneSide> mirror{};  ///< 1/t of the mirror, from the mirrored origin; what it shows lies beyond
  scene::ElementSet en{};             ///< the elements of the mirror
  std::uint32_t parent = without_parent, depth = 1;
  scene::ElementSet edge_on{};
};

class TreeBuilder {
 public:
  TreeBuilder(const scene::Scene& scene, std::uint32_t max_depth)
      : scene_(scene), max_depth_(max_depth), elements_(flat_elements(scene)) {
    require_followed(scene);
  }

  BeamTree build(TracedBeam eye) {
    std::vector<TracedBeam> now{std::move(eye)};
    while (!now.empty()) {
      std::vector<TracedBeam> next;
      for (TracedBeam& beam : now)
        for (BeamCell& cell : cells(beam)) add(beam, std::move(cell), next);
      now = std::move(next);
    }
    return std::move(tree_);
  }

 private:
  /// The parts of a beam, by what its rays meet first. It receives the elements that it sees edge-on.
  std::vector<BeamCell> cells(TracedBeam& beam) const {
    std::vector<BeamCell> all;
    all.emplace_back(beam.outline);
    for (const FlatElement& flat : elements_) {
      if (std::ranges::find(beam.en, flat.element) != beam.en.end()) continue;
      std::optional<SeenElement> element = seen(flat, beam.view);
      if (!element) {
        beam.edge_on.push_back(flat.element);
        continue;
      }
      if (beam.mirror) element->body.push_back(difference(*beam.mirror, element->nearness));
      for (const PlaneSide& side : element->body) element->about.emplace_back(side);
      std::vector<BeamCell> divided;
      for (BeamCell& cell : all) divide(std::move(cell), *element, divided);
      all = std::move(divided);
    }
    return all;
  }

  /// Adds a cell, or its parts where the element is nearer than what was met so far.
  static void divide(BeamCell cell, const SeenElement& element, std::vector<BeamCell>& parts) {
    const auto beyond = [&](const SideBounds& side) {
      return std::ranges::all_of(cell.about, [&](const glm::dvec2& w) { return side.surely_negative(w.x, w.y); });
    };
    if (std::ranges::any_of(element.about, beyond)) return parts.push_back(std::move(cell));
    std::vector<PlaneSide> body = element.body;
    scene::ElementSet met{element.element};
    if (!cell.elementos.empty()) {
      const PlaneSide nearer = difference(element.nearness, cell.nearness);
      if (is_zero(nearer))
        met.insert(met.begin(), cell.elementos.begin(), cell.elementos.end());  // elements come ascending
      else
        body.push_back(nearer);
    }
    Polygon inside = polygon::clipped(cell.outline, body);
    if (inside.empty()) return parts.push_back(std::move(cell));
    for (Polygon& outside : polygon::without(cell.outline, body))
      parts.emplace_back(std::move(outside), cell.elementos, cell.nearness);
    parts.emplace_back(std::move(inside), std::move(met), element.nearness);
  }

  /// Adds the region of a cell, and the beam that a mirror makes of it.
  void add(const TracedBeam& beam, BeamCell cell, std::vector<TracedBeam>& next) {
    const auto index = static_cast<std::uint32_t>(tree_.size());
    if (beam.depth < max_depth_ && is_mirror(cell.elementos)) {
      const FlatElement& flat = *std::ranges::find(elements_, cell.elementos.front(), &FlatElement::element);
      next.push_back({beam.view.mirrored(flat.point, flat.normal), cell.outline, cell.nearness, cell.elementos, index,
                      beam.depth + 1});
    }
    tree_.push_back({std::move(cell.outline), std::move(cell.elementos), std::move(cell.nearness), beam.parent,
                     beam.depth, beam.edge_on});
  }

  bool is_mirror(const scene::ElementSet& met) const {
    if (met.empty()) return false;
    const auto material = scene_.material(front(scene_, met));
    return material && scene_.stage().materials[*material].k_ps > 0;
  }

  const scene::Scene& scene_;
  std::uint32_t max_depth_;
  std::vector<FlatElement> elements_;
  BeamTree tree_;
};

}  // namespace

Polygon outline_of(scene::Pixel first, scene::Resolution size) {
  const Rational half = Rational(1) / 2, left = first.x - half, top = first.y - half;
  const Rational right = left + size.width, bottom = top + size.height;
  return {{left, top, 0}, {right, top, 0}, {right, bottom, 0}, {left, bottom, 0}};
}

BeamTree beam_tree(const scene::Scene& scene, const scene::PrimaryRays& rays, const Polygon& outline,
                   std::uint32_t max_depth) {
  return TreeBuilder(scene, max_depth).build({PixelView(rays), outline});
}

Rational area(const Polygon& outline) { return abs(polygon::doubled_area(outline).z) / 2; }

std::string svg(const BeamTree& tree, const scene::Scene& scene, scene::Resolution size) {
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-0.5 -0.5 {0} {1}\" width=\"{0}\" height=\"{1}\">\n",
      size.width, size.height);
  for (const BeamRegion& region : tree) {
    const auto material = region.elementos.empty() ? std::nullopt : scene.material(front(scene, region.elementos));
    const glm::dvec3 color = region.elementos.empty() ? scene.stage().background.value_or(default_background)
                             : material               ? scene.stage().materials[*material].color
                                                      : default_color;
    std::string points;
    for (const RationalPoint& corner : region.outline)
      points += fmt::format("{}{:.3f},{:.3f}", points.empty() ? "" : " ", number::round_to_binary64(corner.x),
                            number::round_to_binary64(corner.y));
    text += fmt::format("<polygon points=\"{}\" fill=\"{}\" stroke=\"{}\" stroke-width=\"{}\"/>\n", points,
                        scene::srgb_text(color), region.depth == 1 ? "black" : "white", 1.0 / region.depth);
  }
  return text + "</svg>\n";
}

}  // namespace durero::render
