#pragma once
/// Names of elements and meshes, made of the name of a file.

#include <string>
#include <string_view>

#include "durero/model/tipos.hpp"

namespace durero::io {

/// A file's name without folders, its first `longest` characters; `_` stands for what may not stand in a name.
inline std::string file_as_name(std::string_view file, std::size_t longest) {
  std::string name(file.substr(file.rfind('/') + 1).substr(0, longest));
  for (char& c : name)
    if (!model::Elemento::is_name(std::string_view(&c, 1))) c = '_';
  return name;
}

}  // namespace durero::io
