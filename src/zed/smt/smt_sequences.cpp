/// The operations of the toolkit on sequences, slot by slot. None has a value where an operand is no sequence.

#include "zed/smt/smt_slots.hpp"

namespace durero::zed {
namespace {

/// Moves each item to the position that `place` makes of its own.
SmtTerm moved_items(const SmtTerm& sequence, const std::function<std::string(const std::string&)>& place) {
  SmtTerm made{SmtSort::set};
  made.defined = smt_all({sequence.defined, slots_are_sequence(sequence)});
  for (std::size_t i = 0; i < sequence.parts.size(); ++i) {
    SmtTerm position{SmtSort::integer, place(as_integer(pair_part(sequence.parts[i], 0)).text)};
    add_slot(made, pair_of(std::move(position), pair_part(sequence.parts[i], 1)), sequence.present[i]);
  }
  made.function = made.sequence = true;
  return merged_slots(std::move(made));
}

/// Keeps the items at some positions.
SmtTerm kept_items(const SmtTerm& sequence, const std::function<std::string(const std::string&)>& at) {
  SmtTerm made = slots_where(sequence, [&](const SmtTerm& pair) { return at(as_integer(pair_part(pair, 0)).text); });
  made.defined = smt_all({sequence.defined, slots_are_sequence(sequence), slots_have_member(sequence)});
  return made;
}

}  // namespace

// The domain has n members, which are whole numbers of 1‥n: it is 1‥n.
std::string slots_are_sequence(const SmtTerm& set) {
  if (set.sequence) return "true";
  const SmtTerm domain = domain_of_slots(set);
  const std::string size = size_of_slots(domain).text;
  limit_text(domain.parts.size() * size.size() + text_size(domain));
  std::vector<std::string> facts = {slots_are_function(set)};
  for (std::size_t i = 0; i < domain.parts.size(); ++i) {
    const SmtTerm place = as_integer(domain.parts[i]);
    const std::string inside =
        smt_all({place.defined, smt_compare("<=", "1", place.text), smt_compare("<=", place.text, size)});
    facts.push_back(smt_implied(domain.present[i], inside));
  }
  return smt_all(facts);
}

SmtTerm sequence_in_slots(const SmtTerm& pairs) {
  SmtTerm made = as_slots(pairs);
  made.defined = smt_all({made.defined, slots_are_sequence(made)});
  made.function = made.sequence = true;
  return made;
}

SmtTerm concatenated_slots(const SmtTerm& a, const SmtTerm& b) {
  const std::string size = size_of_slots(a).text;
  limit_text(b.parts.size() * size.size());
  const SmtTerm after = moved_items(b, [&](const std::string& at) { return smt_plus(size, at); });
  SmtTerm made = union_of_slots(a, after);
  made.defined = smt_all({a.defined, slots_are_sequence(a), after.defined});
  made.function = made.sequence = true;
  return made;
}

SmtTerm reversed_slots(const SmtTerm& sequence) {
  const std::string end = smt_plus(size_of_slots(sequence).text, "1");
  limit_text(sequence.parts.size() * end.size());
  return moved_items(sequence, [&](const std::string& at) { return smt_minus(end, at); });
}

SmtTerm head_of_slots(const SmtTerm& sequence) {
  SmtTerm made = applied_slots(sequence, {SmtSort::integer, "1"});
  made.defined = smt_all({slots_are_sequence(sequence), made.defined});
  return made;
}

SmtTerm last_of_slots(const SmtTerm& sequence) {
  SmtTerm made = applied_slots(sequence, size_of_slots(sequence));
  made.defined = smt_all({slots_are_sequence(sequence), made.defined});
  return made;
}

SmtTerm tail_of_slots(const SmtTerm& sequence) {
  SmtTerm rest = kept_items(sequence, [](const std::string& at) { return smt_compare("<", "1", at); });
  rest.sequence = true;  // of positions from 2 on, which are moved
  return moved_items(rest, [](const std::string& at) { return smt_minus(at, "1"); });
}

SmtTerm front_of_slots(const SmtTerm& sequence) {
  const std::string size = size_of_slots(sequence).text;
  limit_text(sequence.parts.size() * size.size());
  SmtTerm made = kept_items(sequence, [&](const std::string& at) { return smt_compare("<", at, size); });
  made.function = made.sequence = true;
  return made;
}

/// The position of an item is 1 and the number of members that begin before it.
SmtTerm squashed_slots(const SmtTerm& function) {
  const std::vector<std::string> first = first_in_slots(function);
  SmtTerm made{SmtSort::set};
  made.defined = smt_all({function.defined, slots_are_function(function)});
  limit_text(function.parts.size() * text_size(function));
  for (std::size_t i = 0; i < function.parts.size(); ++i) {
    std::vector<std::string> before;
    const std::string here = as_integer(pair_part(function.parts[i], 0)).text;
    for (std::size_t j = 0; j < function.parts.size(); ++j)
      if (j != i)
        before.push_back(smt_all({first[j], smt_compare("<", as_integer(pair_part(function.parts[j], 0)).text, here)}));
    SmtTerm position{SmtSort::integer, smt_plus(count_of(before), "1")};
    add_slot(made, pair_of(std::move(position), pair_part(function.parts[i], 1)), function.present[i]);
  }
  made.function = made.sequence = true;
  return merged_slots(std::move(made));
}

}  // namespace durero::zed
