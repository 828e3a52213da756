// Every answer in the same bytes: whatever compiler built the program and whatever instruction set runs it. bytes.txt
// holds, for each family, digests of what the program prints; every build on every machine must print the same.
//
// Where the meaning of the bytes changes (a family, a format), write them anew, from the exact engine:
//   BYTES_DIR=DIR conform_tests --filenames-as-tags '[#bytes_test]'
// writes DIR/bytes.txt, which then replaces tests/conform/bytes.txt, and, to compare two builds line by line, what is
// digested: DIR/FAMILY.rays and DIR/FAMILY.hits.
#include <fmt/format.h>

#include <boost/crc.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "durero/io/json/scene_file.hpp"
#include "durero/io/rays/hits_file.hpp"
#include "durero/io/rays/rays_file.hpp"
#include "durero/surface/exact.hpp"
#include "durero/trace/analytic.hpp"
#include "hits.hpp"
#include "support/catch.hpp"
#include "support/targets.hpp"
#include "support/tree.hpp"

using namespace durero;
using namespace durero::test;
using conform::Family;

namespace {

constexpr std::uint64_t scenes = 20;
constexpr std::size_t rays_a_scene = 100;

/// What the program reads and prints for the scenes of one family: scene and ray files; hits, as JSON lines.
struct Printed {
  std::string rays, hits;
};

/// CRC-64, as xz computes it.
std::string digest(const std::string& text) {
  boost::crc_optimal<64, 0x42f0e1eba9ea3693, ~std::uint64_t{0}, ~std::uint64_t{0}, true, true> crc;
  crc.process_bytes(text.data(), text.size());
  return fmt::format("{:016x}", std::uint64_t{crc.checksum()});
}

/// One line of bytes.txt.
std::string line(const Family& family, const Printed& printed) {
  return fmt::format("{} {} {} {}", family.name, scenes * rays_a_scene, digest(printed.rays), digest(printed.hits));
}

std::string rays_text(const conform::Case& made) {
  std::vector<io::Ray> rays;
  for (const scene::Query& ray : made.rays) {
    const io::Ray copy{ray.rayo, ray.en};
    rays.push_back(copy);
  }
  return io::rays_text(rays, made.scene);
}

/// The analytic engine, ray by ray and for all at once, under every instruction set of the machine against the exact
/// hits of the same rays.
void compare_targets(const Family& family, std::uint64_t seed, const conform::Case& made,
                     const std::vector<scene::Hit>& exact) {
  const trace::Tables tables(made.scene);
  for (const std::int64_t target : machine_targets()) {
    const Only_Target only(target);
    const std::vector<scene::Hit> analytic = first_hits(tables, made.rays);
    for (std::size_t i = 0; i < exact.size(); ++i) {
      const scene::Hit single = first_hit(tables, made.rays[i].rayo, made.rays[i].en);
      if (identical(analytic[i], exact[i]) && identical(single, exact[i])) continue;
      FAIL(hwy::TargetName(target) << ": " << replay(family, seed, rays_a_scene, i) << "\n  ray      "
                                   << text(made.rays[i]) << "\n  exact    " << text(exact[i]) << "\n  analytic "
                                   << text(analytic[i]) << "\n  single   " << text(single));
    }
  }
}

Printed print(const Family& family) {
  Printed printed;
  for (std::uint64_t seed = 1; seed <= scenes; ++seed) {
    const conform::Case made = generate(family, seed, rays_a_scene);
    printed.rays += io::scene_text(made.scene) + rays_text(made);
    std::vector<scene::Hit> hits(made.rays.size());
    for (std::size_t i = 0; i < hits.size(); ++i) {
      hits[i] = surface::exact::first_hit(made.scene, made.rays[i].rayo, made.rays[i].en);
      printed.hits += io::hit_text(i, hits[i], made.scene) + '\n';
    }
    compare_targets(family, seed, made, hits);
  }
  return printed;
}

/// bytes.txt, by the families' names.
std::map<std::string, std::string, std::less<>> committed() {
  std::ifstream in(durero::test::source_dir() + "/tests/conform/bytes.txt");
  REQUIRE(in);
  std::map<std::string, std::string, std::less<>> lines;
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with('#')) lines.emplace(line.substr(0, line.find(' ')), line);
  }
  return lines;
}

void write(const std::filesystem::path& path, const std::string& text) {
  std::ofstream out(path, std::ios::binary);
  out << text;
  REQUIRE(out.flush());
}

}  // namespace

TEST_CASE("the digest is the known one") { CHECK(digest("123456789") == "995dc9bbdf1939fa"); }

TEST_CASE("every family's rays and hits are the same bytes in every build and under every instruction set") {
  const char* directory = std::getenv("BYTES_DIR");
  const auto expected = committed();
  std::string all = "# family, rays, digest of scenes and rays, digest of hits; see bytes_test.cpp\n";
  for (const Family& family : conform::families_of_few()) {
    const Printed printed = print(family);
    const std::string found = line(family, printed);
    all += found + '\n';
    if (directory != nullptr) {
      const std::filesystem::path path(directory);
      write(path / fmt::format("{}.rays", family.name), printed.rays);
      write(path / fmt::format("{}.hits", family.name), printed.hits);
      continue;
    }
    const auto known = expected.find(family.name);
    CHECK((known == expected.end() ? "nothing" : known->second) == found);
  }
  if (directory != nullptr) return write(std::filesystem::path(directory) / "bytes.txt", all);
  CHECK(expected.size() == conform::families_of_few().size());
}
