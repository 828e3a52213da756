#include "durero/conform/campaign/campaign.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "conform/ask/profile_reader.hpp"
#include "conform/families/digest.hpp"
#include "conform/report/report_parts.hpp"
#include "durero/conform/ask/system_file.hpp"
#include "durero/conform/families/suite_file.hpp"
#include "durero/conform/format_versions.hpp"
#include "durero/io/json/json_writer.hpp"
#include "durero/io/json/whole_number.hpp"
#include "durero/text/shown.hpp"

namespace durero::conform {
namespace {

using io::json::Reader;

enum CampaignKey : std::size_t {
  format,
  version,
  system,
  seed,
  rays_of_a_shard,
  shards,
  profile,
  families_key,
  types,
  solids,
  numbers,
  time,
  faces,
  question
};
constexpr std::string_view keys[] = {"format",  "version", "system",   "seed",    "rays_of_a_shard",
                                     "shards",  "profile", "families", "types",   "solids",
                                     "numbers", "time",    "faces",    "question"};
constexpr std::size_t required = 6;

/// The offsets of the values that are checked after all was read.
struct CampaignPlaces {
  std::size_t system = 0, shards = 0, profile = 0;
};

std::string read_text(Reader& in, std::string_view what) {
  const std::size_t at = in.offset();
  const std::string_view text = in.string(what);
  if (text.empty()) in.fail(at, fmt::format("{} is empty", what), "expected some text");
  return std::string(text);
}

const Family* read_family(Reader& in) {
  const std::size_t at = in.offset();
  const std::string_view name = in.string("a family");
  const Family* const family = find_family(name);
  if (family == nullptr)
    in.fail(at, fmt::format("a family is {}", text::shown(name)), "expected one that durero conform list shows");
  return family;
}

void read_families(Reader& in, std::vector<const Family*>& read) {
  const std::size_t at = in.offset();
  in.array("families", [&] {
    const std::size_t place = in.offset();
    const Family* const family = read_family(in);
    if (std::ranges::find(read, family) != read.end())
      in.fail(place, fmt::format("family {} stands twice", text::shown(family->name)), "expected each once");
    read.push_back(family);
  });
  if (read.empty()) in.fail(at, "families is empty", "expected one at least, or no key families");
}

double read_time(Reader& in) {
  const std::size_t at = in.offset();
  const double seconds = in.number("time");
  if (!(seconds >= 0.001 && seconds <= 86400))
    in.fail(at, fmt::format("time is {}", seconds), "expected seconds, from 0.001 to 86400");
  return seconds;
}

void read_member(Reader& in, CampaignKey key, Campaign& read, CampaignPlaces& places) {
  const std::string_view what = keys[key];
  const std::size_t at = in.offset();
  switch (key) {
    case format:
    case version:  // read before all others
      return in.skip();
    case system:
      places.system = at;
      read.system = read_text(in, what);
      return;
    case seed:
      read.seed = io::json::whole_number(in, what);
      return;
    case rays_of_a_shard:
      read.rays_of_a_shard = io::json::whole_number(in, what);
      return;
    case shards:
      places.shards = at;
      read.shards = io::json::whole_number(in, what);
      return;
    case profile:
      places.profile = at;
      read.profile = read_text(in, what);
      return;
    case families_key:
      return read_families(in, read.families);
    case types:
      return read_tipos(in, what, read.tipos.emplace(), read.bodies.emplace());
    case solids:
      read.caps = in.boolean(what) ? Caps::solid : Caps::open;
      return;
    case numbers:
      read.numbers = read_word<NumberFormat>(in, what, format_words);
      return;
    case time:
      read.time = read_time(in);
      return;
    case faces:
      read.faces = io::json::whole_number(in, what, 1, most_faces, "a number of faces");
      return;
    case question:
      read.question = read_word<QuestionKind>(in, what, question_words);
  }
}

/// Checks the conditions that concern several members. Throws io::InputError.
void check(const io::Source& source, const Campaign& read, const CampaignPlaces& places) {
  if (read.shards == 0) source.fail(places.shards, "shards is 0", "expected one at least");
  // JSON holds the numbers of so many rays, and of fewer cases, exactly.
  if (read.rays_of_a_shard > (std::uint64_t{1} << 53U) / read.shards)
    source.fail(places.shards, fmt::format("{} shards of {} rays", read.shards, read.rays_of_a_shard),
                "expected 2^53 rays at most");
  const bool is_command = read.system.starts_with(of_command);
  if (is_command && read.profile.empty())
    source.fail(places.system, "command: without profile", "expected the key profile, which says what it claims");
  if (!is_command && !read.profile.empty())
    source.fail(places.profile, "profile of a system that has one", "expected it with system command:PROGRAM alone");
}

/// The number of rays of a shard that family number `place` has.
std::uint64_t share(const Campaign& campaign, std::size_t place) {
  const std::uint64_t families = campaign.families.size();
  return campaign.rays_of_a_shard / families + (place < campaign.rays_of_a_shard % families ? 1 : 0);
}

}  // namespace

Campaign read_campaign(const io::Source& source) {
  const io::json::Document document(source);
  Reader in(document);
  require_version(in, campaign_format);
  Campaign read;
  CampaignPlaces places;
  in.object("a campaign", keys, required,
            [&](std::size_t key) { read_member(in, static_cast<CampaignKey>(key), read, places); });
  check(source, read, places);
  read.families = chosen_families({.families = read.families});
  return read;
}

std::string identity(const Campaign& campaign, const Profile& profile) {
  std::string text;
  io::json::Writer out(text);
  const SuiteOptions options = suite_options(campaign, profile);
  out.begin_object().member("suite", suite_version).member("system", campaign.system);
  out.member("profile", campaign.profile).member("seed", campaign.seed);
  out.member("rays_of_a_shard", campaign.rays_of_a_shard);
  out.member("types", type_words(options.tipos, options.bodies)).member("caps", word(options.caps));
  out.member("numbers", word(campaign.numbers)).member("time", campaign.time);
  if (campaign.faces != usual_faces) out.member("faces", campaign.faces);
  if (campaign.question != QuestionKind::first) out.member("question", word(campaign.question));
  out.key("families").begin_array();
  for (const Family* family : campaign.families) out.value(family->name);
  out.end_array();
  for (const ProfileLine& line : profile_lines(profile)) {
    if (line.claim != "questions") out.member(line.claim, line.value);  // what else it claims decides nothing
  }
  out.end_object();
  return digest_text(digest(text));
}

SuiteOptions suite_options(const Campaign& campaign, const Profile& profile) {
  require_claimed(profile, campaign.question);
  return {.families = campaign.families,
          .seed = campaign.seed,
          .tipos = campaign.tipos.value_or(profile.tipos),
          .bodies = campaign.bodies.value_or(profile.bodies),
          .caps = campaign.caps.value_or(profile.caps),
          .numbers = campaign.numbers,
          .faces = campaign.faces,
          .question = campaign.question};
}

std::vector<CasePlace> cases_of_shard(const Campaign& campaign, const SuiteOptions& options, std::uint64_t shard) {
  std::vector<CasePlace> places;
  for (std::size_t i = 0; i < campaign.families.size(); ++i) {
    const Family& family = *campaign.families[i];
    const std::uint64_t rays = share(campaign, i), of_case = rays_of(family), blocks = (rays + of_case - 1) / of_case;
    if (rays == 0 || cases(options, family) == 0) continue;
    for (std::uint64_t block = 0; block < blocks; ++block)
      places.push_back({&family, shard * blocks + block, std::min(of_case, rays - block * of_case)});
  }
  return places;
}

SuiteCase suite_case(SuiteOptions options, const CasePlace& place) {
  options.rays = place.number * rays_of(*place.family) + place.rays;
  SuiteCase of = suite_case(options, *place.family, place.number);
  answer(of);
  ask_question(of, options);
  return of;
}

}  // namespace durero::conform
