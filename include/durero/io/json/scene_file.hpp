#pragma once
/// Scene files: JSON, `{"format":"durero-scene","version":1,…,"elementos":[…]}`.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "durero/io/json/format_version.hpp"
#include "durero/io/json/written_elements.hpp"
#include "durero/io/source.hpp"
#include "durero/scene/scene.hpp"

namespace durero::io {

/// What scene files say of themselves: read_scene() asks for it, and scene_text() writes it.
inline constexpr json::FormatVersion scene_format{"durero-scene", 1};

/// The answer to elements with bodies, such as instances.
enum class Bodies : bool {
  refused,  ///< an error where one stands: in the tables it would be taken for a sphere
  read      ///< they are read: the caller asks Scene::body()
};

/// Reads a scene. A file is good when it is JSON, has the keys of the format and no others, and every element can be
/// added by its operation; otherwise throws InputError at the first value or key that is wrong, with the label of the
/// clause that it breaks, if it breaks one. Names of materials are any text of at least one character.
scene::Scene read_scene(const Source& source, Bodies bodies = Bodies::refused);

/// Reads what there is of a scene: an element, or another member of the file, that is wrong is passed over, and its
/// error goes to the others. The first of them is what read_scene(source) throws.
scene::Scene read_scene(const Source& source, std::vector<InputError>& errors, Bodies bodies = Bodies::refused);

/// Reads a scene whose elements may be of these types too; they go to `elements`, in the order of the file. In the
/// scene each of them has its name and its material, and stands in the tables as a sphere, which says nothing of where
/// it is. Throws InputError as read_scene(source) does.
scene::Scene read_scene(const Source& source, std::span<const WrittenType> types, std::vector<WrittenElement>& elements,
                        Bodies bodies = Bodies::refused);
/// Reads what there is of one; the errors go to the others, as above.
scene::Scene read_scene(const Source& source, std::span<const WrittenType> types, std::vector<WrittenElement>& elements,
                        std::vector<InputError>& errors, Bodies bodies = Bodies::refused);

/// Where an element stands in its file.
struct ElementPlace {
  std::string pointer;  ///< `/elementos/3`, or `/mallas/0/caras/17` of a face
  TextPosition place;   ///< of its opening bracket
};

/// Precondition: the source is the text of a scene that has the element.
ElementPlace element_place(const Source& source, std::string_view name);

/// The canonical text of a scene: the same scene gives the same bytes. Elements stand one a line, ascending by name,
/// and so do meshes, each with a point and a face a line.
std::string scene_text(const scene::Scene& scene);

}  // namespace durero::io
