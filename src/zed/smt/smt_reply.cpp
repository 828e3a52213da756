#include "zed/smt/smt_reply.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <stdexcept>

namespace durero::zed {
namespace {

constexpr std::size_t most_nested = 64;    // lists in each other: a number has a few
constexpr std::size_t most_digits = 4096;  // of a number

bool is_blank(char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r'; }

/// The words and parentheses of a reply. A text between | or " is one word.
std::vector<std::string> tokens_of(const std::string& output) {
  std::vector<std::string> tokens;
  for (std::size_t at = 0; at < output.size();) {
    const char c = output[at];
    if (is_blank(c)) {
      ++at;
      continue;
    }
    std::size_t end = at + 1;
    if (c == '|' || c == '"')
      end = std::min(output.find(c, at + 1), output.size() - 1) + 1;
    else if (c != '(' && c != ')')
      while (end < output.size() && !is_blank(output[end]) && output[end] != '(' && output[end] != ')') ++end;
    tokens.push_back(output.substr(at, end - at));
    at = end;
  }
  return tokens;
}

/// The lists and words at the top of a reply; nothing where its parentheses do not fit, or nest too deep.
std::optional<std::vector<SmtList>> lists_of(const std::string& output) {
  std::vector<SmtList> open(1);
  for (std::string& token : tokens_of(output)) {
    if (token == "(") {
      if (open.size() > most_nested) return std::nullopt;
      open.emplace_back();
    } else if (token == ")") {
      if (open.size() == 1) return std::nullopt;
      SmtList done = std::move(open.back());
      open.pop_back();
      open.back().items.push_back(std::move(done));
    } else {
      open.back().items.push_back({std::move(token)});
    }
  }
  return open.size() == 1 ? std::optional(std::move(open.front().items)) : std::nullopt;
}

std::optional<Real> numeral_of(const std::string& word) {
  const std::size_t dot = std::min(word.find('.'), word.size());
  const std::string whole = word.substr(0, dot), rest = word.substr(std::min(dot + 1, word.size()));
  const std::string digits = whole + rest;
  if (whole.empty() || digits.size() > most_digits || digits.find_first_not_of("0123456789") != digits.npos ||
      (dot < word.size() && rest.empty()))
    return std::nullopt;
  return rest.empty() ? Real::natural(digits)
                      : Real::natural(digits) / Real::natural("1" + std::string(rest.size(), '0'));
}

/// A polynomial c + b·x + a·x².
using Quadratic = std::array<Real, 3>;
std::optional<Quadratic> polynomial_of(const SmtList& term);

std::optional<Quadratic> product_of(const Quadratic& a, const Quadratic& b) {
  Quadratic made;
  for (std::size_t i = 0; i < made.size(); ++i)
    for (std::size_t j = 0; j < made.size(); ++j) {
      const Real part = a[i] * b[j];
      if (sign(part) == 0) continue;
      if (i + j >= made.size()) return std::nullopt;
      made[i + j] = made[i + j] + part;
    }
  return made;
}

std::optional<Quadratic> operation_of(const std::string& by, const std::vector<SmtList>& items) {
  std::optional<Quadratic> made = polynomial_of(items[1]);
  if (by == "-" && items.size() == 2 && made)
    for (Real& each : *made) each = -each;
  for (std::size_t i = 2; i < items.size() && made; ++i) {
    const auto next = polynomial_of(items[i]);
    if (!next) return std::nullopt;
    if (by == "*") {
      made = product_of(*made, *next);
      continue;
    }
    for (std::size_t k = 0; k < made->size(); ++k)
      (*made)[k] = by == "+" ? (*made)[k] + (*next)[k] : (*made)[k] - (*next)[k];
  }
  return made;
}

std::optional<Quadratic> polynomial_of(const SmtList& term) {
  if (term.items.empty()) {
    if (term.word == "x") return Quadratic{Real(0), Real(1), Real(0)};
    const auto number = numeral_of(term.word);
    return number ? std::optional(Quadratic{*number, Real(0), Real(0)}) : std::nullopt;
  }
  const std::string& by = term.items[0].word;
  if (by == "^" && term.items.size() == 3 && term.items[1].word == "x") {
    if (term.items[2].word == "1") return Quadratic{Real(0), Real(1), Real(0)};
    return term.items[2].word == "2" ? std::optional(Quadratic{Real(0), Real(0), Real(1)}) : std::nullopt;
  }
  if ((by != "+" && by != "-" && by != "*") || term.items.size() < 2) return std::nullopt;
  return operation_of(by, term.items);
}

/// (root-obj P k) is the k-th real root of P, from below.
std::optional<Real> root_of(const std::vector<SmtList>& items) {
  const auto polynomial = polynomial_of(items[1]);
  if (!polynomial || sign((*polynomial)[2]) == 0) return std::nullopt;
  const auto& [c, b, a] = *polynomial;
  const Real discriminant = b * b - Real(4) * a * c;
  if (sign(discriminant) < 0) return std::nullopt;
  const Real twice = Real(2) * a, apart = square_root(discriminant / (twice * twice)), middle = -b / twice;
  const Real one = middle - apart, other = middle + apart;
  if (items[2].word == "1") return std::min(one, other);
  return items[2].word == "2" ? std::optional(std::max(one, other)) : std::nullopt;
}

std::optional<Real> number_in(const SmtList& term) {
  if (term.items.empty()) return numeral_of(term.word);
  const std::string& by = term.items[0].word;
  if (by == "root-obj" && term.items.size() == 3) return root_of(term.items);
  if (term.items.size() == 2 && (by == "-" || by == "to_real")) {
    const auto number = number_in(term.items[1]);
    return number && by == "-" ? std::optional(-*number) : number;
  }
  if (by != "/" || term.items.size() != 3) return std::nullopt;
  const auto n = number_in(term.items[1]), d = number_in(term.items[2]);
  return n && d && sign(*d) != 0 ? std::optional(*n / *d) : std::nullopt;
}

}  // namespace

std::optional<Real> number_of(const SmtList& term) {
  try {
    return number_in(term);
  } catch (const std::domain_error&) {  // it is in no field of the evaluator
    return std::nullopt;
  }
}

SmtVerdict read_reply(const std::string& output) {
  SmtVerdict verdict;
  const std::size_t begin = std::min(output.find_first_not_of(" \r\n\t"), output.size());
  const std::size_t end = std::min(output.find_first_of(" \r\n\t", begin), output.size());
  const std::string word = output.substr(begin, end - begin);
  if (word == "unsat") verdict.answer = SmtVerdict::Answer::unsat;
  if (word == "unknown") verdict.answer = SmtVerdict::Answer::unknown;
  if (word == "sat") verdict.answer = SmtVerdict::Answer::sat;
  if (verdict.answer == SmtVerdict::Answer::garbled || verdict.answer == SmtVerdict::Answer::unsat) return verdict;
  const auto lists = lists_of(output.substr(end));
  if (!lists || lists->empty()) return verdict;
  for (const SmtList& pair : lists->front().items)
    if (pair.items.size() == 2 && pair.items[0].items.empty()) verdict.values[pair.items[0].word] = pair.items[1];
  return verdict;
}

}  // namespace durero::zed
