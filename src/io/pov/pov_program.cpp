#include "pov_program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <functional>
#include <utility>

#include "durero/io/number_text.hpp"
#include "durero/text/shown.hpp"
#include "io/stays_within.hpp"
#include "pov_stage.hpp"

namespace durero::io {
namespace {

/// Bounds on a program, which no scene that a person wrote comes near: tokens that are read, tokens that are kept, and
/// what is within each other.
constexpr std::size_t most_steps = 200'000'000, most_kept = 16'000'000, most_frames = 10'000, most_files = 2000,
                      most_calls = 300, most_nested = 200;

/// image_width and image_height where no size is told: as wide by its height as POV-Ray's own picture, and its camera.
constexpr scene::Resolution usual_size{640, 480};

/// The number of no token.
constexpr std::size_t unsettled = ~std::size_t{0};

/// The folders in which POV-Ray keeps the files that its texts include.
constexpr std::array<std::string_view, 3> include_folders{
    "/usr/share/povray-3.7/include", "/usr/local/share/povray-3.7/include", "/opt/homebrew/share/povray-3.7/include"};

/// Whether a value is nothing but the name that has it, as that of a name without a value which a macro is given.
bool is_itself(const PovValue& value, std::string_view name) {
  const auto* const things = std::get_if<std::shared_ptr<const PovTokens>>(&value.of);
  return things != nullptr && (*things)->size() == 1 && (*things)->front().text == name;
}

bool is_directive(const PovToken& token) { return token.text.starts_with('#'); }
/// The name of a directive, which may stand apart from its sign.
std::string_view word_of(const PovToken& directive) {
  const std::string_view name = directive.text.substr(1);
  return name.substr(std::min(name.find_first_not_of(" \t"), name.size()));
}

bool opens_block(std::string_view directive) {
  static constexpr std::string_view openers[] = {"if", "ifdef", "ifndef", "while", "for", "switch", "macro"};
  return std::ranges::find(openers, directive) != std::end(openers);
}

/// The file of that name below a folder; nothing where there is none. A name that leads out of the folder is none.
std::optional<std::string> file_below(const std::filesystem::path& folder, const std::string& name) {
  if (!stays_within(name)) return std::nullopt;
  std::error_code error;
  const std::filesystem::path path = folder / name;
  return std::filesystem::is_regular_file(path, error) ? std::optional(path.string()) : std::nullopt;
}

}  // namespace

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
    if (is_directive(token)) {
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
  if (!value || !std::holds_alternative<std::shared_ptr<const PovTokens>>(value->of) || is_itself(*value, token.text))
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
    keep(token);
    if (token.text == "{") ++open;
    if (token.text == "}") --open;
  } while (open > 0 || sink_->back().text == "function");
}

// Directives.

/// A directive by its name.
struct PovProgram::Directive {
  std::string_view word;
  void (PovProgram::*carry_out)(const PovToken& directive);
};

void PovProgram::direct(const PovToken& directive) {
  static constexpr Directive all[] = {{"include", &PovProgram::include},
                                      {"declare", &PovProgram::declare},
                                      {"local", &PovProgram::declare},
                                      {"undef", &PovProgram::undefine},
                                      {"if", &PovProgram::start_condition},
                                      {"ifdef", &PovProgram::start_condition},
                                      {"ifndef", &PovProgram::start_condition},
                                      {"while", &PovProgram::start_loop},
                                      {"for", &PovProgram::start_count},
                                      {"switch", &PovProgram::start_choice},
                                      {"else", &PovProgram::end_branch},
                                      {"elseif", &PovProgram::end_branch},
                                      {"case", &PovProgram::end_branch},
                                      {"range", &PovProgram::end_branch},
                                      {"end", &PovProgram::end_block},
                                      {"break", &PovProgram::break_out},
                                      {"macro", &PovProgram::define_macro},
                                      {"version", &PovProgram::set_version},
                                      {"default", &PovProgram::set_default},
                                      {"debug", &PovProgram::say},
                                      {"warning", &PovProgram::say},
                                      {"error", &PovProgram::say},
                                      {"render", &PovProgram::say},
                                      {"statistics", &PovProgram::say},
                                      {"fopen", &PovProgram::use_file},
                                      {"fclose", &PovProgram::use_file},
                                      {"write", &PovProgram::use_file},
                                      {"read", &PovProgram::use_file}};
  const auto* const found = std::ranges::find(all, word_of(directive), &Directive::word);
  if (found == std::end(all))
    directive.fail(fmt::format("#{} is not carried out", word_of(directive)), "expected another directive");
  if (++nested_ > most_nested) directive.fail("directives within each other, deeper than 200", "expected 200 at most");
  const std::size_t statement = std::exchange(statement_, 0), open = std::exchange(open_, 0);
  settled_ = unsettled;
  (this->*found->carry_out)(directive);
  statement_ = statement, open_ = open, settled_ = unsettled;
  --nested_;
}

void PovProgram::undefine(const PovToken&) {
  const std::string_view gone = name("expected a name behind #undef");
  for (Scope& scope : scopes_) scope.erase(gone);
  macros_.erase(gone);
}

/// The default look goes on to the reader of what is left.
void PovProgram::set_default(const PovToken& directive) { keep({"#default", directive.source, directive.offset}); }

/// The file of that name below the folder of the text, or among POV-Ray's own; nothing where there is none.
std::optional<std::string> PovProgram::found_file(const std::string& name) const {
  const std::filesystem::path own = std::filesystem::path(main_.name()).parent_path();
  if (auto path = file_below(own.empty() ? "." : own, name)) return path;
  for (const std::string_view folder : include_folders)
    if (auto path = file_below(folder, name)) return path;
  return std::nullopt;
}

void PovProgram::include(const PovToken& at) {
  const std::string file = text("behind #include");
  const auto known = found_file(file);
  if (!known)
    at.fail(fmt::format("no file {}", text::shown(file)),
            "expected one below the folder of the text, or one of POV-Ray's own where it is installed");
  if (files_.size() >= most_files) at.fail("more than 2000 files are included", "expected 2000 at most");
  const Source& source = files_.emplace_back(read_source(*known));
  push(Frame(source, true), at);
}

void PovProgram::declare(const PovToken& directive) {
  const PovToken at = frames_.back().next < frames_.back().end ? *raw() : PovToken{"", &main_, main_.text().size()};
  if (take_raw_if("deprecated")) {
    take_raw_if("once");
    if (raw() != nullptr && raw()->text.starts_with('"')) take_raw("expected a text");
  }
  const std::string_view declared = name("expected a name behind #declare");
  const std::size_t own = frames_.size();
  if (raw() != nullptr && raw()->text == "[") {
    const auto array = find(declared);
    if (!array) at.fail(fmt::format("{} is no array", declared), "expected one that is declared");
    const auto element = element_of(array);
    expect("=", "behind the name of a declaration");
    pass_directives();
    statement_ = own;
    *element = value();
  } else {
    expect("=", "behind the name of a declaration");
    pass_directives();
    statement_ = own;
    PovValue given = value();
    *place_of(declared, word_of(directive) == "local") = std::move(given);
  }
  take(";");
}

/// Carries out the directives before a value, which behind it end it.
void PovProgram::pass_directives() {
  if (raw() != nullptr && is_directive(*raw())) here();
}

std::shared_ptr<PovValue>& PovProgram::place_of(std::string_view declared, bool is_local) {
  if (!is_local)
    for (std::size_t i = scopes_.size(); i-- > 0;)
      if (const auto found = scopes_[i].find(declared); found != scopes_[i].end()) return found->second;
  std::shared_ptr<PovValue>& place = (is_local ? scopes_.back() : scopes_.front())[declared];
  if (!place) place = std::make_shared<PovValue>();
  return place;
}

std::shared_ptr<PovValue> PovProgram::find(std::string_view wanted) const {
  for (std::size_t i = scopes_.size(); i-- > 0;)
    if (const auto found = scopes_[i].find(wanted); found != scopes_[i].end()) return found->second;
  return nullptr;
}

double PovProgram::in_parentheses(std::string_view where) {
  expect("(", where);
  const double value = raw() != nullptr && begins_text() ? compared_texts() : pov_condition(*this).of[0];
  expect(")", where);
  return value;
}

/// Whether a text stands here, by itself or by its name.
bool PovProgram::begins_text() {
  const PovToken* const token = here();
  if (token == nullptr || token->text.starts_with('"')) return token != nullptr;
  const auto known = token->is_name() ? find(token->text) : nullptr;
  return known && std::holds_alternative<std::string>(known->of);
}

/// 1 where two texts are in the order of the sign between them, else 0.
double PovProgram::compared_texts() {
  const std::string first = text("before a comparison");
  const PovToken sign = take_raw("expected a comparison behind a text");
  const int order = first.compare(text("behind a comparison"));
  if (sign.text == "=") return order == 0;
  if (sign.text == "!=") return order != 0;
  if (sign.text == "<") return order < 0;
  if (sign.text == "<=") return order <= 0;
  if (sign.text == ">") return order > 0;
  if (sign.text == ">=") return order >= 0;
  sign.fail(fmt::format("{} behind a text", text::shown(sign.text)), "expected a comparison");
}

bool PovProgram::is_defined() {
  expect_raw("(", "before a name");
  const std::string_view asked = name("expected a name in parentheses");
  auto value = find(asked);
  if (value && raw() != nullptr && raw()->text == "[") value = element_of(value);
  while (raw() != nullptr && raw()->text != ")") take_raw("expected )");
  expect_raw(")", "behind a name");
  if (macros_.contains(asked)) return true;
  return value && !std::holds_alternative<std::monostate>(value->of) && !is_itself(*value, asked);
}

void PovProgram::start_condition(const PovToken& directive) {
  const std::string_view word = word_of(directive);
  bool holds = word == "if" ? std::abs(in_parentheses("behind #if")) > same_within : is_defined() == (word == "ifdef");
  while (!holds) {
    const std::string_view branch = skip();
    if (branch == "end") return;
    if (branch == "else") break;
    if (branch == "elseif") holds = std::abs(in_parentheses("behind #elseif")) > same_within;
  }
  frames_.back().blocks.push_back({Block::Kind::condition});
}

/// Passes what stands up to the next branch or end of the block that it stands in, and that directive; its name.
std::string_view PovProgram::skip() {
  for (std::size_t open = 0;;) {
    const PovToken token = take_raw("expected #end for each #if, #while, #for, #switch and #macro");
    if (!is_directive(token)) continue;
    const std::string_view word = word_of(token);
    if (opens_block(word)) ++open;
    if (word == "end" && open-- == 0) return word;
    if (open == 0 && (word == "else" || word == "elseif" || word == "case" || word == "range")) return word;
  }
}
void PovProgram::skip_to_end() {
  while (skip() != "end") continue;
}

void PovProgram::start_loop(const PovToken&) {
  const std::size_t again = frames_.back().next - 1;  // the directive itself
  if (std::abs(in_parentheses("behind #while")) <= same_within) return skip_to_end();
  frames_.back().blocks.push_back({Block::Kind::loop, again});
}

/// Whether a counter has not passed the last number.
bool PovProgram::Block::goes_on(double count) const {
  return step > 0 ? count < last + same_within : count > last - same_within;
}

void PovProgram::start_count(const PovToken&) {
  expect_raw("(", "behind #for");
  const std::string_view counter = name("expected the name of a counter in #for");
  expect(",", "behind the counter of #for");
  const double first = pov_sum(*this).of[0];
  expect(",", "in #for");
  Block block{Block::Kind::count};
  block.last = pov_sum(*this).of[0];
  if (take(",")) block.step = pov_sum(*this).of[0];
  if (std::abs(block.step) < same_within) fail_here("expected a step other than 0 in #for");
  expect(")", "behind #for");
  block.counter = place_of(counter, true);
  block.counter->of = PovNumbers(first);
  if (!block.goes_on(first)) return skip_to_end();
  block.again = frames_.back().next;
  frames_.back().blocks.push_back(std::move(block));
}

void PovProgram::start_choice(const PovToken&) {
  const double chosen = in_parentheses("behind #switch");
  while (true) {
    const std::string_view branch = skip();
    if (branch == "end") return;
    if (branch == "else") break;
    if (branch == "case" && std::abs(in_parentheses("behind #case") - chosen) < same_within) break;
    if (branch == "range") {
      const auto ends = numbers_in_parentheses("behind #range");
      if (ends.size() != 2) fail_here("expected two numbers in #range");
      if (chosen >= ends[0].of[0] && chosen <= ends[1].of[0]) break;
    }
  }
  frames_.back().blocks.push_back({Block::Kind::choice});
}

/// A branch that was carried out ends at the next one; but one of a #switch goes on into it.
void PovProgram::end_branch(const PovToken& directive) {
  const std::string_view word = word_of(directive);
  auto& blocks = frames_.back().blocks;
  if (blocks.empty()) directive.fail(fmt::format("#{} without #if", word), "expected one before it");
  if (blocks.back().kind != Block::Kind::choice) {
    skip_to_end();
    blocks.pop_back();
  } else if (word == "case" || word == "range") {
    numbers_in_parentheses(fmt::format("behind #{}", word));
  }
}

void PovProgram::end_block(const PovToken& at) {
  Frame& frame = frames_.back();
  if (frame.blocks.empty()) at.fail("#end without a beginning", "expected #if, #while, #for or #switch before it");
  Block block = std::move(frame.blocks.back());
  frame.blocks.pop_back();
  count_step(at);
  if (block.kind == Block::Kind::loop) frame.next = block.again;
  if (block.kind != Block::Kind::count) return;
  auto* const counter = std::get_if<PovNumbers>(&block.counter->of);
  if (counter == nullptr) at.fail("the counter of #for is no number any more", "expected a number");
  counter->of[0] += block.step;
  if (!block.goes_on(counter->of[0])) return;
  frame.next = block.again;
  frame.blocks.push_back(std::move(block));
}

void PovProgram::break_out(const PovToken& at) {
  auto& blocks = frames_.back().blocks;
  while (!blocks.empty()) {
    const bool is_condition = blocks.back().kind == Block::Kind::condition;
    skip_to_end();
    blocks.pop_back();
    if (!is_condition) return;
  }
  at.fail("#break outside of a loop or a #switch", "expected one around it");
}

void PovProgram::define_macro(const PovToken&) {
  const std::string_view defined = name("expected a name behind #macro");
  expect_raw("(", "behind the name of a macro");
  std::vector<std::string_view> given = parameters();
  const std::size_t begin = frames_.back().next;
  skip_to_end();
  const Frame& here = frames_.back();
  macros_[defined] = std::make_shared<const Macro>(Macro{std::move(given), here.tokens, begin, here.next - 1});
}

/// The version of the text itself goes on to the reader of what is left; that of a file that it includes is that
/// file's.
void PovProgram::set_version(const PovToken& at) {
  const auto is_file = [](const Frame& frame) { return frame.is_file; };
  const bool is_own = std::ranges::count_if(frames_, is_file) == 1;
  take("unofficial");
  statement_ = frames_.size();
  version_ = pov_sum(*this).of[0];
  take(";");
  if (!is_own) return;
  keep({"#version", at.source, at.offset});
  emit(version_, at);
  keep({";", at.source, at.offset});
}

/// A text may end itself; other messages are of no concern here.
void PovProgram::say(const PovToken& directive) {
  const std::string_view word = word_of(directive);
  statement_ = frames_.size();
  const std::string said = text(fmt::format("behind #{}", word));
  take(";");
  if (word == "error") directive.fail(fmt::format("the text ends itself: {}", text::shown(said)), "expected no #error");
}

/// No file is written, and none that a text reads numbers from is read.
void PovProgram::use_file(const PovToken& at) {
  const std::string_view word = word_of(at);
  if (word == "read")
    at.fail("#read is not carried out", "expected numbers in the text, or in a file that it includes");
  if (word == "write") {
    expect_raw("(", "behind #write");
    for (std::size_t open = 1; open > 0;) {
      const PovToken token = take_raw("expected ) behind #write");
      if (token.text == "(") ++open;
      if (token.text == ")") --open;
    }
    return;
  }
  name("expected the name of a file");
  if (word == "fclose") return;
  text("behind the name of a file");
  if (take_raw_if("read")) at.fail("#fopen … read is not carried out", "expected no file but those that are included");
  if (!take_raw_if("write") && !take_raw_if("append")) fail_here("expected read, write or append");
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
