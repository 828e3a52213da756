#pragma once
/// Every clause of an operation that would not hold, where the answer to it tells the first alone.

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "durero/io/json/edited_scene.hpp"
#include "durero/io/json/operations_file.hpp"

namespace durero::io {

/// A value that a predicate speaks of; of what has none, such as de_que_tipo(e?) where e? ∉ elementos, nothing.
using PredicateValue = std::variant<std::monostate, std::string, double, std::uint64_t, glm::dvec3,
                                    std::array<glm::dvec3, 3>, std::vector<std::string>>;

/// A part of a predicate, and its value.
struct NamedValue {
  std::string word;      ///< as the predicate has it, `radio?`; or what shows why it is false, such as a face
  PredicateValue value;  ///< in the scene before the operation
};

/// A clause of an operation that does not hold.
struct BrokenClause {
  std::string label;                 ///< as in the text, `Agregar_Esfera.pre.2`
  std::string predicate;             ///< in Unicode
  std::vector<NamedValue> values{};  ///< in the order in which the operation has its inputs
};

/// The answer to an operation that is not carried out.
struct WhyNot {
  EditAnswer answer;                   ///< as the operation would be answered
  std::vector<BrokenClause> broken{};  ///< in the order of the text; none where it would be carried out
  /// Whether these are all. A Z text of --with tells the first predicate that does not hold, and only where every
  /// clause of the program's own holds.
  bool is_whole = true;
};

/// Finds every clause of a step that does not hold. The scene stays as it is. O(n log n). Throws as apply_total() does,
/// and std::logic_error where the step would be carried out though a clause does not hold: the program is wrong.
WhyNot why_not(const EditedScene& edited, const ScriptStep& step);

/// `{"line":1,"ok":false,"r":"radio_no_positivo","broken":[{"label":…,"predicate":…,"values":{…}}]}`, with
/// `"whole":false` where there may be others; without line end.
std::string why_not_text(std::size_t line, const WhyNot& told);

}  // namespace durero::io
