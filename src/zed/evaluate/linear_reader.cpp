/// Reads the linear conditions in the predicate of a quantifier.

#include <algorithm>

#include "zed/evaluate/linear_question.hpp"
#include "zed/evaluate/said_by_exists.hpp"
#include "zed/syntax/match.hpp"
#include "zed/value/integer_lines.hpp"

namespace durero::zed {
namespace {

using FormulaKind = LinearFormula::Kind;

/// The set of whole numbers from one form to another, either of which may be without end.
struct WholeNumberRange {
  std::optional<FormCode> low{}, high{};
};

FormCode constant_form(int value) {
  return [value](Frame&) {
    IntegerForm form;
    form.constant = value;
    return std::optional(form);
  };
}

/// a + times · b
FormCode combined_form(FormCode a, FormCode b, int times) {
  return [a = std::move(a), b = std::move(b), times](Frame& frame) -> std::optional<IntegerForm> {
    auto left = a(frame);
    const auto right = left ? b(frame) : std::nullopt;
    if (!right) return std::nullopt;
    left->add(*right, times);
    return left;
  };
}

/// a · b, one of which has no variable.
FormCode product_form(FormCode a, FormCode b) {
  return [a = std::move(a), b = std::move(b)](Frame& frame) -> std::optional<IntegerForm> {
    const auto left = a(frame), right = left ? b(frame) : std::nullopt;
    if (!right || (!left->coefficients.empty() && !right->coefficients.empty())) return std::nullopt;
    const bool is_right_constant = right->coefficients.empty();
    IntegerForm product;
    product.add(is_right_constant ? *left : *right, is_right_constant ? right->constant : left->constant);
    return product;
  };
}

/// The number that an expression has, where it is a whole one.
FormCode known_form(Code code) {
  return [code = std::move(code)](Frame& frame) -> std::optional<IntegerForm> {
    try {
      const Value value = code(frame);
      const Real* real = value.real();
      if (!real || !real->is_integer()) return std::nullopt;
      IntegerForm form;
      form.constant = numerator(real->surd().x);
      return form;
    } catch (const EvaluationError&) {
      return std::nullopt;
    }
  };
}

/// The line that a function is; nothing where it is none, or has no value.
std::optional<IntegerLine> known_line(const Code& function, Frame& frame) {
  try {
    return integer_line(function(frame), frame.context);
  } catch (const EvaluationError&) {
    return std::nullopt;
  }
}

/// The value of a function that is a line.
FormCode applied_form(Code function, FormCode argument) {
  return [function = std::move(function), argument = std::move(argument)](Frame& frame) -> std::optional<IntegerForm> {
    const auto line = known_line(function, frame);
    const auto at = line ? argument(frame) : std::nullopt;
    if (!at) return std::nullopt;
    IntegerForm value;
    value.add(*at, numerator(line->slope.surd().x));
    value.constant += numerator(line->constant.surd().x);
    return value;
  };
}

/// The least number at which a function that is a line has a value; the argument itself where it has one at each.
FormCode least_argument(Code function, FormCode argument) {
  return [function = std::move(function), argument = std::move(argument)](Frame& frame) -> std::optional<IntegerForm> {
    const auto line = known_line(function, frame);
    if (!line) return std::nullopt;
    return line->least ? constant_form(*line->least)(frame) : argument(frame);
  };
}

LinearFormula not_known() { return {.kind = FormulaKind::unknown}; }
LinearFormula joined_formula(FormulaKind kind, std::vector<LinearFormula> parts) {
  return {.kind = kind, .parts = std::move(parts)};
}

/// a ≤ b, or a < b: a − b + 1 ≤ 0 of whole numbers.
LinearFormula at_most_formula(const FormCode& a, const FormCode& b, bool strict = false) {
  const FormCode difference = combined_form(a, b, -1);
  return {.kind = FormulaKind::at_most, .form = strict ? combined_form(difference, constant_form(1), 1) : difference};
}

/// Says whether an expression binds no names and includes no schema, so that each name of it stands there.
bool is_plain_expression(const Term& term) {
  const Kind kind = term->kind;
  const bool plain = kind == Kind::reference || kind == Kind::number || kind == Kind::application ||
                     kind == Kind::tuple || kind == Kind::selection || kind == Kind::tuple_selection ||
                     kind == Kind::set_extension;
  return plain && std::all_of(term->children.begin(), term->children.end(), is_plain_expression);
}

class LinearReader {
 public:
  explicit LinearReader(const LinearSurroundings& around) : around_(around) {}

  std::shared_ptr<const LinearQuestion> question(const Node& quantifier) {
    if (std::none_of(quantifier.text->declarations.begin(), quantifier.text->declarations.end(),
                     [&](const Declaration& each) { return is_of_integers(each); }))
      return nullptr;
    applied_.clear();
    LinearFormula formula = some(quantifier);
    std::vector<std::pair<unsigned, unsigned>> slots;
    bool is_whole = true;
    for (const auto& [name, variable] : quantified_of_outermost_) {
      if (variable) slots.emplace_back(*variable, around_.slot(name));
      is_whole = is_whole && variable.has_value();
    }
    return std::make_shared<const LinearQuestion>(std::move(formula), std::move(slots), is_whole);
  }

 private:
  using Quantified = std::vector<std::pair<Name, std::optional<unsigned>>>;

  bool is_of_integers(const Declaration& declaration) {
    return declaration.form == Declaration::Form::typed && range(declaration.term);
  }

  /// The formula that some values satisfy the text, and make the body true under ∃, and false under ∀.
  LinearFormula some(const Node& quantifier, std::vector<unsigned>* variables = nullptr) {
    const std::size_t outer = quantified_.size();
    std::vector<LinearFormula> parts;
    Quantified inner;
    for (const Declaration& declaration : quantifier.text->declarations) declare(declaration, inner, parts);
    quantified_.insert(quantified_.end(), inner.begin(), inner.end());
    if (outer == 0) quantified_of_outermost_ = inner;
    for (const auto& [name, variable] : inner)
      if (variables && variable) variables->push_back(*variable);
    for (const Predicate& predicate : quantifier.text->predicates) parts.push_back(formula(predicate.term, true));
    parts.push_back(formula(quantifier.children[0], quantifier.kind == Kind::exists));
    quantified_.resize(outer);
    return joined_formula(FormulaKind::all, std::move(parts));
  }

  /// The sets of a text are read outside it.
  void declare(const Declaration& declaration, Quantified& inner, std::vector<LinearFormula>& parts) {
    const std::size_t before = applied_.size();
    const auto of = declaration.form == Declaration::Form::typed ? range(declaration.term) : std::nullopt;
    parts.push_back(defined_since(before, true));
    const std::vector<Name> names =
        declaration.form == Declaration::Form::included ? around_.components(declaration) : declaration.names;
    if (!of) parts.push_back(not_known());
    for (const Name& name : names) {
      // A name that is declared twice has both sets; the first is enough to know what it is.
      const bool again = std::any_of(inner.begin(), inner.end(), [&](const auto& each) { return each.first == name; });
      if (again) parts.push_back(not_known());
      if (again) continue;
      inner.emplace_back(name, of ? std::optional(next_++) : std::nullopt);
      if (of) parts.push_back(in_range(variable_form(*inner.back().second), *of, true));
    }
  }

  static FormCode variable_form(unsigned variable) {
    return [variable](Frame&) {
      IntegerForm form;
      form.coefficients[variable] = 1;
      return std::optional(form);
    };
  }

  /// The range that a set is; nothing where it is no such set. Each member of it is a whole number.
  std::optional<WholeNumberRange> range(const Term& set) {
    if (set->kind == Kind::reference && set->children.empty() && !is_quantified(set->name)) {
      const std::string word = set->name.text();
      if (!around_.is_toolkit(set->name)) {
        const Term* of = around_.abbreviated(set->name);
        return of && is_numeral_range(*of) ? range(*of) : std::nullopt;
      }
      if (word == "ℤ") return WholeNumberRange{};
      if (word == "ℕ") return WholeNumberRange{constant_form(0), {}};
      if (word == "ℕ₁") return WholeNumberRange{constant_form(1), {}};
      return std::nullopt;
    }
    const Node* ends = toolkit_operands(set, "_‥_");
    if (!ends) return std::nullopt;
    const auto low = form(ends->children[0]), high = form(ends->children[1]);
    return low && high ? std::optional(WholeNumberRange{low, high}) : std::nullopt;
  }

  /// Says whether the term means the same where it stands and here: a set of the toolkit, or a range of numerals.
  bool is_numeral_range(const Term& term) const {
    if (term->kind == Kind::reference) return around_.is_toolkit(term->name);
    const Node* ends = toolkit_operands(term, "_‥_");
    return ends && ends->children[0]->kind == Kind::number && ends->children[1]->kind == Kind::number;
  }

  bool is_quantified(const Name& name) const {
    return std::any_of(quantified_.begin(), quantified_.end(), [&](const auto& each) { return each.first == name; });
  }

  const Node* toolkit_operands(const Term& term, std::string_view word) const {
    const Node* pair = match::operands(term, word);
    return pair && is_operator(term) ? pair : nullptr;
  }
  bool is_operator(const Term& application) const {
    const Name& name = application->children[0]->name;
    return !is_quantified(name) && around_.is_toolkit(name);
  }

  /// The linear form that an expression is; nothing where it is none.
  std::optional<FormCode> form(const Term& term) {
    if (term->kind == Kind::reference && term->children.empty())
      for (auto each = quantified_.rbegin(); each != quantified_.rend(); ++each)
        if (each->first == term->name) return each->second ? std::optional(variable_form(*each->second)) : std::nullopt;
    if (is_plain_expression(term) && !mentions_quantified(term)) return known_form(around_.code(term));
    if (const Term* of = match::argument_of(term, "-_"); of && is_operator(term)) {
      const auto value = form(*of);
      return value ? std::optional(combined_form(constant_form(0), *value, -1)) : std::nullopt;
    }
    for (const char* word : {"_+_", "_-_", "_*_"}) {
      const Node* pair = toolkit_operands(term, word);
      if (!pair) continue;
      const auto left = form(pair->children[0]), right = left ? form(pair->children[1]) : std::nullopt;
      if (!right) return std::nullopt;
      if (word[1] == '*') return product_form(*left, *right);
      return combined_form(*left, *right, word[1] == '-' ? -1 : 1);
    }
    return term->kind == Kind::application ? application(term) : std::nullopt;
  }

  /// f x of a function f that is known, and may be a line then. It has a value where x is in the domain of f.
  std::optional<FormCode> application(const Term& term) {
    const Term& function = term->children[0];
    if (!is_plain_expression(function) || mentions_quantified(function)) return std::nullopt;
    const auto argument = form(term->children[1]);
    const auto code = argument ? code_of(function) : std::nullopt;
    if (!code) return std::nullopt;
    applied_.emplace_back(least_argument(*code, *argument), *argument);
    return applied_form(*code, *argument);
  }

  /// The code of an expression; nothing where the evaluator has none.
  std::optional<Code> code_of(const Term& term) const {
    try {
      return around_.code(term);
    } catch (const EvaluationError&) {
      return std::nullopt;
    }
  }

  /// The applications that were read since then have values; or one of them has none.
  LinearFormula defined_since(std::size_t before, bool holds) {
    std::vector<LinearFormula> parts;
    for (std::size_t i = before; i < applied_.size(); ++i)
      parts.push_back(compared_forms(applied_[i].first, applied_[i].second, holds));
    applied_.resize(before);
    return joined_formula(holds ? FormulaKind::all : FormulaKind::any, std::move(parts));
  }

  bool mentions_quantified(const Term& term) const {
    bool some = false;
    match::each_name(term, [&](const Name& name) { some = some || is_quantified(name); });
    return some;
  }

  /// The conditions that follow from the truth of a predicate, or from its falsity.
  LinearFormula formula(const Term& term, bool holds) {
    const Node& node = *term;
    const auto part = [&](std::size_t i, bool is_true) { return formula(node.children[i], is_true); };
    const auto both = [&](FormulaKind kind, bool first, bool second) {
      return joined_formula(kind, {part(0, first), part(1, second)});
    };
    if (node.kind == Kind::truth || node.kind == Kind::falsity)
      return joined_formula((node.kind == Kind::truth) == holds ? FormulaKind::all : FormulaKind::any, {});
    if (node.kind == Kind::negation) return part(0, !holds);
    if (node.kind == Kind::conjunction) return both(holds ? FormulaKind::all : FormulaKind::any, holds, holds);
    if (node.kind == Kind::disjunction) return both(holds ? FormulaKind::any : FormulaKind::all, holds, holds);
    if (node.kind == Kind::implication) return both(holds ? FormulaKind::any : FormulaKind::all, !holds, holds);
    if (node.kind == Kind::equivalence)
      return joined_formula(FormulaKind::any,
                            {both(FormulaKind::all, true, holds), both(FormulaKind::all, false, !holds)});
    if (node.kind == Kind::relation) return relation(node, holds);
    if (node.kind == Kind::exists_one) {
      const auto same = around_.just_one(node);
      return same ? formula(*same, holds) : not_known();
    }
    if (node.kind != Kind::exists && node.kind != Kind::forall) return not_known();
    if ((node.kind == Kind::exists) == holds) return some(node);
    LinearFormula none{.kind = FormulaKind::none_such};
    none.parts.push_back(some(node, &none.bound));
    return none;
  }

  LinearFormula relation(const Node& node, bool holds) {
    if (node.children.size() != node.names.size() + 1) return not_known();
    const auto is_toolkit = [this](const Name& name) { return !is_quantified(name) && around_.is_toolkit(name); };
    if (const auto same = emptiness_by_exists(node, is_toolkit)) return formula(*same, holds);
    std::vector<LinearFormula> links;
    for (std::size_t i = 0; i < node.names.size(); ++i)
      links.push_back(link(node.names[i], node.children[i], node.children[i + 1], holds));
    return joined_formula(holds ? FormulaKind::all : FormulaKind::any, std::move(links));
  }

  /// A relation holds of values alone: it is false where an operand has none.
  LinearFormula link(const Name& name, const Term& left, const Term& right, bool holds) {
    const std::size_t before = applied_.size();
    LinearFormula of_values = link_of_values(name, left, right, holds);
    if (applied_.size() == before) return of_values;
    std::vector<LinearFormula> parts{std::move(of_values)};
    parts.push_back(defined_since(before, holds));
    return joined_formula(holds ? FormulaKind::all : FormulaKind::any, std::move(parts));
  }

  LinearFormula link_of_values(const Name& name, const Term& left, const Term& right, bool holds) {
    const std::string word = name.text();
    const auto a = form(left);
    if (!a || is_quantified(name) || !around_.is_toolkit(name)) return not_known();
    if (word == "_∈_" || word == "_∉_") {
      const auto of = range(right);
      return of ? in_known_range(*a, *of, (word == "_∈_") == holds) : not_known();
    }
    const auto b = form(right);
    if (!b) return not_known();
    if (word == "_≤_" || word == "_>_") return compared_forms(*a, *b, (word == "_≤_") == holds);
    if (word == "_≥_" || word == "_<_") return compared_forms(*b, *a, (word == "_≥_") == holds);
    if (word != "_=_" && word != "_≠_") return not_known();
    if ((word == "_=_") == holds)
      return joined_formula(FormulaKind::all, {at_most_formula(*a, *b), at_most_formula(*b, *a)});
    return joined_formula(FormulaKind::any, {at_most_formula(*a, *b, true), at_most_formula(*b, *a, true)});
  }

  /// a ≤ b, or else a > b.
  static LinearFormula compared_forms(const FormCode& a, const FormCode& b, bool holds) {
    return holds ? at_most_formula(a, b) : at_most_formula(b, a, true);
  }

  static LinearFormula in_range(const FormCode& form, const WholeNumberRange& range, bool holds) {
    std::vector<LinearFormula> parts;
    if (range.low) parts.push_back(compared_forms(*range.low, form, holds));
    if (range.high) parts.push_back(compared_forms(form, *range.high, holds));
    return joined_formula(holds ? FormulaKind::all : FormulaKind::any, std::move(parts));
  }

  /// The formula in_range() of an expression that may be no whole number: nothing is known then.
  static LinearFormula in_known_range(const FormCode& form, const WholeNumberRange& range, bool holds) {
    LinearFormula formula = in_range(form, range, holds);
    // Of a whole number a ≤ a is true, and a < a is false, so that the formula is the same; of others neither is known.
    formula.parts.push_back(at_most_formula(form, form, !holds));
    return formula;
  }

  const LinearSurroundings& around_;
  Quantified quantified_, quantified_of_outermost_;
  std::vector<std::pair<FormCode, FormCode>> applied_;  // the least argument of each application, and its argument
  unsigned next_ = 0;
};

}  // namespace

std::shared_ptr<const LinearQuestion> linear_question(const Node& quantifier, const LinearSurroundings& around) {
  return LinearReader(around).question(quantifier);
}

}  // namespace durero::zed
