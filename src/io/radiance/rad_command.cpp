#include "rad_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "durero/io/number_text.hpp"

namespace durero::io {
namespace {

using CommandWords = std::vector<std::string>;

/// More copies would be a program that does not end.
constexpr std::size_t most_copies = 1'000'000;

/// The words of each program of a line. Nothing where the shell would do more than to part them.
std::optional<std::vector<CommandWords>> stages_of(std::string_view line) {
  std::vector<CommandWords> stages(1);
  std::optional<std::string> word;
  const auto end_word = [&] {
    if (word) stages.back().push_back(*std::exchange(word, std::nullopt));
  };
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '|') {
      end_word();
      stages.emplace_back();
    } else if (c == '"' || c == '\'') {
      const std::size_t end = line.find(c, i + 1);
      if (end == line.npos) return std::nullopt;
      const std::string_view quoted = line.substr(i + 1, end - i - 1);
      if (c == '"' && quoted.find_first_of("$`\\") != quoted.npos) return std::nullopt;
      word = word.value_or("") + std::string(quoted);
      i = end;
    } else if (std::string_view(" \t").find(c) != std::string_view::npos) {
      end_word();
    } else if (std::string_view(";&<>$`\\*?[](){}~#!").find(c) != std::string_view::npos) {
      return std::nullopt;
    } else {
      word = word.value_or("") + c;
    }
  }
  end_word();
  return stages;
}

/// Reads the words of a program from the front.
class CommandReader {
 public:
  explicit CommandReader(const CommandWords& words) : words_(words) {}

  bool done() const { return next_ == words_.size(); }
  const std::string& here() const { return words_[next_]; }
  void pass() { ++next_; }
  bool take(std::string_view word) { return !done() && here() == word && (pass(), true); }
  std::optional<std::string> word() { return done() ? std::nullopt : std::optional(words_[next_++]); }
  std::optional<double> number() { return done() ? std::nullopt : read_decimal(words_[next_++]); }
  std::optional<glm::dvec3> triple() {
    const auto x = number(), y = number(), z = number();
    return x && y && z ? std::optional(glm::dvec3(*x, *y, *z)) : std::nullopt;
  }
  std::optional<std::size_t> count() {
    const auto value = number();
    if (!value || !(*value >= 0 && *value <= most_copies) || *value != static_cast<double>(std::size_t(*value)))
      return std::nullopt;
    return static_cast<std::size_t>(*value);
  }
  CommandWords rest() { return {words_.begin() + std::ptrdiff_t(std::exchange(next_, words_.size())), words_.end()}; }

 private:
  const CommandWords& words_;
  std::size_t next_ = 1;  // behind the name of the program
};

/// The axis that the last letter of an option names.
std::optional<int> axis_of(const std::string& option) {
  const std::size_t axis = std::string_view("xyz").find(option.back());
  return option.size() == 3 && axis < 3 ? std::optional(static_cast<int>(axis)) : std::nullopt;
}

/// The transformation that stands here; nothing where none does, or where it is incomplete.
std::optional<Transform> take_transform_option(CommandReader& in) {
  const std::string option = in.here();
  if (in.take("-t")) {
    const auto way = in.triple();
    return way ? std::optional(shift_by(*way)) : std::nullopt;
  }
  if (in.take("-s")) {
    const auto factor = in.number();
    return factor && *factor > 0 ? std::optional(scaling_by(glm::dvec3(*factor))) : std::nullopt;
  }
  const auto axis = axis_of(option);
  if (axis && option.starts_with("-r")) {
    in.pass();
    const auto degrees = in.number();
    return degrees ? std::optional(turn_about(*axis, *degrees)) : std::nullopt;
  }
  if (axis && option.starts_with("-m")) {
    in.pass();
    glm::dvec3 factors(1);
    factors[*axis] = -1;
    return scaling_by(factors);
  }
  return std::nullopt;
}

Transform times(std::size_t count, const Transform& one) {
  Transform all;
  for (std::size_t i = 0; i < count; ++i) all = all.then(one);
  return all;
}

/// Every copy, moved as the last transformations say: as often as -i, or in an array 0, 1, … times.
struct LastTransforms {
  std::size_t count = 1;
  bool is_array = false;
  Transform one{};

  bool end(std::vector<RadCopy>& copies) const {
    const std::size_t first = is_array ? 0 : count, last = is_array ? count : count + 1;
    if (copies.size() * (last - first) > most_copies || last > most_copies) return false;
    std::vector<RadCopy> made;
    for (const RadCopy& copy : copies) {
      Transform moved = times(first, one);
      for (std::size_t i = first; i < last; ++i, moved = moved.then(one))
        made.push_back({copy.placed.then(moved), is_array ? fmt::format("{}{}.", copy.prefix, i) : copy.prefix});
    }
    copies = std::move(made);
    return true;
  }
};

/// What the options of xform say, up to the first word that is none. Nothing where one is not carried out.
std::optional<RadTransform> take_transform(CommandReader& in) {
  RadTransform made;
  std::string name;
  LastTransforms last;
  while (!in.done() && in.here().starts_with('-')) {
    if (in.take("-I") || in.take("-e") || in.take("-c")) continue;  // sides, commands and comments
    if (in.take("-n")) {
      const auto prefix = in.word();
      if (!prefix) return std::nullopt;
      name = *prefix + ".";
    } else if (in.take("-m")) {
      if (!(made.modifier = in.word())) return std::nullopt;
    } else if (const bool is_array = in.here() == "-a"; is_array || in.here() == "-i") {
      in.pass();
      const auto count = in.count();
      if (!count || !last.end(made.copies)) return std::nullopt;
      last = {*count, is_array};
    } else if (const auto one = take_transform_option(in)) {
      last.one = last.one.then(*one);
    } else {
      return std::nullopt;
    }
  }
  if (!last.end(made.copies)) return std::nullopt;
  for (RadCopy& copy : made.copies)
    copy.prefix = name.empty() && !copy.prefix.empty() ? "a" + copy.prefix : name + copy.prefix;
  return made;
}

/// genbox MATERIAL NAME X Y Z, perhaps turned inside out.
std::optional<RadBox> box_of(CommandReader in) {
  const auto modifier = in.word(), identifier = in.word();
  const auto size = in.triple();
  in.take("-i");
  if (!modifier || !identifier || !size || !in.done()) return std::nullopt;
  return RadBox{*modifier, *identifier, *size};
}

/// What the first program of a line writes, before what the next ones make of it.
std::optional<RadCommand> first_of(const CommandWords& words) {
  CommandReader in(words);
  if (words[0] == "genbox") {
    const auto box = box_of(in);
    return box ? std::optional(RadCommand{*box, {}}) : std::nullopt;
  }
  std::vector<RadTransform> then;
  if (words[0] == "xform") {
    const auto transform = take_transform(in);
    if (!transform) return std::nullopt;
    then.push_back(*transform);
  } else if (words[0] != "cat") {
    return std::nullopt;
  }
  CommandWords files = in.rest();
  const auto is_option = [](const std::string& word) { return word.starts_with('-'); };
  if (files.empty() || std::ranges::any_of(files, is_option)) return std::nullopt;
  return RadCommand{std::move(files), std::move(then)};
}

}  // namespace

std::optional<RadCommand> rad_command(std::string_view line) {
  const auto stages = stages_of(line);
  if (!stages || std::ranges::any_of(*stages, [](const CommandWords& words) { return words.empty(); }))
    return std::nullopt;
  auto command = first_of(stages->front());
  for (std::size_t i = 1; command && i < stages->size(); ++i) {
    CommandReader in((*stages)[i]);
    const auto transform = (*stages)[i][0] == "xform" ? take_transform(in) : std::nullopt;
    if (!transform || !in.done()) return std::nullopt;
    command->then.push_back(*transform);
  }
  return command;
}

// Of the number of a corner, 0 to 7, a bit says whether it is at the far end of x, y and z.
std::array<RadFace, 6> faces_of(const RadBox& box) {
  std::array<RadFace, 6> faces{{{"1540", {}}, {"4620", {}}, {"2310", {}}, {"3267", {}}, {"5137", {}}, {"6457", {}}}};
  for (RadFace& face : faces)
    for (std::size_t k = 0; k < 4; ++k) {
      const unsigned corner = static_cast<unsigned>(face.name[k] - '0');
      face.corners[k] = box.size * glm::dvec3(corner & 1U, corner >> 1U & 1U, corner >> 2U & 1U);
    }
  return faces;
}

}  // namespace durero::io
