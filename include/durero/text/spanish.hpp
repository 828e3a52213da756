#pragma once
/// English for the names of the Z text, which are Spanish: one table, from which the help, the messages, the Python
/// package and docs/spanish.md take it.

#include <span>
#include <string>
#include <string_view>

namespace durero::text {

/// A name of the Z text, or a word that such names are made of, with its English and its meaning.
struct SpanishName {
  std::string_view name;     ///< as the text has it, with the `?` of an input and the `!` of an output
  std::string_view english;  ///< without `?` and `!`; the same word where the name is English or a symbol
  std::string_view meaning;  ///< in one line
};

/// The table, in the order of the text.
std::span<const SpanishName> spanish_names();

/// The English of a name; empty where the table lacks it.
std::string_view english_of(std::string_view name);

/// The English that a message puts behind a name: ` (radius)` of `radio`; empty where it is the same word, or none is
/// known. Of an input that the table lacks, such as `elementos?`, it is that of the name without its mark.
std::string english_beside(std::string_view name);

/// The name as a message shows it: `radio (radius)`.
std::string with_english(std::string_view name);

}  // namespace durero::text
