#pragma once
/// Addresses of files, as editors write them: file:///folder/a%20text.tex.

#include <string>
#include <string_view>

namespace durero::lsp {

/// Returns the path that a file's address names, without `.` and `..` in it; of any other address, such as
/// `untitled:Untitled-1`, the address itself, which is no path of a file.
std::string path_of_uri(std::string_view uri);

/// Returns the address of a file at a path.
std::string uri_of_path(std::string_view path);

}  // namespace durero::lsp
