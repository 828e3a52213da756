#pragma once
/// A cross-reference tells of every name in some texts where it stands and what it stands for.
///
/// Components have one referent through all that carries them along: inclusion, decoration, Δ and Ξ, renaming, hiding,
/// θ, a schema as a predicate, and bindings of which a component is selected. So a referent is what a renaming must
/// rename as a whole.

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "durero/zed/syntax/reader.hpp"
#include "durero/zed/types/typecheck.hpp"

namespace durero::zed {

/// A referent is what names stand for. All its names have one word; their strokes may differ, as those of x and x' do.
struct Referent {
  /// The form of a referent. One that is several of these has the last of them.
  enum class Form : unsigned char {
    variable,   ///< a quantifier, λ, μ, let or a set comprehension declares it
    formal,     ///< a generic formal
    component,  ///< a component of a schema
    global,     ///< a paragraph declares it for its section
    toolkit     ///< the language or its toolkit has it
  };
  Form form = Form::variable;  ///< the greatest of those that it is
  Name name;                   ///< as it is declared first
};

/// An occurrence is a name at its place in a file.
struct Occurrence {
  std::size_t from = 0, to = 0;  ///< its bytes in the file
  Place place;                   ///< the same as a place
  std::string section;           ///< the section that it stands in
  Name name;                     ///< the name as it stands there
  std::string sign;          ///< Δ or Ξ where it is that sign with the name of a schema, and declared nowhere itself
  bool is_operator = false;  ///< it is a word or symbol of an operator, whose name is that of the referent
  bool declares = false;     ///< it declares the referent
  std::optional<std::size_t> referent;  ///< an index of CrossReference::referents; none where the name is not declared
  std::optional<Type> type;             ///< none where it is not known
};

/// A cross-reference lists the occurrences in each file, in the order of the text.
struct CrossReference {
  std::map<std::string, std::vector<Occurrence>> files;  ///< by the names that the files were read under
  std::vector<Referent> referents;                       ///< some of them stand for no occurrence
  /// Says whether each name was found in the tree of its paragraph: so it is where all was read without a defect.
  bool complete = true;

  /// Returns the occurrence that this byte of a file is in, or that ends there; null where there is none.
  const Occurrence* at(const std::string& file, std::size_t byte) const;
};

/// Texts, by the names of their files, that are read and checked together.
struct CheckedTexts {
  std::map<std::string, std::string> texts;  ///< as they were read
  Specification read;                        ///< their sections, with those of parents that were found beside them
  Typing typing;                             ///< the types of these
  /// Says whether reading and types found no error.
  bool ok() const { return read.ok() && typing.ok(); }
};

/// Reads and checks texts.
CheckedTexts checked(std::map<std::string, std::string> texts);

/// Returns the cross-reference of checked texts.
CrossReference cross_reference(const CheckedTexts& of);

}  // namespace durero::zed
