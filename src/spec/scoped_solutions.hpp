#pragma once
/// The bindings of a schema in a small scope.

#include <functional>

#include "scoped_values.hpp"

namespace durero::spec {

/// A sample of the bindings of a schema in a scope.
struct ScopedSample {
  std::vector<zed::Valuation> bindings;
  bool all = false;  ///< the scope has no others
};

/// Finds the bindings of a schema with some of its components given: by its equations and finite sets, and where these
/// leave a component open, by the members of its declared set in the scope. Each is judged by the schema.
class ScopedSolutions {
 public:
  /// In a scope of this size. `parts` outlives it.
  ScopedSolutions(const Machine::Parts& parts, std::size_t size) : parts_(parts), values_(parts, size) {}
  /// Calls `visit`, which returns false to stop, for bindings with these values; those of other names count for
  /// nothing. Says whether there are no others: that is so where every set that was gone through has no other members.
  /// Throws zed::StepsSpent.
  bool each(const std::string& schema, const zed::Valuation& given,
            const std::function<bool(const zed::Valuation&)>& visit);
  /// Whether there is one; open where none was found and there may be others.
  zed::Truth some(const std::string& schema, const zed::Valuation& given);
  /// Takes `most` bindings at most; where the scope has more, they are spread over it, the same each time.
  ScopedSample sample(const std::string& schema, std::size_t most);
  /// Whether values for all components satisfy the schema.
  zed::Truth holds(const std::string& schema, const zed::Valuation& values) const;
  /// The reason for which something was last left open.
  const std::string& why_open() const { return why_open_; }
  /// The members of the declared set of a component in the scope.
  const ScopedMembers& members(const std::string& schema, const zed::Name& component) {
    return values_.of(schema, component);
  }

 private:
  struct Before {
    bool operator()(const std::vector<zed::Value>& a, const std::vector<zed::Value>& b) const;
  };
  struct Search {
    const std::string& schema;
    const std::function<bool(const zed::Valuation&)>& visit;
    std::size_t tried = 0;
    bool stopped = false, cut = false;                    ///< some members of the scope were left out where it was cut
    std::set<std::vector<zed::Value>, Before> visited{};  ///< in the order of the components
  };
  bool look(Search& search, zed::Valuation& known, std::size_t quota);
  bool go_through(Search& search, zed::Valuation& known, std::size_t quota);

  const Machine::Parts& parts_;
  ScopedValues values_;
  std::string why_open_{};
};

}  // namespace durero::spec
