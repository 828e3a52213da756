#include "conform/ask/claims_log.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>

#include "conform/ask/profile_reader.hpp"
#include "durero/conform/ask/question.hpp"
#include "durero/conform/format_versions.hpp"
#include "durero/io/json/json.hpp"
#include "durero/io/json/json_writer.hpp"
#include "durero/io/lines.hpp"
#include "durero/text/shown.hpp"

namespace durero::conform {
namespace {

using io::json::Reader;

/// The whole lines of a text.
std::vector<io::TextLine> whole_lines(std::string_view text) {
  std::vector<io::TextLine> whole;
  io::Lines lines(text.substr(0, text.find_last_of('\n') + 1));
  while (const auto line = lines.next()) whole.push_back(*line);
  return whole;
}

/// Reads the first line and returns the system's name and version in it.
std::string read_head(const io::Source& source, const io::TextLine& line, const std::string& identity) {
  constexpr std::string_view keys[] = {"format", "version", "run", "system"};
  const io::json::Document document(source, line.begin, line.end);
  Reader in(document);
  require_version(in, claims_format);
  std::string says;
  in.object("claims", keys, 4, [&](std::size_t key) {
    if (key < 2) in.skip();  // format and version
    if (key == 2) read_exactly(in, "run", identity);
    if (key == 3) says = in.string("system");
  });
  return says;
}

}  // namespace

ClaimsLog ClaimsLog::begin(const std::string& path, const std::string& identity) {
  ClaimsLog log;
  log.path_ = path;
  log.identity_ = identity;
  log.open("wbx");
  return log;
}

ClaimsLog ClaimsLog::go_on(const std::string& path, const std::string& identity) {
  ClaimsLog log;
  log.path_ = path;
  log.identity_ = identity;
  const io::Source source = io::read_source(path);
  const std::vector<io::TextLine> lines = whole_lines(source.text());
  if (!lines.empty()) log.says_ = read_head(source, lines.front(), identity);
  for (std::size_t i = 1; i < lines.size(); ++i)
    log.lines_.emplace_back(source.text().substr(lines[i].begin, lines[i].end - lines[i].begin));
  std::filesystem::resize_file(path, source.text().find_last_of('\n') + 1);
  log.open("ab");
  return log;
}

std::vector<Claim> ClaimsLog::claims(std::size_t place, const SuiteCase& of) const {
  constexpr std::string_view keys[] = {"case", "claims"};
  const io::Source source(fmt::format("{}: case {}", path_, place), lines_[place]);
  const io::json::Document document(source);
  Reader in(document);
  std::vector<Claim> claims;
  in.object("a case", keys, 2, [&](std::size_t key) {
    if (key == 0) return read_exactly(in, "case", of.name());
    in.array("claims", [&] {
      const std::size_t at = in.offset();
      try {
        claims.push_back(read_claim(in.string("a claim"), of.the_case.scene));
      } catch (const std::invalid_argument& error) {
        in.fail(at, error.what(), "expected a claim");
      }
    });
  });
  if (claims.size() != of.the_case.rays.size())
    source.fail(0, fmt::format("{} claims", claims.size()), fmt::format("expected {}", of.the_case.rays.size()));
  return claims;
}

void ClaimsLog::add(const SuiteCase& of, std::span<const Claim> claims, const std::string& says) {
  if (says_.empty()) write_head(says);
  if (says != says_)
    throw std::runtime_error(
        fmt::format("{}: the run was begun with {}, and now it is {}; expected the same system", path_, says_, says));
  std::string line;
  io::json::Writer row(line);
  row.begin_object().member("case", of.name()).key("claims").begin_array();
  for (const Claim& claim : claims) row.value(claim_text(claim, of.the_case.scene));
  row.end_array().end_object();
  write(line + '\n');
}

void ClaimsLog::remove() { std::filesystem::remove(path_); }

void ClaimsLog::write_head(const std::string& says) {
  says_ = says;
  std::string line;
  io::json::Writer head(line);
  write_version(head.begin_object(), claims_format);
  head.member("run", identity_).member("system", says).end_object();
  write(line + '\n');
}

void ClaimsLog::open(const char* mode) {
  file_.reset(std::fopen(path_.c_str(), mode));
  if (!file_) throw io::FileError(path_, std::strerror(errno), "expected a new file, or to go on with one");
}

void ClaimsLog::write(const std::string& line) {
  if (std::fwrite(line.data(), 1, line.size(), file_.get()) != line.size() || std::fflush(file_.get()) != 0)
    throw io::FileError(path_, std::strerror(errno), "expected to write to it");
}

}  // namespace durero::conform
