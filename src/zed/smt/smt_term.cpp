#include "zed/smt/smt_term.hpp"

#include <algorithm>

namespace durero::zed {
namespace {

const std::string holds_always = "true", holds_never = "false";

/// Joins formulas by an operator whose neutral part adds nothing, and whose deciding part decides the whole.
std::string joined_formulas(const std::string& by, const std::vector<std::string>& parts, const std::string& neutral,
                            const std::string& deciding) {
  std::vector<std::string> kept;
  for (const std::string& part : parts) {
    if (part == deciding) return deciding;
    if (part != neutral && std::find(kept.begin(), kept.end(), part) == kept.end()) kept.push_back(part);
  }
  if (kept.empty()) return neutral;
  return kept.size() == 1 ? kept.front() : smt_call(by, kept);
}

bool is_numeral(const std::string& text) { return text.find_first_not_of("0123456789") == text.npos; }

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
  return {SmtSort::real, is_numeral(number.text) ? number.text + ".0" : smt_call("to_real", {number.text}),
          number.defined};
}

void bring_together(SmtTerm& a, SmtTerm& b) {
  if (a.sort == SmtSort::integer && b.sort == SmtSort::integer) return;
  a = as_real(a);
  b = as_real(b);
}

// A term without a value may have any sort: nothing is equal to it, as its condition says.
std::string smt_equal(SmtTerm a, SmtTerm b) {
  if (a.defined == holds_never || b.defined == holds_never) return holds_never;
  if (is_number(a) && is_number(b)) {
    bring_together(a, b);
    return smt_call("=", {a.text, b.text});
  }
  if (a.sort != b.sort || a.type != b.type || a.parts.size() != b.parts.size() || a.names != b.names)
    throw Untranslated("values of two forms are compared");
  if (a.sort == SmtSort::atom) return smt_call("=", {a.text, b.text});
  std::vector<std::string> equal;
  for (std::size_t i = 0; i < a.parts.size(); ++i) equal.push_back(smt_equal(a.parts[i], b.parts[i]));
  return smt_all(equal);
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
