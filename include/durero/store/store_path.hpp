#pragma once
/// The name of a store is the path of a file, or the URI of a PostgreSQL server.

#include <string>
#include <string_view>

namespace durero::store {

/// Whether it begins as libpq's connection URIs do: postgresql:// or postgres://.
bool is_server_uri(std::string_view path) noexcept;

/// The path as messages show it: a URI without its password, and without parameters that are secret.
std::string shown_path(std::string_view path);

/// The path from whose folder the pictures of a store's scenes are named: its own; a store on a server has /.
std::string picture_place(const std::string& path);

}  // namespace durero::store
