// A suite is read from its files: its contents are taken from some, and all others must agree with what follows from
// these.
#include <fmt/format.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "conform/ask/profile_reader.hpp"
#include "conform/families/suite_text.hpp"
#include "durero/conform/format_versions.hpp"
#include "durero/io/json/json.hpp"
#include "durero/io/json/scene_file.hpp"
#include "durero/io/json/whole_number.hpp"
#include "durero/io/rays/rays_file.hpp"
#include "durero/text/shown.hpp"

namespace durero::conform {
namespace {

using io::json::Reader;

/// Reads the name of a family; the rest follows from it.
const Family* read_family(Reader& in) {
  const Family* family = nullptr;
  const std::size_t at = in.offset();
  in.members("a family", [&](const io::json::Key& key) {
    if (key.name != "family") return in.skip();
    const std::size_t place = in.offset();
    const std::string_view name = in.string("family");
    family = find_family(name);
    if (family == nullptr)
      in.fail(place, fmt::format("family is {}", text::shown(name)), "expected one that durero conform list shows");
  });
  if (family == nullptr) in.fail(at, "a family without its name", "expected the key family");
  return family;
}

SuiteOptions read_options(const io::Source& source) {
  enum Key : std::size_t { format, version, seed, rays, numbers, caps, tipos, families, faces, question };
  constexpr std::array<std::string_view, 10> keys{"format", "version", "seed",     "rays",  "numbers",
                                                  "caps",   "tipos",   "families", "faces", "question"};
  const io::json::Document document(source);
  Reader in(document);
  require_version(in, suite_format);
  SuiteOptions options;
  in.object("a suite", keys, faces, [&](std::size_t key) {
    switch (static_cast<Key>(key)) {
      case format:
      case version:  // read before all others
        return in.skip();
      case seed:
        options.seed = io::json::whole_number(in, "seed");
        return;
      case rays:
        options.rays = io::json::whole_number(in, "rays");
        return;
      case numbers:
        options.numbers = read_word<NumberFormat>(in, "numbers", format_words);
        return;
      case caps:
        options.caps = read_word<Caps>(in, "caps", caps_words);
        return;
      case tipos:
        return read_tipos(in, "tipos", options.tipos, options.bodies);
      case families:
        return in.array("families", [&] { options.families.push_back(read_family(in)); });
      case faces:
        options.faces = io::json::whole_number(in, "faces", 1, most_faces, "a number of faces");
        return;
      case question:
        options.question = read_word<QuestionKind>(in, "question", question_words);
        return;
    }
  });
  return options;
}

scene::ElementRef read_element(Reader& in, const scene::Scene& scene) {
  const std::size_t at = in.offset();
  const std::string_view name = in.string("an element");
  const auto element = scene.find(name);
  if (!element) in.fail(at, fmt::format("no element {}", text::shown(name)), "expected an element of the scene");
  return *element;
}

Solid read_solid(Reader& in, const scene::Scene& scene) {
  constexpr std::array<std::string_view, 2> keys{"wall", "discs"};
  Solid solid{};
  in.object("a solid", keys, keys.size(), [&](std::size_t key) {
    if (key == 0)
      solid.wall = read_element(in, scene);
    else
      in.array("discs", [&] { solid.discs.push_back(read_element(in, scene)); });
  });
  return solid;
}

/// Reads a body of the scene. The scene's file must hold the body that follows from its numbers.
NamedBody read_body(Reader& in, const scene::Scene& scene) {
  constexpr std::array<std::string_view, 7> keys{"id", "tipo", "centro", "x", "y", "z", "radio"};
  NamedBody named{};
  const std::size_t at = in.offset();
  in.object("a body", keys, keys.size() - 1, [&](std::size_t key) {
    if (key == 0)
      named.element = read_element(in, scene);
    else if (key == 1)
      named.body.kind = read_word<BodyKind>(in, "tipo", body_words);
    else if (key == 6)
      named.body.radio = in.number("radio");
    else
      (key == 2 ? named.body.centro : named.body.sides[key - 3]) = in.vec3(keys[key]);
  });
  if (scene.body(named.element) == nullptr || !is_body(named.body))
    in.fail(at, "no body", "expected one of the scene, whose sides span space, with its radius");
  return named;
}

/// The scene with the bodies that follow from their numbers.
scene::Scene with_bodies(scene::Scene scene, const std::vector<NamedBody>& bodies) {
  for (const auto& [element, body] : bodies) scene.set_body(element, exact_body(body));
  return scene;
}

/// Reads the parameter, the solids and the bodies; the rest follows from the scene and the rays.
void read_sidecar(const io::Source& source, SuiteCase& of) {
  const io::json::Document document(source);
  Reader in(document);
  in.members("a case", [&](const io::json::Key& key) {
    if (key.name == "solids")
      return in.array("solids", [&] { of.solids.push_back(read_solid(in, of.the_case.scene)); });
    if (key.name == "bodies") return in.array("bodies", [&] { of.bodies.push_back(read_body(in, of.the_case.scene)); });
    if (key.name != "parameter") return in.skip();
    in.members("parameter", [&](const io::json::Key& part) {
      if (part.name != "value") return in.skip();
      constexpr int most = std::numeric_limits<int>::max();
      of.parameter = static_cast<int>(io::json::whole_number(in, "the parameter", -most, most, "a whole number"));
    });
  });
}

/// Checks that the text of the file is `expected`. Throws io::InputError at the first byte that differs.
void require_text(const io::Source& file, std::string_view expected) {
  const std::string_view text = file.text();
  const auto [here, there] = std::mismatch(text.begin(), text.end(), expected.begin(), expected.end());
  if (here == text.end() && there == expected.end()) return;
  const auto at = static_cast<std::size_t>(here - text.begin());
  const auto rest = [at](std::string_view of) { return at < of.size() ? text::shown(of.substr(at)) : "the end"; };
  file.fail(at, rest(text), fmt::format("expected {}, which follows from the scene and the rays", rest(expected)));
}

/// A case, read from its files and answered anew.
SuiteCase read_case(const std::string& directory, const SuiteOptions& options, const Family& family, std::size_t number,
                    FamilySummary& counted) {
  SuiteCase of;
  of.family = &family;
  of.number = number;
  of.is_grid = is_of_meshes(family) && asks_grids(options.tipos, options.bodies);
  const std::string path = fmt::format("{}/{}", directory, of.name());
  const auto source = [&](std::string_view ending) { return io::read_source(fmt::format("{}{}", path, ending)); };
  of.the_case.scene = io::read_scene(source(scene_ending), io::Bodies::read);
  const io::Source rays = source(rays_ending);
  of.the_case.rays = io::read_rays(rays, of.the_case.scene);
  const std::size_t expected = std::min(rays_of(family), options.rays - number * rays_of(family));
  if (of.the_case.rays.size() != expected)
    rays.fail(rays.text().size(), fmt::format("{} rays", of.the_case.rays.size()),
              fmt::format("expected {}", expected));
  read_sidecar(source(sidecar_ending), of);
  of.the_case.scene = with_bodies(std::move(of.the_case.scene), of.bodies);
  answer(of);
  counted = summary(of);
  ask_question(of, options);
  for (const File& file : case_files(of, counted.count)) require_text(source(file.ending), file.text);
  return of;
}

}  // namespace

Suite read_suite(const std::string& directory) {
  const io::Source source = io::read_source(directory + "/suite.json");
  Suite suite{read_options(source), {}};
  std::vector<FamilySummary> families;
  for (const Family* family : chosen_families(suite.options)) {
    std::vector<SuiteCase> read(cases(suite.options, *family));
    std::vector<FamilySummary> counted(read.size());
    oneapi::tbb::parallel_for(std::size_t{0}, read.size(), [&](std::size_t number) {
      read[number] = read_case(directory, suite.options, *family, number, counted[number]);
    });
    FamilySummary& all = families.emplace_back(FamilySummary{.family = family});
    for (const FamilySummary& of_case : counted) all += of_case;
    std::move(read.begin(), read.end(), std::back_inserter(suite.cases));
  }
  require_text(source, suite_text(suite.options, families));
  return suite;
}

}  // namespace durero::conform
