// The options of `durero conform` that say which cases.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>

#include "conform.hpp"
#include "durero/scene/shapes.hpp"
#include "numbers.hpp"

namespace durero::cli {
namespace {

using conform::Caps;
using conform::Family;
using conform::Format;
using conform::SuiteOptions;

constexpr std::uint64_t greatest_seed = std::uint64_t{1} << 53U;  // JSON's numbers are exact up to there

std::map<std::string, model::Tipo, std::less<>> types() {
  std::map<std::string, model::Tipo, std::less<>> all;
  scene::for_each_shape([&]<class Shape>(std::type_identity<Shape>) { all.emplace(Shape::word, Shape::tipo); });
  return all;
}

std::string words_of_types() {
  std::string words;
  scene::for_each_shape([&]<class Shape>(std::type_identity<Shape>) {
    words += fmt::format("{}{}", words.empty() ? "" : ", ", Shape::word);
  });
  return words;
}

void add_families(CLI::App& command, const SuiteCall& options) {
  const auto take = [options](const std::vector<std::string>& names) {
    for (const std::string& name : names) {
      const Family* family = conform::find_family(name);
      if (family == nullptr)
        throw CLI::ValidationError("--family", fmt::format("no family {}; expected one of durero conform list", name));
      options->families.push_back(family);
    }
  };
  command
      .add_option_function<std::vector<std::string>>(
          "--family", take, "A family of durero conform list; may stand several times; without it, all")
      ->expected(1)
      ->delimiter(',')
      ->allow_extra_args(false)
      ->take_all();
}

void add_types(CLI::App& command, const SuiteCall& options) {
  const auto take = [options](const std::vector<std::string>& words) {
    const auto known = types();
    for (const std::string& word : words) {
      const auto type = known.find(word);
      if (type == known.end())
        throw CLI::ValidationError("--types", fmt::format("no type {}; expected some of {}", word, words_of_types()));
      options->tipos.push_back(type->second);
    }
  };
  command
      .add_option_function<std::vector<std::string>>(
          "--types", take, fmt::format("Elements of these types alone, of {}", words_of_types()))
      ->delimiter(',');
}

void add_numbers(CLI::App& command, const SuiteCall& options) {
  const auto take = [options](const std::string& name) {
    if (name != "binary32" && name != "binary64")
      throw CLI::ValidationError("--numbers", fmt::format("no format {}; expected binary32 or binary64", name));
    options->numbers = name == "binary32" ? Format::binary32 : Format::binary64;
  };
  command.add_option_function<std::string>("--numbers", take,
                                           "The format of every number: binary32 (as without it) or binary64");
}

}  // namespace

void add_seed(CLI::App& command, const SuiteCall& options) {
  command.add_option("--seed", options->seed, "Which cases")
      ->check(whole_number(0, greatest_seed))
      ->capture_default_str();
}

void add_rays(CLI::App& command, const SuiteCall& options) {
  add_families(command, options);
  add_seed(command, options);
  command.add_option("--rays", options->rays, "How many rays of each family")
      ->check(whole_number(1, 100'000'000))
      ->capture_default_str();
}

void add_elements(CLI::App& command, const SuiteCall& options) {
  add_types(command, options);
  const auto close = [options](std::int64_t) { options->caps = Caps::solid; };
  command.add_flag_function("--solids", close, "Discs close the cylinders, cones and truncated cones");
  add_numbers(command, options);
}

}  // namespace durero::cli
