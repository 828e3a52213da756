#include "zed/smt/smt_slots.hpp"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

namespace durero::zed {
namespace {

/// A text that two terms share only if they are equal.
void write_key(const SmtTerm& term, std::string& key) {
  key += std::to_string(static_cast<int>(term.sort)) + '\n' + term.text + '\n' + term.type + '\n';
  for (std::size_t i = 0; i < term.parts.size(); ++i) {
    if (i < term.present.size()) key += term.present[i] + '\n';
    write_key(term.parts[i], key);
  }
  key += ")\n";
}

bool is_constant(const SmtTerm& term) {
  if (term.sort == SmtSort::set) return false;
  if (term.parts.empty()) return smt_constant(term.text).has_value();
  for (const SmtTerm& part : term.parts)
    if (!is_constant(part)) return false;
  return true;
}

bool is_pair(const SmtTerm& term) { return term.sort == SmtSort::tuple && term.parts.size() == 2; }

/// Says whether all members are pairs whose first parts are constants that differ.
bool begin_by_constants(const SmtTerm& set) {
  std::unordered_set<std::string> seen;
  for (const SmtTerm& part : set.parts) {
    if (!is_pair(part) || !is_constant(part.parts[0])) return false;
    std::string key;
    write_key(part.parts[0], key);
    if (!seen.insert(std::move(key)).second) return false;
  }
  return true;
}

/// Says of each two slots whose members share the part `by` that they share the other.
std::string one_to_one(const SmtTerm& set, std::size_t by) {
  limit_text(set.parts.size() * text_size(set));
  std::vector<std::string> facts;
  for (std::size_t i = 0; i < set.parts.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const SmtTerm &a = set.parts[i], &b = set.parts[j];
      const std::string alike =
          smt_all({set.present[i], set.present[j], smt_equal(pair_part(a, by), pair_part(b, by))});
      if (alike != "false") facts.push_back(smt_implied(alike, smt_equal(pair_part(a, 1 - by), pair_part(b, 1 - by))));
    }
  return smt_all(facts);
}

/// The least or greatest member is the one that all others are at least, or at most.
SmtTerm extreme_of_slots(const SmtTerm& numbers, bool greatest) {
  SmtTerm set = as_slots(numbers);
  bool real = false;
  for (const SmtTerm& part : set.parts) real = real || part.sort == SmtSort::real;
  for (SmtTerm& part : set.parts) part = real ? as_real(part) : as_integer(part);
  limit_text(set.parts.size() * text_size(set));
  SmtTerm made{real ? SmtSort::real : SmtSort::integer, real ? "0.0" : "0"};
  for (std::size_t i = set.parts.size(); i-- > 0;) {
    std::vector<std::string> facts = {set.present[i]};
    const std::string& here = set.parts[i].text;
    for (std::size_t j = 0; j < set.parts.size(); ++j) {
      const std::string& other = set.parts[j].text;
      if (j != i)
        facts.push_back(
            smt_implied(set.present[j], smt_compare("<=", greatest ? other : here, greatest ? here : other)));
    }
    made.text = i + 1 == set.parts.size() ? here : smt_choice(smt_all(facts), here, made.text);
  }
  made.defined = smt_all({set.defined, slots_have_member(set)});
  return made;
}

}  // namespace

SmtTerm as_slots(const SmtTerm& set) {
  if (set.sort == SmtSort::set) return set;
  if (set.defined != "false") throw Untranslated("a set is expected of what is none");
  SmtTerm none{SmtSort::set};
  none.defined = "false";
  return none;
}

bool have_one_text(const SmtTerm& a, const SmtTerm& b) {
  std::string one, other;
  write_key(a, one);
  write_key(b, other);
  return one == other;
}

void add_slot(SmtTerm& set, SmtTerm member, const std::string& present) {
  set.present.push_back(smt_all({present, member.defined}));
  member.defined = "true";
  set.parts.push_back(std::move(member));
}

SmtTerm merged_slots(SmtTerm set) {
  limit_text(text_size(set));
  std::unordered_map<std::string, std::size_t> places;
  std::vector<SmtTerm> parts;
  std::vector<std::vector<std::string>> present;
  for (std::size_t i = 0; i < set.parts.size(); ++i) {
    if (set.present[i] == "false") continue;
    std::string key;
    write_key(set.parts[i], key);
    const auto [at, fresh] = places.emplace(std::move(key), parts.size());
    if (fresh) {
      parts.push_back(std::move(set.parts[i]));
      present.emplace_back();
    }
    present[at->second].push_back(std::move(set.present[i]));
  }
  set.parts = std::move(parts);
  set.present.clear();
  for (const auto& each : present) set.present.push_back(smt_any(each));
  set.function = set.function || begin_by_constants(set);
  return set;
}

std::string in_slots(const SmtTerm& element, const SmtTerm& set) {
  limit_text(set.parts.size() * text_size(element) + text_size(set));
  std::vector<std::string> one;
  for (std::size_t i = 0; i < set.parts.size(); ++i)
    one.push_back(smt_all({set.present[i], smt_equal(element, set.parts[i])}));
  return smt_any(one);
}

std::string subset_of_slots(const SmtTerm& a, const SmtTerm& b) {
  std::vector<std::string> facts;
  for (std::size_t i = 0; i < a.parts.size(); ++i) facts.push_back(smt_implied(a.present[i], in_slots(a.parts[i], b)));
  return smt_all(facts);
}

std::string slots_are_function(const SmtTerm& set) { return set.function ? "true" : one_to_one(set, 0); }

std::string slots_are_injective(const SmtTerm& set) { return one_to_one(set, 1); }

std::string slots_have_member(const SmtTerm& set) { return smt_any(set.present); }

std::string slots_are_disjoint(const SmtTerm& family) {
  limit_text(family.parts.size() * text_size(family));
  std::vector<std::string> facts;
  for (std::size_t i = 0; i < family.parts.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const SmtTerm &a = family.parts[i], &b = family.parts[j];
      const std::string two =
          smt_all({family.present[i], family.present[j], smt_not(smt_equal(pair_part(a, 0), pair_part(b, 0)))});
      const SmtTerm sets = as_slots(pair_part(b, 1));
      const SmtTerm shared =
          slots_where(as_slots(pair_part(a, 1)), [&](const SmtTerm& x) { return in_slots(x, sets); });
      facts.push_back(smt_not(smt_all({two, slots_have_member(shared)})));
    }
  return smt_all(facts);
}

SmtTerm slots_where(const SmtTerm& set, const std::function<std::string(const SmtTerm&)>& condition) {
  SmtTerm made = set;
  made.sequence = false;
  for (std::size_t i = 0; i < made.parts.size(); ++i)
    made.present[i] = smt_all({made.present[i], condition(made.parts[i])});
  return merged_slots(std::move(made));
}

const SmtTerm& pair_part(const SmtTerm& pair, std::size_t part) {
  if (!is_pair(pair)) throw Untranslated("a pair is expected of what is none");
  return pair.parts[part];
}

SmtTerm pair_of(SmtTerm first, SmtTerm second) {
  SmtTerm made{SmtSort::tuple};
  made.defined = smt_all({first.defined, second.defined});
  made.parts = {std::move(first), std::move(second)};
  return made;
}

SmtTerm union_of_slots(const SmtTerm& a, const SmtTerm& b) {
  SmtTerm made = a;
  made.defined = smt_all({a.defined, b.defined});
  made.parts.insert(made.parts.end(), b.parts.begin(), b.parts.end());
  made.present.insert(made.present.end(), b.present.begin(), b.present.end());
  made.function = made.sequence = false;
  return merged_slots(std::move(made));
}

SmtTerm difference_of_slots(const SmtTerm& a, const SmtTerm& b) {
  limit_text(a.parts.size() * text_size(b) + b.parts.size() * text_size(a));
  SmtTerm made = slots_where(a, [&](const SmtTerm& part) { return smt_not(in_slots(part, b)); });
  made.defined = smt_all({a.defined, b.defined});
  return made;
}

SmtTerm symmetric_difference_of_slots(const SmtTerm& a, const SmtTerm& b) {
  return union_of_slots(difference_of_slots(a, b), difference_of_slots(b, a));
}

SmtTerm union_in_slots(const SmtTerm& sets) {
  const SmtTerm outer = as_slots(sets);
  SmtTerm made{SmtSort::set};
  made.defined = outer.defined;
  for (std::size_t i = 0; i < outer.parts.size(); ++i) {
    const SmtTerm inner = as_slots(outer.parts[i]);
    for (std::size_t j = 0; j < inner.parts.size(); ++j)
      add_slot(made, inner.parts[j], smt_all({outer.present[i], inner.present[j]}));
  }
  return merged_slots(std::move(made));
}

SmtTerm product_of_slots(const std::vector<SmtTerm>& sets) {
  constexpr std::size_t most = 2048;
  SmtTerm made{SmtSort::set};
  add_slot(made, {SmtSort::tuple}, "true");
  for (const SmtTerm& each : sets) {
    SmtTerm longer{SmtSort::set};
    longer.defined = smt_all({made.defined, each.defined});
    if (made.parts.size() * each.parts.size() > most) throw Untranslated("a product has too many members");
    for (std::size_t i = 0; i < made.parts.size(); ++i)
      for (std::size_t j = 0; j < each.parts.size(); ++j) {
        SmtTerm tuple = made.parts[i];
        tuple.parts.push_back(each.parts[j]);
        add_slot(longer, std::move(tuple), smt_all({made.present[i], each.present[j]}));
      }
    made = std::move(longer);
  }
  return merged_slots(std::move(made));
}

// Members of a function are equal where they begin alike.
std::vector<std::string> first_in_slots(const SmtTerm& set) {
  const auto known_by = [&](std::size_t i) -> const SmtTerm& {
    return set.function ? pair_part(set.parts[i], 0) : set.parts[i];
  };
  const auto computed =
      std::count_if(set.parts.begin(), set.parts.end(), [](const auto& each) { return !is_constant(each); });
  limit_text(static_cast<std::size_t>(computed) * text_size(set));  // constants are compared at once
  std::vector<std::string> made;
  for (std::size_t i = 0; i < set.parts.size(); ++i) {
    std::vector<std::string> here = {set.present[i]};
    for (std::size_t j = 0; j < i; ++j)
      here.push_back(smt_not(smt_all({set.present[j], smt_equal(known_by(i), known_by(j))})));
    made.push_back(smt_all(here));
  }
  return made;
}

std::string count_of(const std::vector<std::string>& conditions) {
  std::vector<std::string> terms;
  int known = 0;
  for (const std::string& each : conditions) {
    if (each == "true") ++known;
    if (each != "true" && each != "false") terms.push_back(smt_call("ite", {each, "1", "0"}));
  }
  if (terms.empty()) return std::to_string(known);
  if (known > 0) terms.push_back(std::to_string(known));
  return terms.size() == 1 ? terms.front() : smt_call("+", terms);
}

SmtTerm size_of_slots(const SmtTerm& set) { return {SmtSort::integer, count_of(first_in_slots(set)), set.defined}; }

SmtTerm least_of_slots(const SmtTerm& set) { return extreme_of_slots(set, false); }

SmtTerm greatest_of_slots(const SmtTerm& set) { return extreme_of_slots(set, true); }

SmtTerm interval_in_slots(const SmtTerm& from, const SmtTerm& to, std::size_t slots) {
  const SmtTerm first = as_integer(from), last = as_integer(to);
  SmtTerm made{SmtSort::set};
  for (std::size_t i = 0; i < slots; ++i) {
    SmtTerm here{SmtSort::integer, smt_plus(first.text, std::to_string(i))};
    const std::string present = smt_compare("<=", here.text, last.text);
    add_slot(made, std::move(here), present);
  }
  const std::string fits = smt_compare("<", last.text, smt_plus(first.text, std::to_string(slots)));
  made.defined = smt_all({first.defined, last.defined, fits});
  return merged_slots(std::move(made));
}

}  // namespace durero::zed
