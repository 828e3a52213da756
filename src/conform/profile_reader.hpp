#pragma once
/// Reads profiles, and the sources of what they claim.

#include "durero/conform/profile.hpp"
#include "durero/io/json.hpp"

namespace durero::conform {

/// The object of a key "profile", into the profile; its name and its sources stay.
void read_profile_members(io::json::Reader& in, Profile& profile);

/// The array of a key "sources". A claim must be a key of a profile.
std::vector<Source> read_sources(io::json::Reader& in);

/// A string that must be this one, such as the name of a format.
void read_exactly(io::json::Reader& in, std::string_view what, std::string_view expected);
/// The number 1.
void read_version_one(io::json::Reader& in);

}  // namespace durero::conform
