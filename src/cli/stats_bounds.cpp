#include "stats_bounds.hpp"

#include <fmt/format.h>

namespace durero::cli {
namespace {

using engine::Bound;
using engine::BoundedElement;
using engine::BoundsFigures;
using engine::Fit;
using engine::WayOfBounding;

std::string of_ray(std::uint64_t count, std::uint64_t rays) {
  return rays == 0 ? "-" : fmt::format("{:.2f}", static_cast<double>(count) / static_cast<double>(rays));
}

std::string shown(const Fit& fit) {
  return fmt::format("{:>12.5g}{:>12}", fit.mean_fit, fit.void_area ? fmt::format("{:.5g}", *fit.void_area) : "-");
}

std::string ways_text(const BoundsFigures& figures, bool no_times) {
  constexpr auto head = "{:<24}{:>10}{:>10}{:>12}{:>12}{:>8}{:>10}";
  std::string text = fmt::format("\nI = {:.1f} ns\n", figures.I);
  text += fmt::format(head, "volumes", "n/ray", "m/ray", "mean fit", "void area", "B ns", "T ns");
  text += no_times ? "\n" : fmt::format("{:>13}\n", "measured ns");
  for (const WayOfBounding& way : figures.ways) {
    text += fmt::format("{:<24}{:>10}{:>10}{}{:>8.1f}{:>10.1f}", way.name, of_ray(way.n, figures.rays),
                        of_ray(way.m, figures.rays), shown(way.fit), way.B, way.T);
    text += no_times ? "\n" : fmt::format("{:>13.1f}\n", way.measured);
  }
  return text;
}

void write_fit(io::json::Writer& out, const Fit& fit) {
  out.member("mean_fit", fit.mean_fit);
  if (fit.void_area) out.member("void_area", *fit.void_area);
}

void write_bound(io::json::Writer& out, const char* key, const Bound& bound) {
  out.begin_object().member(key, bound.name).member("m", bound.m);
  write_fit(out, bound.fit);
  out.member("T", bound.T).end_object();
}

void write_way(io::json::Writer& out, const WayOfBounding& way, bool no_times) {
  out.new_line().begin_object().member("volumes", way.name).member("n", way.n).member("m", way.m);
  write_fit(out, way.fit);
  out.member("B", way.B).member("T", way.T);
  if (!no_times) out.member("measured", way.measured);
  out.end_object();
}

}  // namespace

std::string bounds_text(const BoundsFigures& figures, const scene::Scene& scene, bool no_times) {
  std::string text = ways_text(figures, no_times);
  constexpr auto head = "{:<24}{:<24}{:>10}{:>12}{:>12}{:>12}\n";
  text += "\n" + fmt::format(head, "element", "chosen", "m/ray", "mean fit", "void area", "T foretold");
  for (const BoundedElement& element : figures.elements) {
    const Bound& chosen = element.chosen;
    text += fmt::format("{:<24}{:<24}{:>10}{}{:>12.2f}\n", scene.name(element.element).name(), chosen.name,
                        of_ray(chosen.m, figures.rays), shown(chosen.fit), chosen.T);
  }
  return text;
}

void write_bounds(io::json::Writer& out, const BoundsFigures& figures, const scene::Scene& scene, bool no_times) {
  out.new_line().key("bounds").begin_object().member("I", figures.I);
  out.new_line().key("ways").begin_array();
  for (const WayOfBounding& way : figures.ways) write_way(out, way, no_times);
  out.end_array();
  out.new_line().key("elements").begin_array();
  for (const BoundedElement& element : figures.elements) {
    out.new_line().begin_object().member("id", scene.name(element.element).name()).key("chosen");
    write_bound(out, "volume", element.chosen);
    out.key("kinds").begin_array();
    for (const Bound& kind : element.kinds) write_bound(out, "kind", kind);
    out.end_array().end_object();
  }
  out.end_array().end_object();
}

}  // namespace durero::cli
