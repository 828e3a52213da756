#pragma once
/// The types of Z (ISO/IEC 13568, clause 10) are given types, power sets, products and schema types; unify() makes two
/// of them equal. Punto and Vector have one type: a schema type is its components, whatever its name.

#include <cstdint>
#include <memory>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "durero/zed/syntax/ast.hpp"

namespace durero::zed {

/// A type says which values an expression may have: all numbers are of type 𝔸, and a set of them is of type ℙ 𝔸. Copies
/// share one immutable tree, but for its variables: what unify() finds out of one is so in every type that has it.
class Type {
 public:
  /// The kind of a type. Beside each kind stands which of name(), fields() and parts() are not empty.
  enum class Kind : std::uint8_t {
    given,     ///< name: a given set, a free type, or 𝔸
    formal,    ///< name: a generic formal, in its own paragraph
    power,     ///< parts: one
    product,   ///< parts: two or more
    schema,    ///< fields, in the order of names, and parts: the type of each
    variable,  ///< not determined (yet)
    unknown,   ///< the type of an expression in error; agrees with every type
  };

  /// The type of the members of the given set or free type of this name.
  static Type given(Name name);
  /// The type of the members of a generic formal, such as X in N[X] == …; substitute() puts another in its place.
  static Type formal(Name name);
  /// ℙ of the type: that of the sets of such elements.
  static Type power(Type element);
  /// T₁ × T₂ × …, the type of tuples. Precondition: there are two parts or more.
  static Type product(std::vector<Type> parts);
  static Type schema(std::vector<std::pair<Name, Type>> fields);  ///< the names are distinct, in any order
  /// A type that is still to be determined, by unify(); two calls give two.
  static Type variable();
  /// The type of an expression in error; it agrees with every type, so that one error is not reported twice.
  static Type unknown();

  /// Returns the kind of the type. A determined variable counts as the type that it was found to be, here and below.
  Kind kind() const { return node().kind; }
  /// Says whether the type is of this kind.
  bool is(Kind what) const { return kind() == what; }
  /// Returns the name of a given set, a free type or a formal; an empty one for another kind.
  const Name& name() const;
  /// Returns T of ℙ T, the factors of a product, or the types of components, in step with fields(); or nothing.
  const std::vector<Type>& parts() const { return node().parts; }
  /// Returns the names of the components of a schema type, sorted; nothing for another kind.
  const std::vector<Name>& fields() const;
  /// Returns the type of a component of a schema type, or null.
  const Type* field(const Name& name) const;

  /// Says whether this is the type of a set of bindings, which is that of a schema.
  bool is_schema_set() const { return is(Kind::power) && parts()[0].is(Kind::schema); }
  /// Says whether the type has variables that are not determined. An unknown part counts as determined.
  bool has_variables() const;
  /// Says whether all of the type is known, so that its text can be read back as the set of all its values.
  bool is_known() const;
  /// Writes the type in Z notation: `ℙ (Elemento × 𝔸)`, `[x : 𝔸; y : 𝔸]`. An unknown part is written `?`, and the parts
  /// behind the first `parts` are written `…`.
  std::string text(int parts = 40) const;

  /// Returns the size of the type, written out, when it was made; the count saturates. The type-checker refuses types
  /// larger than the limits: the largest of spec/ has some 150 parts, and a recursion over a type is at most max_depth
  /// levels deep.
  std::uint32_t size() const { return node().size; }
  /// Returns the depth of the type when it was made: 1 without parts, else 1 + the greatest depth of a part.
  std::uint32_t depth() const { return node().depth; }
  static constexpr std::uint32_t max_size = 5000, max_depth = 500;  ///< the limits on size() and depth()

  /// Returns the same type with each determined variable replaced by its type, and every other variable by the unknown
  /// type. A type that is larger than the limits, once written out, becomes unknown too.
  Type settled() const;

  /// Puts types for formals, which `actuals` are in step with.
  Type substitute(const std::vector<Name>& formals, const std::vector<Type>& actuals) const;

  /// Makes two types equal by determining variables in them. Returns false where that is impossible; some variables may
  /// be determined then.
  friend bool unify(const Type& a, const Type& b);

 private:
  struct Node {  // its members leave no holes, as a text has many thousands of types
    Kind kind = Kind::unknown;
    bool generic = false;            // says whether a formal is in it
    bool open = false;               // and whether a variable was, when it was made
    mutable std::uint32_t rank = 0;  // the rank of a variable keeps chains of them logarithmic
    std::uint32_t size = 1, depth = 1;
    std::vector<Name> names;  // the name of a given set, a free type or a formal, or the fields of a schema
    std::vector<Type> parts;
    mutable std::shared_ptr<const Node> same;  // the variable has been found to be this
  };
  explicit Type(Node node);
  explicit Type(std::shared_ptr<const Node> node) : node_(std::move(node)) {}
  /// Returns the node of the type that its variables were determined to be.
  const Node& node() const;
  std::shared_ptr<const Node> resolved() const;
  static bool unify_at(const Type& a, const Type& b, unsigned depth, std::uint32_t& steps);
  static void join(const Type& a, const Type& b);
  Type settled_at(std::uint32_t depth, std::unordered_map<const Node*, Type>& done) const;
  static bool is_open(const Node& node) { return node.open; }
  template <class LookedInto, class Test>
  static bool any_node(const Type& in, LookedInto&& looked_into, Test&& test);
  static bool occurs(const Node* variable, const Type& in);
  void append(std::string& out, bool tight, int& budget) const;

  std::shared_ptr<const Node> node_;
};

/// A scheme is the type of a name, for every choice of its generic formals.
struct Scheme {
  std::vector<Name> formals;  ///< X, Y of N[X, Y], in order; none where the name is not generic
  Type type;                  ///< each formal in it is Type::formal; a set of T, or a schema, has a type ℙ T
};

}  // namespace durero::zed
