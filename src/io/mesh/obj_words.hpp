#pragma once
/// The statements of OBJ, and the lines that they stand on.

#include <array>
#include <string>
#include <string_view>

namespace durero::io {

/// What a reader of OBJ does with a statement.
enum class ObjKind {
  vertex,
  face,
  normal,
  texture_coordinate,
  group,
  material,
  other  ///< is passed over: no vertex, no face
};

struct ObjWord {
  std::string_view word;
  ObjKind kind;
};

/// Every statement that may stand in a file; `fo` is an old name of `f`. Not among them are `call` and `csh`, which
/// fetch what stands elsewhere.
inline constexpr std::array obj_words = {
    ObjWord{"v", ObjKind::vertex},
    ObjWord{"f", ObjKind::face},
    ObjWord{"fo", ObjKind::face},
    ObjWord{"vn", ObjKind::normal},
    ObjWord{"vt", ObjKind::texture_coordinate},
    ObjWord{"o", ObjKind::group},
    ObjWord{"g", ObjKind::group},
    ObjWord{"usemtl", ObjKind::material},
    ObjWord{"mtllib", ObjKind::material},
    ObjWord{"p", ObjKind::other},
    ObjWord{"l", ObjKind::other},
    ObjWord{"s", ObjKind::other},
    ObjWord{"mg", ObjKind::other},
    ObjWord{"vp", ObjKind::other},
    ObjWord{"vw", ObjKind::other},
    ObjWord{"t", ObjKind::other},
    ObjWord{"bevel", ObjKind::other},
    ObjWord{"c_interp", ObjKind::other},
    ObjWord{"d_interp", ObjKind::other},
    ObjWord{"lod", ObjKind::other},
    ObjWord{"maplib", ObjKind::other},
    ObjWord{"usemap", ObjKind::other},
    ObjWord{"shadow_obj", ObjKind::other},
    ObjWord{"trace_obj", ObjKind::other},
    ObjWord{"ctech", ObjKind::other},
    ObjWord{"stech", ObjKind::other},
    ObjWord{"cstype", ObjKind::other},
    ObjWord{"deg", ObjKind::other},
    ObjWord{"bmat", ObjKind::other},
    ObjWord{"step", ObjKind::other},
    ObjWord{"curv", ObjKind::other},
    ObjWord{"curv2", ObjKind::other},
    ObjWord{"surf", ObjKind::other},
    ObjWord{"parm", ObjKind::other},
    ObjWord{"trim", ObjKind::other},
    ObjWord{"hole", ObjKind::other},
    ObjWord{"scrv", ObjKind::other},
    ObjWord{"sp", ObjKind::other},
    ObjWord{"end", ObjKind::other},
    ObjWord{"con", ObjKind::other},
    ObjWord{"bsp", ObjKind::other},
    ObjWord{"bzp", ObjKind::other},
    ObjWord{"cdc", ObjKind::other},
    ObjWord{"cdp", ObjKind::other},
    ObjWord{"res", ObjKind::other},
};

/// The row of a statement; null where there is none.
const ObjWord* obj_word(std::string_view word) noexcept;

/// The text with blanks where a line goes on: for a backslash at its end, which stands in no comment, and for the line
/// end. It is as long as before, so that every place stays where it is.
std::string obj_joined(std::string_view text);

/// How many vertices such a text has: a face may name one that stands below it.
std::size_t obj_vertex_count(std::string_view joined);

}  // namespace durero::io
