#pragma once
/// Scripts that tests run on an edited scene.

#include <string>

#include "durero/io/json/edited_scene.hpp"

namespace durero::test {

/// The answers to the operations, a line each: r!, then what does not hold.
inline std::string edit(io::EditedScene& edited, const std::string& script) {
  std::string answers;
  const io::Source source("script", script);
  for (const io::ScriptStep& step : io::read_script(source, edited.of().scene.stage(), edited.types())) {
    const io::EditAnswer answer = edited.apply_total(step);
    if (!answer.left_group.empty()) answers += answer.left_group + " left: ";
    answers += answer.r + (answer.ok() ? "" : " " + answer.violated + ": " + answer.predicate) + "\n";
  }
  return answers;
}

}  // namespace durero::test
