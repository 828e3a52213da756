#pragma once
/// Readers of profiles, of their sources, and of parts that other files share with them.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "durero/conform/ask/profile.hpp"
#include "durero/io/json/json.hpp"
#include "durero/text/shown.hpp"

namespace durero::conform {

/// Reads the object of a key "profile" into the profile, whose name and sources stay.
void read_profile_members(io::json::Reader& in, Profile& profile);

/// Reads the array of a key "sources". Each claim must be a key of a profile.
std::vector<Citation> read_sources(io::json::Reader& in);

/// Reads the words of types of elements and of kinds of bodies, at least one.
void read_tipos(io::json::Reader& in, std::string_view what, std::vector<model::Tipo>& tipos,
                std::vector<BodyKind>& bodies);

/// Reads a word of a closed set, which lists them in the order of the enumerators.
template <class Enumeration, std::size_t count>
Enumeration read_word(io::json::Reader& in, std::string_view what, const std::array<std::string_view, count>& words) {
  const std::size_t at = in.offset();
  const std::string_view word = in.string(what);
  const auto place = std::ranges::find(words, word);
  if (place == words.end())
    in.fail(at, fmt::format("{} is {}", what, text::shown(word)),
            fmt::format("expected one of {}", fmt::join(words, ", ")));
  return static_cast<Enumeration>(place - words.begin());
}

/// Reads a string that must be `expected`, such as the name of a system.
void read_exactly(io::json::Reader& in, std::string_view what, std::string_view expected);

}  // namespace durero::conform
