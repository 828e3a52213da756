#pragma once
/// A set is a list of slots: members that it may have, each with the condition on which it has it. The operations of
/// the toolkit are computed slot by slot, so that no quantifier is needed. Two slots may hold the same member.

#include <functional>

#include "zed/smt/smt_term.hpp"

namespace durero::zed {

/// Returns a set as one; an undefined term is the empty set without a value. Throws Untranslated for any other.
SmtTerm as_slots(const SmtTerm& set);
/// Adds a member where the condition holds and the member has a value.
void add_slot(SmtTerm& set, SmtTerm member, const std::string& present);
/// Makes one slot of those that have the same text, drops empty ones, and says whether constants make it a function.
SmtTerm merged_slots(SmtTerm set);

/// Says whether two terms are written alike: they are equal then.
bool have_one_text(const SmtTerm& a, const SmtTerm& b);

/// Says that a term is a member. It has a value.
std::string in_slots(const SmtTerm& element, const SmtTerm& set);
/// Says that every member of one set is a member of the other.
std::string subset_of_slots(const SmtTerm& a, const SmtTerm& b);
/// Says that a set of pairs is a function: members that begin alike are equal.
std::string slots_are_function(const SmtTerm& set);
/// Says that the inverse of a set of pairs is a function.
std::string slots_are_injective(const SmtTerm& set);
/// Says that a set of pairs is a sequence.
std::string slots_are_sequence(const SmtTerm& set);
/// Says that the set has a member.
std::string slots_have_member(const SmtTerm& set);
/// Says that no two sets of a family, a function to sets, share a member.
std::string slots_are_disjoint(const SmtTerm& family);

/// Keeps the members of which `condition` holds.
SmtTerm slots_where(const SmtTerm& set, const std::function<std::string(const SmtTerm&)>& condition);
/// Returns part 0 or 1 of a pair. Throws Untranslated for another term.
const SmtTerm& pair_part(const SmtTerm& pair, std::size_t part);
SmtTerm pair_of(SmtTerm first, SmtTerm second);

/// @{ The operations of the toolkit. Each has a value where that of the toolkit does.
SmtTerm union_of_slots(const SmtTerm& a, const SmtTerm& b);
SmtTerm difference_of_slots(const SmtTerm& a, const SmtTerm& b);
SmtTerm symmetric_difference_of_slots(const SmtTerm& a, const SmtTerm& b);
SmtTerm union_in_slots(const SmtTerm& sets);  ///< ⋃
SmtTerm product_of_slots(const std::vector<SmtTerm>& sets);
SmtTerm size_of_slots(const SmtTerm& set);
SmtTerm least_of_slots(const SmtTerm& set);
SmtTerm greatest_of_slots(const SmtTerm& set);
SmtTerm domain_of_slots(const SmtTerm& relation);
SmtTerm range_of_slots(const SmtTerm& relation);
SmtTerm inverse_of_slots(const SmtTerm& relation);
SmtTerm identity_of_slots(const SmtTerm& set);
SmtTerm overridden_slots(const SmtTerm& by_less, const SmtTerm& by_more);  ///< f ⊕ g
SmtTerm composed_slots(const SmtTerm& first, const SmtTerm& second);       ///< R ⨾ S
SmtTerm applied_slots(const SmtTerm& function, const SmtTerm& argument);
/// @}

/// Returns from ‥ to in so many slots. It has no value where the interval has more members.
SmtTerm interval_in_slots(const SmtTerm& from, const SmtTerm& to, std::size_t slots);

/// @{ The operations on sequences, in smt_sequences.cpp.
SmtTerm concatenated_slots(const SmtTerm& a, const SmtTerm& b);
SmtTerm reversed_slots(const SmtTerm& sequence);
SmtTerm head_of_slots(const SmtTerm& sequence);
SmtTerm last_of_slots(const SmtTerm& sequence);
SmtTerm tail_of_slots(const SmtTerm& sequence);
SmtTerm front_of_slots(const SmtTerm& sequence);
SmtTerm squashed_slots(const SmtTerm& function);
SmtTerm sequence_in_slots(const SmtTerm& pairs);  ///< ⟨,,⟩ of {(1, a), (2, b)}
/// @}

/// Says of each slot that its member is there, and in no slot before it.
std::vector<std::string> first_in_slots(const SmtTerm& set);
/// Adds up how many of the conditions hold.
std::string count_of(const std::vector<std::string>& conditions);

}  // namespace durero::zed
