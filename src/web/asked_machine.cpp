#include "asked_machine.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "durero/io/json/whole_number.hpp"
#include "durero/spec/constants.hpp"
#include "held_text.hpp"

namespace durero::web {
namespace {

constexpr std::array<std::string_view, 9> setup_keys{"state",   "init",   "given", "constants", "members",
                                                     "numbers", "inputs", "steps", "choices"};

/// The setup of a machine, and how many ways to go on are listed.
struct AskedSetup {
  spec::Setup setup{};
  std::size_t choices = 20;
};

/// The members of a given set: their names, or how many there are.
std::vector<std::string> members_of(io::json::Reader& in, std::string_view set) {
  std::vector<std::string> members;
  if (in.kind() == io::json::TokenKind::array) {
    in.array("members", [&] { members.emplace_back(in.string("a member")); });
    return members;
  }
  const auto count = io::json::whole_number(in, "members", 1, 20, "1 to 20, or an array of names");
  for (std::int64_t i = 1; i <= count; ++i) members.push_back(fmt::format("{}{}", set, i));
  return members;
}

void read_setup_member(io::json::Reader& in, std::size_t key, AskedSetup& to) {
  const auto whole = [&](std::string_view what, std::int64_t least, std::int64_t most) {
    return io::json::whole_number(in, what, least, most, fmt::format("{} to {}", least, most));
  };
  spec::Setup& setup = to.setup;
  switch (key) {
    case 0:
      setup.state = in.string("state");
      return;
    case 1:
      setup.init = in.string("init");
      return;
    case 2:
      in.members("given",
                 [&](const io::json::Key& set) { setup.given[std::string(set.name)] = members_of(in, set.name); });
      return;
    case 3:
      in.array("constants", [&] { setup.constants.emplace_back(in.string("a constant")); });
      return;
    case 4:
      setup.members = static_cast<std::size_t>(whole("members", 1, 20));
      return;
    case 5:
      setup.numbers = static_cast<int>(whole("numbers", 0, 1000));
      return;
    case 6:
      setup.inputs = static_cast<std::size_t>(whole("inputs", 1, 1'000'000));
      return;
    case 7:
      setup.steps = static_cast<std::uint64_t>(whole("steps", 1, io::json::most_whole));
      return;
    case 8:
      to.choices = static_cast<std::size_t>(whole("choices", 1, 1000));
      return;
  }
}

AskedSetup setup_of(const AskedCall& asked) {
  AskedSetup setup;
  if (asked.has("setup")) {
    io::json::Reader in = asked.at("setup");
    in.object("setup", setup_keys, 0, [&](std::size_t key) { read_setup_member(in, key, setup); });
  }
  // The scene is the state of the program's own text, as for `durero spec run`.
  if (!asked.has("text") && setup.setup.state.empty()) setup.setup.state = "Escena";
  return setup;
}

std::shared_ptr<const spec::Machine> made_machine(const AskedCall& asked, const spec::Setup& setup) {
  const auto text = text_of(asked);
  text->require_right();
  try {
    return std::make_shared<const spec::Machine>(text->text, setup);
  } catch (const spec::ConstantError& error) {
    throw io::InputError("constants", {error.place.line, error.place.column}, error.what_is_wrong, error.expected);
  } catch (const std::invalid_argument& error) {
    const std::string said = error.what();
    const std::size_t end = std::min(said.find("; expected"), said.size());
    throw io::InputError(text->name, {1, 1}, said.substr(0, end),
                         end == said.size() ? "expected a text without errors" : said.substr(end + 2));
  }
}

}  // namespace

AskedMachine machine_of(const AskedCall& asked) {
  const AskedSetup setup = setup_of(asked);
  return {made_machine(asked, setup.setup), setup.choices};
}

void refuse_question(const std::string& wrong, const std::string& expected) {
  throw io::InputError("step", {1, 1}, wrong, expected);
}

void go_way(const AskedCall& asked, spec::Animation& way) {
  if (!asked.has("way")) return;
  try {
    asking([&] {
      way.replay(asked.text("way", ""));
      return 0;
    });
  } catch (const zed::ZError& error) {
    throw io::InputError("way", {error.place.line, error.place.column}, error.what_is_wrong, error.expected);
  }
}

}  // namespace durero::web
