#pragma once
/// The formats of JSON that this layer reads and writes, each in its version. docs/formats.md has them all.

#include "durero/conform/suite_file.hpp"
#include "durero/io/format_version.hpp"
#include "durero/io/scene_check.hpp"
#include "durero/io/scene_file.hpp"

namespace durero::conform {

using io::json::FormatVersion;

inline constexpr FormatVersion suite_format{"durero-suite", suite_version};
inline constexpr FormatVersion case_format{"durero-case", 1};
inline constexpr FormatVersion system_format{"durero-system", 1};
inline constexpr FormatVersion profile_format{"durero-profile", 1};
inline constexpr FormatVersion claims_format{"durero-claims", 1};
inline constexpr FormatVersion report_format{"durero-report", 1};
inline constexpr FormatVersion campaign_format{"durero-campaign", 1};
inline constexpr FormatVersion shards_format{"durero-shards", 1};
inline constexpr FormatVersion agreement_format{"durero-agreement", 1};
inline constexpr FormatVersion stats_format{"durero-stats", 1};

/// Those of this layer and of the layers above it.
inline constexpr FormatVersion format_versions[] = {io::scene_format, io::check_format, suite_format,     case_format,
                                                    system_format,    profile_format,   claims_format,    report_format,
                                                    campaign_format,  shards_format,    agreement_format, stats_format};

}  // namespace durero::conform
