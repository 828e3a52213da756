#pragma once
/// The options that choose a suite are shared by all subcommands that make one.

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "durero/conform/families/suite.hpp"

namespace durero::cli {

struct SuiteCall {
  std::vector<std::string> families;
  std::uint64_t seed = 1;
  std::size_t rays = conform::SuiteOptions().rays, faces = conform::usual_faces;
  std::vector<std::string> types;
  bool solids = false;
  std::string numbers{word(conform::NumberFormat::binary32)};
  std::string question{word(conform::QuestionKind::first)};
};

/// Adds --family, --seed, --rays and --faces.
void add_rays(CLI::App& command, SuiteCall& call);
/// Adds --question, which is returned.
CLI::Option* add_question(CLI::App& command, std::string& question);
/// The question of that word. Precondition: it is one of question_words.
conform::QuestionKind question_of(const std::string& word);
/// Adds --family, --seed, --faces and --numbers, which say where fuzzing begins.
void add_sources(CLI::App& command, SuiteCall& call);
/// Adds --types, --solids and --numbers, which a system's profile gives for its own suite.
void add_elements(CLI::App& command, SuiteCall& call);

/// The suite of the call. Throws std::runtime_error where there is no such family or type.
conform::SuiteOptions suite_of(const SuiteCall& call);
/// The suite of the call, with elements that a system of this profile has. Throws std::runtime_error also where the
/// profile does not claim the question.
conform::SuiteOptions suite_of(const SuiteCall& call, const conform::Profile& profile);

/// One ray of a suite.
struct CaseCall {
  SuiteCall suite;
  std::string name;  ///< the name of the case: FAMILY/NUMBER
  std::size_t ray = 0;
};

/// Adds --ray, which is returned, --seed and --faces.
CLI::Option* add_ray(CLI::App& command, CaseCall& call);
/// Adds --case and --ray, which must be given, --seed and --faces.
void add_case(CLI::App& command, CaseCall& call);

/// The answered case of a suite with those elements and numbers; it has the ray. Throws std::runtime_error where there
/// is no such case.
conform::SuiteCase case_of(const CaseCall& call, conform::SuiteOptions suite);

}  // namespace durero::cli
