#include "zed/smt/smt_term.hpp"

#include <algorithm>
#include <unordered_set>

#include "zed/smt/smt_slots.hpp"

namespace durero::zed {
namespace {

const std::string holds_always = "true", holds_never = "false";

/// Joins formulas by an operator whose neutral part adds nothing, and whose deciding part decides the whole.
std::string joined_formulas(const std::string& by, const std::vector<std::string>& parts, const std::string& neutral,
                            const std::string& deciding) {
  std::vector<std::string> kept;
  std::unordered_set<std::string_view> seen;
  for (const std::string& part : parts) {
    if (part == deciding) return deciding;
    if (part != neutral && seen.insert(part).second) kept.push_back(part);
  }
  if (kept.empty()) return neutral;
  return kept.size() == 1 ? kept.front() : smt_call(by, kept);
}

bool is_numeral(std::string_view text) { return !text.empty() && text.find_first_not_of("0123456789") == text.npos; }

/// The whole number that a short numeral is, with or without its sign. 15 digits keep sums of two in 64 bits.
std::optional<std::int64_t> small_numeral(std::string_view text) {
  const bool negative = text.starts_with("(- ") && text.ends_with(')');
  if (negative) text = text.substr(3, text.size() - 4);
  if (!is_numeral(text) || text.size() > 15) return std::nullopt;
  const std::int64_t size = std::stoll(std::string(text));
  return negative ? -size : size;
}

bool is_number(const SmtTerm& term) { return term.sort == SmtSort::integer || term.sort == SmtSort::real; }

/// A numeral with a sign. SMT-LIB has no negative numerals.
std::string signed_text(const std::string& digits, bool negative, bool real) {
  const std::string plain = digits + (real ? ".0" : "");
  return negative ? smt_call("-", {plain}) : plain;
}

}  // namespace

std::string smt_call(const std::string& of, const std::vector<std::string>& terms) {
  std::string text = "(" + of;
  for (const std::string& term : terms) text += " " + term;
  return text + ")";
}

std::string smt_all(const std::vector<std::string>& parts) {
  return joined_formulas("and", parts, holds_always, holds_never);
}

std::string smt_any(const std::vector<std::string>& parts) {
  return joined_formulas("or", parts, holds_never, holds_always);
}

std::string smt_not(const std::string& formula) {
  if (formula == holds_always) return holds_never;
  return formula == holds_never ? holds_always : smt_call("not", {formula});
}

std::string smt_implied(const std::string& from, const std::string& to) { return smt_any({smt_not(from), to}); }

std::string smt_choice(const std::string& condition, const std::string& yes, const std::string& no) {
  if (condition == holds_always || yes == no) return yes;
  if (condition == holds_never) return no;
  if (yes == holds_always) return smt_any({condition, no});
  return no == holds_never ? smt_all({condition, yes}) : smt_call("ite", {condition, yes, no});
}

SmtTerm as_integer(const SmtTerm& number) {
  if (!is_number(number)) throw Untranslated("a number is expected of what is none");
  if (number.sort == SmtSort::integer) return number;
  SmtTerm whole{SmtSort::integer, smt_call("to_int", {number.text})};
  whole.defined = smt_all({number.defined, smt_call("is_int", {number.text})});
  return whole;
}

SmtTerm as_real(const SmtTerm& number) {
  if (!is_number(number)) throw Untranslated("a number is expected of what is none");
  if (number.sort == SmtSort::real) return number;
  if (const auto known = small_numeral(number.text))
    return {SmtSort::real, signed_text(std::to_string(std::abs(*known)), *known < 0, true), number.defined};
  return {SmtSort::real, is_numeral(number.text) ? number.text + ".0" : smt_call("to_real", {number.text}),
          number.defined};
}

void bring_together(SmtTerm& a, SmtTerm& b) {
  if (a.sort == SmtSort::integer && b.sort == SmtSort::integer) return;
  a = as_real(a);
  b = as_real(b);
}

namespace {

/// Says that two texts are equal. Short constants are compared at once.
std::string equal_texts(const std::string& a, const std::string& b) {
  constexpr std::size_t most_short = 64;
  if (a == b) return holds_always;
  if (a.size() > most_short || b.size() > most_short) return smt_call("=", {a, b});
  const auto left = smt_constant(a), right = smt_constant(b);
  if (!left || !right) return smt_call("=", {a, b});
  return *left == *right ? holds_always : holds_never;
}

std::string equal_sets(const SmtTerm& a, const SmtTerm& b) {
  limit_text(a.parts.size() * text_size(b) + b.parts.size() * text_size(a));
  return smt_all({subset_of_slots(a, b), subset_of_slots(b, a)});
}

}  // namespace

// A term without a value may have any sort: nothing is equal to it, as its condition says.
std::string smt_equal(SmtTerm a, SmtTerm b) {
  if (a.defined == holds_never || b.defined == holds_never) return holds_never;
  if (is_number(a) && is_number(b)) {
    bring_together(a, b);
    return equal_texts(a.text, b.text);
  }
  if (a.sort == SmtSort::set && b.sort == SmtSort::set) return equal_sets(a, b);
  if (a.sort != b.sort || a.type != b.type || a.parts.size() != b.parts.size() || a.names != b.names)
    throw Untranslated("values of two forms are compared");
  if (a.sort == SmtSort::atom) return equal_texts(a.text, b.text);
  std::vector<std::string> equal;
  for (std::size_t i = 0; i < a.parts.size(); ++i) equal.push_back(smt_equal(a.parts[i], b.parts[i]));
  return smt_all(equal);
}

std::string smt_compare(const std::string& by, const std::string& a, const std::string& b) {
  const auto left = small_numeral(a), right = small_numeral(b);
  if (!left || !right) return smt_call(by, {a, b});
  return (by == "<" ? *left < *right : *left <= *right) ? holds_always : holds_never;
}

std::string smt_plus(const std::string& a, const std::string& b) {
  const auto left = small_numeral(a), right = small_numeral(b);
  if (left && right) return signed_text(std::to_string(std::abs(*left + *right)), *left + *right < 0, false);
  return b == "0" ? a : smt_call("+", {a, b});
}

std::string smt_minus(const std::string& a, const std::string& b) {
  const auto left = small_numeral(a), right = small_numeral(b);
  if (left && right) return signed_text(std::to_string(std::abs(*left - *right)), *left < *right, false);
  return b == "0" ? a : smt_call("-", {a, b});
}

namespace {

/// Has the members of one set or of the other.
SmtTerm chosen_set(const std::string& condition, const SmtTerm& yes, const SmtTerm& no) {
  SmtTerm made{SmtSort::set};
  made.defined = smt_choice(condition, yes.defined, no.defined);
  for (std::size_t i = 0; i < yes.parts.size(); ++i) add_slot(made, yes.parts[i], smt_all({condition, yes.present[i]}));
  for (std::size_t i = 0; i < no.parts.size(); ++i)
    add_slot(made, no.parts[i], smt_all({smt_not(condition), no.present[i]}));
  made.function = yes.function && no.function;
  made.sequence = yes.sequence && no.sequence;
  return merged_slots(std::move(made));
}

}  // namespace

SmtTerm smt_chosen(const std::string& condition, SmtTerm yes, SmtTerm no) {
  const auto take_form = [](SmtTerm& of, const SmtTerm& other) {
    of = other;
    of.defined = "false";
  };
  if (yes.defined == holds_never)
    take_form(yes, no);
  else if (no.defined == holds_never)
    take_form(no, yes);
  if (yes.sort == SmtSort::set && no.sort == SmtSort::set) return chosen_set(condition, yes, no);
  if (is_number(yes) && is_number(no)) bring_together(yes, no);
  if (yes.sort != no.sort || yes.type != no.type || yes.parts.size() != no.parts.size() || yes.names != no.names)
    throw Untranslated("values of two forms are the sides of one choice");
  SmtTerm made = yes;
  made.defined = smt_choice(condition, yes.defined, no.defined);
  if (made.parts.empty()) made.text = smt_choice(condition, yes.text, no.text);
  for (std::size_t i = 0; i < made.parts.size(); ++i) made.parts[i] = smt_chosen(condition, yes.parts[i], no.parts[i]);
  return made;
}

void limit_text(std::size_t characters) {
  if (characters > most_smt_text) throw Untranslated("what it stands for is too long");
}

std::size_t text_size(const SmtTerm& term) {
  std::size_t size = term.text.size() + term.defined.size();
  for (const std::string& each : term.present) size += each.size();
  for (const SmtTerm& part : term.parts) size += text_size(part);
  return size;
}

std::optional<Real> smt_constant(const std::string& text) {
  const auto inside = [&](std::size_t from) { return text.substr(from, text.size() - from - 1); };
  if (is_numeral(text)) return Real::natural(text);
  if (text.ends_with(".0") && is_numeral(std::string_view(text).substr(0, text.size() - 2)))
    return Real::natural(text.substr(0, text.size() - 2));
  if (!text.ends_with(')')) return std::nullopt;
  if (text.starts_with("(- ")) {
    const auto number = smt_constant(inside(3));
    return number ? std::optional(-*number) : std::nullopt;
  }
  const std::size_t last = text.rfind(' ');
  if (!text.starts_with("(/ ") || last <= 3) return std::nullopt;
  const auto n = smt_constant(text.substr(3, last - 3)), d = smt_constant(inside(last + 1));
  return n && d && sign(*d) > 0 ? std::optional(*n / *d) : std::nullopt;
}

SmtTerm smt_number(const Real& number) {
  std::string text = number.text();
  if (text.find_first_not_of("-/0123456789") != text.npos) throw Untranslated(text + " is not rational");
  const bool negative = text.starts_with('-');
  if (negative) text.erase(0, 1);
  const std::size_t slash = text.find('/');
  if (slash == text.npos) return {SmtSort::integer, signed_text(text, negative, false)};
  return {SmtSort::real, smt_call("/", {signed_text(text.substr(0, slash), negative, true),
                                        signed_text(text.substr(slash + 1), false, true)})};
}

}  // namespace durero::zed
