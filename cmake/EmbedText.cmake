# cmake -D OUT=FILE.cpp -D FUNCTION=NAME -D ROOT=DIR -D FILES="a;b" -P EmbedText.cmake: files as a map from their names,
# relative to ROOT, to their contents, in the function durero::embedded::NAME().
set(entries "")
foreach(file IN LISTS FILES)
  file(RELATIVE_PATH name "${ROOT}" "${file}")
  file(READ "${file}" text)
  # A string literal is short, for compilers that limit it: one line each.
  string(REGEX REPLACE "\\\\" "\\\\\\\\" text "${text}")
  string(REPLACE "\"" "\\\"" text "${text}")
  string(REPLACE "\n" "\\n\"\n     \"" text "${text}")
  string(APPEND entries "    all.emplace(\"${name}\",\n     \"${text}\");\n")
endforeach()
file(WRITE "${OUT}" "#include <map>\n#include <string>\n\nnamespace durero::embedded {\n
const std::map<std::string, std::string>& ${FUNCTION}();
const std::map<std::string, std::string>& ${FUNCTION}() {
  static const auto files = [] {\n    std::map<std::string, std::string> all;\n${entries}    return all;\n  }();
  return files;\n}\n\n}  // namespace durero::embedded\n")
