// The directives of a POV-Ray program.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <utility>

#include "durero/text/shown.hpp"
#include "io/scene_folder.hpp"
#include "pov_program.hpp"

namespace durero::io {
namespace {

/// Bounds on files that are included, and on directives within each other.
constexpr std::size_t most_files = 2000, most_nested = 200;

/// The folders in which POV-Ray keeps the files that its texts include.
constexpr std::array<std::string_view, 3> include_folders{
    "/usr/share/povray-3.7/include", "/usr/local/share/povray-3.7/include", "/opt/homebrew/share/povray-3.7/include"};

/// The name of a directive, which may stand apart from its sign.
std::string_view word_of(const PovToken& directive) {
  const std::string_view name = directive.text.substr(1);
  return name.substr(std::min(name.find_first_not_of(" \t"), name.size()));
}

bool opens_block(std::string_view directive) {
  static constexpr std::string_view openers[] = {"if", "ifdef", "ifndef", "while", "for", "switch", "macro"};
  return std::ranges::find(openers, directive) != std::end(openers);
}

}  // namespace

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
  if (auto path = SceneFolder(main_).find(main_, name)) return path;
  for (const std::string_view folder : include_folders)
    if (auto path = file_below(folder, name)) return path;
  return std::nullopt;
}

void PovProgram::include(const PovToken& at) {
  const std::string file = text("behind #include");
  const auto known = found_file(file);
  if (!known)
    at.fail(fmt::format("no file {}", text::shown(file)),
            SceneFolder(main_).expected() + ", or one of POV-Ray's own where it is installed");
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
  if (raw() != nullptr && raw()->is_directive()) here();
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
  return value && !std::holds_alternative<std::monostate>(value->of) && !value->is_itself(asked);
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
    if (!token.is_directive()) continue;
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

}  // namespace durero::io
