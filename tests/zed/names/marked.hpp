#pragma once
/// A text with a place marked in it, as one who edits it stands there.

#include <set>
#include <string>

#include "durero/zed/names/cross_reference.hpp"
#include "support/catch.hpp"

namespace durero::zed::test {

/// A text without its mark ‸, and the byte where that stood.
struct MarkedText {
  std::string text;
  std::size_t at;

  explicit MarkedText(std::string marked) : text(std::move(marked)), at(text.find("‸")) {
    REQUIRE(at != text.npos);
    text.erase(at, std::string("‸").size());
  }
};

inline const char* marked_file = "no-such-folder/m.tex";

/// The lines, from 1, with columns, of all names that have the referent of the marked one: 3:5 and so on. A declaration
/// has a star.
inline std::set<std::string> places_of_marked(const std::string& marked) {
  const MarkedText mark(marked);
  const CheckedTexts of = checked({{marked_file, mark.text}});
  for (const Defect& defect : of.read.defects) FAIL(defect.text());
  for (const Defect& defect : of.typing.defects) FAIL(defect.text());
  const CrossReference names = cross_reference(of);
  CHECK(names.complete);
  const Occurrence* occurrence = names.at(marked_file, mark.at);
  REQUIRE(occurrence);
  REQUIRE(occurrence->referent);
  std::set<std::string> places;
  for (const Occurrence& each : names.files.at(marked_file))
    if (each.referent == occurrence->referent)
      places.insert(std::to_string(each.place.line) + ":" + std::to_string(each.place.column) +
                    (each.declares ? "*" : ""));
  return places;
}

}  // namespace durero::zed::test
