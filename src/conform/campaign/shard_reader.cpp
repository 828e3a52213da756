// The reader of files of shards.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "conform/ask/profile_reader.hpp"
#include "conform/campaign/shard_text.hpp"
#include "conform/campaign/trimmed.hpp"
#include "durero/conform/campaign/shard.hpp"
#include "durero/conform/format_versions.hpp"
#include "durero/io/json/whole_number.hpp"

namespace durero::conform {
namespace {

using io::json::Reader;

/// Checks that the file is whole: it ends in the digest of all bytes before. Throws io::InputError.
void require_digest(const io::Source& source) {
  const std::string_view text = source.text();
  if (!text.starts_with(R"({"format":"durero-shards",)"))
    source.fail(0, "no file of shards", "expected what durero conform shard or merge writes");
  const std::size_t end = text.size() - std::min(digest_member("").size(), text.size());
  const std::string expected = digest_member(text.substr(0, end));
  if (text.substr(end) != expected)
    source.fail(end, "the file is truncated or was altered",
                fmt::format("expected the digest of what stands before it: {}", text::shown(expected)));
}

class ShardsReader {
 public:
  ShardsReader(const io::json::Document& document, const Campaign& campaign, const std::string& identity)
      : in_(document), campaign_(&campaign), identity_(&identity) {}

  Shards read() {
    enum Key : std::size_t {
      format,
      version,
      campaign,
      system,
      says,
      families,
      counted_verdicts,
      shards,
      failures,
      end
    };
    constexpr std::string_view keys[] = {"format",   "version",  "campaign", "system",   "says",
                                         "families", "verdicts", "shards",   "failures", "digest"};
    require_version(in_, shards_format);
    in_.object("shards", keys, std::size(keys), [&](std::size_t key) {
      switch (static_cast<Key>(key)) {
        case format:
        case version:  // read before all others
          return in_.skip();
        case campaign:
          return read_identity();
        case system:
          return read_exactly(in_, "system", campaign_->system);
        case says:
          shards_.says = in_.string("says");
          return;
        case families:
          return in_.array("families", [&] { read_family(); });
        case counted_verdicts:
          return in_.array("verdicts", [&] { read_verdict(); });
        case shards:
          return in_.array("shards", [&] { read_shard(); });
        case failures:
          return in_.array("failures", [&] { read_failed(); });
        case end:
          return in_.skip();
      }
    });
    return std::move(shards_);
  }

 private:
  /// A number that is less than `limit`.
  std::uint64_t read_below(std::string_view what, std::uint64_t limit) {
    const std::size_t at = in_.offset();
    const std::uint64_t number = io::json::whole_number(in_, what);
    if (number >= limit)
      in_.fail(at, fmt::format("{} is {}", what, number), fmt::format("expected less than {}", limit));
    return number;
  }

  void read_identity() {
    const std::size_t at = in_.offset();
    const std::string_view read = in_.string("campaign");
    if (read != *identity_)
      in_.fail(at,
               fmt::format("shards of another campaign, or of a system with another profile: {}", text::shown(read)),
               fmt::format("expected those of \"{}\"", *identity_));
  }

  const Family* read_family() {
    const std::size_t at = in_.offset();
    const std::string_view name = in_.string("a family");
    const auto& known = campaign_->families;
    const auto place = std::ranges::find(known, name, &Family::name);
    if (place == known.end())
      in_.fail(at, fmt::format("a family is {}", text::shown(name)), "expected one of the campaign");
    return *place;
  }

  Verdict read_verdict() {
    const std::size_t at = in_.offset();
    const std::string_view word = in_.string("a verdict");
    const auto place = std::ranges::find(counted, word, [](Verdict verdict) { return name(verdict); });
    if (place == counted.end())
      in_.fail(at, fmt::format("a verdict is {}", text::shown(word)), "expected one that is counted");
    return *place;
  }

  std::vector<std::uint64_t> read_counts(std::size_t most) {
    const std::size_t at = in_.offset();
    std::vector<std::uint64_t> counts;
    in_.array("counts", [&] { counts.push_back(io::json::whole_number(in_, "a count")); });
    if (counts.size() > most)
      in_.fail(at, fmt::format("{} counts", counts.size()), fmt::format("expected {} at most", most));
    return counts;
  }

  FamilyCounts read_counts_of_family(std::size_t clauses) {
    const std::size_t at = in_.offset(), lengths[] = {counted.size(), clauses};
    std::vector<std::vector<std::uint64_t>> lists;
    in_.array("a family", [&] {
      if (lists.size() == std::size(lengths)) in_.fail(at, "more lists", "expected two at most");
      lists.push_back(read_counts(lengths[lists.size()]));
    });
    lists.resize(std::size(lengths));
    return trimmed(FamilyCounts{lists[0], lists[1]});
  }

  void read_shard() {
    constexpr std::string_view keys[] = {"shard", "answers", "ulps", "clauses", "families"};
    ShardCounts counts;
    const std::size_t at = in_.offset();
    in_.object("a shard", keys, 2, [&](std::size_t key) {
      if (key == 0) counts.shard = read_below("shard", campaign_->shards);
      if (key == 1) counts.answers = read_answers();
      if (key == 2) counts.ulps = read_counts(ulp_bins);
      if (key == 3) in_.array("clauses", [&] { counts.clauses.emplace_back(in_.string("a clause")); });
      if (key == 4)
        in_.array("families", [&] { counts.families.push_back(read_counts_of_family(counts.clauses.size())); });
    });
    if (counts.families.size() > campaign_->families.size())
      in_.fail(at, fmt::format("counts of {} families", counts.families.size()), "expected those of the campaign");
    shards_.counts.insert(trimmed(std::move(counts)));
  }

  std::uint64_t read_answers() {
    const std::size_t at = in_.offset();
    const std::string_view text = in_.string("answers");
    std::uint64_t answers = 0;
    std::from_chars(text.data(), text.data() + text.size(), answers, 16);
    if (digest_text(answers) != text)
      in_.fail(at, fmt::format("answers is {}", text::shown(text)), "expected sixteen hexadecimal digits");
    return answers;
  }

  double read_backward() {
    const std::size_t at = in_.offset();
    const double backward = in_.extended_number("backward");
    if (!(backward >= 0)) in_.fail(at, fmt::format("backward is {}", backward), "expected no negative number");
    return backward;
  }

  void read_failed() {
    enum Key : std::size_t { family, verdict, number, ray, elements, backward, claim };
    constexpr std::string_view keys[] = {"family", "verdict", "case", "ray", "elements", "backward", "claim"};
    std::pair<const Family*, Verdict> kind;
    FailedRay failed;
    in_.object("a failure", keys, std::size(keys), [&](std::size_t key) {
      switch (static_cast<Key>(key)) {
        case family:
          kind.first = read_family();
          return;
        case verdict:
          kind.second = read_verdict();
          return;
        case number:
          failed.number = io::json::whole_number(in_, "case");
          return;
        case ray:
          failed.ray = read_below("ray", rays_of_a_mesh);
          return;
        case elements:
          failed.elements = io::json::whole_number(in_, "elements");
          return;
        case backward:
          failed.backward = read_backward();
          return;
        case claim:
          failed.claim = in_.string("claim");
      }
    });
    shards_.failures[kind].add(failed);
  }

  Reader in_;
  const Campaign* campaign_;
  const std::string* identity_;
  Shards shards_;
};

}  // namespace

Shards read_shards(const io::Source& source, const Campaign& campaign, const std::string& identity) {
  require_digest(source);
  const io::json::Document document(source);
  return ShardsReader(document, campaign, identity).read();
}

}  // namespace durero::conform
