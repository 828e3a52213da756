#pragma once
/// A value of an attribute that a Z text declares, by its kind.

#include "durero/io/json/written_elements.hpp"

namespace durero::io {

/// read(value) fills a double, a glm::dvec3 or scene::Corners, as the kind says.
template <class Read>
WrittenValue read_written_value(WrittenKind kind, Read&& read) {
  const auto filled = [&](auto value) {
    read(value);
    return WrittenValue(value);
  };
  switch (kind) {
    case WrittenKind::number:
      return filled(0.0);
    case WrittenKind::triple:
      return filled(glm::dvec3());
    case WrittenKind::three_points:
      return filled(scene::Corners());
  }
  __builtin_unreachable();  // a kind is one of its enumerators
}

}  // namespace durero::io
