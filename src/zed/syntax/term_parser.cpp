#include "zed/syntax/term_parser.hpp"

#include <fmt/core.h>

#include <utility>

#include "zed/syntax/spivey_binding.hpp"

namespace durero::zed {
namespace {

/// Counts the depth of the recursion for a scope.
class ParsingDepth {
 public:
  ParsingDepth(unsigned& depth, Place place) : depth_(depth) {
    if (++depth_ > max_depth) {
      --depth_;
      throw ZError(place, fmt::format("the text nests deeper than {} levels", max_depth), "expected less nesting");
    }
  }
  ~ParsingDepth() { --depth_; }
  ParsingDepth(const ParsingDepth&) = delete;
  ParsingDepth& operator=(const ParsingDepth&) = delete;

 private:
  unsigned& depth_;
};

constexpr std::string_view named_relation = "\\inrel";

/// An operator of a template binds like those of its kind in the toolkit.
int own_strength(const OperatorTemplate& op) {
  if (op.role == Role::relation) return binding::relation;
  if (op.has_left() && op.has_right()) return binding::infix + op.precedence;
  return op.has_left() ? binding::postfix : binding::prefix;
}

}  // namespace

Term TermParser::checked(Term term) const {
  if (term->depth > max_depth)
    throw ZError(term->place, fmt::format("the text nests deeper than {} levels", max_depth), "expected less nesting");
  return term;
}

Term TermParser::term(int least, Sort sort) {
  const ParsingDepth deeper(depth_, in_.peek().place);
  const std::size_t from = in_.position();
  Making made;
  Term left = leading(made, sort);
  const auto takes_relation = [=] { return binding::relation >= least && sort == Sort::any; };
  for (;;) {
    const Token& token = in_.peek();
    const std::size_t sign_at = in_.position();
    bool otherwise = false;
    if (token.type != Token::Type::symbol && token.type != Token::Type::word) break;
    if (const Connective* connective = token.symbol->connective; connective && !connective->prefix) {
      const Connective sign = bound(*connective);
      if (sign.strength < least) break;
      in_.next();
      const Term right = term(sign.right_strength(), sort);
      left = checked(node(sign.kind, {left, right}, left->place));
      otherwise = sign.strength != connective->strength;
    } else if (token.is("⧹") && least <= (in_.is_spivey() ? spivey_binding::hiding : binding::hiding)) {
      left = hiding(left);
      otherwise = true;
      last_ = {};
    } else if (token.is("×") && least <= binding::infix + product_precedence) {
      left = product(left);
    } else if (token.is(named_relation)) {
      if (!takes_relation()) break;
      left = relations(left, from);
    } else if (token.own) {
      const OperatorTemplate& of = *token.own->of;
      const bool relates = of.role == Role::relation;
      if (!token.own->first() || !of.has_left() || own_strength(of) < least) break;
      if (relates && !takes_relation()) break;
      const bool one_word = of.parts.size() == 3;
      left = relates ? relations(left, from) : own_operation({left});
      if (!one_word) last_ = {};
    } else if (token.symbol->infix) {
      const Operator& of_iso = *token.symbol->infix;
      const Operator op = in_.is_spivey() ? spivey_binding::infix(of_iso) : of_iso;
      const bool relates = op.role == Role::relation;
      const int strength = binding::infix + op.precedence;
      if (relates ? !takes_relation() : strength < least) break;
      left = relates ? relations(left, from) : infix(left, strength, op);
      otherwise = op.precedence != of_iso.precedence || op.right != of_iso.right;
    } else {
      break;
    }
    bind(made, from, sign_at, otherwise);
  }
  last_ = made;
  return left;
}

/// Notes an operand that an operator takes, where one of the two binds otherwise in ISO's Z.
void TermParser::group(const Making& made, bool otherwise, std::size_t from, std::size_t to) {
  if (regrouping_ && made.by_operator && (made.otherwise || otherwise)) regrouping_->groups.emplace(from, to);
}

/// Notes the operands of an operator of one token: the left one, and the one that was taken last.
void TermParser::bind(Making& left, std::size_t from, std::size_t sign, bool otherwise) {
  group(left, otherwise, from, sign);
  group(last_, otherwise, sign + 1, in_.position());
  left = {true, otherwise};
}

Connective TermParser::bound(const Connective& sign) const {
  return in_.is_spivey() ? spivey_binding::connective(sign) : sign;
}

Term TermParser::infix(const Term& left, int strength, const Operator& op) {
  in_.next();
  const Term right = term(op.right ? strength : strength + 1);
  const Place place = left->place;
  if (op.role == Role::generic) return checked(reference({op.name(), {}}, {left, right}, place));
  return checked(operation(op.name(), {left, right}, place));
}

/// Takes a chain a ≤ b < c. Where an operator of a template is in it, each link is a conjunct.
Term TermParser::relations(const Term& left, std::size_t from) {
  const Place place = left->place;
  std::vector<Term> operands = {left}, links;  // null where a link is one of the names
  std::vector<Name> names;
  const std::size_t sign = in_.position();
  const bool is_named = in_.sees(named_relation);
  for (;;) {
    const Token& token = in_.peek();
    Term link, right;
    if (token.is(named_relation)) {
      link = membership_in_named(operands.back(), right);
    } else if (token.own && token.own->first() && token.own->of->has_left() && token.own->of->role == Role::relation) {
      link = own_relation(operands.back(), right);
    } else {
      const Operator* op = token.symbol->infix;
      if (token.own || !op || op->role != Role::relation) break;
      in_.next();
      names.push_back({op->name(), {}});
      right = term(binding::relation + 1);
    }
    links.push_back(std::move(link));
    operands.push_back(right);
    if (!right) break;  // a postfix relation ends the chain
  }
  last_ = {};  // a relation binds less tightly than its operands, in either
  if (regrouping_ && is_named && links.size() == 1) regrouping_->memberships.push_back({from, sign, in_.position()});
  if (names.size() == links.size()) return checked(relation(std::move(names), std::move(operands), place));
  Term all;
  auto name = names.begin();
  for (std::size_t i = 0; i < links.size(); ++i) {
    const Term& from = operands[i];
    const Term link = links[i] ? links[i] : relation({*name++}, {from, operands[i + 1]}, from->place);
    all = all ? checked(node(Kind::conjunction, {all, link}, place)) : link;
  }
  return checked(all);
}

/// Takes \inrel{R} y behind x, which Spivey's Z has for (x, y) ∈ R.
Term TermParser::membership_in_named(const Term& left, Term& right) {
  in_.next();
  const Place place = in_.peek().place;
  const Term of = reference(in_.name(), {}, place);
  right = term(binding::relation + 1);
  return checked(relation({{"_∈_", {}}}, {node(Kind::tuple, {left, right}, left->place), of}, left->place));
}

Term TermParser::product(const Term& left) {
  const Place place = left->place;
  std::vector<Term> factors = {left};
  while (in_.accept("×")) factors.push_back(term(binding::infix + product_precedence + 1));
  if (factors.size() > 2) last_ = {};  // what stands behind the first × is no operand
  return checked(node(Kind::product, std::move(factors), place));
}

Term TermParser::hiding(Term left) {
  in_.next();
  in_.expect("(");
  Node node{.kind = Kind::hiding, .place = left->place, .name = {}, .children = {left}, .names = names(), .text = {}};
  in_.expect(")");
  return checked(make(std::move(node)));
}

Term TermParser::leading(Making& made, Sort sort) {
  const Token& token = in_.peek();
  const Place place = token.place;
  if (const Quantifier* sign = token.symbol->quantifier)
    return sign->kind == Kind::let ? let() : quantifier(sign->kind, true);
  if (token.is("if")) return conditional();
  if (const Connective* sign = token.symbol->connective; sign && sign->prefix) {
    in_.next();
    const std::size_t from = in_.position();
    const int strength = bound(*sign).strength;
    Term operand = term(strength, sort);
    made = {true, strength != sign->strength};
    group(last_, made.otherwise, from, in_.position());
    return checked(node(sign->kind, {std::move(operand)}, place));
  }
  if (token.own && token.own->first() && !token.own->of->has_left() && !begins_primary()) return own_operation({});
  const Operator* op = token.symbol->prefix;
  const bool prefix_word = token.type == Token::Type::word && token.strokes.empty() && is_prefix_word(token.text);
  if (!in_.is_spivey() && prefix_word && begins_primary(1) && !in_.peek(1).is("[")) {
    const Term function = reference(in_.name(), {}, place);
    return checked(apply(function, term(binding::prefix), place));
  }
  if (!op) return application();
  if (token.only_infix) in_.fail("expected \\negate for the sign, or a term before -");
  in_.next();
  if (in_.is_spivey() && op->symbol == "#") return size_applied(*op, place);
  made = {true, false};
  if (op->role == Role::relation) return checked(relation({{op->name(), {}}}, {term(binding::relation + 1)}, place));
  const Term operand = term(binding::prefix);
  if (op->role == Role::generic) return checked(reference({op->name(), {}}, {operand}, place));
  return checked(operation(op->name(), {operand}, place));
}

/// Takes what # counts, and arguments: # s i is (# s) i in Spivey's Z.
Term TermParser::size_applied(const Operator& op, Place place) {
  const std::size_t from = in_.position() - 1;
  const Term size = checked(operation(op.name(), {primary()}, place));
  const std::size_t to = in_.position();
  Term all = applied(size);
  if (in_.position() > to) group({true, true}, true, from, to);
  return all;
}

/// The body of λ and μ is an expression, which ends before a relation: λ x : X • x = f is (λ x : X • x) = f.
Term TermParser::quantifier(Kind kind, bool value_needed) {
  const Place place = in_.next().place;
  SchemaText text = schema_text();
  if (kind == Kind::mu && !value_needed && !in_.sees("•")) return checked(quantified(kind, std::move(text), {}, place));
  in_.expect("•");
  const bool is_value = (kind == Kind::lambda || kind == Kind::mu) && !in_.is_spivey();
  Term body = term(binding::weakest, is_value ? Sort::expression : Sort::any);
  return checked(quantified(kind, std::move(text), {std::move(body)}, place));
}

Term TermParser::let() {
  const Place place = in_.next().place;
  SchemaText text = schema_text();
  for (const Declaration& declaration : text.declarations)
    if (declaration.form != Declaration::Form::defined)
      throw ZError(declaration.place, "a let that does not define", "expected NAME == value");
  if (!text.predicates.empty()) in_.fail("expected • after the definitions of a let");
  in_.expect("•");
  Term body = term();
  return checked(quantified(Kind::let, std::move(text), {std::move(body)}, place));
}

Term TermParser::conditional() {
  const Place place = in_.next().place;
  Term condition = term();
  in_.expect("then");
  Term yes = term();
  in_.expect("else");
  Term no = term(binding::conditional);
  return checked(node(Kind::conditional, {std::move(condition), std::move(yes), std::move(no)}, place));
}

std::vector<Name> TermParser::names() {
  std::vector<Name> names = {in_.name()};
  while (in_.accept(",")) names.push_back(in_.name());
  return names;
}

/// A declaration begins with x : …, with x, y : … or with x == …
bool TermParser::begins_declaration() const {
  for (std::size_t ahead = 0;; ++ahead) {
    const bool first = ahead == 0;
    const std::size_t length = operator_ahead(ahead, nullptr);
    if (length == 0 && !TokenStream::is_name(in_.peek(ahead))) return false;
    ahead += length == 0 ? 1 : length;
    const Token& after = in_.peek(ahead);
    if (after.is(":")) return true;
    if (after.is("==")) return first;
    if (!after.is(",")) return false;
  }
}

/// In `x, 1 : T` the 1 is to blame, and not the comma.
void TermParser::refuse_list() const {
  std::size_t ahead = 0;
  while (TokenStream::is_name(in_.peek(ahead)) && in_.peek(ahead + 1).is(",")) ahead += 2;
  if (ahead == 0 || TokenStream::is_name(in_.peek(ahead))) return;
  in_.fail("expected names before : in a declaration", ahead);
}

Declaration TermParser::declaration() {
  Declaration declaration;
  declaration.place = in_.peek().place;
  if (!begins_declaration()) {
    refuse_list();
    declaration.form = Declaration::Form::included;
    declaration.term = term();
    if (in_.sees(",") || in_.sees(":")) in_.fail("expected names before : in a declaration");
    return declaration;
  }
  do {
    declaration.places.push_back(in_.peek().place);
    std::vector<Name> formals;
    const std::optional<Name> op = operator_name(formals);
    declaration.names.push_back(op ? *op : in_.name());
  } while (in_.accept(","));
  declaration.form = in_.next().is("==") ? Declaration::Form::defined : Declaration::Form::typed;
  declaration.term = term();
  return declaration;
}

SchemaText TermParser::schema_text(bool labelled) {
  const ParsingDepth deeper(depth_, in_.peek().place);
  SchemaText text;
  if (!in_.sees("|") && !in_.sees("•")) {
    do {
      text.declarations.push_back(declaration());
    } while (in_.accept(";") || in_.accept(Token::Type::newline));
  }
  if (in_.accept("|")) text.predicates = predicates(labelled);
  return text;
}

std::vector<Predicate> TermParser::predicates(bool labelled) {
  std::vector<Predicate> predicates;
  do {
    const std::size_t from = in_.position();
    Predicate predicate;
    predicate.place = in_.peek().place;
    predicate.term = term();
    if (labelled) predicate.label = in_.label_since(from);
    predicates.push_back(std::move(predicate));
  } while (in_.accept(";") || in_.accept(Token::Type::newline));
  return predicates;
}

}  // namespace durero::zed
