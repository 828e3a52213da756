#pragma once
/// The functions that answer calls, each with an object of JSON. All of them throw an exception for a call that is
/// wrong.

#include <string>

#include "asked.hpp"

namespace durero::web {

/// @{ The text and what carries it out.
std::string answer_text(const AskedCall& asked);
std::string answer_labels(const AskedCall& asked);
std::string answer_errata(const AskedCall& asked);
std::string answer_operations(const AskedCall& asked);
/// @}
/// @{ Scenes and their edits.
std::string answer_check(const AskedCall& asked);
std::string answer_edit(const AskedCall& asked);
/// @}
/// @{ Rays.
std::string answer_trace(const AskedCall& asked);
std::string answer_ray(const AskedCall& asked);
std::string answer_light(const AskedCall& asked);
std::string answer_surface(const AskedCall& asked);
std::string answer_render_shader(const AskedCall& asked);
/// @}
/// @{ Z.
std::string answer_eval(const AskedCall& asked);
std::string answer_zed_check(const AskedCall& asked);
std::string answer_zed_run(const AskedCall& asked);
std::string answer_zed_graph(const AskedCall& asked);
/// @}

}  // namespace durero::web
