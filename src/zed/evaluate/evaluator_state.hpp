#pragma once
/// The state that an evaluator owns.

#include "durero/zed/evaluate/evaluate.hpp"
#include "zed/evaluate/compiler.hpp"

namespace durero::zed {

struct Evaluator::State {
  State(std::vector<Section> given_sections, Steps* counted)
      : steps(counted ? *counted : own_steps),
        sections(std::move(given_sections)),
        definitions(sections),
        compiler(definitions) {}
  Steps own_steps;
  Steps& steps;
  std::vector<Section> sections;
  Definitions definitions;
  Compiler compiler;
};

}  // namespace durero::zed
