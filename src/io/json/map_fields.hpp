#pragma once
/// Affine maps in files: three rows of four entries, each a number or the text of a fraction.

#include <optional>
#include <string_view>

#include "durero/io/json/json.hpp"
#include "durero/io/json/json_writer.hpp"
#include "durero/model/instancias.hpp"

namespace durero::io {

/// A map. Fails where it makes a plane of space (Mapa.inv.1).
model::Mapa read_map(json::Reader& in);

/// Writes an entry that is a binary64 as a number, and each other one as a fraction in lowest terms.
void write_map(json::Writer& out, const model::Mapa& mapa);

/// The text of a fraction, `p` or `p/q` with whole numbers and q > 0; nothing where it is none, or one of more than
/// 1000 characters.
std::optional<number::Rational> fraction_of(std::string_view text);

}  // namespace durero::io
