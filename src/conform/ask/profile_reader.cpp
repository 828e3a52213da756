#include "conform/ask/profile_reader.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "durero/io/json/whole_number.hpp"
#include "durero/scene/shapes.hpp"

namespace durero::conform {
namespace {

using io::json::Reader;

enum ProfileKey : std::size_t {
  format,
  tipos,
  caps,
  measure,
  directions,
  inside,
  names_elements,
  thickness,
  least_t,
  greatest_t,
  least_size,
  greatest_size,
  greatest_coordinate,
  watertight,
  normal,
  normal_length,
  faces,
  uv,
  questions,
  error,
  half_spaces,
  back_faces,
  surfaces,
  touching
};
constexpr std::string_view profile_keys[] = {"format",
                                             "tipos",
                                             "caps",
                                             "measure",
                                             "directions",
                                             "inside",
                                             "names_elements",
                                             "thickness",
                                             "least_t",
                                             "greatest_t",
                                             "least_size",
                                             "greatest_size",
                                             "greatest_coordinate",
                                             "watertight",
                                             "normal",
                                             "normal_length",
                                             "faces",
                                             "uv",
                                             "questions",
                                             "error",
                                             "half_spaces",
                                             "back_faces",
                                             "surfaces",
                                             "touching"};
constexpr std::size_t required_keys = 7;

/// The words of the types, and then those of the kinds of bodies.
constexpr auto type_names = [] {
  std::array<std::string_view, model::tipo_count + kind_count> words{};
  scene::for_each_shape([&]<class Shape>(std::type_identity<Shape>) { words[scene::place_of<Shape>] = Shape::word; });
  std::copy(body_words.begin(), body_words.end(), words.begin() + model::tipo_count);
  return words;
}();

/// A number that is not negative.
void read_bound(Reader& in, std::string_view what, double& bound) {
  const std::size_t at = in.offset();
  bound = in.number(what);
  if (bound < 0) in.fail(at, fmt::format("{} is {}", what, bound), "expected a number that is not negative");
}

void read_error(Reader& in, double& error) {
  const std::size_t at = in.offset();
  error = in.number("error");
  if (!(error >= usual_error && error <= greatest_error))
    in.fail(at, fmt::format("error is {}", error),
            fmt::format("expected units of rounding, from {} to {}", usual_error, greatest_error));
}

void read_questions(Reader& in, std::string_view what, std::vector<QuestionKind>& read) {
  const std::size_t at = in.offset();
  read.clear();
  in.array(what, [&] { read.push_back(read_word<QuestionKind>(in, "a question", question_words)); });
  if (read.empty()) in.fail(at, fmt::format("{} is empty", what), "expected one question at least");
}

void read_surfaces(Reader& in, std::string_view what, std::vector<std::string>& read) {
  in.array(what, [&] {
    const std::size_t at = in.offset();
    read.emplace_back(in.string("a type of a text"));
    if (read.back().empty()) in.fail(at, "a type of a text is empty", "expected its word in scene files");
  });
}

/// Reads the words of types, of which there may be none.
void read_type_words(Reader& in, std::string_view what, std::vector<model::Tipo>& types, std::vector<BodyKind>& kinds) {
  in.array(what, [&] {
    const std::size_t number = read_word<std::size_t>(in, "a tipo", type_names);
    if (number < model::tipo_count)
      types.push_back(static_cast<model::Tipo>(number));
    else
      kinds.push_back(static_cast<BodyKind>(number - model::tipo_count));
  });
}

[[noreturn]] void fail_without_types(Reader& in, std::size_t at, std::string_view what) {
  in.fail(at, fmt::format("{} is empty", what), "expected one type of elements at least");
}

void read_member(Reader& in, ProfileKey key, Profile& profile) {
  const std::string_view what = profile_keys[key];
  switch (key) {
    case format:
      profile.format = read_word<NumberFormat>(in, what, format_words);
      return;
    case tipos:
      return read_type_words(in, what, profile.tipos, profile.bodies);
    case caps:
      profile.caps = read_word<Caps>(in, what, caps_words);
      return;
    case measure:
      profile.measure = read_word<Measure>(in, what, measure_words);
      return;
    case directions:
      profile.directions = read_word<Directions>(in, what, directions_words);
      return;
    case inside:
      profile.inside = read_word<Inside>(in, what, inside_words);
      return;
    case names_elements:
      profile.names_elements = in.boolean(what);
      return;
    case thickness:
      return read_bound(in, what, profile.thickness);
    case least_t:
      return read_bound(in, what, profile.least_t);
    case greatest_t:
      return read_bound(in, what, profile.greatest_t);
    case least_size:
      return read_bound(in, what, profile.least_size);
    case greatest_size:
      return read_bound(in, what, profile.greatest_size);
    case greatest_coordinate:
      return read_bound(in, what, profile.greatest_coordinate);
    case watertight:
      profile.watertight = in.boolean(what);
      return;
    case normal:
      profile.normal = read_word<NormalSide>(in, what, normal_words);
      return;
    case normal_length:
      profile.normal_length = read_word<NormalLength>(in, what, normal_length_words);
      return;
    case faces:
      profile.faces = in.boolean(what);
      return;
    case uv:
      profile.uv = in.boolean(what);
      return;
    case questions:
      return read_questions(in, what, profile.questions);
    case error:
      return read_error(in, profile.error);
    case half_spaces:
      profile.half_spaces = in.boolean(what);
      return;
    case back_faces:
      profile.back_faces = read_word<BackFaces>(in, what, back_faces_words);
      return;
    case surfaces:
      return read_surfaces(in, what, profile.surfaces);
    case touching:
      profile.touching = read_word<Touching>(in, what, touching_words);
      return;
  }
}

Citation read_source_of_claim(Reader& in) {
  constexpr std::string_view source_keys[] = {"claim", "sentence", "place"};
  Citation source;
  in.object("a source", source_keys, 3, [&](std::size_t key) {
    const std::size_t at = in.offset();
    const std::string_view value = in.string(source_keys[key]);
    if (value.empty()) in.fail(at, fmt::format("{} is empty", source_keys[key]), "expected some text");
    if (key == 0 && std::ranges::find(profile_keys, value) == std::end(profile_keys))
      in.fail(at, fmt::format("claim is {}", text::shown(value)),
              fmt::format("expected one of {}", fmt::join(profile_keys, ", ")));
    (key == 0 ? source.claim : key == 1 ? source.sentence : source.place) = value;
  });
  return source;
}

}  // namespace

void read_profile_members(Reader& in, Profile& profile) {
  std::size_t types_at = in.offset();
  in.object("a profile", profile_keys, required_keys, [&](std::size_t key) {
    if (key == tipos) types_at = in.offset();
    read_member(in, static_cast<ProfileKey>(key), profile);
  });
  if (profile.tipos.empty() && profile.bodies.empty() && profile.surfaces.empty())
    fail_without_types(in, types_at, profile_keys[tipos]);
}

std::vector<Citation> read_sources(Reader& in) {
  std::vector<Citation> sources;
  in.array("sources", [&] { sources.push_back(read_source_of_claim(in)); });
  return sources;
}

void read_tipos(Reader& in, std::string_view what, std::vector<model::Tipo>& tipos, std::vector<BodyKind>& bodies) {
  const std::size_t at = in.offset();
  read_type_words(in, what, tipos, bodies);
  if (tipos.empty() && bodies.empty()) fail_without_types(in, at, what);
}

void read_exactly(Reader& in, std::string_view what, std::string_view expected) {
  const std::size_t at = in.offset();
  const std::string_view value = in.string(what);
  if (value != expected)
    in.fail(at, fmt::format("{} is {}", what, text::shown(value)), fmt::format("expected \"{}\"", expected));
}

}  // namespace durero::conform
