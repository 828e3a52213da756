// durero conform judge DIR HITS --profile P [--report DIR]: the hits of a program that anyone ran by hand.
// durero conform judge --scene SCENE --rays RAYS HITS --profile P: those of one's own rays.
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "conform.hpp"
#include "conform_suite.hpp"
#include "description.hpp"
#include "durero/conform/ask/claims_file.hpp"
#include "durero/conform/ask/ranges_file.hpp"
#include "durero/conform/ask/system_file.hpp"
#include "durero/conform/families/suite_file.hpp"
#include "durero/conform/report/causes.hpp"
#include "durero/conform/report/judged_rays.hpp"
#include "durero/conform/report/report.hpp"
#include "durero/io/json/scene_file.hpp"
#include "durero/io/rays/rays_file.hpp"
#include "durero/io/standard_output.hpp"
#include "durero/written/engine.hpp"
#include "file_error.hpp"
#include "numbers.hpp"
#include "progress.hpp"

namespace durero::cli {
namespace {

using namespace conform;

struct ConformJudgeOptions {
  std::vector<std::string> files;  // the suite and the hits, or the hits alone
  std::string scene, rays, ranges, with, format = "text", profile, report;
  std::string question{word(QuestionKind::first)};
  std::string systems = default_systems();
  bool quiet = false;

  const std::string& hits() const { return files.back(); }
};

/// Checks that the files and options go together. Throws std::invalid_argument.
void check_together(const ConformJudgeOptions& options) {
  const bool is_own = !options.scene.empty();
  if (is_own != (options.files.size() == 1))
    throw std::invalid_argument(is_own ? "HITS alone stands beside --scene; expected no suite"
                                       : "HITS is missing; expected DIR and HITS, or --scene, --rays and HITS");
  const bool wants_ranges = is_own && has_numbers(question_of(options.question));
  if (wants_ranges != !options.ranges.empty())
    throw std::invalid_argument(wants_ranges
                                    ? "--ranges is missing; expected the file of the rays' ends, or of balls' radii"
                                    : "--ranges is for shadow rays, ranges and casts; expected no such file");
  if (!is_own && options.format != "text")
    throw std::invalid_argument("--format json is for one's own rays; expected --scene, or --report for a suite");
}

/// A user's scene, whose elements a text may define.
struct OwnScene {
  scene::Scene scene;
  std::vector<NamedSurface> surfaces{};
};

/// Reads a scene by a text. Throws io::InputError, also of a text that says itself what the model's shapes are: their
/// allowances are those of the model.
OwnScene read_own_scene(const std::string& scene_file, const std::string& text_file) {
  const io::Source source = io::read_source(scene_file);
  if (text_file.empty()) return {io::read_scene(source)};
  const auto text = std::make_shared<const written::Text>(text_file);
  if (text->declares_shapes())
    throw io::InputError(text_file, {1, 1}, "it says what points elements of the model's types have",
                         "expected types of its own alone");
  written::Written read = written::read(source, *text, io::Bodies::refused);
  std::vector<NamedSurface> surfaces = surfaces_of(read.scene, read.elements, text);
  return {std::move(read.scene), std::move(surfaces)};
}

/// A user's scene and rays. Throws io::InputError, and std::invalid_argument of rays that no system is asked.
SuiteCase read_own(const ConformJudgeOptions& options) {
  auto [scene, surfaces] = read_own_scene(options.scene, options.with);
  std::vector<scene::Query> rays = io::read_rays(io::read_source(options.rays), scene);
  return naming_file<std::invalid_argument>(options.rays, [&] {
    SuiteCase of = own_case(std::move(scene), std::move(rays));
    of.surfaces = std::move(surfaces);
    return of;
  });
}

/// Judges the hits of a user's own rays.
int run_own(const ConformJudgeOptions& options) {
  const Profile profile = read_profile(options.profile, options.systems);
  std::optional<Progress> progress(std::in_place, options.quiet, "judge");
  SuiteCase of = read_own(options);
  of.question = question_of(options.question);
  require_claimed(profile, of.question);
  const bool is_of_distances = of.question == QuestionKind::closest || of.question == QuestionKind::cast;
  if (is_of_distances && !of.surfaces.empty())
    throw std::invalid_argument("distances from a surface of a text are not known; expected another question");
  if (!options.ranges.empty())
    of.ranges = read_ranges(io::read_lines(options.ranges), of.question, of.the_case.rays.size());
  const std::vector<Claims> claims = read_claims(io::read_lines(options.hits()), {&of, 1});
  answer(of);
  Tally tally;
  const std::vector<ClaimJudgement> judgements = tally.add(of, claims[0], profile);
  progress.reset();
  io::print(options.format == "json" ? judged_rays_json(of, claims[0], judgements)
                                     : judged_rays_text(of, claims[0], judgements));
  return tally.is_conformant() ? 0 : 1;
}

int run(const ConformJudgeOptions& options) {
  const Profile profile = read_profile(options.profile, options.systems);
  if (!options.report.empty()) require_room_for_reports(options.report);
  std::optional<Progress> progress(std::in_place, options.quiet, "judge: reading");
  const Suite suite = read_suite(options.files.front());
  require_claimed(profile, suite.options.question);
  const std::vector<Claims> claims = read_claims(io::read_lines(options.hits()), suite.cases);
  progress.emplace(options.quiet, "judge", "scenes", suite.cases.size());
  Report report{.title = profile.system, .profile = profile, .options = suite.options};
  for (std::size_t i = 0; i < suite.cases.size(); ++i) {
    report.tally.add(suite.cases[i], claims[i], profile);
    progress->add();
  }
  progress.reset();
  guess_causes(report);
  io::print(report_text(report));
  if (!options.report.empty()) write_reports(options.report, report);
  return report.tally.is_conformant() ? 0 : 1;
}

}  // namespace

void add_conform_judge(CLI::App& conform, int& status) {
  auto* command =
      conform.add_subcommand("judge", "Judge the hits that a program gave for the rays of a suite, or for its own");
  const auto options = std::make_shared<ConformJudgeOptions>();
  command
      ->add_option("FILE", options->files,
                   "DIR HITS: the suite, as durero conform make wrote it, and the hits: JSON lines, .csv or .npy; "
                   "- is the standard input. With --scene HITS alone")
      ->required()
      ->expected(1, 2);
  auto* const scene = command->add_option("--scene", options->scene, "A scene of one's own (JSON)");
  auto* const rays = command->add_option("--rays", options->rays, "The rays that the hits answer, in a text or a .npy");
  scene->needs(rays);
  rays->needs(scene);
  auto* const question = add_question(*command, options->question)->needs(scene);
  command
      ->add_option("--with", options->with,
                   "A Z text that declares types of elements: the profile names those that it claims as surfaces")
      ->needs(scene);
  command
      ->add_option("--ranges", options->ranges,
                   "The numbers behind the rays, a line each: T of shadow rays, T0 T1 of ranges, R of balls")
      ->needs(question);
  command->add_option("--format", options->format, "How verdicts on one's own rays are printed; json: a line a ray")
      ->check(one_of("format", {"text", "json"}))
      ->capture_default_str();
  command->add_option("--profile", options->profile, "What the program claims: a system's name, or a file")->required();
  add_systems(*command, options->systems);
  command->add_option("--report", options->report, "The folder for JSON, JUnit XML, SARIF and a page of HTML")
      ->excludes(scene);
  add_quiet(*command, options->quiet);
  command->footer(
      "JSON lines: "
      "{\"case\":\"generic/0000\",\"ray\":0,\"outcome\":\"hit\",\"element\":\"e0\",\"t\":4,\"point\":[0,0,4]}; "
      "CSV: columns\n"
      "case, ray and any of outcome, element, t, x, y, z; .npy: t of every ray in the suite's order, inf for a miss.\n"
      "A ray without a line is unanswered. Hits of one's own rays need no case.\n\n" +
      exit_status("no answer is off", "some is, or none was judged", "the call or a file is bad") +
      examples({"conform judge suite hits.csv --profile embree",
                "conform judge --scene demo/still-life.json --rays rays.txt hits.jsonl --profile mine.json",
                "conform judge --scene demo/surfaces/torus.json --with demo/surfaces/torus.tex --rays rays.txt "
                "hits.jsonl --profile mine.json"}));
  command->callback([options, &status] {
    check_together(*options);
    status = options->scene.empty() ? run(*options) : run_own(*options);
  });
}

}  // namespace durero::cli
