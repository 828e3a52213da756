#pragma once
/// The values that the corners of an OBJ file's faces name, of one kind: texture coordinates, or normals.

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "durero/io/source.hpp"
#include "durero/text/shown.hpp"
#include "face_corners.hpp"

namespace durero::io {

/// The numbers that a corner may have for a thing of which the file has so many, each said by a statement.
inline std::string expected_number(std::size_t count, std::string_view statement) {
  if (count == 0) return fmt::format("expected a {} before it: there is none", statement);
  return fmt::format("expected 1 to {}, or a distance back to one above", count);
}

/// The values of one kind while a file is read. A face may name a value that stands below it.
template <class Value>
class ObjCorners {
 public:
  /// The statement of a value, and its name in messages.
  ObjCorners(const Source& source, std::string_view statement, std::string_view name)
      : source_(source), statement_(statement), name_(name) {}

  void add(const Value& value) { corners_.values.push_back(value); }
  std::size_t count() const { return corners_.values.size(); }

  /// The corner of a face names a value: its number from 0, and where it stands. The greatest of the numbers whose
  /// values may stand below is looked for at the end.
  void name(std::size_t at, std::string_view word, std::int64_t number) {
    const Named named{at, word, number};
    if (number < 0) fail(named);
    if (number >= static_cast<std::int64_t>(count()) && (!late_ || late_->number < number)) late_ = named;
    face_.push_back(number);
  }
  /// Ends a face, which has values if each of its corners has named one.
  void end_face(std::size_t corners) {
    if (face_.size() != corners) face_.clear();
    corners_.of_face.push_back(std::exchange(face_, {}));
  }

  /// Throws InputError where a face named a value that the file does not have.
  void end() const {
    if (late_ && late_->number >= static_cast<std::int64_t>(count())) fail(*late_);
  }

  /// How many values no face has.
  std::size_t unused() const {
    std::vector<bool> used(count());
    for (const Face& face : corners_.of_face)
      for (const std::int64_t number : face) used[static_cast<std::size_t>(number)] = true;
    return static_cast<std::size_t>(std::ranges::count(used, false));
  }

  /// The values, and what each face has of them.
  FaceCorners<Value> take() { return std::move(corners_); }

 private:
  struct Named {
    std::size_t at;
    std::string_view word;
    std::int64_t number;
  };
  [[noreturn]] void fail(const Named& named) const {
    source_.fail(named.at, fmt::format("{} names no {}", text::shown(named.word), name_),
                 expected_number(count(), statement_));
  }

  const Source& source_;
  const std::string_view statement_, name_;
  FaceCorners<Value> corners_;
  Face face_;  ///< the numbers of the face that is read
  std::optional<Named> late_{};
};

}  // namespace durero::io
