#include "durero/zed/syntax/defect.hpp"

#include <fmt/core.h>

#include "durero/text/shown.hpp"

namespace durero::zed {

std::string Defect::text() const {
  return text::escaped(fmt::format("{}:{}:{}: {}{}; {}", file, place.line, place.column,
                                   severity == Severity::warning ? "warning: " : "", what, expected));
}

}  // namespace durero::zed
