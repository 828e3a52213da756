#pragma once
/// The predicates of which obligations are made, for whoever states them and whoever tries them.

#include "durero/spec/refinement.hpp"

namespace durero::spec {

/// The reference to a schema.
zed::Term schema_named(const std::string& name);
/// S ' of a schema S.
zed::Term dashed(const zed::Term& schema);
/// a ∧ b.
zed::Term both_hold(const zed::Term& a, const zed::Term& b);
/// The initial schemas as ones of A ' and C '.
zed::Term first_abstract(const Refinement& refinement);
zed::Term first_concrete(const Refinement& refinement);

}  // namespace durero::spec
