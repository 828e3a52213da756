#pragma once
/// Unfolding writes a schema expression as one schema text [ D | P ], in which no other schema is included, and its
/// hidden components are eliminated by the one-point rule where equations give them. `pre Op` thereby becomes the
/// precondition of Op, calculated.

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "durero/zed/syntax/ast.hpp"

namespace durero::zed {

/// The set of all values of the type of a component of the schema; a null term where it has no such component.
using Carriers = std::function<Term(const Name& component)>;

/// The actuals of a reference to a generic schema that leaves them out: the sets of all values of the types that they
/// are found to have. Nothing where they are not known.
using Actuals = std::function<std::optional<std::vector<Term>>(const Term& reference)>;

/// Returns the schema as a schema text; nothing where something in it is not written out: generic schemas whose actuals
/// are not known, and where a name would be captured. It has the same bindings.
std::optional<Term> unfolded(const Term& schema, const std::vector<Section>& sections, const Carriers& carriers,
                             const Actuals& actuals = {});

class Definitions;

/// An unfolder does what unfolded() does for several schemas of the same sections, whose definitions it looks up once.
class SchemaUnfolder {
 public:
  /// The sections outlive it.
  explicit SchemaUnfolder(const std::vector<Section>& sections);
  /// Returns what unfolded() returns.
  std::optional<Term> unfolded(const Term& schema, const Carriers& carriers, const Actuals& actuals = {}) const;

 private:
  std::shared_ptr<const Definitions> definitions_;
};

}  // namespace durero::zed
