#include "durero/zed/syntax/ast.hpp"

#include <algorithm>
#include <utility>

namespace durero::zed {
namespace {

bool same_text(const std::shared_ptr<const SchemaText>& a, const std::shared_ptr<const SchemaText>& b) {
  if (a == b) return true;
  return a && b && *a == *b;
}

bool same(const Node& a, const Node& b) {
  return a.kind == b.kind && a.depth == b.depth && a.name == b.name && a.names == b.names && a.children == b.children &&
         same_text(a.text, b.text);
}

bool operator==(const Branch& a, const Branch& b) { return a.name == b.name && a.argument == b.argument; }

struct SameForm {
  bool operator()(const GivenTypes& a, const GivenTypes& b) const { return a.names == b.names; }
  bool operator()(const FreeType& a, const FreeType& b) const {
    return a.name == b.name && a.joined == b.joined &&
           std::equal(a.branches.begin(), a.branches.end(), b.branches.begin(), b.branches.end(),
                      [](const Branch& x, const Branch& y) { return x == y; });
  }
  bool operator()(const Definition& a, const Definition& b) const {
    return a.name == b.name && a.formals == b.formals && a.value == b.value && a.label == b.label;
  }
  bool operator()(const Axiomatic& a, const Axiomatic& b) const { return a.formals == b.formals && a.text == b.text; }
  bool operator()(const Schema& a, const Schema& b) const {
    return a.name == b.name && a.formals == b.formals && a.text == b.text;
  }
  bool operator()(const Conjecture& a, const Conjecture& b) const {
    return a.claim == b.claim && a.formals == b.formals;
  }
  template <class A, class B>
  bool operator()(const A&, const B&) const {
    return false;
  }
};

}  // namespace

bool operator==(const Term& a, const Term& b) {
  if (a.node_ == b.node_) return true;
  return a.node_ && b.node_ && same(*a.node_, *b.node_);
}

bool operator==(const Declaration& a, const Declaration& b) {
  return a.form == b.form && a.names == b.names && a.term == b.term;
}

bool operator==(const Predicate& a, const Predicate& b) { return a.label == b.label && a.term == b.term; }

bool operator==(const SchemaText& a, const SchemaText& b) {
  return a.declarations == b.declarations && a.predicates == b.predicates;
}

bool operator==(const Paragraph& a, const Paragraph& b) { return std::visit(SameForm(), a.form, b.form); }

std::uint32_t depth(const SchemaText& text) {
  std::uint32_t deepest = 0;
  for (const Declaration& declaration : text.declarations) deepest = std::max(deepest, declaration.term->depth);
  for (const Predicate& predicate : text.predicates) deepest = std::max(deepest, predicate.term->depth);
  return deepest;
}

Term make(Node node) {
  std::uint32_t below = node.text ? depth(*node.text) : 0;
  for (const Term& child : node.children) below = std::max(below, child->depth);
  node.depth = below + 1;
  return Term(std::make_shared<const Node>(std::move(node)));
}

Term node(Kind kind, std::vector<Term> children, Place place) {
  return make({.kind = kind, .place = place, .name = {}, .children = std::move(children), .names = {}, .text = {}});
}

Term reference(Name name, std::vector<Term> actuals, Place place) {
  return make({.kind = Kind::reference,
               .place = place,
               .name = std::move(name),
               .children = std::move(actuals),
               .names = {},
               .text = {}});
}

Term number(std::string digits, Place place) {
  return make(
      {.kind = Kind::number, .place = place, .name = {std::move(digits), {}}, .children = {}, .names = {}, .text = {}});
}

Term apply(Term function, Term argument, Place place) {
  std::vector<Term> parts;
  parts.reserve(2);
  parts.push_back(std::move(function));
  parts.push_back(std::move(argument));
  return node(Kind::application, std::move(parts), place);
}

Term operation(std::string f, std::vector<Term> arguments, Place place) {
  Term argument = arguments.size() == 1 ? std::move(arguments[0]) : node(Kind::tuple, std::move(arguments), place);
  return apply(reference({std::move(f), {}}, {}, place), std::move(argument), place);
}

Term relation(std::vector<Name> relations, std::vector<Term> operands, Place place) {
  return make({.kind = Kind::relation,
               .place = place,
               .name = {},
               .children = std::move(operands),
               .names = std::move(relations),
               .text = {}});
}

Term quantified(Kind kind, SchemaText text, std::vector<Term> children, Place place) {
  return make({.kind = kind,
               .place = place,
               .name = {},
               .children = std::move(children),
               .names = {},
               .text = std::make_shared<const SchemaText>(std::move(text))});
}

}  // namespace durero::zed
