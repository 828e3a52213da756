#include "durero/spec/refusal.hpp"

#include <fmt/format.h>

namespace durero::spec {

EvaluationRefusal refusal_of(const zed::EvaluationError& error) {
  const std::string undecided = std::string("this is not decided: ") + error.what();
  if (const auto* const constant = dynamic_cast<const zed::Undetermined*>(&error))
    return {undecided, fmt::format("expected one, or --let {}=VALUE", constant->constant())};
  if (dynamic_cast<const zed::Unsatisfied*>(&error) != nullptr)
    return {std::string("the text cannot be so: ") + error.what(),
            "expected a text that some values satisfy, or another --let"};
  if (dynamic_cast<const zed::TooManyMembers*>(&error) != nullptr)
    return {undecided, "expected a smaller set, whatever --steps and --memory are"};
  return {undecided, "expected finite sets, or equations, for what is quantified"};
}

}  // namespace durero::spec
