#include "conform_suite.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "durero/conform/ask/system_file.hpp"
#include "durero/text/shown.hpp"
#include "durero/text/whole_number.hpp"
#include "numbers.hpp"

namespace durero::cli {
namespace {

using namespace conform;

std::vector<std::string> type_words() {
  std::vector<std::string> words;
  scene::for_each_shape([&]<class Shape>(std::type_identity<Shape>) { words.emplace_back(Shape::word); });
  words.insert(words.end(), body_words.begin(), body_words.end());
  return words;
}

/// Adds the type, or the kind of bodies, of that word. Precondition: the word is one of type_words().
void add_type(SuiteOptions& options, const std::string& word) {
  scene::for_each_shape([&]<class Shape>(std::type_identity<Shape>) {
    if (word == Shape::word) options.tipos.push_back(Shape::tipo);
  });
  const auto* const body = std::ranges::find(body_words, word);
  if (body != body_words.end()) options.bodies.push_back(static_cast<BodyKind>(body - body_words.begin()));
}

std::vector<std::string> family_names() {
  std::vector<std::string> names;
  for (const Family& family : families()) names.emplace_back(family.name);
  return names;
}

const Family& family_of(const std::string& name) {
  const Family* family = find_family(name);
  if (family == nullptr)
    throw std::runtime_error(
        fmt::format("no family {}; expected {}", text::shown(name), text::expected_of(name, family_names())));
  return *family;
}

/// The parts FAMILY and NUMBER of a case's name.
std::pair<std::string, std::uint64_t> parts_of(const std::string& name) {
  const std::size_t slash = name.find('/');
  const auto number = slash == name.npos ? std::nullopt : text::whole_number(std::string_view(name).substr(slash + 1));
  if (!number)
    throw std::runtime_error(fmt::format("no case {}; expected FAMILY/NUMBER, such as {}/0000", text::shown(name),
                                         find_family(name.substr(0, slash)) ? name.substr(0, slash) : "rim"));
  return {name.substr(0, slash), *number};
}

void add_seed(CLI::App& command, SuiteCall& call) {
  command.add_option("--seed", call.seed, "Which rays")
      ->check(whole_number(0, std::uint64_t{1} << 53U))  // up to there the numbers of JSON are exact
      ->capture_default_str();
}

void add_faces(CLI::App& command, SuiteCall& call) {
  command.add_option("--faces", call.faces, "About so many faces has a mesh, in the families of meshes")
      ->check(whole_number(1, most_faces))
      ->capture_default_str();
}

void add_families(CLI::App& command, SuiteCall& call) {
  command.add_option("--family", call.families, "Families of the suite; without it, all")
      ->delimiter(',')
      ->check(one_of("family", family_names()));
}

void add_numbers(CLI::App& command, SuiteCall& call) {
  command.add_option("--numbers", call.numbers, "The format that every number of scenes and rays is of")
      ->check(one_of("format", {"binary32", "binary64"}))
      ->capture_default_str();
}

}  // namespace

void add_rays(CLI::App& command, SuiteCall& call) {
  add_families(command, call);
  add_seed(command, call);
  command.add_option("--rays", call.rays, "How many rays of each family")
      ->check(whole_number(1, 100'000'000))
      ->capture_default_str();
  add_faces(command, call);
}

void add_elements(CLI::App& command, SuiteCall& call) {
  command.add_option("--types", call.types, "Elements of these types alone, such as esfera,cilindro")
      ->delimiter(',')
      ->check(one_of("type", type_words()));
  command.add_flag("--solids", call.solids, "Discs close the cylinders, cones and truncated cones");
  add_numbers(command, call);
}

QuestionKind question_of(const std::string& word) {
  return static_cast<QuestionKind>(std::ranges::find(question_words, word) - question_words.begin());
}

CLI::Option* add_question(CLI::App& command, std::string& question) {
  return command
      .add_option(
          "--question", question,
          "What is asked: the first hit; shadow, whether anything is hit up to an end of each ray; range, the first "
          "hit between two ends of each ray; all hits in order; count, their number; closest, the nearest point "
          "to a point; or cast, the first touch of a ball that moves along each ray")
      ->check(one_of("question", {question_words.begin(), question_words.end()}))
      ->capture_default_str();
}

void add_sources(CLI::App& command, SuiteCall& call) {
  add_families(command, call);
  add_seed(command, call);
  add_faces(command, call);
  add_numbers(command, call);
}

SuiteOptions suite_of(const SuiteCall& call) {
  SuiteOptions options{.seed = call.seed, .rays = call.rays, .faces = call.faces};
  for (const std::string& name : call.families) options.families.push_back(&family_of(name));
  for (const std::string& word : call.types) add_type(options, word);
  options.caps = call.solids ? Caps::solid : Caps::open;
  options.question = question_of(call.question);
  options.numbers = call.numbers == word(NumberFormat::binary64) ? NumberFormat::binary64 : NumberFormat::binary32;
  return options;
}

SuiteOptions suite_of(const SuiteCall& call, const Profile& profile) {
  SuiteOptions options = suite_of(call);
  options.tipos = profile.tipos;
  options.bodies = profile.bodies;
  options.caps = profile.caps;
  require_claimed(profile, options.question);
  return options;
}

CLI::Option* add_ray(CLI::App& command, CaseCall& call) {
  auto* ray =
      command.add_option("--ray", call.ray, "Which of its rays, from 0")->check(whole_number(0, rays_of_a_mesh - 1));
  add_seed(command, call.suite);
  add_faces(command, call.suite);
  return ray;
}

void add_case(CLI::App& command, CaseCall& call) {
  command.add_option("--case", call.name, "Which, such as tiny/0007")->required();
  add_ray(command, call)->required();
}

SuiteCase case_of(const CaseCall& call, SuiteOptions suite) {
  const auto [family_name, number] = parts_of(call.name);
  const Family& family = family_of(family_name);
  suite.rays = (number + 1) * rays_of(family);
  if (number >= cases(suite, family))
    throw std::runtime_error(fmt::format("no case {}; expected one of elements that the family has", call.name));
  SuiteCase of = suite_case(suite, family, number);
  if (call.ray >= of.the_case.rays.size())
    throw std::runtime_error(
        fmt::format("ray {} of {}; expected a ray of the case, from 0", call.ray, of.the_case.rays.size()));
  answer(of);
  ask_question(of, suite);
  return of;
}

}  // namespace durero::cli
