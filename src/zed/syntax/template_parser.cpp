/// Parses the operators that templates make (ISO/IEC 13568, 12.2.8), and their names.

#include <utility>

#include "zed/syntax/term_parser.hpp"

namespace durero::zed {

/// Returns how many tokens from `ahead` on are an operator's name: `_ below _`, or where there are `formals`, also with
/// names in the place of _; 0 where they are none.
std::size_t TermParser::operator_ahead(std::size_t ahead, std::vector<Name>* formals) const {
  const OperatorWord* word = in_.peek(ahead).own ? in_.peek(ahead).own : in_.peek(ahead + 1).own;
  if (!word || !word->first()) return 0;
  std::size_t at = ahead;
  for (const std::string& part : word->of->parts) {
    const Token& token = in_.peek(at++);
    if (part == ",," && token.is(",") && in_.peek(at).is(",")) {
      ++at;
    } else if (formals && part == "_" && TokenStream::is_name(token)) {
      formals->push_back({token.text, token.strokes});
    } else if (!token.is(part)) {
      return 0;
    }
  }
  return at - ahead;
}

std::optional<Name> TermParser::operator_name(std::vector<Name>& formals) {
  std::size_t length = operator_ahead(0, nullptr);
  if (length == 0) {
    length = operator_ahead(0, &formals);
    if (length == 0 || !in_.peek(length).is("==")) {
      formals.clear();
      return std::nullopt;
    }
  }
  const OperatorWord& word = in_.peek().own ? *in_.peek().own : *in_.peek(1).own;
  while (length-- > 0) in_.next();
  return Name{word.of->name(), {}};
}

/// Takes the operand that stands at a part: the last one as tightly as the operator binds, others between words.
Term TermParser::own_operand(const OperatorTemplate& of, std::size_t part) {
  if (of.parts[part] == ",,") {
    const Place place = in_.peek().place;
    std::vector<Term> elements;
    const auto ends = [](const OperatorWord* word) { return word && !(word->first() && !word->of->has_left()); };
    while (!ends(in_.peek().own)) {
      if (!elements.empty()) in_.expect(",");
      elements.push_back(term());
    }
    return sequence_of(std::move(elements), place);
  }
  if (part + 1 < of.parts.size()) return term();
  if (of.role == Role::relation) return term(binding::relation + 1);
  if (!of.has_left()) return term(binding::prefix);
  return term(binding::infix + of.precedence + (of.right ? 0 : 1));
}

/// An operator of a template is a function, a generic set, or a relation, of which the tuple of operands is a member.
Term TermParser::own_operation(std::vector<Term> operands) {
  const OperatorTemplate& op = *in_.peek().own->of;
  const Place place = operands.empty() ? in_.peek().place : operands[0]->place;
  for (std::size_t part = op.has_left() ? 1 : 0; part < op.parts.size(); ++part) {
    if (op.parts[part] == "_" || op.parts[part] == ",,") {
      operands.push_back(own_operand(op, part));
    } else if (in_.sees(op.parts[part])) {
      in_.next();
    } else {
      in_.fail("expected " + op.parts[part] + ", as the operator " + op.name() + " goes on");
    }
  }
  if (op.role == Role::generic) return checked(reference({op.name(), {}}, std::move(operands), place));
  if (operands.empty()) return reference({op.name(), {}}, {}, place);
  if (op.role == Role::function) return checked(operation(op.name(), std::move(operands), place));
  Term member = operands.size() == 1 ? operands[0] : checked(node(Kind::tuple, std::move(operands), place));
  return checked(relation({{"_∈_", {}}}, {std::move(member), reference({op.name(), {}}, {}, place)}, place));
}

/// Takes a relation behind its left operand, and tells its right one: none where it is postfix.
Term TermParser::own_relation(Term left, Term& right) {
  const bool has_right = in_.peek().own->of->has_right();
  Term link = own_operation({std::move(left)});
  const Term& member = link->children[0];
  right = has_right ? member->children.back() : Term();
  return link;
}

}  // namespace durero::zed
