#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "conform/report/picture.hpp"

namespace durero::conform {
namespace {

constexpr double width = 420, height = 240, left = 46, right = 12, top = 12, bottom = 40;

struct PlotAxis {
  double least, greatest, from, to;  // a number, and where it stands
  double place(double x) const { return from + (x - least) / std::max(greatest - least, 1.0) * (to - from); }
};

/// The height of a case in the plot: log₂ of its backward error, at least that of 2⁻¹⁰ ε. A case whose worst verdict is
/// gross though the error is at most 16ε, such as a missed hit, stands above all.
double level(const Spread& spread, double above) {
  if (is_gross(spread.worst) && spread.backward <= 16) return above;
  return std::log2(std::max(spread.backward, 0x1p-10));
}

std::string label(double x, double y, const char* anchor, const std::string& text) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x, y, anchor, text);
}

std::string ticks(const PlotAxis& across, const PlotAxis& up) {
  std::string svg;
  const double step = std::max(1.0, std::round((up.greatest - up.least) / 6));
  for (double y = up.least; y <= up.greatest; y += step) {
    svg += fmt::format("<line class=\"grid\" x1=\"{0:.1f}\" x2=\"{1:.1f}\" y1=\"{2:.1f}\" y2=\"{2:.1f}\"/>\n",
                       across.from, across.to, up.place(y));
    svg += label(left - 5, up.place(y) + 4, "end", fmt::format("2^{}", y));
  }
  for (const double x : {across.least, (across.least + across.greatest) / 2, across.greatest})
    svg += label(across.place(x), height - bottom + 15, "middle", fmt::format("{:g}", x));
  return svg;
}

}  // namespace

std::string spread_svg(const FamilyTally& family) {
  const Range& range = family.family->parameter;
  const PlotAxis across{double(range.least), double(range.greatest), left, width - right};
  double highest = 6;
  for (const Spread& spread : family.spreads) highest = std::max(highest, level(spread, 0) + 1);
  const PlotAxis up{-10, std::ceil(highest) + 1, height - bottom, top};
  std::string svg = fmt::format("<svg viewBox=\"0 0 {} {}\" role=\"img\">\n", width, height) + ticks(across, up);
  for (const bool failing : {false, true}) {  // failing cases are drawn over the others
    for (const Spread& spread : family.spreads) {
      if (is_failure(spread.worst) != failing) continue;
      svg += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\" fill=\"{}\"/>\n", across.place(spread.parameter),
                         up.place(level(spread, up.greatest)), colour(spread.worst));
    }
  }
  svg += label((across.from + across.to) / 2, height - 8, "middle", std::string(range.name));
  return svg + "</svg>\n";
}

}  // namespace durero::conform
