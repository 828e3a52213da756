#pragma once
/// Random definitions by cases, and predicates of them. Each comes as Z and as what it means in numbers, which are two
/// accounts that share nothing: the second goes through each value in turn.

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace durero::zed::test {

using Number = std::int64_t;

/// Draws numbers, the same for a seed on each machine (Steele, Lea and Flood, 2014).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::size_t below(std::size_t end);
  template <class T>
  const T& one_of(const std::vector<T>& all) {
    return all[below(all.size())];
  }

 private:
  std::uint64_t state_;
};

/// The values of the variables in scope, and their names.
using Values = std::array<Number, 5>;
using Names = std::array<const char*, 5>;
inline constexpr Names plain_names = {"x", "y", "a", "b", "c"};

/// Z, and what it means where the variables have these values.
template <class T>
struct Written {
  std::string z;
  std::function<T(const Values&)> means;
};
using Expression = Written<std::optional<Number>>;  ///< nothing where it is undefined
using Condition = Written<bool>;

/// The meaning goes further than is worth while: the case is left out.
struct TooFar {};

/// A function of some numbers: nothing outside its domain.
struct Function {
  std::string name;
  std::function<std::optional<Number>(Number)> at;
};
struct PairFunction {
  std::string name;
  std::function<std::optional<Number>(Number, Number)> at;
};
/// A set of numbers, and a relation between them.
struct NumberSet {
  std::string name;
  std::function<bool(Number)> has;
};
struct Relation {
  std::string name;
  std::function<bool(Number, Number)> has;
};

/// A text of definitions by cases. The free type TREE ::= leaf | tip⟪ℕ⟫ | node⟪TREE × TREE⟫ is in each.
struct World {
  std::string text;
  std::vector<Function> functions;
  std::vector<PairFunction> pair_functions;
  std::vector<NumberSet> sets;
  std::vector<Relation> relations;
  std::function<Number(Number)> size_of_tip;
  Number size_of_leaf = 0, size_of_node = 0, total_of_none = 0;
  std::function<bool(Number)> tip_is_odd;
};

World random_world(Random& random);

/// Makes expressions and conditions of so many of the variables, `depth` deep at most.
class Maker {
 public:
  Maker(const World& world, Random& random, const Names& names = plain_names)
      : world_(world), random_(random), variables_(names) {}
  Expression expression(int depth, std::size_t scope);
  Condition condition(int depth, std::size_t scope);

 private:
  struct Tree {
    std::string z;
    std::function<std::optional<Number>(const Values&)> size;
    std::function<std::optional<bool>(const Values&)> odd;
  };
  Tree tree(int depth, std::size_t scope);
  Expression arithmetic(int depth, std::size_t scope);
  Expression application(int depth, std::size_t scope);
  Expression of_finite_function(int depth, std::size_t scope);
  Expression of_lambda(int depth, std::size_t scope);
  Expression choice(int depth, std::size_t scope);
  Expression count(int depth, std::size_t scope);
  Expression the_one(int depth, std::size_t scope);
  Condition comparison(int depth, std::size_t scope);
  Condition membership(int depth, std::size_t scope);
  Condition in_function(int depth, std::size_t scope);
  Condition connective(int depth, std::size_t scope);
  Condition quantified(int depth, std::size_t scope);
  Condition of_sets(int depth, std::size_t scope);
  Condition of_trees(int depth, std::size_t scope);

  const World& world_;
  Random& random_;
  const Names& variables_;
};

}  // namespace durero::zed::test
