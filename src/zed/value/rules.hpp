#pragma once
/// A relation of infinitely many pairs is a rule: it answers which values it relates to one value. What the toolkit
/// makes of such a relation is a rule again.

#include "zed/value/functions.hpp"

namespace durero::zed {

/// @{ Makes R ⨟ S, R ⊕ S and R∼ of relations, one of which at least cannot be listed.
Value composed_rules(const Value& first, const Value& then);
Value overriding_rules(const Value& below, const Value& above);
Value inverse_rule(const Value& relation);
/// @}
/// Makes the relation of the pairs whose `part`, 0 or 1, is in the set, or is not, of a relation that cannot be listed.
/// It is listed where its first parts are among those of a finite set.
Value restricted_rule(const Value& relation, const Value& set, std::size_t part, bool in, Context& context);
/// Makes the set of second parts of a relation that cannot be listed.
Value range_of_rule(const Value& relation);
/// Makes the identity on a set that cannot be listed.
Value identity_rule(const Value& set);

}  // namespace durero::zed
