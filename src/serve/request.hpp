#pragma once
/// The bodies of requests, read.

#include <string>
#include <string_view>
#include <vector>

#include "durero/scene/query.hpp"
#include "durero/scene/scene.hpp"
#include "store_worker.hpp"

namespace durero::serve {

/// Reads an edit:
///   {"operations":["Agregar_Esfera e?=a
///   …",{"op":"Eliminar_Esfera","e":"a"}],"all_or_nothing":true,"comment":"…","author":"…"}
/// Throws io::InputError at the first thing that is wrong, with its place in the body. The time is now.
AskedEdit read_edit(std::string_view body, const std::string& author);

/// Reads rays: {"rays":[[px,py,pz,vx,vy,vz],…]}, or of each {"ray":[…],"on":["a"]} with the elements that it starts on.
/// Throws io::InputError.
std::vector<scene::Query> read_rays(std::string_view body, const scene::Scene& scene);

}  // namespace durero::serve
