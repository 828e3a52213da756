#pragma once
/// The parts that reports in JSON share.

#include <string_view>

#include "durero/conform/report/report.hpp"
#include "durero/io/json/json_writer.hpp"

namespace durero::conform {

using io::json::Writer;

/// The members `profile` and `sources`.
void write_profile(Writer& out, const Profile& profile);

/// The member `least`: a finding made small, and data that would explain it.
void write_least(Writer& out, const Profile& profile, const LeastFinding& least);

/// A member that is an array of names.
template <class Names>
void write_names(Writer& out, std::string_view key, const Names& names) {
  out.key(key).begin_array();
  for (const auto& each : names) out.value(each);
  out.end_array();
}

}  // namespace durero::conform
