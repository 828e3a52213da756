#include "durero/zed/syntax/defect.hpp"

#include <fmt/core.h>

#include "durero/text/shown.hpp"

namespace durero::zed {

namespace {

const char* weight(Defect::Severity severity) {
  switch (severity) {
    case Defect::Severity::error:
      return "";
    case Defect::Severity::warning:
      return "warning: ";
    case Defect::Severity::opinion:
      return "opinion: ";
  }
  return "";
}

}  // namespace

std::string Defect::text() const {
  return text::escaped(
      fmt::format("{}:{}:{}: {}{}; {}", file, place.line, place.column, weight(severity), what, expected));
}

}  // namespace durero::zed
