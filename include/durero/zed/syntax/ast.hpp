#pragma once
/// The syntax tree of Z (ISO/IEC 13568) is made of values: a Term is a shared pointer to an immutable node, so copying
/// is cheap and sub-trees are shared. Equality ignores places.
///
/// Expressions, schema expressions and predicates are one type of node, as the connectives and quantifiers are one
/// notation for both: `A ∧ B` is a schema where an expression is expected and a predicate where a predicate is, and for
/// two schemas both readings mean the same. The type-checker refuses a predicate in the place of an expression.
///
/// Operators are not nodes of their own. `a + b` is the application of the reference `_+_` to the tuple (a, b); `A ⇸ B`
/// is the reference `_⇸_` with the generic actuals A, B; `a ≤ b < c` is one `relation` with two operators.

#include <compare>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace durero::zed {

/// A place says where something begins in its file: lines and columns count from 1, and columns count characters (code
/// points).
struct Place {
  std::uint32_t line = 0, column = 0;
  bool operator==(const Place&) const = default;
};

/// A Z name has a word in Unicode (`mi_centro`, `ΔEscena`, `_∪_`) and strokes (`'`, `?`, `!`, `₀`…`₉`) in order.
struct Name {
  std::string word, strokes;
  auto operator<=>(const Name&) const = default;
  std::string text() const { return word + strokes; }
  bool empty() const { return word.empty(); }
};

enum class Kind : std::uint8_t {
  // These are expressions. Beside each kind stands what `name`, `children`, `names` and `text` hold; those that are not
  // mentioned are empty.
  reference,          ///< name; children: generic actuals, if any
  number,             ///< name.word: its decimal digits
  set_extension,      ///< children: the elements, maybe none
  comprehension,      ///< text; children: the term, or none for the characteristic tuple
  tuple,              ///< children: two or more
  product,            ///< children: two or more sets
  power,              ///< children: the set
  selection,          ///< children: the binding; name: the component
  tuple_selection,    ///< children: the tuple; name.word: the position, from 1, in decimal
  binding_extension,  ///< names and children, paired: ⦉ x == e, … ⦊
  theta,              ///< children: the schema; name.strokes: the strokes after it
  application,        ///< children: function, argument
  lambda,             ///< text; children: the value
  mu,                 ///< text; children: the value, or none for the characteristic tuple
  let,                ///< text: declarations by `==` only; children: the value, or the predicate
  conditional,        ///< children: predicate, then, else
  // These are schema expressions.
  schema_text,   ///< text: [ declarations | predicates ]
  decoration,    ///< children: the schema; name.strokes
  renaming,      ///< children: the schema; names: new, old, new, old, …
  hiding,        ///< children: the schema; names: the hidden
  composition,   ///< children: two schemas, ⨟
  piping,        ///< children: two schemas, ⨠
  projection,    ///< children: two schemas, ⨡
  precondition,  ///< children: the schema, `pre S`
  // These are schema expressions and predicates.
  negation,     ///< children: one
  conjunction,  ///< children: two
  disjunction,  ///< children: two
  implication,  ///< children: two
  equivalence,  ///< children: two
  forall,       ///< text; children: the body
  exists,       ///< text; children: the body
  exists_one,   ///< text; children: the body
  // These are predicates. A schema expression in the place of a predicate is a predicate too.
  truth,
  falsity,
  relation,  ///< children: n+1 operands; names: the n relations between them (`_=_`, `_∈_`, `_≤_`, …), all of which
             ///< hold
};

struct Node;
struct SchemaText;

/// A term shares an immutable node. It is never null but where it is default-constructed or moved from.
class Term {
 public:
  Term() = default;
  explicit Term(std::shared_ptr<const Node> node) : node_(std::move(node)) {}
  const Node& operator*() const { return *node_; }
  const Node* operator->() const { return node_.get(); }
  const Node* get() const { return node_.get(); }
  explicit operator bool() const { return node_ != nullptr; }
  /// Two terms are equal where their trees are the same, whatever their places.
  friend bool operator==(const Term& a, const Term& b);

 private:
  std::shared_ptr<const Node> node_;
};

struct Node {
  Kind kind = Kind::truth;
  Place place;
  Name name;
  std::vector<Term> children;
  std::vector<Name> names;
  std::shared_ptr<const SchemaText> text;
  /// The depth is 1 + the greatest below. The reader limits it (parser.hpp), so that every recursion over a tree is
  /// safe.
  std::uint32_t depth = 1;
};

/// A declaration is `x, y : T`, `x == e` or the inclusion of a schema.
struct Declaration {
  enum class Form : std::uint8_t { typed, defined, included };
  Form form = Form::typed;
  std::vector<Name> names;    ///< a definition has one, an inclusion none
  std::vector<Place> places;  ///< the names stand here, in step
  Term term;                  ///< this is the set, the value, or the schema
  Place place;
};

/// A predicate is one conjunct of a paragraph or of a schema text, with the label in the comment that ends its line, if
/// any.
struct Predicate {
  Term term;
  std::string label;  ///< it is SCHEMA.KIND.NUMBER, or empty
  Place place;
};

struct SchemaText {
  std::vector<Declaration> declarations;
  std::vector<Predicate> predicates;  ///< all of them hold
};

bool operator==(const Declaration& a, const Declaration& b);
bool operator==(const Predicate& a, const Predicate& b);  ///< labels count
bool operator==(const SchemaText& a, const SchemaText& b);

/// A paragraph of given types is written [ A, B ].
struct GivenTypes {
  std::vector<Name> names;
  std::vector<Place> places;
};

/// A branch of a free type is a constant, or a constructor with the set of its arguments.
struct Branch {
  Name name;
  Term argument;  ///< a constant has none
  Place place;
};

/// A free type is written T ::= a | b ⟪ E ⟫. Types that `&` joins are a paragraph each: they may name one another, and
/// stand in a row.
struct FreeType {
  Name name;
  std::vector<Branch> branches;
  bool joined = false;  ///< `&` joins it to the paragraph before it
};

/// A definition is written N[X, Y] == E, where E is an expression or a schema expression.
struct Definition {
  Name name;
  std::vector<Name> formals;
  Term value;
  std::string label;  ///< the comment that ends its line says it, if any
};

/// An axiomatic paragraph is the box `axdef`, without formals, or `gendef`.
struct Axiomatic {
  std::vector<Name> formals;
  SchemaText text;
};

/// A schema is the box `schema`.
struct Schema {
  Name name;
  std::vector<Name> formals;
  SchemaText text;
};

/// A conjecture ⊢? P is a claim that is type-checked and no more.
struct Conjecture {
  Predicate claim;
};

struct Paragraph {
  Place place;
  std::variant<GivenTypes, FreeType, Definition, Axiomatic, Schema, Conjecture> form;
};

/// Compares paragraphs, whatever their places.
bool operator==(const Paragraph& a, const Paragraph& b);

/// A section has a name. A file without section headers is the one section `Specification` on `standard_toolkit`.
struct Section {
  std::string file;  ///< it is named as it was given
  std::string name;
  std::vector<std::string> parents;
  std::vector<Paragraph> paragraphs;
  Place place;
  std::vector<Name> lost;  ///< paragraphs which could not be read declare these
};

/// Makes a node, and computes its depth.
Term make(Node node);
Term reference(Name name, std::vector<Term> actuals = {}, Place place = {});
Term number(std::string digits, Place place = {});
Term apply(Term function, Term argument, Place place = {});
/// Makes the application of an operator. Its word `f` is `_+_`, `#_` or `_∼`; several arguments go into a tuple.
Term operation(std::string f, std::vector<Term> arguments, Place place = {});
Term relation(std::vector<Name> relations, std::vector<Term> operands, Place place = {});
Term node(Kind kind, std::vector<Term> children, Place place = {});
Term quantified(Kind kind, SchemaText text, std::vector<Term> children, Place place = {});

/// Returns the depth of the deepest of a schema text's terms.
std::uint32_t depth(const SchemaText& text);

}  // namespace durero::zed

template <>
struct std::hash<durero::zed::Name> {
  std::size_t operator()(const durero::zed::Name& name) const noexcept {
    return std::hash<std::string>()(name.word) * 31 + std::hash<std::string>()(name.strokes);
  }
};
