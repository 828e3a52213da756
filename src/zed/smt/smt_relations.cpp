/// The operations of the toolkit on relations and functions, slot by slot.

#include "zed/smt/smt_slots.hpp"

namespace durero::zed {
namespace {

/// Makes a set of what `part` makes of each member.
SmtTerm each_slot(const SmtTerm& set, const std::function<SmtTerm(const SmtTerm&)>& part) {
  SmtTerm made{SmtSort::set};
  made.defined = set.defined;
  for (std::size_t i = 0; i < set.parts.size(); ++i) add_slot(made, part(set.parts[i]), set.present[i]);
  return merged_slots(std::move(made));
}

/// Says that two slots give the argument one value.
std::string give_one_value(const SmtTerm& function, const std::vector<std::string>& here) {
  limit_text(function.parts.size() * text_size(function));
  std::vector<std::string> facts;
  for (std::size_t i = 0; i < here.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const std::string both = smt_all({here[i], here[j]});
      if (both == "false") continue;
      facts.push_back(smt_implied(both, smt_equal(pair_part(function.parts[i], 1), pair_part(function.parts[j], 1))));
    }
  return smt_all(facts);
}

}  // namespace

SmtTerm domain_of_slots(const SmtTerm& relation) {
  return each_slot(as_slots(relation), [](const SmtTerm& pair) { return pair_part(pair, 0); });
}

SmtTerm range_of_slots(const SmtTerm& relation) {
  return each_slot(as_slots(relation), [](const SmtTerm& pair) { return pair_part(pair, 1); });
}

SmtTerm inverse_of_slots(const SmtTerm& relation) {
  return each_slot(as_slots(relation),
                   [](const SmtTerm& pair) { return pair_of(pair_part(pair, 1), pair_part(pair, 0)); });
}

SmtTerm identity_of_slots(const SmtTerm& set) {
  SmtTerm made = each_slot(as_slots(set), [](const SmtTerm& part) { return pair_of(part, part); });
  made.function = true;
  return made;
}

SmtTerm overridden_slots(const SmtTerm& by_less, const SmtTerm& by_more) {
  const SmtTerm domain = domain_of_slots(by_more);
  limit_text(by_less.parts.size() * text_size(domain) + domain.parts.size() * text_size(by_less));
  const SmtTerm kept =
      slots_where(by_less, [&](const SmtTerm& pair) { return smt_not(in_slots(pair_part(pair, 0), domain)); });
  SmtTerm made = union_of_slots(kept, by_more);
  made.function = made.function || (by_less.function && by_more.function);
  return made;
}

SmtTerm composed_slots(const SmtTerm& first, const SmtTerm& second) {
  limit_text(first.parts.size() * text_size(second) + second.parts.size() * text_size(first));
  SmtTerm made{SmtSort::set};
  made.defined = smt_all({first.defined, second.defined});
  for (std::size_t i = 0; i < first.parts.size(); ++i)
    for (std::size_t j = 0; j < second.parts.size(); ++j) {
      const SmtTerm &a = first.parts[i], &b = second.parts[j];
      const std::string meet =
          smt_all({first.present[i], second.present[j], smt_equal(pair_part(a, 1), pair_part(b, 0))});
      if (meet != "false") add_slot(made, pair_of(pair_part(a, 0), pair_part(b, 1)), meet);
    }
  made.function = first.function && second.function;
  return merged_slots(std::move(made));
}

// The last slot needs no test: the function has a value where one of the slots has the argument.
SmtTerm applied_slots(const SmtTerm& function, const SmtTerm& argument) {
  const SmtTerm set = as_slots(function);
  limit_text(set.parts.size() * text_size(argument) + text_size(set));
  SmtTerm made{SmtSort::integer, "0", "false"};
  std::vector<std::string> here;
  for (std::size_t i = 0; i < set.parts.size(); ++i)
    here.push_back(smt_all({set.present[i], smt_equal(argument, pair_part(set.parts[i], 0))}));
  bool first = true;
  for (std::size_t i = here.size(); i-- > 0;) {
    if (here[i] == "false") continue;
    const SmtTerm& value = pair_part(set.parts[i], 1);
    made = first ? value : smt_chosen(here[i], value, std::move(made));
    first = false;
  }
  if (first) return made;
  const std::string one = set.function ? "true" : give_one_value(set, here);
  made.defined = smt_all({set.defined, argument.defined, smt_any(here), one});
  return made;
}

}  // namespace durero::zed
