// The writer of files of shards.
#include "conform/campaign/shard_text.hpp"
#include "conform/campaign/trimmed.hpp"
#include "durero/conform/campaign/shard.hpp"
#include "durero/conform/format_versions.hpp"
#include "durero/io/json/json_writer.hpp"

namespace durero::conform {
namespace {

using io::json::Writer;

void write_counts(Writer& out, const std::vector<std::uint64_t>& counts) {
  out.begin_array();
  for (const std::uint64_t count : counts) out.value(count);
  out.end_array();
}

void write_family(Writer& out, const FamilyCounts& family) {
  std::vector<std::vector<std::uint64_t>> lists{family.verdicts, family.clauses};
  trim(lists);
  out.begin_array();
  for (const auto& list : lists) write_counts(out, list);
  out.end_array();
}

void write_shard(Writer& out, const ShardCounts& counts) {
  out.new_line().begin_object().member("shard", counts.shard).member("answers", digest_text(counts.answers));
  if (!counts.ulps.empty()) write_counts(out.key("ulps"), counts.ulps);
  if (!counts.clauses.empty()) {
    out.key("clauses").begin_array();
    for (const std::string& clause : counts.clauses) out.value(clause);
    out.end_array();
  }
  if (!counts.families.empty()) {
    out.key("families").begin_array();
    for (const FamilyCounts& family : counts.families) write_family(out, family);
    out.end_array();
  }
  out.end_object();
}

void write_failed(Writer& out, const Family& family, Verdict verdict, const FailedRay& failed) {
  out.new_line().begin_object().member("family", family.name).member("verdict", name(verdict));
  out.member("case", failed.number).member("ray", std::uint64_t{failed.ray});
  out.member("elements", std::uint64_t{failed.elements}).member("backward", failed.backward);
  out.member("claim", failed.claim).end_object();
}

}  // namespace

std::string shards_text(const Shards& shards, const Campaign& campaign, const std::string& identity) {
  std::string text;
  Writer out(text);
  write_version(out.begin_object(), shards_format);
  out.member("campaign", identity).member("system", campaign.system).member("says", shards.says);
  out.new_line().key("families").begin_array();
  for (const Family* family : campaign.families) out.value(family->name);
  out.end_array().new_line().key("verdicts").begin_array();
  for (const Verdict verdict : counted) out.value(name(verdict));
  out.end_array().new_line().key("shards").begin_array();
  for (const ShardCounts& counts : shards.counts) write_shard(out, counts);
  out.new_line().end_array().new_line().key("failures").begin_array();
  for (const auto& [kind, rays] : shards.failures) {
    for (const FailedRay& failed : rays.all()) write_failed(out, *kind.first, kind.second, failed);
  }
  out.new_line().end_array();
  return text + digest_member(text);
}

}  // namespace durero::conform
