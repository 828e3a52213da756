#include "conform_suite.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "durero/text/shown.hpp"
#include "numbers.hpp"

namespace durero::cli {
namespace {

using namespace conform;

model::Tipo type_of(const std::string& word) {
  std::optional<model::Tipo> tipo;
  scene::for_each_shape([&]<class Shape>(std::type_identity<Shape>) {
    if (word == Shape::word) tipo = Shape::tipo;
  });
  if (!tipo) throw std::runtime_error(fmt::format("no type {}; expected a tipo of a scene file", text::shown(word)));
  return *tipo;
}

const Family& family_of(const std::string& name) {
  const Family* family = find_family(name);
  if (family == nullptr)
    throw std::runtime_error(
        fmt::format("no family {}; expected one that durero conform list shows", text::shown(name)));
  return *family;
}

}  // namespace

void add_rays(CLI::App& command, SuiteCall& call) {
  command.add_option("--family", call.families, "A family of the suite; without it, all")->delimiter(',');
  command.add_option("--seed", call.seed, "Which rays")
      ->check(whole_number(0, std::uint64_t{1} << 53U))  // up to there the numbers of JSON are exact
      ->capture_default_str();
  command.add_option("--rays", call.rays, "How many rays of each family")
      ->check(whole_number(1, 100'000'000))
      ->capture_default_str();
}

void add_elements(CLI::App& command, SuiteCall& call) {
  command.add_option("--types", call.types, "Elements of these types alone, such as esfera,cilindro")->delimiter(',');
  command.add_flag("--solids", call.solids, "Discs close the cylinders, cones and truncated cones");
  command.add_option("--numbers", call.numbers, "The format that every number of scenes and rays is of")
      ->check(CLI::IsMember({"binary32", "binary64"}))
      ->capture_default_str();
}

SuiteOptions suite_of(const SuiteCall& call) {
  SuiteOptions options{.seed = call.seed, .rays = call.rays};
  for (const std::string& name : call.families) options.families.push_back(&family_of(name));
  for (const std::string& word : call.types) options.tipos.push_back(type_of(word));
  options.caps = call.solids ? Caps::solid : Caps::open;
  options.numbers = call.numbers == word(Format::binary64) ? Format::binary64 : Format::binary32;
  return options;
}

}  // namespace durero::cli
