#pragma once
/// Spivey's Z, as textbooks, fuzz, ProB and Jaza write it: where its LaTeX mark-up is read otherwise than ISO's.
///
/// Blanks separate words. `S'` decorates a schema S. `\defs` defines one, `-` may be a sign, and `%%inop` and its like
/// declare operators. What both mark-ups write alike is read alike, so that `S~'` and `==` are read here too.

#include <array>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "durero/zed/syntax/ast.hpp"
#include "durero/zed/syntax/operators.hpp"

namespace durero::zed {

/// A text in Spivey's Z, by what is known before its paragraphs are read.
struct SpiveyText {
  std::string sign;                              ///< by it the text is known: `\usepackage{fuzz}`, `\defs`, `S'`
  Place place;                                   ///< the sign stands there
  std::set<std::string, std::less<>> schemas{};  ///< their names, which a stroke decorates
  std::set<std::string, std::less<>> names{};    ///< its names that are words of ISO's operators: `seq`, `mod`
  bool has_bags = false;                         ///< it uses the bags that ISO Z lacks
};

/// What is known of a text in LaTeX mark-up that is Spivey's Z; null where it is ISO's. A text with a section header is
/// ISO's. Else the first of these tells: a package of Spivey's Z or of ISO's, a command or directive that ISO lacks, a
/// schema with a stroke behind its name, S', in a document that \begin{document} begins, whatever its packages.
std::shared_ptr<const SpiveyText> spivey_text(std::string_view text);

/// Says whether a word without a backslash is a name, though ISO Z has it for a keyword, such as `function`, or for an
/// operator: as a keyword or operator Spivey's Z writes a command.
bool is_name_of_spivey(std::string_view word, const SpiveyText& text);

/// The Unicode text of a command that ISO lacks, or has for something else; nothing of another.
std::optional<std::string_view> spivey_command(std::string_view command);

/// The commands of bags.
inline constexpr std::array<std::string_view, 9> bag_commands = {"bag",    "lbag",   "rbag",  "uplus",   "uminus",
                                                                 "otimes", "bcount", "inbag", "subbageq"};

/// A directive of fuzz: `%%inop \foo 3`.
struct SpiveyDirective {
  /// The kinds of it; `passed` tells fuzz about types, and nothing here.
  enum class Kind : unsigned char { operators, ignored, unchecked, passed };

  Kind kind = Kind::passed;
  std::vector<std::string> words{};           ///< without backslashes
  std::vector<OperatorTemplate> operators{};  ///< of each word, with its Unicode text among the parts
};

/// Says whether a line begins with %% and no directive: LaTeX passes over it, and Z goes on behind the two signs.
bool is_hidden_line(std::string_view line);

/// Reads the directive on a line, which begins with %%; nothing where fuzz has none of its name. Throws ZError.
std::optional<SpiveyDirective> spivey_directive(std::string_view line, Place place);

}  // namespace durero::zed
