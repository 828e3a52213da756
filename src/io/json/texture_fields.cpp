#include "texture_fields.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <set>

#include "durero/scene/stage.hpp"
#include "durero/text/nearest.hpp"
#include "durero/text/shown.hpp"
#include "stage_fields.hpp"
#include "two.hpp"

namespace durero::io {
namespace {

using scene::Bump;
using scene::Environment;
using scene::Surroundings;
using scene::Texture;

constexpr std::string_view texture_keys[] = {"image",  "checker", "stripes", "p6m",   "waves",
                                             "repeat", "filter",  "edges",   "curve", "near"};
enum TextureKey : std::size_t { repeat = scene::pattern_words.size(), filter, edges, curve, near };

bool is_positive(const double& x) { return x > 0; }
constexpr Rule<double> positive{is_positive, "", "a number above 0"};

/// Which of the words stands here.
std::size_t read_word(json::Reader& in, std::string_view what, std::span<const std::string_view> words) {
  const std::size_t at = in.offset();
  const std::string_view word = in.string(what);
  const auto found = std::ranges::find(words, word);
  if (found == words.end())
    in.fail(at, fmt::format("{} is {}", what, text::shown(word)),
            "expected " + text::expected_of(word, {words.begin(), words.end()}));
  return static_cast<std::size_t>(found - words.begin());
}

std::string read_name(json::Reader& in, std::string_view what, const char* expected) {
  const std::size_t at = in.offset();
  std::string name(in.string(what));
  if (name.empty()) in.fail(at, fmt::format("{} is empty", what), expected);
  return name;
}

scene::PictureFile read_file_name(json::Reader& in, std::string_view what) {
  return {read_name(in, what, "expected the name of a PNG or JPEG file")};
}

double read_positive(json::Reader& in, std::string_view what) {
  const std::size_t at = in.offset();
  const double x = in.number(what);
  check_rule(in, at, what, positive, x);
  return x;
}

std::array<glm::dvec3, 2> read_colors(json::Reader& in, std::string_view what, const Rule<glm::dvec3>& rule) {
  return read_two<glm::dvec3>(in, what, "expected two colours", [&] {
    const std::size_t at = in.offset();
    const glm::dvec3 color = in.vec3(what);
    check_rule(in, at, what, rule, color);
    return color;
  });
}

glm::dvec2 read_repeat(json::Reader& in) {
  const auto [across, upwards] =
      read_two<double>(in, "repeat", "expected two numbers above 0", [&] { return read_positive(in, "repeat"); });
  return {across, upwards};
}

/// Reads the textures one by one, and holds each to what its keys say together.
class TextureReader {
 public:
  explicit TextureReader(json::Reader& in) : in_(in), at_(in.offset()) {}

  Texture read(std::string_view name) {
    texture_.name = name;
    in_.object("a texture", texture_keys, 0, [&](std::size_t key) { read_key(key); });
    if (patterns_ == 0)
      in_.fail(at_, "a texture is made of nothing",
               fmt::format("expected one of {}", fmt::join(scene::pattern_words, ", ")));
    const bool is_image = texture_.pattern == scene::Pattern::image;
    if (of_image_ && !is_image) in_.fail(*of_image_, "only an image has this key", "expected none but repeat");
    const bool is_mipmap = texture_.filter == scene::Filter::mipmap;
    if (is_mipmap && !texture_.near) in_.fail(at_, "a mipmap lacks near", "expected the distance up to which it is M₀");
    if (texture_.near && !is_mipmap) in_.fail(at_, "near without a mipmap", "expected \"filter\":\"mipmap\"");
    return std::move(texture_);
  }

 private:
  void read_key(std::size_t key) {
    if (key < scene::pattern_words.size()) return read_pattern(key);
    if (key != repeat) of_image_ = in_.key_offset();
    switch (static_cast<TextureKey>(key)) {
      case repeat:
        texture_.repeat = read_repeat(in_);
        return;
      case filter:
        texture_.filter = static_cast<scene::Filter>(read_word(in_, "filter", scene::filter_words));
        return;
      case edges:
        texture_.edges = static_cast<scene::Edges>(read_word(in_, "edges", scene::edges_words));
        return;
      case curve:
        texture_.curve = static_cast<scene::TransferFunction>(read_word(in_, "curve", scene::curve_words));
        return;
      case near:
        texture_.near = read_positive(in_, "near");
    }
  }

  void read_pattern(std::size_t key) {
    if (patterns_++ > 0) in_.fail(in_.key_offset(), "a texture is made of two things", "expected one");
    texture_.pattern = static_cast<scene::Pattern>(key);
    if (texture_.pattern == scene::Pattern::image)
      texture_.image = read_file_name(in_, "image");
    else
      texture_.colors = read_colors(in_, scene::pattern_words[key], share);
  }

  json::Reader& in_;
  std::size_t at_;
  Texture texture_;
  int patterns_ = 0;
  std::optional<std::size_t> of_image_;  // where a key stands that only an image has
};

void read_surroundings(json::Reader& in, Environment& environment) {
  const std::string_view what = scene::surroundings_words[static_cast<std::size_t>(environment.kind)];
  const std::size_t at = in.offset();
  switch (environment.kind) {
    case Surroundings::gradient:
      environment.colors = read_colors(in, what, light_color);
      return;
    case Surroundings::box:
      in.array(what, [&] { environment.pictures.push_back(read_file_name(in, what)); });
      if (environment.pictures.size() != scene::box_faces.size())
        in.fail(at, fmt::format("box has {} items", environment.pictures.size()),
                fmt::format("expected six pictures, {}", fmt::join(scene::box_faces, ", ")));
      return;
    case Surroundings::spherical:
    case Surroundings::equirectangular:
      environment.pictures.push_back(read_file_name(in, what));
  }
}

void write_colors(json::Writer& out, std::string_view key, const std::array<glm::dvec3, 2>& colors) {
  out.key(key).begin_array().value(colors[0]).value(colors[1]).end_array();
}

constexpr std::string_view bump_keys[] = {"texture", "height", "delta"};

/// Where a value stands in a material.
std::size_t place_in(const json::Document& document, const std::string& material,
                     std::initializer_list<std::string_view> keys) {
  json::Reader in = json::Reader(document).member("materials").value().member(material).value();
  for (const std::string_view key : keys) in = in.member(key).value();
  return in.offset();
}

}  // namespace

std::vector<Texture> read_textures(json::Reader& in) {
  std::vector<Texture> textures;
  std::set<std::string_view> names;
  in.members("textures", [&](const json::Key& key) {
    if (key.name.empty()) in.fail(key.offset, "the name of a texture is empty", "expected a name");
    if (!names.insert(key.name).second)
      in.fail(key.offset, fmt::format("texture {} stands twice", text::shown(key.name)), "expected it once");
    textures.push_back(TextureReader(in).read(key.name));
  });
  std::ranges::sort(textures, {}, &Texture::name);
  return textures;
}

Environment read_environment(json::Reader& in) {
  Environment environment;
  const std::size_t at = in.offset();
  int count = 0;
  in.object("environment", scene::surroundings_words, 0, [&](std::size_t key) {
    if (count++ > 0) in.fail(in.key_offset(), "environment is two things", "expected one");
    environment.kind = static_cast<Surroundings>(key);
    read_surroundings(in, environment);
  });
  if (count == 0)
    in.fail(at, "environment is nothing",
            fmt::format("expected one of {}", fmt::join(scene::surroundings_words, ", ")));
  return environment;
}

void read_json(json::Reader& in, std::string_view what, scene::TextureUses& uses) {
  in.object(what, scene::coefficient_words, 0, [&](std::size_t key) {
    uses.names[key] = read_name(in, scene::coefficient_words[key], "expected the name of a texture");
  });
}

void read_json(json::Reader& in, std::string_view what, std::optional<Bump>& bump) {
  bump.emplace();
  in.object(what, bump_keys, 1, [&](std::size_t key) {
    if (key == 0) bump->texture = read_name(in, "texture", "expected the name of a texture");
    if (key == 1) bump->height = in.number("height");
    if (key == 2) bump->delta = read_positive(in, "delta");
  });
}

void write_member(json::Writer& out, std::string_view key, const scene::TextureUses& uses) {
  out.key(key).begin_object();
  for (std::size_t i = 0; i < uses.names.size(); ++i)
    if (!uses.names[i].empty()) out.member(scene::coefficient_words[i], std::string_view(uses.names[i]));
  out.end_object();
}

void write_member(json::Writer& out, std::string_view key, const std::optional<Bump>& bump) {
  out.key(key).begin_object().member("texture", std::string_view(bump->texture));
  if (bump->height != Bump{}.height) out.member("height", bump->height);
  if (bump->delta) out.member("delta", *bump->delta);
  out.end_object();
}

void check_texture_names(const json::Document& document, const scene::Stage& stage) {
  const auto check = [&](const std::string& name, const std::string& material,
                         std::initializer_list<std::string_view> keys) {
    if (name.empty() || std::ranges::binary_search(stage.textures, name, {}, &Texture::name)) return;
    document.source().fail(place_in(document, material, keys), fmt::format("unknown texture {}", text::shown(name)),
                           "expected one of the scene's textures");
  };
  for (const scene::Material& material : stage.materials) {
    for (std::size_t i = 0; i < material.textures.names.size(); ++i)
      check(material.textures.names[i], material.name, {"textures", scene::coefficient_words[i]});
    if (material.bump) check(material.bump->texture, material.name, {"bump", "texture"});
  }
}

void write_texture(json::Writer& out, const Texture& texture) {
  const Texture fresh;
  const std::string_view word = scene::pattern_words[static_cast<std::size_t>(texture.pattern)];
  out.begin_object();
  if (texture.pattern == scene::Pattern::image)
    out.member(word, std::string_view(texture.image.file));
  else
    write_colors(out, word, texture.colors);
  if (texture.repeat != fresh.repeat)
    out.key("repeat").begin_array().value(texture.repeat.x).value(texture.repeat.y).end_array();
  const auto write = [&](std::string_view key, const auto& words, auto value, auto usual) {
    if (value != usual) out.member(key, words[static_cast<std::size_t>(value)]);
  };
  write("filter", scene::filter_words, texture.filter, fresh.filter);
  write("edges", scene::edges_words, texture.edges, fresh.edges);
  write("curve", scene::curve_words, texture.curve, fresh.curve);
  if (texture.near) out.member("near", *texture.near);
  out.end_object();
}

void write_environment(json::Writer& out, const Environment& environment) {
  const std::string_view word = scene::surroundings_words[static_cast<std::size_t>(environment.kind)];
  out.begin_object();
  switch (environment.kind) {
    case Surroundings::gradient:
      write_colors(out, word, environment.colors);
      break;
    case Surroundings::box:
      out.key(word).begin_array();
      for (const scene::PictureFile& picture : environment.pictures) out.value(std::string_view(picture.file));
      out.end_array();
      break;
    case Surroundings::spherical:
    case Surroundings::equirectangular:
      out.member(word, std::string_view(environment.pictures.at(0).file));
  }
  out.end_object();
}

}  // namespace durero::io
