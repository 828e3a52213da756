#include "durero/io/json/file_patch.hpp"

#include <string_view>

#include "json_patch.hpp"

namespace durero::io::json {

bool is_patch(const Source& source) {
  const std::size_t first = source.text().find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && source.text()[first] == '[';
}

PatchedFile patched_file(const Source& file, const Source& patch) {
  JsonValue value = read_whole(file);
  PatchedFile patched;
  patched.operations = apply_patch(patch, value);
  append_lines(patched.text, value);
  return patched;
}

}  // namespace durero::io::json
