#pragma once
/// What logs of SARIF 2.1.0 have in common, whatever they tell of.

#include <span>
#include <string>
#include <string_view>

#include "durero/io/json/json_writer.hpp"

namespace durero::io {

/// What a result can be of. The texts must outlive it.
struct SarifRule {
  std::string_view id, description;  ///< the name by which results refer to it, and what it means
};

/// Begins a log of one run: its tool and the rules that results refer to. Members of the run may follow.
void begin_sarif(json::Writer& out, std::string_view tool, std::span<const SarifRule> rules);
/// Ends the array of results, the run and the log.
void end_sarif(json::Writer& out);

/// A member that is a message.
void write_sarif_message(json::Writer& out, std::string_view key, std::string_view text);

/// A file's name as the reference to it (RFC 3986).
std::string sarif_uri(std::string_view file);

}  // namespace durero::io
