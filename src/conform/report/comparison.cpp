#include "durero/conform/report/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "conform/ask/profile_reader.hpp"
#include "conform/report/report_parts.hpp"
#include "durero/conform/format_versions.hpp"
#include "durero/io/json/json.hpp"
#include "durero/io/json/whole_number.hpp"
#include "durero/text/shown.hpp"

namespace durero::conform {
namespace {

using io::json::Reader;

void read_counts(Reader& in, VerdictCounts& counts) {
  std::array<std::string_view, verdict_count> keys;
  for (const Verdict verdict : verdicts) keys[static_cast<std::size_t>(verdict)] = name(verdict);
  in.object("verdicts", keys, 0,  // a report of a program that did not know a verdict has none of it
            [&](std::size_t key) { counts[key] = io::json::whole_number(in, keys[key]); });
}

/// Calls member(name) for the members that are among the names, and passes the others.
template <class Member>
void some_members(Reader& in, std::string_view what, std::initializer_list<std::string_view> names, Member member) {
  in.members(what, [&](const io::json::Key& key) {
    if (std::ranges::find(names, key.name) == names.end()) return in.skip();
    member(key.name);
  });
}

Summary::OfFamily read_family(Reader& in) {
  Summary::OfFamily read;
  some_members(in, "a family", {"family", "verdicts"}, [&](std::string_view key) {
    if (key == "family") read.family = in.string(key);
    if (key == "verdicts") read_counts(in, read.counts);
  });
  return read;
}

void read_suite(Reader& in, Summary& read) {
  some_members(in, "suite", {"version", "seed", "rays", "numbers", "faces", "question"}, [&](std::string_view key) {
    if (key == "version") read.suite_version = io::json::whole_number(in, key);
    if (key == "seed") read.seed = io::json::whole_number(in, key);
    if (key == "rays") read.rays = io::json::whole_number(in, key);
    if (key == "numbers") read.numbers = in.string(key);
    if (key == "faces") read.faces = io::json::whole_number(in, key);
    if (key == "question") read.question = in.string(key);
  });
}

void read_member(Reader& in, std::string_view key, Summary& read) {
  if (key == "format" || key == "version") in.skip();  // read before all others
  if (key == "system") read.system = in.string(key);
  if (key == "title") read.title = in.string(key);
  if (key == "system_version") read.version = in.string(key);
  if (key == "suite") read_suite(in, read);
  if (key == "verdicts") read_counts(in, read.counts);
  if (key == "families") in.array(key, [&] { read.families.push_back(read_family(in)); });
}

template <class Holds>
std::uint64_t sum_where(const VerdictCounts& counts, Holds holds) {
  std::uint64_t sum = 0;
  for (const Verdict verdict : verdicts) sum += holds(verdict) ? counts[static_cast<std::size_t>(verdict)] : 0;
  return sum;
}

std::uint64_t of(const VerdictCounts& counts, Verdict verdict) { return counts[static_cast<std::size_t>(verdict)]; }
std::uint64_t gross(const VerdictCounts& counts) { return sum_where(counts, is_gross); }
std::uint64_t judged(const VerdictCounts& counts) {
  return sum_where(counts, [](Verdict verdict) { return verdict != Verdict::skipped; });
}

void check_one_suite(const std::vector<Summary>& systems) {
  for (const Summary& system : systems) {
    const Summary& first = systems.front();
    if (std::tie(system.suite_version, system.seed, system.rays, system.numbers, system.faces, system.question) !=
        std::tie(first.suite_version, first.seed, first.rays, first.numbers, first.faces, first.question))
      throw std::invalid_argument(fmt::format("{} and {} were asked other rays; expected reports of one suite",
                                              text::shown(first.system), text::shown(system.system)));
  }
}

void sort_and_check(std::vector<Summary>& systems) {
  check_one_suite(systems);
  std::ranges::stable_sort(systems, std::greater<>(), [](const Summary& system) {
    return std::pair{gross(system.counts), of(system.counts, Verdict::off)};
  });
}

/// A share as a reader sees it, such as `34 %`.
std::string share_text(double share) {
  const double percent = 100 * share;
  const int digits = percent < 99 ? 2 : 3;  // of two, 99.6 would be 1e+02
  return fmt::format("{:.{}g} %", percent, digits);
}

/// The share of gross failures among the judged rays of a family; nothing where none was judged.
std::optional<double> gross_share(const Summary& system, std::string_view family) {
  const auto found = std::ranges::find(system.families, family, &Summary::OfFamily::family);
  if (found == system.families.end() || judged(found->counts) == 0) return std::nullopt;
  return double(gross(found->counts)) / double(judged(found->counts));
}

/// `tiny 34 %, inside 2 %`: of the judged rays, the most first.
std::string failing_families(const Summary& system) {
  std::vector<std::pair<double, std::string_view>> shares;
  for (const Summary::OfFamily& family : system.families) {
    if (gross(family.counts) > 0)
      shares.emplace_back(double(gross(family.counts)) / double(judged(family.counts)), family.family);
  }
  std::ranges::stable_sort(shares, std::greater<>(), [](const auto& share) { return share.first; });
  std::string text;
  for (const auto& [share, family] : shares) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", family, share_text(share));
  }
  return text.empty() ? "none" : text;
}

std::string title_of(const Summary& system) {
  return system.version.empty() ? system.title : fmt::format("{} ({})", system.title, system.version);
}

}  // namespace

Summary read_summary(const io::Source& source) {
  const io::json::Document document(source);
  Reader in(document);
  require_version(in, report_format);
  Summary read;
  std::vector<std::string> seen;
  const std::initializer_list<std::string_view> names = {"format",         "version", "system",   "title",
                                                         "system_version", "suite",   "verdicts", "families"};
  some_members(in, "a report", names, [&](std::string_view key) {
    seen.emplace_back(key);
    read_member(in, key, read);
  });
  for (const std::string_view name : names) {
    if (std::ranges::find(seen, name) == seen.end())
      source.fail(0, fmt::format("a report without {}", name), "expected what durero conform run --report writes");
  }
  return read;
}

namespace {

/// A row for each system, in their order.
std::string table_text(const std::vector<Summary>& systems) {
  std::size_t width = 6;
  for (const Summary& system : systems) width = std::max(width, title_of(system).size());
  std::string text = fmt::format("{:<{}} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9}\n", "system", width, "judged", "skipped",
                                 "exact", "right", "off", "gross");
  for (const Summary& system : systems) {
    const VerdictCounts& counts = system.counts;
    text += fmt::format("{:<{}} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9}\n", title_of(system), width, judged(counts),
                        of(counts, Verdict::skipped), of(counts, Verdict::exact), of(counts, Verdict::right),
                        of(counts, Verdict::off), gross(counts));
  }
  return text;
}

/// `tiny 34 % to 2 %, inside 0 % to 1 %`: the families that fail less, or more, in the later report.
std::string changed_families(const Summary& before, const Summary& after, bool less) {
  std::string text;
  for (const Family& family : families()) {
    const std::optional<double> was = gross_share(before, family.name), is = gross_share(after, family.name);
    if (!was || !is || (less ? *is >= *was : *is <= *was)) continue;
    text += fmt::format("{}{} {} to {}", text.empty() ? "" : ", ", family.name, share_text(*was), share_text(*is));
  }
  return text;
}

}  // namespace

std::string history_text(const std::vector<Summary>& versions) {
  check_one_suite(versions);
  std::string text = table_text(versions);
  for (std::size_t i = 1; i < versions.size(); ++i) {
    const std::string less = changed_families(versions[i - 1], versions[i], true),
                      more = changed_families(versions[i - 1], versions[i], false);
    text += fmt::format("{}, after {}:\n", title_of(versions[i]), title_of(versions[i - 1]));
    if (!less.empty()) text += fmt::format("  fewer gross in {}\n", less);
    if (!more.empty()) text += fmt::format("  more gross in {}\n", more);
    if (less.empty() && more.empty()) text += "  the same share of gross failures in each family\n";
  }
  return text;
}

std::string comparison_text(std::vector<Summary> systems) {
  sort_and_check(systems);
  std::string text = table_text(systems);
  for (const Summary& system : systems)
    text += fmt::format("{}: gross in {}\n", system.system, failing_families(system));
  return text;
}

std::string comparison_markdown(std::vector<Summary> systems) {
  sort_and_check(systems);
  std::string text =
      "| system | judged | skipped | exact | right | off | gross | families with gross failures |\n"
      "| --- | --: | --: | --: | --: | --: | --: | --- |\n";
  for (const Summary& system : systems) {
    const VerdictCounts& counts = system.counts;
    text += fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} |\n", title_of(system), judged(counts),
                        of(counts, Verdict::skipped), of(counts, Verdict::exact), of(counts, Verdict::right),
                        of(counts, Verdict::off), gross(counts), failing_families(system));
  }
  return text;
}

}  // namespace durero::conform
