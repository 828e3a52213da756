// durero conform make DIR [--family F]… [--seed N] [--rays N] [--types T,…] [--solids] [--numbers F] [--threads N]
#include <fmt/format.h>

#include <array>

#include "commands.hpp"
#include "conform.hpp"
#include "conform_suite.hpp"
#include "durero/conform/suite_file.hpp"
#include "durero/io/output_file.hpp"

namespace durero::cli {
namespace {

using conform::Ambiguity;
using conform::FamilySummary;

struct Options {
  std::string directory;
  SuiteCall suite;
  std::size_t threads = 0;
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

int run(const Options& options) {
  const ThreadLimit limit(options.threads);
  std::string text;
  for (const FamilySummary& family : write_suite(options.directory, suite_of(options.suite))) text += text_of(family);
  io::write_file("-", text);
  return 0;
}

}  // namespace

void add_conform_make(CLI::App& conform, int& status) {
  auto* command = conform.add_subcommand("make", "Write a suite: scenes, rays and exact answers of the families");
  const auto options = std::make_shared<Options>();
  command->add_option("DIR", options->directory, "Directory to write: new, or empty")->required();
  add_rays(*command, options->suite);
  add_elements(*command, options->suite);
  add_threads(*command, options->threads);
  command->footer(
      "The same options give the same bytes on any machine. DIR/suite.json says what the suite has; a case is\n"
      "DIR/FAMILY/0000.scene.json, .rays.txt, .hits.jsonl (and .npy of both), .case.json, of 64 rays at most.");
  command->callback([options, &status] { status = run(*options); });
}

}  // namespace durero::cli
