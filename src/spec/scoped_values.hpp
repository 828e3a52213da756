#pragma once
/// The members of a declared set in a small scope: of numbers those up to a bound, of an infinite table those that are
/// constant from there on, of a set the small subsets.

#include <map>
#include <optional>

#include "machine_parts.hpp"

namespace durero::spec {

/// Members of a set, and whether it has no others.
struct ScopedMembers {
  std::vector<zed::Value> values;  ///< each once
  bool all = false;                ///< the set has no others
};

/// Lists members of the sets that the components of schemas are declared from.
class ScopedValues {
 public:
  /// In a scope of this size: numbers from −size to size, sequences and tables with so many places. `parts` outlives
  /// it.
  ScopedValues(const Machine::Parts& parts, std::size_t size) : parts_(parts), size_(static_cast<int>(size)) {}
  /// Members of the set that the schema declares the component from. Precondition: it has this component.
  const ScopedMembers& of(const std::string& schema, const zed::Name& component);

 private:
  std::optional<zed::Term> declared_set(const std::string& schema, const zed::Name& component);
  ScopedMembers of_set(const zed::Term& set, const zed::Type& element) const;
  ScopedMembers by_form(const zed::Term& set, const zed::Type& element) const;
  ScopedMembers functions(const zed::Term& set, const zed::Type& element, bool total) const;
  ScopedMembers of_type(const zed::Type& type) const;
  ScopedMembers of_given(const zed::Name& name) const;
  ScopedMembers of_free_type(const zed::FreeType& form) const;
  void add_constructed(const zed::Branch& branch, ScopedMembers& to) const;

  const Machine::Parts& parts_;
  int size_;
  mutable int nested_ = 0;  // so many constructors are around what is being listed
  std::map<std::string, std::optional<zed::Term>> texts_;
  std::map<std::pair<std::string, zed::Name>, ScopedMembers> known_;
};

}  // namespace durero::spec
