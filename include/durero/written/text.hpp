#pragma once
/// A Z text declares types of elements: `puntos_toro` defines the points of an element of type `toro`.
///
/// The parameters of the function are the attributes of the type, by their names: those of the ∀, or λ, that defines
/// it, or the components of a schema that is its only one. An attribute is a number, a point or vector, or three
/// points. docs/surfaces.md tells how a text is written.

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "durero/io/json/written_elements.hpp"
#include "durero/io/source.hpp"
#include "durero/written/moved_points.hpp"
#include "durero/written/surface.hpp"

namespace durero::written {

/// How far the numbers of an attribute are off: by a part of the largest magnitude of them, and by a length besides. A
/// numeral of the text is off by that part of itself.
struct AttributeErrors {
  number::Rational part;   ///< not negative
  number::Rational least;  ///< not negative
};

/// A Z text with types of elements, which any number of threads may use at once.
class Text {
 public:
  /// Reads a file, and its parents: from its folder, or the program's own text. Throws io::FileError, and
  /// io::InputError at its first error.
  explicit Text(const std::string& file);
  /// Reads a text that is held whole, and its parents from the program's own text; no file is asked. Throws
  /// io::InputError at its first error.
  explicit Text(const io::Source& source);
  ~Text();
  Text(Text&&) noexcept;             ///< takes over the other, which is then for its end or an assignment only
  Text& operator=(Text&&) noexcept;  ///< likewise

  /// The file.
  const std::string& file() const;
  /// Every type that a section of the file declares, as scene files are to have its elements; types with shapes of the
  /// program are not among them.
  const std::vector<io::WrittenType>& types() const;
  /// Whether the file says itself what the points of a type are that the program has a shape for, or has a section in
  /// the place of one of the program's own. Otherwise the program's formulas have the same points.
  bool declares_shapes() const;

  /// The points of an element of that type, whose attributes have these values, in the order of the parameters. Throws
  /// NotInDomain where the text defines none for them, and io::InputError at the place of a definition that is no
  /// algebraic surface, or where the text declares no such function.
  Surface surface(const std::string& type, const std::vector<io::WrittenValue>& attributes) const;
  /// The points of an element at a point that moves, where its numbers and that point are off. Whether the numbers are
  /// in the domain, the numbers as they are given say. Throws as surface() does, and where the text asks which of two
  /// polynomials it is, and numbers that are off have either.
  MovedPoints moved_points(const std::string& type, const std::vector<io::WrittenValue>& attributes,
                           const AttributeErrors& errors, const MovedPoint& at) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// The error of an element whose attributes are not in the domain of its function.
struct NotInDomain {
  std::string type;       ///< the TYPE of puntos_TYPE
  std::string attribute;  ///< the attribute in error; empty where it is several together
  std::string expected;   ///< the predicate that must hold, in Z
};

}  // namespace durero::written
