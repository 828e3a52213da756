#pragma once
/// The definitions give the names of a specification their meanings.

#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "durero/zed/syntax/ast.hpp"
#include "zed/value/context.hpp"

namespace durero::zed {

/// A meaning is that of a name that a paragraph declares. Its value is computed when it is first asked for.
struct Meaning {
  enum class Kind { given, free_type, constant, constructor, definition, axiomatic, schema };
  Kind kind = Kind::given;
  Name name;
  const Section* section = nullptr;
  const Paragraph* paragraph = nullptr;
  std::uint32_t order = 0;  ///< a branch has a place in its free type
  std::optional<Value> value{};
  bool busy = false;  ///< its value is being computed

  const std::string& label() const;  ///< returns that of a definition, and nothing for any other meaning
};

class Definitions {
 public:
  /// The sections outlive it.
  explicit Definitions(const std::vector<Section>& sections);
  /// Returns null where the specification declares no such name. Throws EvaluationError where two sections declare it,
  /// and for every name where a section declares one of the toolkit: it does not see that one, and other sections may.
  Meaning* find(const Name& name);
  const Meaning* find(const Name& name) const;
  const std::vector<Section>& sections() const { return sections_; }

 private:
  void add(Meaning global);
  void add(const Section& section, const Paragraph& paragraph);
  void refuse_ambiguous(const Name& name) const;
  const std::vector<Section>& sections_;
  std::unordered_map<Name, Meaning> globals_;
  std::unordered_map<Name, std::string> ambiguous_;  // these names have two meanings, as the texts say
  std::string of_toolkit_;                           // a section declares a name that the toolkit has, as this says
  bool is_whole_ = false;                            // all sections are added
};

/// Returns `S` for `ΔS` and for `ΞS`, unless the specification declares that name itself; else nothing.
std::optional<Name> implicit(const Name& name, std::string_view prefix, const Definitions& definitions);

/// Returns the names of a schema's components in the order of their declaration; nothing where it is no schema.
using Components = std::vector<Name>;
std::optional<Components> components(const Term& term, const Definitions& definitions);
Components components(const SchemaText& text, const Definitions& definitions);
Components components(const Declaration& declaration, const Definitions& definitions);

Name decorated(Name name, const std::string& strokes);
/// Returns the names, without the stroke, of the components that S ⨟ T joins (x' of S with x of T), and of those that
/// S ⨠ T joins (x! of S with x? of T).
std::vector<Name> joined(const Term& left, const std::string& stroke, const Term& right, const std::string& to_stroke,
                         const Definitions& definitions);
/// Returns what `pre S` hides: the after-state and the outputs.
Components hidden_by_pre(const Term& schema, const Definitions& definitions);

}  // namespace durero::zed
