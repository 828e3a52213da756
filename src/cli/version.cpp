// durero version [--json]: what this program is made of.
#include <OpenEXRConfig.h>
#include <flint/flint.h>
#include <fmt/core.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmp.h>
#include <histedit.h>
#include <hwy/highway.h>
#include <jconfig.h>
#include <openssl/opensslv.h>
#include <png.h>
#include <rapidjson/rapidjson.h>
#include <sqlite3.h>
#include <tbb/version.h>

#include <CLI/Version.hpp>
#include <boost/version.hpp>
#include <memory>
#include <pugixml.hpp>
#include <string>
#include <utility>
#include <vector>

#include "commands.hpp"
#include "description.hpp"
#include "durero/conform/format_versions.hpp"
#include "durero/io/json/json_writer.hpp"
#include "durero/io/standard_output.hpp"
#include "durero/store/store.hpp"

#ifndef __has_feature
#define __has_feature(x) 0  // Clang's, which alone tells of its sanitizers so
#endif

namespace durero::cli {
namespace {

using Pairs = std::vector<std::pair<std::string, std::string>>;

std::pair<const char*, std::string> compiler() {
#ifdef __clang__
  return {"Clang", fmt::format("{}.{}.{}", __clang_major__, __clang_minor__, __clang_patchlevel__)};
#else
  return {"GCC", fmt::format("{}.{}.{}", __GNUC__, __GNUC_MINOR__, __GNUC_PATCHLEVEL__)};
#endif
}

std::vector<std::string> sanitizers() {
  std::vector<std::string> names;
#if defined(__SANITIZE_ADDRESS__) || __has_feature(address_sanitizer)
  names.emplace_back("address");
#endif
#if defined(__SANITIZE_THREAD__) || __has_feature(thread_sanitizer)
  names.emplace_back("thread");
#endif
  return names;
}

/// The names of Highway's targets, from the widest.
std::vector<std::string> names_of_targets(std::int64_t targets) {
  std::vector<std::string> names;
  for (std::int64_t rest = targets; rest != 0; rest &= rest - 1) names.emplace_back(hwy::TargetName(rest & -rest));
  return names;
}

std::vector<std::string> compiled() { return names_of_targets(HWY_TARGETS); }
/// The target in use: Highway takes the widest that the machine has.
std::string in_use() { return names_of_targets(hwy::SupportedTargets() & HWY_TARGETS).front(); }

std::string of_parts(unsigned number, unsigned major, unsigned minor, unsigned most = ~0U) {
  return fmt::format("{}.{}.{}", number / major, number / minor % most, number % minor);
}

Pairs libraries() {
  Pairs all{{"GMP", gmp_version},
            {"Boost", of_parts(BOOST_VERSION, 100'000, 100, 1000)},
            {"oneTBB", fmt::format("{}.{}", TBB_VERSION_MAJOR, TBB_VERSION_MINOR)},
            {"Highway", fmt::format("{}.{}.{}", HWY_MAJOR, HWY_MINOR, HWY_PATCH)},
            {"fmt", of_parts(FMT_VERSION, 10'000, 100, 100)},
            {"libpng", png_get_libpng_ver(nullptr)},
            {"OpenEXR", OPENEXR_VERSION_STRING},
            {"libjpeg-turbo", of_parts(LIBJPEG_TURBO_VERSION_NUMBER, 1'000'000, 1000, 1000)},
            {"RapidJSON", RAPIDJSON_VERSION_STRING},
            {"CLI11", CLI11_VERSION},
            {"FLINT", FLINT_VERSION},
            {"pugixml", of_parts(PUGIXML_VERSION / 10, 100, 1)},
            {"libedit", fmt::format("{}.{}", LIBEDIT_MAJOR, LIBEDIT_MINOR)},
            {"SQLite", sqlite3_libversion()},
            {"OpenSSL", OPENSSL_VERSION_STR}};
  if (const std::string libpq = store::libpq_version(); !libpq.empty()) all.emplace_back("libpq", libpq);
  return all;
}

void write_words(io::json::Writer& out, std::string_view key, const std::vector<std::string>& words) {
  out.key(key).begin_array();
  for (const std::string& word : words) out.value(word);
  out.end_array();
}

std::string version_json() {
  std::string text;
  io::json::Writer out(text);
  out.begin_object().member("durero", DURERO_VERSION);
  out.key("formats").begin_object();
  for (const auto& [name, version] : conform::format_versions) out.member(name, version);
  out.end_object();
  const auto [name, version] = compiler();
  out.key("compiler").begin_object().member("name", name).member("version", version).end_object();
  out.member("build_type", DURERO_BUILD_TYPE);
  write_words(out, "sanitizers", sanitizers());
  out.key("instruction_sets").begin_object();
  write_words(out, "compiled", compiled());
  out.member("in_use", in_use()).end_object();
  out.key("libraries").begin_object();
  for (const auto& [library, of_library] : libraries()) out.member(library, of_library);
  out.end_object().end_object();
  return text + '\n';
}

std::string joined(const std::vector<std::string>& words) { return fmt::format("{}", fmt::join(words, ", ")); }

std::string text() {
  const auto [name, version] = compiler();
  std::string text = fmt::format("durero {}\n", DURERO_VERSION);
  text += fmt::format("compiler          {} {}, {}\n", name, version, DURERO_BUILD_TYPE);
  if (!sanitizers().empty()) text += fmt::format("sanitizers        {}\n", joined(sanitizers()));
  text += fmt::format("instruction sets  {}; here {}\n", joined(compiled()), in_use());
  std::vector<std::string> list;
  for (const auto& [format, of_format] : conform::format_versions)
    list.push_back(fmt::format("{} {}", format, of_format));
  text += fmt::format("formats           {}\n", joined(list));
  list.clear();
  for (const auto& [library, of_library] : libraries()) list.push_back(library + " " + of_library);
  return text + fmt::format("libraries         {}\n", joined(list));
}

}  // namespace

void add_version(CLI::App& app, int& status) {
  auto* command = app.add_subcommand("version", "The version of this program, and what it is made of");
  const auto as_json = std::make_shared<bool>(false);
  command->add_flag("--json", *as_json, "As JSON");
  command->footer(
      "The keys of the JSON object: durero, the version; formats, with the version of each format of files; compiler,\n"
      "with name and version; build_type; sanitizers, a list; instruction_sets, with the list compiled and the one "
      "that is\n"
      "in_use on this machine; libraries, with the version of each.\n\n" +
      exit_status("it is printed", "the call is bad") + examples({"version", "version --json"}));
  command->callback([as_json, &status] {
    io::print(*as_json ? version_json() : text());
    status = 0;
  });
}

}  // namespace durero::cli
