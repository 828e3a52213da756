#pragma once
/// Definitions of Coq, of what was recorded.

#include <functional>
#include <string>
#include <vector>

#include "proofs/recorded.hpp"

namespace durero::trace::HWY_NAMESPACE {

/// What a definition is of: a constructor and what it is applied to; or a record, the name of each part of which is
/// given.
struct Built {
  std::string constructor;
  std::vector<Node> parts;
  std::vector<std::string> names = {};
};

/// Prints `Definition HEAD := …` of what `build` gives, with a `let` for each term that it uses more than once. Where
/// `build` branches on conditions, it is called for each way through it.
/// Where an earlier definition in reach has the same text, of the same arguments, it is called in place of it.
void define(const std::string& comment, const std::string& head, const std::function<Built()>& build);

}  // namespace durero::trace::HWY_NAMESPACE
