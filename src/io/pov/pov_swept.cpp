#include "pov_swept.hpp"

#include <algorithm>
#include <utility>

#include "durero/io/pov/algebraic.hpp"
#include "pov_curve.hpp"

namespace durero::io {
namespace {

/// A prism as it stands in a text.
struct SweptOutline {
  PovCurveKind kind = PovCurveKind::linear;
  bool is_conic = false, is_open = false;
  double from = 0, to = 0;
  std::vector<glm::dvec2> points{};
};

SweptOutline swept_outline(PovWords& in) {
  SweptOutline outline;
  while (true) {
    const std::size_t here = in.offset();
    if (in.take("conic_sweep"))
      outline.is_conic = true;
    else if (in.take("linear_sweep"))
      outline.is_conic = false;
    else
      outline.kind = in.word().ends_with("_spline") ? take_curve_kind(in) : outline.kind;
    in.comma();
    if (in.offset() == here) break;
  }
  outline.from = in.number("prism");
  in.comma();
  outline.to = in.number("prism");
  in.comma();
  const double count = in.number("prism");
  for (double i = 0; i < count; ++i) {
    in.comma();
    const glm::dvec3 point = in.triple("prism");
    outline.points.emplace_back(point.x, point.y);
  }
  in.comma();
  outline.is_open = in.take("open");
  return outline;
}

/// The stretches of all outlines. The first point of one is a control point, which a Bézier curve has not; the outline
/// ends where the second comes again, and a cubic one has another control point behind.
std::optional<std::vector<PovStretch>> stretches_of(const SweptOutline& outline) {
  const std::vector<glm::dvec2>& points = outline.points;
  if (outline.kind == PovCurveKind::bezier)
    return points.size() % 4 == 0 ? std::optional(stretches_of(outline.kind, points)) : std::nullopt;
  const std::size_t behind = outline.kind == PovCurveKind::cubic ? 1 : 0;
  std::vector<PovStretch> all;
  for (std::size_t begin = 0; begin < points.size();) {
    std::size_t last = begin + 2;
    while (last < points.size() && points[last] != points[begin + 1]) ++last;
    if (last + behind >= points.size()) return std::nullopt;
    const auto first = points.begin() + static_cast<std::ptrdiff_t>(begin);
    const std::size_t end = last + behind + 1;
    const auto more = stretches_of(outline.kind, {first, points.begin() + static_cast<std::ptrdiff_t>(end)});
    all.insert(all.end(), more.begin(), more.end());
    begin = end;
  }
  return all;
}

glm::dvec3 swept_place(const glm::dvec2& point, double height, bool is_conic) {
  const double times = is_conic ? height : 1;
  return {times * point.x, height, times * point.y};
}

/// Adds both triangles of a straight side.
void add_side(std::size_t at, const std::array<glm::dvec2, 2>& line, const SweptOutline& outline,
              std::vector<PovObject>& parts) {
  const glm::dvec3 a = swept_place(line[0], outline.from, outline.is_conic),
                   b = swept_place(line[1], outline.from, outline.is_conic),
                   c = swept_place(line[1], outline.to, outline.is_conic),
                   d = swept_place(line[0], outline.to, outline.is_conic);
  for (const auto& [p, q, r] : {std::array{a, b, c}, std::array{a, c, d}}) {
    if (p == q || q == r || r == p) continue;
    PovObject part{.at = at, .word = "triangle"};
    part.shape = PovShape{scene::Triangle{{p, q, r}}};
    parts.push_back(std::move(part));
  }
}

}  // namespace

std::optional<std::vector<PovObject>> read_pov_curved_prism(PovWords& in, std::size_t at) {
  const SweptOutline outline = swept_outline(in);
  if (outline.kind == PovCurveKind::linear || !outline.is_open) return std::nullopt;
  const auto stretches = stretches_of(outline);
  if (!stretches) return std::nullopt;
  std::vector<PovObject> parts;
  for (const PovStretch& stretch : *stretches) {
    const auto line = stretch.is_straight() ? stretch.line() : std::nullopt;
    if (stretch.is_straight() && !line) return std::nullopt;
    if (line) {
      add_side(at, *line, outline, parts);
      continue;
    }
    PovObject part{.at = at, .word = "prism"};
    part.element = PovElement{swept_curve, stretch.attributes(), stretch.is_rounded};
    part.element->own["desde"] = outline.from, part.element->own["hasta"] = outline.to;
    part.element->own["conico"] = outline.is_conic ? 1.0 : 0.0;
    parts.push_back(std::move(part));
  }
  return parts;
}

}  // namespace durero::io
