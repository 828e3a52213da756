#pragma once
/// What there is to say of a scene file: all that is wrong with it, or, of a file that is right, each invariant of
/// Escena, of its materials and of its lights. As text, and for programs as JSON and as SARIF 2.1.0.

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "durero/io/json/format_version.hpp"
#include "durero/io/json/scene_file.hpp"
#include "durero/io/json/stage_check.hpp"
#include "durero/io/json/written_elements.hpp"
#include "durero/io/source.hpp"
#include "durero/model/operation.hpp"
#include "durero/scene/scene.hpp"

namespace durero::io {

/// What the text of check_json() says of itself.
inline constexpr json::FormatVersion check_format{"durero-check", 1};

/// Something wrong, and where.
struct SceneDefect {
  const contract::clause* broken;      ///< null where no clause speaks of it: the file is malformed
  std::string message;                 ///< what is wrong; what is expected
  std::optional<std::string> pointer;  ///< to the value in the file, or to where it should be; none where it is no JSON
  TextPosition place;                  ///< in the file; of a broken invariant, where the element begins
};

/// What check_scene() has found.
struct SceneCheck {
  std::string file;      ///< the name of the source
  scene::Scene scene{};  ///< without what is wrong
  /// How many there are of each type that a Z text declares, and of each kind of body; in the scene they stand as
  /// spheres.
  std::map<std::string, std::size_t> written{};
  std::vector<InputError> errors{};     ///< as they were met: the first is what read_scene throws
  model::Judgements invariants{};       ///< none where there is an error: then there is no scene to judge
  std::vector<SceneDefect> findings{};  ///< in the order of the file
  std::vector<Warning> warnings{};      ///< of what is right, and may not be meant
};

/// Reads the whole file and judges the scene. What is wrong with the file is found, not thrown.
SceneCheck check_scene(const Source& file);

/// Elements may be of these types too here, and bodies are read or refused. Where the file is right otherwise, `judge`
/// is called: the InputError that it throws of this file is found, any other thrown on.
SceneCheck check_scene(const Source& file, std::span<const WrittenType> types, Bodies bodies,
                       const std::function<void()>& judge);

/// A finding for each element that breaks an invariant. A scene that was read breaks none, unless the program is wrong.
std::vector<SceneDefect> broken_invariants(const Source& file, const model::Escena& escena);

/// The elements by shape, a line for each invariant and one for each warning; `fails` is the word for one that does not
/// hold.
std::string check_text(const SceneCheck& check, std::string_view fails = "fails");
/// One JSON object: the findings and, of a file without errors, what check_text() says. Ends its line.
std::string check_json(const SceneCheck& check);
/// A SARIF log: each finding is a result, under the label of the clause it breaks or as `malformed`. Ends its line.
std::string check_sarif(const SceneCheck& check);

}  // namespace durero::io
