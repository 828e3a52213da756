// durero conform make DIR [--family F]… [--seed N] [--rays N] [--types T,…] [--solids] [--numbers F] [--threads N]
#include <fmt/format.h>

#include <array>
#include <stdexcept>

#include "commands.hpp"
#include "conform.hpp"
#include "conform_suite.hpp"
#include "description.hpp"
#include "durero/conform/families/suite_file.hpp"
#include "durero/io/standard_output.hpp"
#include "interrupted.hpp"
#include "progress.hpp"

namespace durero::cli {
namespace {

using conform::Ambiguity;
using conform::FamilySummary;

struct ConformMakeOptions {
  std::string directory;
  SuiteCall suite;
  std::size_t threads = 0;
  bool quiet = false;
};

double percent(std::size_t some, std::size_t all) {
  return all == 0 ? 0 : 100 * static_cast<double>(some) / static_cast<double>(all);
}

std::string text_of(const FamilySummary& of) {
  if (of.cases == 0) return fmt::format("{:20} no scene has elements of these types alone\n", of.family->name);
  const std::size_t alone = of.ambiguities[static_cast<std::size_t>(Ambiguity::none)];
  return fmt::format("{:20} {} rays: {:.1f} % truly of the family, {:.1f} % exactly; {:.1f} % with one answer alone\n",
                     of.family->name, of.count.rays, percent(of.count.members, of.count.rays),
                     percent(of.count.exact, of.count.rays), percent(alone, of.count.rays));
}

int run(const ConformMakeOptions& options) {
  const ThreadLimit limit(options.threads);
  const conform::SuiteOptions suite = suite_of(options.suite);
  std::size_t all = 0;
  for (const conform::Family* family : conform::chosen_families(suite)) all += conform::cases(suite, *family);
  std::vector<FamilySummary> families;
  {
    Progress progress(options.quiet, "make", "scenes", all);
    const std::atomic<bool>& stops = interrupted();
    families = write_suite(options.directory, suite, [&] {
      if (stops) throw std::runtime_error("stopped; expected to go on, and nothing was written");
      progress.add();
    });
  }
  std::string text;
  for (const FamilySummary& family : families) text += text_of(family);
  io::print(text);
  return 0;
}

}  // namespace

void add_conform_make(CLI::App& conform, int& status) {
  auto* command = conform.add_subcommand("make", "Write a suite: scenes, rays and exact answers of the families");
  const auto options = std::make_shared<ConformMakeOptions>();
  command->add_option("DIR", options->directory, "Directory to write: new, or empty")->required();
  add_rays(*command, options->suite);
  add_elements(*command, options->suite);
  add_question(*command, options->suite.question);
  add_threads(*command, options->threads);
  add_quiet(*command, options->quiet);
  command->footer(
      "The same options give the same bytes on any machine. DIR/suite.json says what the suite has; a case is\n"
      "DIR/FAMILY/0000.scene.json, .rays.txt, .hits.jsonl (and .npy of both), .case.json, of 16 rays at most; and\n"
      "where something else than the first hit is asked for, .claims.jsonl, and .ranges.txt with the ends of rays or "
      "the radii of balls.\n\n" +
      exit_status("it is written", "the call is bad, or the folder is not empty") +
      examples({"conform make suite --rays 1000", "conform make suite --family grazing --numbers binary64"}));
  command->callback([options, &status] { status = run(*options); });
}

}  // namespace durero::cli
