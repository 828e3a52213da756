#pragma once
/// The headers of a text name its sections, and so the texts that it is read with.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace durero::zed {

/// Returns the names of the sections of a text with those of their parents, as its headers say. A header that cannot be
/// read is left out: reading the text reports it.
std::vector<std::pair<std::string, std::vector<std::string>>> section_headers(std::string_view text);

}  // namespace durero::zed
