#pragma once
/// What a message suggests where a word stands that is none of a closed list.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace durero::text {

/// The fewest characters that are written, left out or replaced, or neighbours that are exchanged, to make one text of
/// the other (Damerau's distance, in which no place is changed twice).
std::size_t apart(std::string_view a, std::string_view b);

/// The word of the list whose English the given one is (spanish.hpp), or else that it is a slip of: the least apart,
/// the first of several, where no more than a third of its characters, or one of three and more, are amiss.
std::optional<std::string> nearest(std::string_view word, const std::vector<std::string>& list);

/// The words that a message expects in place of the given one: the nearest of the list, or else `one of` them all, each
/// name of the Z text with its English.
std::string expected_of(std::string_view word, const std::vector<std::string>& list);

}  // namespace durero::text
