#pragma once
/// A renaming gives a referent another name wherever it stands, and changes nothing else that a text says.

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "durero/zed/names/cross_reference.hpp"

namespace durero::zed {

/// A replacement puts a text in the place of some bytes of a file.
struct Replacement {
  std::size_t from = 0, to = 0;  ///< these bytes, which may be none
  std::string text;              ///< it comes in their place
};

/// Returns a text with replacements made. Precondition: they are in its order, and none overlaps another.
std::string replaced(std::string_view text, const std::vector<Replacement>& replacements);

/// Returns the word that a renaming of this occurrence replaces: its name without strokes, and without the Δ or Ξ of an
/// implied schema. Throws ZError where the occurrence is not renamed, as an operator and a name of the toolkit are not.
std::string word_to_rename(const CheckedTexts& of, const CrossReference& names, const Occurrence& occurrence);

/// Renames the referent of an occurrence to a word, which may be typed in Unicode or in LaTeX, with the strokes of the
/// occurrence or without: replacements by file, in the order of each. It is refused where the texts have an error, the
/// word is no name, or where a name would stand for something else than before: what was renamed is read again, and
/// each name in it must have the referent that it had. Throws ZError.
std::map<std::string, std::vector<Replacement>> renamed(const CheckedTexts& of, const CrossReference& names,
                                                        const Occurrence& occurrence, const std::string& to);

}  // namespace durero::zed
