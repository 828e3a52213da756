#pragma once
/// Referents grow together as their names are found to stand for one thing.

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "durero/zed/names/cross_reference.hpp"

namespace durero::zed {

/// The components of a schema, with their referents.
using ComponentReferents = std::vector<std::pair<Name, std::size_t>>;

/// A union-find structure over referents (Tarjan). It knows the signatures too: bindings of one schema type share the
/// components of every schema of that type, whatever its name.
class ReferentTable {
 public:
  std::size_t add(Referent referent);
  /// Returns the referent that stands for all that this one was united with.
  std::size_t root(std::size_t of);
  /// Makes two one, whose form is the greater.
  void unite(std::size_t a, std::size_t b);
  /// Remembers the components of a schema for bindings of its type.
  void remember(const ComponentReferents& components);
  /// Returns the components of bindings of a schema type.
  ComponentReferents of_bindings(const Type& schema);
  /// Returns all referents, by their numbers.
  const std::vector<Referent>& referents() const { return referents_; }

 private:
  /// The schemas of one signature. Their components are one each as soon as some binding of that type is used as such.
  struct SharedSignature {
    std::optional<std::map<Name, std::size_t>> shared;
    std::vector<ComponentReferents> waiting;
  };
  static void share(std::map<Name, std::size_t>& shared, const ComponentReferents& components, ReferentTable& in);

  std::vector<Referent> referents_;
  std::vector<std::size_t> parents_;
  std::map<std::vector<Name>, SharedSignature> signatures_;  // by the sorted names of the components
};

}  // namespace durero::zed
