#pragma once
/// The conjectures of a text that speak of a state, or of a step.

#include <optional>
#include <vector>

#include "durero/zed/types/typecheck.hpp"

namespace durero::spec {

/// The names that the text before the • of a claim includes, where it includes schemas of a state or a step; nothing
/// where it includes none.
std::optional<std::vector<zed::Name>> included_names(const zed::Typing& typing, const zed::Term& claim);
/// The claim with values of these names: of ∀ S; D | P • Q it is S ⇒ (∀ D | P • Q).
zed::Term claim_instance(const zed::Term& claim);

}  // namespace durero::spec
