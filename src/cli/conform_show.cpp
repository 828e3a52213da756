// durero conform show --case FAMILY/NUMBER --ray N: a ray of a suite and its exact answer.
#include <fmt/format.h>

#include <charconv>
#include <memory>

#include "conform.hpp"
#include "conform_suite.hpp"
#include "durero/conform/explanation.hpp"
#include "durero/text/shown.hpp"
#include "numbers.hpp"

namespace durero::cli {
namespace {

using namespace conform;

struct Options {
  SuiteCall suite;
  std::string name;
  std::size_t ray = 0;
};

/// FAMILY and NUMBER.
std::pair<std::string, std::uint64_t> parts_of(const std::string& name) {
  const std::size_t slash = name.find('/');
  std::uint64_t number = 0;
  const char* const end = name.data() + name.size();
  const auto parsed = std::from_chars(name.data() + std::min(slash, name.size() - 1) + 1, end, number);
  if (slash == name.npos || parsed.ec != std::errc() || parsed.ptr != end)
    throw std::runtime_error(fmt::format("no case {}; expected FAMILY/NUMBER", text::shown(name)));
  return {name.substr(0, slash), number};
}

int run(const Options& options) {
  const auto [family, number] = parts_of(options.name);
  SuiteCall call = options.suite;
  call.families = {family};
  call.rays = (number + 1) * rays_of_a_case;
  const SuiteOptions suite = suite_of(call);
  const Family& of = *suite.families.front();
  if (number >= cases(suite, of))
    throw std::runtime_error(fmt::format("no case {}; expected one of elements that the family has", options.name));
  SuiteCase shown = suite_case(suite, of, number);
  if (options.ray >= shown.the_case.rays.size())
    throw std::runtime_error(
        fmt::format("ray {} of {}; expected a ray of the case, from 0", options.ray, shown.the_case.rays.size()));
  answer(shown);
  fmt::print("{}", explanation(shown, options.ray));
  return 0;
}

}  // namespace

void add_conform_show(CLI::App& conform, int& status) {
  auto* command = conform.add_subcommand("show", "A ray of a suite and its exact answer, to forty digits");
  const auto options = std::make_shared<Options>();
  command->add_option("--case", options->name, "Which, such as tiny/0007")->required();
  command->add_option("--ray", options->ray, "Which of its rays, from 0")
      ->check(whole_number(0, rays_of_a_case - 1))
      ->required();
  command->add_option("--seed", options->suite.seed, "Of which suite")
      ->check(whole_number(0, std::numeric_limits<std::uint64_t>::max()))
      ->capture_default_str();
  add_elements(*command, options->suite);
  command->callback([options, &status] { status = run(*options); });
}

}  // namespace durero::cli
