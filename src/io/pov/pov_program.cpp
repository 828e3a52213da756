#include "pov_program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "durero/io/number_text.hpp"
#include "durero/text/shown.hpp"
#include "pov_stage.hpp"

namespace durero::io {
namespace {

/// Bounds on a program, which no scene that a person wrote comes near: tokens that are read, tokens that are kept, and
/// what is within each other.
constexpr std::size_t most_steps = 200'000'000, most_kept = 16'000'000, most_frames = 10'000, most_calls = 300;

/// image_width and image_height where no size is told: as wide by its height as POV-Ray's own picture, and its camera.
constexpr scene::Resolution usual_size{640, 480};

}  // namespace

bool PovValue::is_itself(std::string_view name) const {
  const auto* const things = std::get_if<std::shared_ptr<const PovTokens>>(&of);
  return things != nullptr && (*things)->size() == 1 && (*things)->front().text == name;
}

PovProgram::PovProgram(const Source& source) : main_(source), size_(pov_size(source).value_or(usual_size)) {
  scopes_.emplace_back();
  frames_.emplace_back(source, false);
  run();
}

void PovProgram::run() {
  while (here() != nullptr) emit();
}

// Reading.

const PovToken* PovProgram::here() {
  while (frames_.size() > floor_) {
    Frame& frame = frames_.back();
    if (frame.next == frame.end) {
      leave_frame();
      continue;
    }
    const PovToken& token = (*frame.tokens)[frame.next];
    if (frame.next == settled_) return &token;
    if (token.is_directive()) {
      if (statement_ == frames_.size() && open_ == 0) return nullptr;
      const PovToken directive = token;
      ++frame.next;
      direct(directive);
    } else if (!token.is_name() || !replace(token)) {
      settled_ = frame.next;
      return &token;
    }
  }
  return nullptr;
}

void PovProgram::count_step(const PovToken& at) {
  if (++steps_ > most_steps) at.fail("a program of more than 200,000,000 steps", "expected one that ends before");
}

void PovProgram::pass() {
  const std::string_view text = here()->text;
  count_step(*here());
  if (text == "(" || text == "[" || text == "{") ++open_;
  if ((text == ")" || text == "]" || text == "}") && open_ > 0) --open_;
  ++frames_.back().next;
  settled_ = unsettled;
}

/// Puts what a name of a macro or of tokens stands for in its place. False where it stands for none.
bool PovProgram::replace(const PovToken& token) {
  if (const auto macro = macros_.find(token.text); macro != macros_.end() && raw(1) != nullptr && raw(1)->text == "(") {
    const PovToken at = token;
    ++frames_.back().next;
    invoke(*std::shared_ptr(macro->second), at);  // what it is given may define another by its name
    return true;
  }
  const auto value = find(token.text);
  if (value && std::holds_alternative<PovArray>(value->of) && raw(1) != nullptr && raw(1)->text == "[") {
    const PovToken at = token;
    ++frames_.back().next;
    put(*element_of(value), at);
    return true;
  }
  if (!value || !std::holds_alternative<std::shared_ptr<const PovTokens>>(value->of) || value->is_itself(token.text))
    return false;
  const PovToken at = token;
  ++frames_.back().next;
  put(*value, at);
  return true;
}

/// Puts the tokens of a value in the place of what had it.
void PovProgram::put(const PovValue& value, const PovToken& at) {
  if (const auto* const things = std::get_if<std::shared_ptr<const PovTokens>>(&value.of)) {
    // `texture { T }`, of a T that is `texture { … }`: what is in it.
    const PovTokens& all = **things;
    const bool is_within = sink_->size() >= 2 && sink_->back().text == "{" && all.size() >= 3 && all[1].text == "{" &&
                           (*sink_)[sink_->size() - 2].text == all.front().text && all.back().text == "}";
    const std::size_t around = is_within ? 1 : 0;
    return push(Frame(*things, 2 * around, all.size() - around), at);
  }
  PovTokens tokens = kept_by([&] {
    if (const auto* const numbers = std::get_if<PovNumbers>(&value.of)) emit(*numbers, at);
    if (const auto* const said = std::get_if<std::string>(&value.of)) keep(made('"' + *said + '"', at));
  });
  if (tokens.empty()) at.fail(fmt::format("an element of {} has no value here", text::shown(at.text)), "expected one");
  push(Frame(std::make_shared<const PovTokens>(std::move(tokens))), at);
}

void PovProgram::push(Frame frame, const PovToken& at) {
  if (frames_.size() >= most_frames)
    at.fail("macros, files and names within each other, deeper than 10,000", "expected 10,000 at most");
  count_step(at);
  if (frame.has_scope) scopes_.emplace_back();
  settled_ = unsettled;
  frames_.push_back(std::move(frame));
}

void PovProgram::leave_frame() {
  const Frame& frame = frames_.back();
  if (!frame.blocks.empty()) fail_here("expected #end for each #if, #while, #for and #switch");
  if (frame.has_scope) scopes_.pop_back();
  settled_ = unsettled;
  frames_.pop_back();
}

const PovToken* PovProgram::raw(std::size_t ahead) const {
  if (frames_.empty()) return nullptr;
  const Frame& frame = frames_.back();
  return frame.next + ahead < frame.end ? &(*frame.tokens)[frame.next + ahead] : nullptr;
}

PovToken PovProgram::take_raw(const std::string& expected) {
  const PovToken* const token = raw();
  if (token == nullptr) fail_here(expected);
  const PovToken taken = *token;
  ++frames_.back().next;
  return taken;
}

bool PovProgram::take_raw_if(std::string_view text) {
  if (raw() == nullptr || raw()->text != text) return false;
  ++frames_.back().next;
  return true;
}

/// The names of parameters, from behind a ( to behind its ).
std::vector<std::string_view> PovProgram::parameters() {
  std::vector<std::string_view> all;
  while (!take_raw_if(")")) {
    all.push_back(name("expected the name of a parameter"));
    take_raw_if(",");
  }
  return all;
}

void PovProgram::expect_raw(std::string_view text, std::string_view where) {
  if (!take_raw_if(text)) fail_here(fmt::format("expected {} {}", text, where));
}

std::string_view PovProgram::name(const std::string& expected) {
  if (raw() == nullptr || !raw()->is_name()) fail_here(expected);
  return take_raw(expected).text;
}

void PovProgram::refuse(const std::string& expected) const {
  const PovToken* const token = raw();
  if (token != nullptr) token->fail(fmt::format("{} stands here", text::shown(token->text)), expected);
  main_.fail(main_.text().size(), "the text ends", expected);
}

// Keeping.

void PovProgram::keep(const PovToken& token) {
  if (++kept_ > most_kept) token.fail("a program that leaves more than 16,000,000 words", "expected a smaller scene");
  sink_->push_back(token);
}

PovToken PovProgram::made(std::string text, const PovToken& at) {
  return {made_.emplace_back(std::move(text)), at.source, at.offset};
}

/// Keeps what stands here, with the values of its names.
void PovProgram::emit() {
  const PovToken token = *here();
  if (token.is_name()) {
    if (token.text == "function" && raw(1) != nullptr && raw(1)->text == "{") return emit_block_as_it_stands();
    if (const auto said = take_text()) return keep(made('"' + *said + '"', token));
    if (const auto numbers = named()) return emit(*numbers, token);
  }
  keep(token);
  pass();
}

/// A number below 0 stands in parentheses, so that it is no difference.
void PovProgram::emit(const PovNumbers& numbers, const PovToken& at) {
  const auto sign = [&](std::string_view text) { keep({text, at.source, at.offset}); };
  const auto number = [&](double x) {
    if (x < 0) sign("-");
    keep(made(number_text(std::abs(x)), at));
  };
  if (numbers.count == 1) {
    if (numbers.of[0] < 0) sign("(");
    number(numbers.of[0]);
    if (numbers.of[0] < 0) sign(")");
    return;
  }
  if (numbers.count == 5) sign("rgbft");
  sign("<");
  for (std::size_t i = 0; i < numbers.count; ++i) {
    if (i > 0) sign(",");
    number(numbers.of[i]);
  }
  sign(">");
}

void PovProgram::emit_block_as_it_stands() {
  std::size_t open = 0;
  do {
    const PovToken token = take_raw("expected } for each {");
    const auto known = token.is_name() ? find(token.text) : nullptr;
    const auto* const numbers = known ? std::get_if<PovNumbers>(&known->of) : nullptr;
    if (numbers != nullptr && numbers->count == 1)
      emit(*numbers, token);
    else
      keep(token);
    if (token.text == "{") ++open;
    if (token.text == "}") --open;
  } while (open > 0 || sink_->back().text == "function");
}

// Macros and functions.

void PovProgram::invoke(const Macro& macro, const PovToken& at) {
  const std::size_t statement = std::exchange(statement_, 0);
  expect("(", "behind the name of a macro");
  std::vector<std::shared_ptr<PovValue>> arguments;
  // A name that stands first or behind a comma is not replaced yet.
  if (!take_raw_if(")")) {
    do arguments.push_back(argument());
    while (take(","));
    expect(")", "behind what a macro is given");
  }
  if (arguments.size() != macro.parameters.size())
    at.fail(fmt::format("{} is given {} values", at.text, arguments.size()),
            fmt::format("expected {}", macro.parameters.size()));
  push(Frame(macro.tokens, macro.begin, macro.end, true), at);
  for (std::size_t i = 0; i < arguments.size(); ++i) scopes_.back()[macro.parameters[i]] = arguments[i];
  statement_ = statement;
}

/// A name alone is the same in the macro; so a macro may give it a value.
std::shared_ptr<PovValue> PovProgram::argument() {
  const PovToken* const token = raw();
  const PovToken* const behind = raw(1);
  const bool is_alone =
      token != nullptr && token->is_name() && behind != nullptr && (behind->text == "," || behind->text == ")");
  if (!is_alone || begins_pov_expression(*token)) return std::make_shared<PovValue>(value());
  const std::string_view given = take_raw("expected a value").text;
  if (auto known = find(given)) return known;
  auto& place = place_of(given, false);
  place->of = std::make_shared<const PovTokens>(PovTokens{*token});
  return place;
}

double PovProgram::call(const PovFunction& function, const PovToken& at) {
  const std::vector<PovNumbers> given = numbers_in_parentheses("of what a function is asked of");
  if (given.size() != function.parameters.size())
    at.fail(fmt::format("{} of {} values", at.text, given.size()),
            fmt::format("expected {}", function.parameters.size()));
  if (++calls_ > most_calls) at.fail("functions within each other, deeper than 300", "expected 300 at most");
  const std::size_t statement = std::exchange(statement_, 0), floor = std::exchange(floor_, frames_.size());
  push(Frame(function.body, 0, function.body->size(), true), at);
  for (std::size_t i = 0; i < given.size(); ++i)
    scopes_.back()[function.parameters[i]] = std::make_shared<PovValue>(PovValue{given[i]});
  const double result = pov_condition(*this).of[0];
  if (here() != nullptr) fail_here("expected the end of a function behind its value");
  statement_ = statement, floor_ = floor;
  --calls_;
  return result;
}

}  // namespace durero::io
