#include "durero/conform/report/report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <glm/geometric.hpp>
#include <span>
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

namespace {

/// The number of hits of a list up to which it is shown whole.
constexpr std::size_t most_hits_shown = 8;

/// "e0 at t = 4; e0 at t = 6", from the words of the first hits of a list of so many.
std::string list_words(std::span<const std::string> first, std::size_t count) {
  std::string words = fmt::format("{}", fmt::join(first, "; "));
  if (count > first.size()) words += fmt::format("; and {} more", count - first.size());
  return words;
}

std::string count_words(std::uint64_t count) { return count == 1 ? "1 hit" : fmt::format("{} hits", count); }

std::string claimed_hit_words(const Claim& claim, const scene::Scene& scene) {
  std::string words = claim.element ? scene.name(*claim.element).name() : "a hit";
  if (claim.t) words += " at t = " + io::number_text(*claim.t);
  if (claim.punto) words += (claim.t ? ", point " : " at ") + point_text(*claim.punto);
  if (claim.normal) words += ", normal " + point_text(*claim.normal);
  if (claim.is_front) words += *claim.is_front ? ", front" : ", back";
  if (claim.uv) words += fmt::format(", uv ({}, {})", io::number_text(claim.uv->x), io::number_text(claim.uv->y));
  return words;
}

}  // namespace

std::string claim_words(const Claim& claim, const scene::Scene& scene) {
  if (claim.count) return count_words(*claim.count);
  if (claim.outcome == Claim::Outcome::miss) return "a miss";
  if (claim.outcome != Claim::Outcome::hit) return claim.why.empty() ? std::string(name(claim.outcome)) : claim.why;
  std::vector<std::string> words{claimed_hit_words(claim, scene)};
  for (const Claim& behind : claim.behind) {
    if (words.size() < most_hits_shown) words.push_back(claimed_hit_words(behind, scene));
  }
  return list_words(words, 1 + claim.behind.size());
}

namespace {

std::string all_words(const std::vector<scene::Hit>& all, const scene::Scene& scene) {
  if (all.empty()) return "a miss";
  std::vector<std::string> words;
  for (const scene::Hit& hit : std::span(all).first(std::min(all.size(), most_hits_shown)))
    words.push_back(hit_words(hit, scene));
  return list_words(words, all.size());
}

/// The outward normal of the exact hit and the side that the ray comes from, by binary64, where the claim says such.
std::string besides_words(const SuiteCase& of, std::size_t ray, const Claim& claim) {
  const scene::Hit& hit = of.truths[ray].hit;
  if (hit.resultado != model::Resultado::hit || !has_besides(claim)) return "";
  const bool is_claimed = claim.element && std::ranges::find(hit.elementos, *claim.element) != hit.elementos.end();
  const scene::ElementRef element = is_claimed ? *claim.element : hit.elementos.front();
  const glm::dvec3 normal = surface::normal(of.the_case.scene, element, hit.punto);
  const bool is_front = glm::dot(of.the_case.rays[ray].rayo.v().xyz(), normal) < 0;
  return fmt::format(", outward normal {}, {}", point_text(normal), is_front ? "front" : "back");
}

std::string shadow_words(const scene::Hit& hit, double end, const std::string& first) {
  if (hit.resultado == model::Resultado::miss) return "no hit";
  const bool is_before = hit.resultado == model::Resultado::no_minimum || hit.t <= end;
  return fmt::format("{} up to t = {}, the first being {}", is_before ? "a hit" : "no hit", io::number_text(end),
                     first);
}

std::string cast_words(const scene::Hit& hit, double radius, const scene::Scene& scene) {
  const std::string ball = fmt::format("a ball of radius {}", io::number_text(radius));
  if (hit.resultado == model::Resultado::miss) return ball + " touches nothing";
  return fmt::format("{} touches {} at t = {}, its middle at {}", ball, element_names(hit.elementos, scene),
                     io::number_text(hit.t), point_text(hit.punto));
}

}  // namespace

std::string claim_words(const Finding& finding) { return claim_words(finding.claim, finding.of.the_case.scene); }

std::string truth_words(const SuiteCase& of, std::size_t ray, const Claim& claim) {
  const auto& [hit, ambiguity, permissible, all] = of.truths[ray];
  const scene::Scene& scene = of.the_case.scene;
  const std::string first = hit_words(hit, scene) + besides_words(of, ray, claim);
  switch (of.question) {
    case QuestionKind::first:
      return first;
    case QuestionKind::shadow:
      return shadow_words(hit, of.ranges[ray].end, first);
    case QuestionKind::range:
      return fmt::format("{} within t = {} … {}", first, io::number_text(of.ranges[ray].begin),
                         io::number_text(of.ranges[ray].end));
    case QuestionKind::all:
      return all_words(all, scene);
    case QuestionKind::closest:
      return fmt::format("{} at a distance of {}, point {}", element_names(hit.elementos, scene),
                         io::number_text(hit.t), point_text(hit.punto));
    case QuestionKind::cast:
      return cast_words(hit, of.ranges[ray].radio, scene);
    case QuestionKind::count:
      return fmt::format("{}{}{}", count_words(all.size()), all.empty() ? "" : ": ",
                         all.empty() ? "" : all_words(all, scene));
  }
  contract::unreachable();
}

std::string truth_words(const Finding& finding) { return truth_words(finding.of, 0, finding.claim); }

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
