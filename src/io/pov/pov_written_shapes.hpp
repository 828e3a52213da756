#pragma once
/// The superellipsoids and blobs of a POV-Ray text, as far as they are algebraic.

#include <optional>
#include <string>
#include <string_view>

#include "pov_words.hpp"
#include "pov_written.hpp"

namespace durero::io {

/// The most states of a blob: a ball with density or none has two, a cylinder with its round ends four.
inline constexpr std::size_t most_blob_states = 64;
/// The most parts of a blob.
inline constexpr std::size_t most_blob_parts = 6;

/// Reads a superellipsoid from behind its {; nothing where its polynomial has a degree above 24, or it has none.
std::optional<PovElement> read_pov_superellipsoid(PovWords& in);

/// Reads a blob from behind its { to behind its parts; nothing where it has more states or parts than the above, or a
/// part that is moved by another map than one that keeps angles. `looks` counts what tells of the looks of parts.
std::optional<PovElement> read_pov_blob(PovWords& in, std::size_t& looks);

}  // namespace durero::io
