#pragma once
/// The options that say which suite: those of every subcommand that makes one.

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "durero/conform/suite.hpp"

namespace durero::cli {

struct SuiteCall {
  std::vector<std::string> families;
  std::uint64_t seed = 1;
  std::size_t rays = conform::SuiteOptions().rays;
  std::vector<std::string> types;
  bool solids = false;
  std::string numbers{word(conform::Format::binary32)};
};

/// --family, --seed and --rays.
void add_rays(CLI::App& command, SuiteCall& call);
/// --types, --solids and --numbers, which a system's profile says of its own suite.
void add_elements(CLI::App& command, SuiteCall& call);

/// Throws std::runtime_error where a family or a type is none.
conform::SuiteOptions suite_of(const SuiteCall& call);
/// With elements that a system of this profile has.
conform::SuiteOptions suite_of(const SuiteCall& call, const conform::Profile& profile);

/// One ray of a suite.
struct CaseCall {
  SuiteCall suite;
  std::string name;  ///< of the case: FAMILY/NUMBER
  std::size_t ray = 0;
};

/// --ray, which is handed back, and --seed.
CLI::Option* add_ray(CLI::App& command, CaseCall& call);
/// --case, --ray, which must be given, and --seed.
void add_case(CLI::App& command, CaseCall& call);

/// The case, answered, of a suite with those elements and numbers; it has the ray. Throws std::runtime_error where
/// there is none such.
conform::SuiteCase case_of(const CaseCall& call, conform::SuiteOptions suite);

}  // namespace durero::cli
