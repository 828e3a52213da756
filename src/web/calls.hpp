#pragma once
/// What answers each call: a function from the call to an object of JSON. All of them throw what is wrong.

#include <string>

#include "asked.hpp"

namespace durero::web {

/// @{ The text and what carries it out.
std::string answer_text(const Asked& asked);
std::string answer_labels(const Asked& asked);
std::string answer_errata(const Asked& asked);
std::string answer_operations(const Asked& asked);
/// @}
/// @{ Scenes and their edits.
std::string answer_check(const Asked& asked);
std::string answer_edit(const Asked& asked);
/// @}
/// @{ Rays.
std::string answer_trace(const Asked& asked);
std::string answer_ray(const Asked& asked);
std::string answer_light(const Asked& asked);
std::string answer_surface(const Asked& asked);
std::string answer_render_shader(const Asked& asked);
/// @}
/// @{ Z.
std::string answer_eval(const Asked& asked);
std::string answer_zed_check(const Asked& asked);
std::string answer_zed_run(const Asked& asked);
std::string answer_zed_graph(const Asked& asked);
/// @}

}  // namespace durero::web
