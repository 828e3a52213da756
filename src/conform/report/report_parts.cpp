#include "conform/report/report_parts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <sstream>

#include "conform/ask/words.hpp"
#include "durero/conform/ask/question.hpp"
#include "durero/conform/report/least_findings.hpp"
#include "durero/io/number_text.hpp"

namespace durero::conform {
namespace {

void add_limit(std::vector<ProfileLine>& lines, const char* claim, double limit, double none) {
  if (limit != none) lines.push_back({claim, io::number_text(limit)});
}

/// The number of elements up to which a question is shown whole.
constexpr std::size_t most_elements_shown = 32;

/// The word of a line at that place, from 0; empty where the line ends before.
std::string word_of(const std::string& line, int place) {
  std::istringstream words(line);
  std::string word;
  for (int i = 0; i <= place; ++i) {
    if (!(words >> word)) return "";
  }
  return word;
}

/// Whether a line of a question is an element's: it begins with the word of a type.
bool is_element_line(const std::string& line) {
  bool is = false;
  scene::for_each_shape([&]<class Shape>(std::type_identity<Shape>) { is = is || word_of(line, 0) == Shape::word; });
  return is;
}

/// The names of the elements that the ray meets first, or is claimed to meet.
std::set<std::string> names_of_met(const SuiteCase& of, const std::optional<scene::ElementRef>& claimed) {
  const scene::Scene& scene = of.the_case.scene;
  std::set<std::string> names;
  for (const scene::ElementRef e : of.truths[0].hit.elementos) names.emplace(scene.name(e).name());
  if (claimed) names.emplace(scene.name(*claimed).name());
  return names;
}

/// The options of a suite that a call of a system's must repeat.
std::string unusual_suite(const Report& report, const Finding& finding) {
  const SuiteOptions usual;
  std::string options;
  if (report.options.seed != usual.seed) options += fmt::format(" --seed {}", report.options.seed);
  if (report.options.faces != usual.faces && is_of_meshes(*finding.of.family))
    options += fmt::format(" --faces {}", report.options.faces);
  if (report.options.question != usual.question)
    options += fmt::format(" --question {}", word(report.options.question));
  return options;
}

}  // namespace

std::vector<Verdict> columns_of(const Tally& tally) {
  std::vector<Verdict> columns;
  for (const Verdict verdict : verdicts) {
    const bool always = verdict == Verdict::exact || verdict == Verdict::right || verdict == Verdict::off;
    if (always || tally.of(verdict) > 0) columns.push_back(verdict);
  }
  return columns;
}

std::string type_words(std::span<const model::Tipo> tipos, std::span<const BodyKind> bodies) {
  std::string words;
  const auto add = [&](std::string_view word) { words.append(words.empty() ? "" : ",").append(word); };
  for (const model::Tipo tipo : tipos)
    add(scene::with_shape(tipo, []<class Shape>(std::type_identity<Shape>) { return Shape::word; }));
  for (const BodyKind kind : bodies) add(word(kind));
  return words;
}

std::vector<ProfileLine> profile_lines(const Profile& profile) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<ProfileLine> lines = {{"format", std::string(word(profile.format))},
                                    {"tipos", type_words(profile.tipos, profile.bodies)},
                                    {"caps", std::string(word(profile.caps))},
                                    {"measure", std::string(word(profile.measure))},
                                    {"directions", std::string(word(profile.directions))},
                                    {"inside", std::string(word(profile.inside))},
                                    {"names_elements", profile.names_elements ? "true" : "false"}};
  if (!profile.surfaces.empty()) lines.push_back({"surfaces", fmt::format("{}", fmt::join(profile.surfaces, ","))});
  if (profile.questions != Profile().questions) {
    std::string words;
    for (const QuestionKind question : profile.questions) words.append(words.empty() ? "" : ",").append(word(question));
    lines.push_back({"questions", words});
  }
  if (profile.normal != NormalSide::none) {
    lines.push_back({"normal", std::string(word(profile.normal))});
    lines.push_back({"normal_length", std::string(word(profile.normal_length))});
  }
  if (profile.faces) lines.push_back({"faces", "true"});
  if (profile.uv) lines.push_back({"uv", "true"});
  if (profile.watertight) lines.push_back({"watertight", "true"});
  if (profile.half_spaces) lines.push_back({"half_spaces", "true"});
  if (profile.back_faces != BackFaces::seen) lines.push_back({"back_faces", std::string(word(profile.back_faces))});
  if (profile.touching != Touching::undefined) lines.push_back({"touching", std::string(word(profile.touching))});
  add_limit(lines, "error", profile.error, usual_error);
  add_limit(lines, "thickness", profile.thickness, 0);
  add_limit(lines, "least_t", profile.least_t, 0);
  add_limit(lines, "greatest_t", profile.greatest_t, infinity);
  add_limit(lines, "least_size", profile.least_size, 0);
  add_limit(lines, "greatest_size", profile.greatest_size, infinity);
  add_limit(lines, "greatest_coordinate", profile.greatest_coordinate, infinity);
  return lines;
}

std::string verdict_words(Verdict verdict) {
  std::string words(name(verdict));
  std::ranges::replace(words, '_', ' ');
  return words;
}

std::string whole_question_of(const Finding& finding, const Profile& profile) {
  constexpr std::array<std::size_t, 1> only{0};
  return question_text(finding.of, profile.caps, only);
}

std::string question_of(const Finding& finding, const Profile& profile) {
  return shown_question(finding.of, finding.claim.element, profile.caps);
}

std::string shown_question(const SuiteCase& of, const std::optional<scene::ElementRef>& claimed, Caps caps) {
  constexpr std::array<std::size_t, 1> only{0};
  const std::string whole = question_text(of, caps, only);
  const std::size_t elements = of.the_case.scene.size();
  if (elements <= most_elements_shown) return whole;
  const std::set<std::string> names = names_of_met(of, claimed);
  std::string text;
  std::size_t shown = 0;
  std::istringstream lines(whole);
  for (std::string line; std::getline(lines, line);) {
    if (std::ranges::find(heads_of_rays, word_of(line, 0)) != heads_of_rays.end())
      text += fmt::format("({} more elements)\n", elements - shown);
    if (!is_element_line(line)) {
      text += line + "\n";
    } else if (names.contains(word_of(line, 1))) {
      text += line + "\n";
      ++shown;
    }
  }
  return text;
}

std::string sentence(Verdict verdict, const std::string& expected, const std::string& got) {
  return fmt::format("{}: expected {}; got {}", name(verdict), expected, got);
}

std::string sentence(const Finding& finding) {
  return sentence(finding.judgement.verdict, truth_words(finding), claim_words(finding));
}

std::string replay(const Report& report, const Finding& finding) {
  return "durero conform show " + replay_options(report.options, finding);
}

std::string minimising(const Report& report, const Finding& finding) {
  if (report.asked.empty()) return "";
  return fmt::format("durero conform minimise {} --case {} --ray {}{}", report.asked, finding.of.name(), finding.ray,
                     unusual_suite(report, finding));
}

std::string writing_up(const Report& report, const Finding& finding) {
  if (report.asked.empty()) return "";
  return fmt::format("durero conform bug {} {} --ray {}{}", report.asked, finding.of.name(), finding.ray,
                     unusual_suite(report, finding));
}

std::string least_of(const Report& report, const Finding& finding) {
  const auto least = report.least.find(FindingKey(finding));
  return least == report.least.end() ? "" : least_text(least->second, report.profile);
}

std::string left_out_words(const Report& report) {
  if (report.not_minimised == 0) return "";
  return fmt::format("{} worst findings were not made small: their number or the time was over", report.not_minimised);
}

std::string unasked_words(const Report& report) {
  std::vector<std::string_view> unasked;
  for (const Family* family : chosen_families(report.options)) {
    if (std::ranges::find(report.tally.families(), family, &FamilyTally::family) == report.tally.families().end())
      unasked.push_back(family->name);
  }
  if (unasked.empty()) return "";
  return fmt::format("{} no scene of these types of elements: {}",
                     unasked.size() == 1 ? "1 family has" : fmt::format("{} families have", unasked.size()),
                     fmt::join(unasked, ", "));
}

std::vector<const Finding*> findings_of(const FamilyTally& family) {
  std::vector<const Finding*> findings;
  for (const bool gross : {true, false}) {
    for (const std::optional<Finding>& worst : family.worst) {
      if (worst && is_gross(worst->judgement.verdict) == gross) findings.push_back(&*worst);
    }
  }
  return findings;
}

std::string indented(const std::string& text, std::string_view by) {
  std::string out;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) out += fmt::format("{}{}\n", by, line);
  return out;
}

std::string as_markup(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\n':
      case '\t':
        out += c;
        break;
      default:
        out += static_cast<unsigned char>(c) < 0x20 ? '?' : c;
    }
  }
  return out;
}

}  // namespace durero::conform
