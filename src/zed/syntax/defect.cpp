#include "durero/zed/syntax/defect.hpp"

#include <fmt/core.h>

namespace durero::zed {

std::string Defect::text() const {
  return fmt::format("{}:{}:{}: {}{}; {}", file, place.line, place.column,
                     severity == Severity::warning ? "warning: " : "", what, expected);
}

}  // namespace durero::zed
