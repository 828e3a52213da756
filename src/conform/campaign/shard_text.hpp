#pragma once
/// The parts that the writer and the reader of files of shards share.

#include <fmt/format.h>

#include <span>
#include <string>

#include "conform/families/digest.hpp"
#include "conform/report/report_parts.hpp"

namespace durero::conform {

/// The verdicts that a family counts: all but skipped, which the clauses count.
inline constexpr std::span<const Verdict> counted{verdicts, verdict_count - 1};
static_assert(verdicts[verdict_count - 1] == Verdict::skipped);

/// The end of a file of shards whose text so far is `text`: its digest.
inline std::string digest_member(std::string_view text) {
  return fmt::format(",\"digest\":\"{}\"}}\n", digest_text(digest(text)));
}

}  // namespace durero::conform
