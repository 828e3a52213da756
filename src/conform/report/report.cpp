#include "durero/conform/report/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <glm/geometric.hpp>
#include <tuple>

#include "conform/report/report_parts.hpp"
#include "durero/io/number_text.hpp"
#include "durero/io/output_file.hpp"
#include "durero/io/source.hpp"
#include "durero/surface/normal.hpp"

namespace durero::conform {
namespace {

std::string point_text(const glm::dvec3& p) {
  return fmt::format("({}, {}, {})", io::number_text(p.x), io::number_text(p.y), io::number_text(p.z));
}

std::string hit_words(const scene::Hit& hit, const scene::Scene& scene) {
  switch (hit.resultado) {
    case model::Resultado::miss:
      return "a miss";
    case model::Resultado::no_minimum:
      return fmt::format("in the surface of {} from the start: no nearest point", element_names(hit.elementos, scene));
    case model::Resultado::hit:
      return fmt::format("{} at t = {}, point {}", element_names(hit.elementos, scene), io::number_text(hit.t),
                         point_text(hit.punto));
  }
  contract::unreachable();
}

}  // namespace

std::string element_names(const scene::ElementSet& elements, const scene::Scene& scene) {
  std::string names;
  for (const scene::ElementRef e : elements) names.append(names.empty() ? "" : ", ").append(scene.name(e).name());
  return names;
}

std::vector<const FamilyTally*> failures_first(const Tally& tally) {
  std::vector<const FamilyTally*> all;
  for (const FamilyTally& family : tally.families()) all.push_back(&family);
  std::ranges::stable_sort(all, std::greater<>(), [](const FamilyTally* family) {
    return std::pair{family->gross(), family->failures()};
  });
  return all;
}

std::string replay_options(const SuiteOptions& options, const Finding& finding) {
  std::string text = fmt::format("--case {} --ray {}", finding.of.name(), finding.ray);
  const SuiteOptions usual;
  if (options.seed != usual.seed) text += fmt::format(" --seed {}", options.seed);
  if (options.faces != usual.faces && is_of_meshes(*finding.of.family))
    text += fmt::format(" --faces {}", options.faces);
  const bool are_all = options.tipos.empty() || options.tipos.size() == scene::shape_count;
  if (!are_all || !options.bodies.empty()) text += " --types " + type_words(options.tipos, options.bodies);
  if (options.caps == Caps::solid) text += " --solids";
  if (options.numbers == NumberFormat::binary64) text += " --numbers binary64";
  if (options.question != usual.question) text += fmt::format(" --question {}", word(options.question));
  return text;
}

std::string claim_words(const Claim& claim, const scene::Scene& scene) {
  if (claim.outcome == Claim::Outcome::miss) return "a miss";
  if (claim.outcome != Claim::Outcome::hit) return claim.why.empty() ? std::string(name(claim.outcome)) : claim.why;
  std::string words = claim.element ? scene.name(*claim.element).name() : "a hit";
  if (claim.t) words += " at t = " + io::number_text(*claim.t);
  if (claim.punto) words += (claim.t ? ", point " : " at ") + point_text(*claim.punto);
  if (claim.normal) words += ", normal " + point_text(*claim.normal);
  if (claim.is_front) words += *claim.is_front ? ", front" : ", back";
  if (claim.uv) words += fmt::format(", uv ({}, {})", io::number_text(claim.uv->x), io::number_text(claim.uv->y));
  return words;
}

namespace {

/// The outward normal of the exact hit and the side that the ray comes from, by binary64, where the claim says such.
std::string besides_words(const Finding& finding) {
  const scene::Hit& hit = finding.of.truths[0].hit;
  const Claim& claim = finding.claim;
  if (hit.resultado != model::Resultado::hit || !has_besides(claim)) return "";
  const bool is_claimed = claim.element && std::ranges::find(hit.elementos, *claim.element) != hit.elementos.end();
  const scene::ElementRef element = is_claimed ? *claim.element : hit.elementos.front();
  const glm::dvec3 normal = surface::normal(finding.of.the_case.scene, element, hit.punto);
  const bool is_front = glm::dot(finding.of.the_case.rays[0].rayo.v().xyz(), normal) < 0;
  return fmt::format(", outward normal {}, {}", point_text(normal), is_front ? "front" : "back");
}

}  // namespace

std::string claim_words(const Finding& finding) { return claim_words(finding.claim, finding.of.the_case.scene); }

std::string truth_words(const ExactAnswer& truth, const scene::Scene& scene) { return hit_words(truth.hit, scene); }

std::string truth_words(const Finding& finding) {
  const std::string first = truth_words(finding.of.truths[0], finding.of.the_case.scene) + besides_words(finding);
  if (!has_range(finding.of.question)) return first;
  const scene::Hit& hit = finding.of.truths[0].hit;
  const auto& [begin, end] = finding.of.ranges[0];
  if (finding.of.question == QuestionKind::range)
    return fmt::format("{} within t = {} … {}", first, io::number_text(begin), io::number_text(end));
  if (hit.resultado == model::Resultado::miss) return "no hit";
  const bool is_before = hit.resultado == model::Resultado::no_minimum || hit.t <= end;
  return fmt::format("{} up to t = {}, the first being {}", is_before ? "a hit" : "no hit", io::number_text(end),
                     first);
}

void require_room_for_reports(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw io::FileError(folder, "cannot be made: " + error.message(), "expected a folder to write into");
  const io::OutputFile first(folder + "/report.json");  // is not written, and so not there
}

void write_reports(const std::string& folder, const Report& report) {
  require_room_for_reports(folder);
  io::write_file(folder + "/report.json", report_json(report));
  io::write_file(folder + "/report.xml", report_junit(report));
  io::write_file(folder + "/report.sarif", report_sarif(report));
  io::write_file(folder + "/report.html", report_html(report));
}

}  // namespace durero::conform
