#include "durero/conform/report/reproducer.hpp"

#include <unistd.h>

#include <filesystem>

#include "conform/drafted.hpp"
#include "conform/judged.hpp"
#include "durero/io/output_file.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::conform;
namespace fs = std::filesystem;

namespace {

const std::atomic<bool> never = false;

/// A system with that template, which is removed when this ends.
struct Templated {
  explicit Templated(const std::string& text) {
    io::write_file(path, text);
    system.profile = test::profile_of_all();
    system.reproducer = {.program = path, .words = {{"real", "double"}}, .run = {{"sh", "{program}"}}};
  }
  ~Templated() { fs::remove(path); }

  std::string filled(const Finding& finding) const {
    return reproducer_text(system, finding, "what\nand why", "it.sh");
  }
  std::string refusal(const Finding& finding) const {
    try {
      return filled(finding);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
  }

  std::string path = fs::temp_directory_path() / ("reproducer_test." + std::to_string(::getpid()));
  System system;
};

Finding missed_sphere() {
  return test::finding_of(test::sphere_case({0, -0.0, 0.5}, {0, 0, 2}), test::miss(), test::profile_of_all());
}

Finding missed_pair() {
  const scene::Cylinder cylinder{.centro = {0, 0, 8}, .radio = 0.5, .vector = {1, 0, 0}, .altura = 3};
  const scene::Sphere sphere{{0, 0, 4}, 1};
  return test::finding_of(test::drafted({{"tube", cylinder}, {"ball", sphere}}, {0, 0, 0}, {0, 0, 1}), test::miss(),
                          test::profile_of_all());
}

}  // namespace

TEST_CASE("numbers stand as any language reads them, and several lines behind what is before them") {
  const Templated templated(
      "# @(about)\n@(p) | @(v.z) | @(unit) | @(length) | @(count) | @(real) | @(file)\n@(expected)\n");
  CHECK(templated.filled(missed_sphere()) ==
        "# what\n# and why\n0.0, -0.0, 0.5 | 2.0 | 0.0, 0.0, 1.0 | 2.0 | 1 | double | it.sh\nhit e0 1.25\n");
}

TEST_CASE("lines of a tipo stand for each element of it, in the order of the elements") {
  const Templated templated(
      "a\n  @esfera ball @(name) @(index) @(radio)\n  @cilindro,cono tube @(name) @(altura)\n  @each  of "
      "@(count)\nb\n@cono x\n");
  const std::string text = templated.filled(missed_pair());
  // Elements are in the order of their types.
  CHECK(text == "a\n  ball ball 0 1.0\n   of 2\n  tube tube 3.0\n   of 2\nb\n");
}

TEST_CASE("an element with an axis has its ends, its middle and frames") {
  const Templated templated(
      "@cilindro @(middle)|@(top)|@(half)|@(base_radius)|@(top_radius)|@(from_z)|@(from_y)|@(x_axis)|@(y_axis)\n");
  const std::string text = templated.filled(missed_pair());
  CHECK(text.starts_with("1.5, 0.0, 8.0|3.0, 0.0, 8.0|1.5|0.5|0.5|"));
  // The half turn of 90° about y, and about −z; x × y is the axis.
  CHECK(text.find("|-0.0, 0.7071067811865475, 0.0, 0.7071067811865475|") != text.npos);
  CHECK(text.find("|0.0, 0.0, -0.7071067811865475, 0.7071067811865475|") != text.npos);
  CHECK(text.ends_with("|0.0, 0.0, -1.0|-0.0, 1.0, 0.0\n"));
}

TEST_CASE("a segment reaches behind every element") {
  const Templated templated("@(segment)\n");
  CHECK(templated.filled(missed_sphere()) == "8.0\n");  // the least power of two of which t = 2.25 is less than half
}

TEST_CASE("a name that stands for nothing is refused with its line") {
  const Templated templated("a\n@(radio)\n");
  CHECK(templated.refusal(missed_sphere())
            .starts_with(templated.path + ":2: nothing is called \"radio\"; expected one of about, "));
  CHECK(Templated("@(p").refusal(missed_sphere()).find(":1: nothing is called \"p\"") != std::string::npos);
}

TEST_CASE("what is expected is said as the system says it, a solid by its name") {
  Templated templated("@(expected)\n");
  templated.system.profile.measure = Measure::length;
  CHECK(templated.filled(missed_sphere()) == "hit e0 2.5\n");
  templated.system.profile.measure = Measure::point;
  CHECK(templated.filled(missed_sphere()) == "hit e0 - 0 0 3\n");
  const Finding miss =
      test::finding_of(test::sphere_case({9, 0, 0}, {0, 0, 1}), test::hit_at(3), test::profile_of_all());
  CHECK(templated.filled(miss) == "miss\n");
}

TEST_CASE("a reproducer is run, and what it gets is judged") {
  const Templated templated("");
  const auto of = [&](const std::string& program) {
    return reproduced(templated.system, missed_sphere(), program, "it.sh", never);
  };
  const Reproduction shows = of("echo loading\nprintf WARN:\necho 'got: miss'\necho 'expected: hit e0 1.25'\n");
  CHECK(shows.output == "got: miss\nexpected: hit e0 1.25\n");
  CHECK(shows.verdict == Verdict::missed);
  CHECK(of("echo 'got: hit e0 1.25'\n").verdict == Verdict::exact);
  CHECK(of("echo 'got: hit e0 1.75'\n").verdict == Verdict::misplaced);
  const Reproduction silent = of("echo no licence >&2\nexit 3\n");
  CHECK(silent.verdict == Verdict::crashed);
  CHECK(silent.output.empty());
  CHECK(silent.words.find("exit status 3: no licence") != std::string::npos);
}

TEST_CASE("where it cannot be built it is not run") {
  Templated templated("");
  templated.system.reproducer.run = {{"false"}, {"echo", "got: miss"}};
  CHECK(reproduced(templated.system, missed_sphere(), "", "it.sh", never).output.empty());
}
