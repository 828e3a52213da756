#include "rad_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "durero/text/shown.hpp"
#include "io/scene_folder.hpp"

namespace durero::io {
namespace {

/// @{ More is taken for a program that does not end.
constexpr std::size_t most_primitives = 20'000'000;
constexpr std::size_t most_bytes_of_files = std::size_t{1} << 30U;
constexpr std::size_t most_commands_within = 32;
/// @}

constexpr std::string_view rad_surfaces[] = {"source",   "sphere", "bubble", "polygon",  "cone", "cup",
                                             "cylinder", "tube",   "ring",   "instance", "mesh"};
constexpr std::string_view rad_materials[] = {
    "light",     "illum", "glow",     "spotlight",  "mirror",    "prism1",   "prism2",  "mist",
    "plastic",   "metal", "plastic2", "metal2",     "trans",     "trans2",   "ashik2",  "dielectric",
    "interface", "glass", "plasfunc", "metfunc",    "transfunc", "plasdata", "metdata", "transdata",
    "BRTDfunc",  "BSDF",  "aBSDF",    "antimatter", "WGMDfunc"};
constexpr std::string_view rad_mixtures[] = {"mixfunc", "mixdata", "mixpict", "mixtext"};
constexpr std::string_view rad_changes[] = {"texfunc",    "texdata",   "colorfunc", "brightfunc", "colordata",
                                            "brightdata", "colorpict", "colortext", "brighttext", "spectrum",
                                            "specfile",   "specfunc",  "specdata",  "specpict"};

template <std::size_t n>
bool is_in(std::string_view word, const std::string_view (&words)[n]) {
  return std::ranges::find(words, word) != std::end(words);
}

}  // namespace

bool is_rad_surface(std::string_view type) { return is_in(type, rad_surfaces); }
bool is_rad_material(std::string_view type) { return is_in(type, rad_materials); }
bool is_rad_mixture(std::string_view type) { return is_in(type, rad_mixtures); }

void RadText::for_each(const std::function<void(const RadPrimitive&)>& primitive) {
  primitive_ = primitive;
  read(main_, {});
}

void RadText::name_losses(std::vector<std::string>& lost) const {
  for (const auto& [program, count] : not_run_)
    lost.push_back(fmt::format("{} command{} not carried out: {}", count, count == 1 ? "" : "s", text::shown(program)));
}

void RadText::count_step(const Source& source, std::size_t at) {
  if (++steps_ > most_primitives)
    source.fail(at, "more than 20000000 primitives and files", "expected a text that ends sooner");
}

void RadText::read(const Source& source, const Around& around) {
  RadWords in(source);
  while (!in.done()) {
    if (const auto line = in.take_command()) {
      carry_out(source, *line, around);
    } else {
      hand_on(primitive(source, in), around);
      in.skip_comments();
    }
  }
}

RadPrimitive RadText::primitive(const Source& source, RadWords& in) {
  RadPrimitive made{&source, in.offset(), std::string(in.word("a modifier")), {}, {}};
  const std::size_t at = in.offset();
  made.type = in.word("a type");
  const bool is_alias = made.type == "alias";
  if (!is_alias && !is_rad_surface(made.type) && !is_rad_material(made.type) && !is_rad_mixture(made.type) &&
      !is_in(made.type, rad_changes))
    in.fail(std::min(source.text().find_first_not_of(" \t\r\n\v\f", at), at + 1),
            fmt::format("there is no type {}", text::shown(made.type)), "expected one of Radiance");
  made.identifier = in.word("an identifier");
  if (is_alias) {
    made.words.emplace_back(in.word("the identifier that an alias stands for"));
    return made;
  }
  for (std::size_t n = in.count("the number of words"); n > 0; --n) made.words.emplace_back(in.word("a word"));
  for (std::size_t n = in.count("the number of whole numbers"); n > 0; --n) in.number("a whole number");
  for (std::size_t n = in.count("the number of numbers"); n > 0; --n) made.numbers.push_back(in.number(made.type));
  return made;
}

// A material has the place of none, and keeps its identifier.
void RadText::hand_on(RadPrimitive primitive, const Around& around) {
  count_step(*primitive.source, primitive.at);
  if (is_rad_surface(primitive.type)) {
    primitive.placed = around.placed;
    primitive.identifier = around.prefix + primitive.identifier;
    if (!around.modifier.empty()) primitive.modifier = around.modifier;
  }
  primitive_(primitive);
}

void RadText::carry_out(const Source& source, const RadLine& line, const Around& around) {
  const auto command = rad_command(line.text);
  if (command) {
    if (++depth_ > most_commands_within)
      source.fail(line.at, "commands within commands, 33 deep", "expected 32 at most");
    carry_out(source, line, *command, command->then.size(), around);
    --depth_;
    return;
  }
  const std::size_t from = std::min(line.text.find_first_not_of(" \t"), line.text.size());
  ++not_run_[line.text.substr(from, line.text.find_first_of(" \t|", from) - from)];
}

// What the last program of a line does is around what those before it do.
void RadText::carry_out(const Source& source, const RadLine& line, const RadCommand& command, std::size_t stage,
                        const Around& around) {
  if (stage > 0) {
    const RadTransform& transform = command.then[stage - 1];
    for (const RadCopy& copy : transform.copies)
      carry_out(source, line, command, stage - 1,
                {copy.placed.then(around.placed), around.prefix + copy.prefix,
                 around.modifier.empty() ? transform.modifier.value_or("") : around.modifier});
    return;
  }
  count_step(source, line.at);
  if (const auto* const box = std::get_if<RadBox>(&command.of)) {
    for (const RadFace& face : faces_of(*box)) {
      RadPrimitive polygon{&source, line.at, box->modifier, "polygon",
                           fmt::format("{}.{}", box->identifier, face.name)};
      for (const glm::dvec3& corner : face.corners)
        polygon.numbers.insert(polygon.numbers.end(), {corner.x, corner.y, corner.z});
      hand_on(std::move(polygon), around);
    }
    return;
  }
  for (const std::string& name : std::get<std::vector<std::string>>(command.of)) read(file(source, line, name), around);
}

const Source& RadText::file(const Source& source, const RadLine& line, const std::string& name) {
  auto known = files_.find(name);
  if (known == files_.end()) {
    const SceneFolder folder(main_);
    const auto path = folder.find(main_, name);
    if (!path) source.fail(line.at, fmt::format("no file {}", text::shown(name)), folder.expected());
    known = files_.emplace(name, read_source(*path)).first;
  }
  const Source& read = known->second;
  bytes_ += read.text().size();
  if (bytes_ > most_bytes_of_files)
    source.fail(line.at, "more than 1073741824 bytes of files, which may be one again and again",
                "expected a text that ends sooner");
  return read;
}

}  // namespace durero::io
