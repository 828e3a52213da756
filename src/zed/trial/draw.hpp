#pragma once
/// Values of a type, for conjectures to be tried on.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "durero/zed/evaluate/evaluate.hpp"
#include "durero/zed/trial/trial.hpp"

namespace durero::zed {

/// A given set that has no samples has so many members.
inline constexpr std::size_t names_of_a_given_set = 3;

/// The numbers that one draw is made of: a row of its own for each, so that no draw depends on another. The first is
/// the draw's own, so that all samples of what is declared first are gone through.
class Chances {
 public:
  explicit Chances(std::uint64_t draw) : draw_(draw), state_(draw) {}
  /// The next number below `end`, which is positive.
  std::size_t below(std::size_t end);

 private:
  std::uint64_t draw_, state_;
  bool first_ = true;
};

/// Makes values of types: of a given set some names, of numbers small ones, of sets small ones, of a free type with
/// constructors such that they are not nested deep.
class Draw {
 public:
  /// The evaluator applies the constructors, and says which members given sets have; it outlives this. Numbers are
  /// within the bounds, if there are some.
  Draw(const Specification& specification, const Typing& typing, const Samples& samples, const Evaluator& evaluator,
       const std::optional<std::pair<std::int64_t, std::int64_t>>& numbers = std::nullopt);
  /// A value of the type.
  Value of(const Type& type, Chances& chances) const { return of(type, chances, most_nested); }
  /// The name of the set, or schema, that this term names, where there are samples of it; else null.
  const std::string* samples_of(const Term& set) const;
  /// The samples of the set of this name. Precondition: samples_of() has given it.
  const std::vector<Value>& samples(const std::string& set) const { return samples_.at(set); }
  /// The samples of a given set, or the members of a free type of constants, by the name of the set; else nothing.
  std::optional<std::vector<Value>> names_in(const Name& set) const;
  /// The declarations of the schema that this term names; null where it names none that is written with declarations.
  const SchemaText* text(const Term& schema) const;

 private:
  static constexpr unsigned most_nested = 3;  // constructors in each other
  struct Constructor {
    Name name;
    Type argument;
  };
  struct Free {
    std::vector<Value> constants;
    std::vector<Constructor> constructors;
  };

  void add(const FreeType& form, const Typing& typing);
  Value of(const Type& type, Chances& chances, unsigned nested) const;
  Value of_set(const Type& element, Chances& chances, unsigned nested) const;
  Value of_free(const std::string& name, const Free& free, Chances& chances, unsigned nested) const;

  Value number(Chances& chances) const;

  const Evaluator& evaluator_;
  std::optional<std::pair<std::int64_t, std::int64_t>> numbers_;
  std::map<std::string, Free> free_;                // free types with constructors
  std::map<std::string, const SchemaText*> texts_;  // of the specification, which outlives it
  Samples samples_;                                 // by type too: the constants of free types, the names of given sets
};

}  // namespace durero::zed
