#pragma once
/// Reads files of Z text as a specification, whose sections stand in an order in which each comes behind its parents.

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "durero/zed/syntax/ast.hpp"
#include "durero/zed/syntax/defect.hpp"
#include "durero/zed/syntax/markup.hpp"
#include "durero/zed/syntax/operators.hpp"

namespace durero::zed {

/// A specification is the result of reading files: sections where their text could be read, defects where not.
struct Specification {
  std::vector<Section> sections;         ///< parents come first
  std::map<std::string, Markup> markup;  ///< each section has the directives in force in it, its parents' too
  /// Each section has the operators of the templates in it, and of its parents'.
  std::map<std::string, Operators> operators;
  /// The files that are read as Spivey's Z, each with the sign in it that tells so; ISO's are not among them.
  std::map<std::string, std::string> spivey;
  std::vector<Defect> defects;   ///< reading found these; a paragraph that cannot be read is left out
  std::vector<Defect> warnings;  ///< warnings about text that is read, and may be meant otherwise

  /// Says whether all was read without a defect. Types and the rest are not looked at yet (typecheck.hpp, review.hpp).
  bool ok() const { return defects.empty(); }
  /// Returns the section of this name, or null where none was read, as for those of the toolkit.
  const Section* find(const std::string& name) const;
};

/// The size in bytes of the largest file that is read, forty times spec/. A byte takes at most 400 of memory, as a
/// token and a node.
inline constexpr std::size_t max_bytes = 1 << 20;

/// Says whether a section is one of the toolkit's, which any section may have as parents; they are built in and not
/// read.
bool is_toolkit(const std::string& section);

/// Says whether a section is of the program and stands in no file: that of the bags of Spivey's Z.
bool is_built_in(const Section& section);

/// Reads files, and the parents that they name: from the files given, or from those in the folder of the
/// file that names the parent which end in `.tex`, `.utf8`, `.zed` or `.zed8`. A file that cannot be opened is a
/// defect.
Specification read_files(const std::vector<std::string>& files);

/// Reads texts that were files, each with its name, in this order. Parents are looked for as by read_files.
Specification read_sources(const std::vector<std::pair<std::string, std::string>>& sources);

/// Reads texts in memory, by the names of the files that they stand for. Parents are looked for among them alone.
Specification read_texts(const std::map<std::string, std::string>& texts);

/// Reads one text as a file of this name. Parents are looked for as by read_files.
Specification read_text(const std::string& text, const std::string& file);

}  // namespace durero::zed
