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

#include "durero/zed/syntax/word.hpp"

namespace durero::zed {

/// A place says where something begins in its file: lines and columns count from 1, and columns count characters (code
/// points).
struct Place {
  std::uint32_t line = 0, column = 0;  ///< 0:0 is no place, as of a node that no text was read for
  bool operator==(const Place&) const = default;
};

/// A Z name has a word in Unicode (`mi_centro`, `ΔEscena`, `_∪_`) and strokes (`'`, `?`, `!`, `₀`…`₉`) in order.
struct Name {
  Word word, strokes;  ///< the name centro' has the word `centro` and the stroke '
  auto operator<=>(const Name&) const = default;
  /// Returns the name in Unicode, as one word: strokes make it another name, so centro' is not centro.
  std::string text() const { return word + strokes; }
  /// Says whether it has no word: a node without a name has none, and a decoration has strokes alone.
  bool empty() const { return word.empty(); }
};

/// The kind of a node is the notation of Z that it stands for.
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
  truth,    ///< `true`
  falsity,  ///< `false`
  relation,  ///< children: n+1 operands; names: the n relations between them (`_=_`, `_∈_`, `_≤_`, …), all of which
             ///< hold; or one operand, and the relation `disjoint_` before it
};

struct Node;
struct SchemaText;

/// A term shares an immutable node. It is never null but where it is default-constructed or moved from.
class Term {
 public:
  Term() = default;
  /// Shares a node whose depth is right, as make() sees to.
  explicit Term(std::shared_ptr<const Node> node) : node_(std::move(node)) {}
  /// Returns the node. Precondition: the term is not null.
  const Node& operator*() const { return *node_; }
  /// Returns the node, of which a member is read. Precondition: the term is not null.
  const Node* operator->() const { return node_.get(); }
  /// Returns the node, or null. Terms that share it have one type (Typing), which equal trees need not have.
  const Node* get() const { return node_.get(); }
  /// Says whether there is a node: the argument of a constant of a free type has none.
  explicit operator bool() const { return node_ != nullptr; }
  /// Two terms are equal where their trees are the same, whatever their places.
  friend bool operator==(const Term& a, const Term& b);

 private:
  std::shared_ptr<const Node> node_;
};

/// A node of the tree is an operator of the syntax with its operands. Its kind says which of its members are in use.
struct Node {
  Kind kind = Kind::truth;  ///< it says what the other members hold
  /// Its text begins here, with its left operand where it has one; parentheses around it do not count.
  Place place;
  Name name;                               ///< that of a reference, a number's digits, a component, or strokes
  std::vector<Term> children;              ///< its operands, from left to right; none of them is null
  std::vector<Name> names;                 ///< the relations of `a ≤ b < c`, or the components that it names
  std::shared_ptr<const SchemaText> text;  ///< its schema text, as before the • of a quantifier; else null
  /// The depth is 1 + the greatest below. The reader limits it (parser.hpp), so that every recursion over a tree is
  /// safe.
  std::uint32_t depth = 1;
};

/// A declaration is `x, y : T`, `x == e` or the inclusion of a schema.
struct Declaration {
  /// The three ways to declare.
  enum class Form : std::uint8_t {
    typed,    ///< `x, y : T`
    defined,  ///< `x == e`
    included  ///< a schema by itself, which declares its components
  };
  Form form = Form::typed;    ///< it says what `names` and `term` hold
  std::vector<Name> names;    ///< a definition has one, an inclusion none
  std::vector<Place> places;  ///< the names stand here, in step
  Term term;                  ///< this is the set, the value, or the schema
  Place place;                ///< its first name stands here, or the schema
};

/// A predicate is one conjunct of a paragraph or of a schema text, with the label in the comment that ends its line, if
/// any.
struct Predicate {
  Term term;          ///< this holds; a schema does where the names in scope satisfy it
  std::string label;  ///< it is SCHEMA.KIND.NUMBER, or empty
  Place place;        ///< it begins here; a conjecture does with its ⊢?
};

/// A schema text is written D | P: a schema's box, [ D | P ], or what stands before the • of a quantifier.
struct SchemaText {
  std::vector<Declaration> declarations;  ///< none sees the names of another; `x, y : T` is one of them
  std::vector<Predicate> predicates;      ///< all of them hold
};

/// @{ Compares without places: what is declared or stated, in what order, and how it is written.
bool operator==(const Declaration& a, const Declaration& b);
bool operator==(const Predicate& a, const Predicate& b);  ///< labels count
bool operator==(const SchemaText& a, const SchemaText& b);
/// @}

/// A paragraph of given types is written [ A, B ].
struct GivenTypes {
  std::vector<Name> names;    ///< each is a set of its own, and a type
  std::vector<Place> places;  ///< the names stand here, in step
};

/// A branch of a free type is a constant, or a constructor with the set of its arguments.
struct Branch {
  Name name;      ///< a constant is a member of the free type, a constructor an injection into it
  Term argument;  ///< a constant has none
  Place place;    ///< the name stands here
};

/// A free type is written T ::= a | b ⟪ E ⟫. Types that `&` joins are a paragraph each: they may name one another, and
/// stand in a row.
struct FreeType {
  Name name;                     ///< T, a set and a type
  std::vector<Branch> branches;  ///< one or more, in the order of the text
  bool joined = false;           ///< `&` joins it to the paragraph before it
};

/// A definition is written N[X, Y] == E, where E is an expression or a schema expression.
struct Definition {
  Name name;                  ///< N
  std::vector<Name> formals;  ///< X, Y; none where it is not generic
  Term value;                 ///< E
  std::string label;          ///< the comment that ends its line says it, if any
};

/// An axiomatic paragraph is the box `axdef`, without formals, or `gendef`.
struct Axiomatic {
  std::vector<Name> formals;  ///< those of a `gendef`, one or more
  SchemaText text;            ///< it declares names for the section, of which its predicates are axioms
};

/// A schema is the box `schema`.
struct Schema {
  Name name;                  ///< it names the set of the bindings that satisfy the text
  std::vector<Name> formals;  ///< X, Y of S[X, Y]; none where it is not generic
  SchemaText text;            ///< it declares the components, and states the invariant
};

/// A conjecture [X, Y] ⊢? P is a claim that is type-checked and no more.
struct Conjecture {
  Predicate claim;            ///< P, with its label
  std::vector<Name> formals;  ///< X, Y of [X, Y] ⊢? P; none where it is not generic
};

/// A paragraph is a box, or one line of a `zed` environment (of free types that `&` joins there, each is one).
struct Paragraph {
  Place place;  ///< what stands first in it is here: a schema's name, or the first name that an axdef declares
  /// Its notation, with what it declares or claims.
  std::variant<GivenTypes, FreeType, Definition, Axiomatic, Schema, Conjecture> form;
};

/// Compares paragraphs, whatever their places.
bool operator==(const Paragraph& a, const Paragraph& b);

/// A section has a name. A file without section headers is the one section `Specification` on `standard_toolkit`.
struct Section {
  std::string file;                   ///< it is named as it was given
  std::string name;                   ///< a second section of this name is a defect
  std::vector<std::string> parents;   ///< it sees what they see; those of the toolkit stand among them
  std::vector<Paragraph> paragraphs;  ///< those that could be read, in the order of the text
  Place place;                        ///< its first environment begins here
  std::vector<Name> lost;             ///< paragraphs which could not be read declare these
};

/// Makes a node, and computes its depth.
Term make(Node node);
/// Makes a name where it is used, with its generic actuals, if any: `∅[𝔸]`, or `A ⇸ B` by the name `_⇸_`.
Term reference(Name name, std::vector<Term> actuals = {}, Place place = {});
/// Makes the numeral of a natural number. Precondition: the digits are decimal, and one or more.
Term number(std::string digits, Place place = {});
/// Makes the application f x, of one argument, which may be a tuple.
Term apply(Term function, Term argument, Place place = {});
/// Makes the application of an operator. Its word `f` is `_+_`, `#_` or `_∼`; several arguments go into a tuple.
Term operation(std::string f, std::vector<Term> arguments, Place place = {});
/// Makes `a ≤ b < c` of `_≤_`, `_<_` and a, b, c. Precondition: as many operands as Kind::relation says.
Term relation(std::vector<Name> relations, std::vector<Term> operands, Place place = {});
/// Makes a node that has operands alone, such as a tuple, a connective or `true`; its kind says how many.
Term node(Kind kind, std::vector<Term> children, Place place = {});
/// Makes a node with a schema text: a quantifier, a comprehension, λ, μ, let or [ D | P ]. The value or body is a
/// child.
Term quantified(Kind kind, SchemaText text, std::vector<Term> children, Place place = {});

/// Returns the depth of the deepest of a schema text's terms.
std::uint32_t depth(const SchemaText& text);

}  // namespace durero::zed

/// Lets names be the keys of unordered containers.
template <>
struct std::hash<durero::zed::Name> {
  /// Hashes word and strokes: centro and centro' are two keys.
  std::size_t operator()(const durero::zed::Name& name) const noexcept {
    return name.word.hash() + 31 * name.strokes.hash();
  }
};
