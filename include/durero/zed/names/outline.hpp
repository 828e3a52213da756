#pragma once
/// The outline of a text: what its paragraphs declare and claim, with the places.

#include <string>
#include <vector>

#include "durero/zed/names/cross_reference.hpp"

namespace durero::zed {

/// An entry of an outline is a paragraph, or a part of one.
struct OutlineEntry {
  /// The kind of an entry.
  enum class Part : unsigned char {
    section,
    given,
    free_type,
    branch,
    definition,
    axiom,
    schema,
    component,
    conjecture
  };
  Part part = Part::definition;            ///< it says what the entry is
  std::string name;                        ///< in Unicode; of a conjecture its label, or ⊢?
  std::string detail;                      ///< its type in Z notation, if it is known
  std::size_t from = 0, to = 0;            ///< the bytes of the file that it takes
  std::size_t name_from = 0, name_to = 0;  ///< those of its name, among them
  std::vector<OutlineEntry> entries;       ///< its own: those of a section, branches, components
};

/// Returns the outline of one of the checked texts: its sections, or, if no header names one, its paragraphs.
std::vector<OutlineEntry> outline(const CheckedTexts& of, const std::string& file);

}  // namespace durero::zed
