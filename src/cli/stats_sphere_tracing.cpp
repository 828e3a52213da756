#include "stats_sphere_tracing.hpp"

#include <fmt/format.h>

namespace durero::cli {

using engine::SphereTracingFigures;

std::vector<SphereTracingFigures> sphere_tracing_figures(const scene::Scene& scene,
                                                         std::span<const scene::Query> rays) {
  const SphereTracingFigures usual = engine::sphere_tracing_figures(scene, rays, 0);
  std::vector<SphereTracingFigures> all;
  for (const double more : {0x1p12, 0x1p8, 0x1p4})
    all.push_back(engine::sphere_tracing_figures(scene, rays, usual.epsilon * more));
  all.push_back(usual);
  return all;
}

std::string sphere_tracing_text(const std::vector<SphereTracingFigures>& all) {
  if (all.empty()) return "";
  constexpr auto head = "{:<16}{:>10}{:>10}{:>10}{:>10}{:>10}{:>10}\n";
  std::string text =
      "\n" + fmt::format(head, "sdf, epsilon", "steps/ray", "right", "grazed", "other", "tired", "passed");
  for (const SphereTracingFigures& of : all) {
    const std::string steps =
        of.rays == 0 ? "-" : fmt::format("{:.2f}", static_cast<double>(of.steps) / static_cast<double>(of.rays));
    text +=
        fmt::format(head, fmt::format("{:.6g}", of.epsilon), steps, of.right, of.grazed, of.other, of.tired, of.passed);
  }
  return text;
}

void write_sphere_tracing(io::json::Writer& out, const std::vector<SphereTracingFigures>& all) {
  if (all.empty()) return;
  out.new_line().key("sphere_tracing").begin_array();
  for (const SphereTracingFigures& of : all) {
    out.new_line().begin_object().member("epsilon", of.epsilon).member("rays", of.rays).member("steps", of.steps);
    out.member("right", of.right).member("grazed", of.grazed).member("other", of.other);
    out.member("tired", of.tired).member("passed", of.passed).end_object();
  }
  out.end_array();
}

}  // namespace durero::cli
