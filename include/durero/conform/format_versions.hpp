#pragma once
/// The formats of JSON that this layer reads and writes, each in its version. docs/formats.md has them all.

#include "durero/conform/families/suite_file.hpp"
#include "durero/io/json/format_version.hpp"
#include "durero/io/json/scene_check.hpp"
#include "durero/io/json/scene_file.hpp"

namespace durero::conform {

using io::json::FormatVersion;

inline constexpr FormatVersion suite_format{"durero-suite", suite_version};  ///< DIR/suite.json of a suite
inline constexpr FormatVersion case_format{"durero-case", 1};      ///< the sidecar of a case, DIR/FAMILY/0000.case.json
inline constexpr FormatVersion system_format{"durero-system", 1};  ///< a system's file (system_file.hpp)
inline constexpr FormatVersion profile_format{"durero-profile", 1};  ///< a profile alone, as read_profile reads it
inline constexpr FormatVersion claims_format{"durero-claims", 1};  ///< the claims that a run keeps (RunOptions::claims)
inline constexpr FormatVersion report_format{"durero-report", 1};  ///< report.json, by report_json
inline constexpr FormatVersion search_format{"durero-search", 1};  ///< search.json, by fuzz_json
inline constexpr FormatVersion campaign_format{"durero-campaign", 1};    ///< a campaign (campaign.hpp)
inline constexpr FormatVersion shards_format{"durero-shards", 1};        ///< a set of shards (shard.hpp)
inline constexpr FormatVersion agreement_format{"durero-agreement", 1};  ///< by agreement_json
inline constexpr FormatVersion stats_format{"durero-stats", 1};          ///< by durero stats --format json
inline constexpr FormatVersion mosaic_format{"durero-mosaic", 1};        ///< by durero voxelise
inline constexpr FormatVersion explore_format{"durero-explore", 1};      ///< by durero spec explore --json

/// The formats of this layer and of the layers above it in the table of layers.
inline constexpr FormatVersion format_versions[] = {io::scene_format, io::check_format, suite_format,  case_format,
                                                    system_format,    profile_format,   claims_format, report_format,
                                                    search_format,    campaign_format,  shards_format, agreement_format,
                                                    stats_format,     mosaic_format,    explore_format};

}  // namespace durero::conform
