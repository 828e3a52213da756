#include "durero/spec/refusal.hpp"

#include <fmt/format.h>

#include "durero/zed/value/undecided.hpp"

namespace durero::spec {
namespace {

std::string expected_for(zed::Lack lack) {
  switch (lack) {
    case zed::Lack::members:
      return "expected sets that can be listed, as {x : 0‥9 | P}; --scope gives a given set members";
    case zed::Lack::equation:
      return "expected an equation for this argument, or another argument";
    case zed::Lack::end:
      return "expected a definition that comes to an end, or a smaller argument";
    case zed::Lack::number:
      return "expected an operation whose result is x + y√Δ of rational numbers, or the root of such";
    case zed::Lack::degree:
      return "expected polynomials of degree two at most in this number";
    case zed::Lack::instance:
      return "expected a generic definition by ==, or by the values of a function";
    case zed::Lack::ground:
      return "expected an equation that does not ask for the value that it gives";
  }
  return "expected finite sets, or equations, for what is quantified";
}

}  // namespace

EvaluationRefusal refusal_of(const zed::EvaluationError& error) {
  const std::string undecided = std::string("this is not decided: ") + error.what();
  if (const auto* const constant = dynamic_cast<const zed::Undetermined*>(&error))
    return {undecided, fmt::format("expected one, or --let {}=VALUE", constant->constant())};
  if (dynamic_cast<const zed::Unsatisfied*>(&error) != nullptr)
    return {std::string("the text cannot be so: ") + error.what(),
            "expected a text that some values satisfy, or another --let"};
  if (dynamic_cast<const zed::TooManyMembers*>(&error) != nullptr)
    return {undecided, "expected a smaller set, whatever --steps and --memory are"};
  if (const auto* const open = dynamic_cast<const OpenVariables*>(&error)) return {undecided, open->expected()};
  if (const auto* const lacking = dynamic_cast<const zed::LackingEvaluation*>(&error))
    return {undecided, expected_for(lacking->lack())};
  return {undecided, "expected finite sets, or equations, for what is quantified"};
}

}  // namespace durero::spec
