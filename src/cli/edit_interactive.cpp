#include "edit_interactive.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <exception>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "colour.hpp"
#include "durero/io/file_lock.hpp"
#include "durero/io/file_name.hpp"
#include "durero/io/json/json.hpp"
#include "durero/io/json/why_not.hpp"
#include "durero/io/output_file.hpp"
#include "durero/io/pictures/picture_file.hpp"
#include "durero/io/standard_output.hpp"
#include "durero/text/shown.hpp"
#include "durero/text/spanish.hpp"
#include "edit_completion.hpp"
#include "edit_session.hpp"
#include "line_reader.hpp"
#include "terminal_view.hpp"

namespace durero::cli {
namespace {

constexpr const char* prompt = "durero> ";

std::string done(std::string_view what) { return in_green("done", STDOUT_FILENO) + ": " + std::string(what) + "\n"; }
std::string refused(std::string_view what) {
  return in_red("refused", STDOUT_FILENO) + ": " + std::string(what) + "\n";
}

std::string answer_line(const io::EditAnswer& answer) {
  if (!answer.ok())
    return refused(fmt::format("{}: {} {}", text::with_english(answer.r), answer.violated, answer.predicate));
  const std::string left = answer.left_group.empty() ? "" : fmt::format(", which left the group {}", answer.left_group);
  return done(text::with_english(answer.r) + left);
}

std::string value_text(const io::PredicateValue& value) {
  struct Text {
    std::string operator()(std::monostate) const { return "undefined"; }
    std::string operator()(const std::string& word) const { return word; }
    std::string operator()(double number) const { return fmt::format("{}", number); }
    std::string operator()(std::uint64_t number) const { return fmt::format("{}", number); }
    std::string operator()(const glm::dvec3& v) const { return fmt::format("({}, {}, {})", v.x, v.y, v.z); }
    std::string operator()(const std::array<glm::dvec3, 3>& v) const {
      return fmt::format("({}, {}, {})", (*this)(v[0]), (*this)(v[1]), (*this)(v[2]));
    }
    std::string operator()(const std::vector<std::string>& names) const {
      std::string text;
      for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
      return "{" + text + "}";
    }
  };
  return std::visit(Text(), value);
}

std::string why_not_lines(const io::WhyNot& told) {
  if (told.answer.ok()) return "every clause holds: " + text::with_english(told.answer.r) + "\n";
  std::string lines = refused(text::with_english(told.answer.r));
  for (const io::BrokenClause& clause : told.broken) {
    lines += fmt::format("  {}  {}\n", clause.label, clause.predicate);
    for (const auto& [word, value] : clause.values) lines += fmt::format("    {} = {}\n", word, value_text(value));
  }
  return told.is_whole ? lines : lines + "  perhaps others: the text tells the first alone\n";
}

/// The first word of a line and the rest, without blanks around.
std::pair<std::string, std::string> first_word(const std::string& line) {
  constexpr const char* blanks = " \t";
  const std::size_t begin = line.find_first_not_of(blanks);
  if (begin == line.npos) return {};
  const std::size_t end = std::min(line.find_first_of(blanks, begin), line.size());
  const std::size_t rest = line.find_first_not_of(blanks, end);
  const std::size_t last = line.find_last_not_of(blanks);
  return {line.substr(begin, end - begin), rest == line.npos ? "" : line.substr(rest, last + 1 - rest)};
}

class Session {
 public:
  explicit Session(SessionCall call)
      : source_(std::move(call.source)),
        with_(std::move(call.with)),
        out_(call.out.empty() ? source_.name() : std::move(call.out)),
        file_text_(source_.text()),
        find_(std::move(call.find)),
        edits_(std::move(call.scene), std::move(call.editor)),
        lines_(prompt, [this](std::string_view line) { return completion_of(line, edits_.scene()); }) {}

  int run() {
    while (!is_over_) {
      const auto line = lines_.next();
      if (!line) {
        if (lines_.is_terminal()) io::print("\n");
        quit(was_warned_ || !lines_.is_terminal());
        continue;
      }
      ++number_;
      try {
        answer(*line);
      } catch (const io::InputError& error) {
        io::print(error_line(error.what()));
      } catch (const io::FileError& error) {
        io::print(error_line(error.what()));
      } catch (const std::domain_error& error) {
        io::print(error_line(error.what()));
      } catch (const std::invalid_argument& error) {
        io::print(error_line(error.what()));
      }
    }
    return edits_.is_saved() ? 0 : 1;
  }

 private:
  static std::string error_line(std::string_view what) {
    return in_red("error", STDOUT_FILENO) + ": " + text::escaped(what) + "\n";
  }

  void answer(const std::string& line) {
    const auto [word, rest] = first_word(line);
    const bool asks_again = std::exchange(was_warned_, false);
    if (word == "help") return help();
    if (word == "list") return list();
    if (word == "show") return show(rest);
    if (word == "view") return view();
    if (word == "why-not") return why_not(line);
    if (word == "undo") return io::print(told_of("taken back", edits_.undo()));
    if (word == "redo") return io::print(told_of("done again", edits_.redo()));
    if (word == "write") return write(rest.empty() ? out_ : rest);
    if (word == "quit") return quit(asks_again);
    carry_out(line);
  }

  /// Of what was typed as a line of its own, so that places in messages are those of the line.
  std::vector<io::ScriptStep> steps_of(std::string text) const {
    const io::Source typed("line", std::move(text), number_ - 1);
    return io::read_script(typed, edits_.scene().of().scene.stage(), edits_.scene().types());
  }

  void carry_out(const std::string& line) {
    for (const io::ScriptStep& step : steps_of(line)) io::print(answer_line(edits_.carry_out(step, line)));
  }

  void why_not(std::string line) {
    const std::size_t at = line.find("why-not");
    std::fill_n(line.begin() + static_cast<std::ptrdiff_t>(at), std::string_view("why-not").size(), ' ');
    for (const io::ScriptStep& step : steps_of(line)) io::print(why_not_lines(find_(edits_.scene(), step)));
  }

  static std::string told_of(std::string_view what, const std::optional<std::string>& operation) {
    return operation ? fmt::format("{}: {}\n", what, *operation) : "there is none\n";
  }

  void help() {
    std::string text = "An operation, such as Eliminar_Elemento e?=moon; or\n";
    for (const auto& [name, value, does] : session_commands())
      text += fmt::format("  {:<20} {}\n", fmt::format("{} {}", name, value), does);
    io::print(text);
  }

  void list() {
    std::vector<std::string> lines;
    const scene::Scene& scene = edits_.scene().of().scene;
    scene.for_each([&](scene::ElementRef element, const auto&) { lines.push_back(scene.name(element).name() + "\n"); });
    std::ranges::sort(lines);
    std::string text;
    for (const std::string& line : lines) text += line;
    io::print(text + fmt::format("{} elementos\n", lines.size()));
  }

  /// The line of the element in the text of the scene; of a face, that it is one.
  void show(const std::string& name) {
    const auto element = edits_.scene().of().scene.find(name);
    if (!element) return io::print(error_line(fmt::format("{} is no element", text::shown(name))));
    const std::string text = edits_.scene().scene_text();
    const std::size_t begin = text.find(fmt::format("\n{{\"id\":\"{}\"", name));
    if (begin == text.npos) return io::print(fmt::format("{} is a face of a mesh\n", name));
    std::string line = text.substr(begin + 1, text.find('\n', begin + 1) - begin - 1);
    if (line.ends_with(',')) line.pop_back();
    const std::string_view group = edits_.scene().of().groups.of_element(name);
    io::print(line + (group.empty() ? "\n" : fmt::format("  in the group {}\n", group)));
  }

  /// Shows the scene as it stands, until the person ends the view.
  void view() {
    ViewOptions options{.scene = source_.name(), .with = with_};
    options.text.emplace(source_.name(), edits_.scene().scene_text());
    options.text->set_root(source_.root());
    show_in_terminal(options);
  }

  /// Writes the scene. Its own file is not replaced where another program has written it since.
  void write(const std::string& file) {
    io::require_ending(file, io::json_endings, "a scene");
    std::optional<io::FileLock> lock;
    const bool is_own = io::is_same_file(source_.name(), file);
    if (is_own) lock.emplace(file);
    if (is_own && io::read_source(source_.name()).text() != file_text_)
      throw io::FileError(file, "another program has written it since it was read", "expected another FILE");
    const std::unique_ptr<io::EditedScene> written = edits_.scene().copy();
    io::rename_pictures(written->stage(), source_.name(), file);
    std::string text = written->scene_text();
    io::write_file(file, text);
    if (is_own) file_text_ = std::move(text);
    edits_.note_saved();
    io::print(done("written to " + text::escaped(file)));
  }

  /// Ends the session; where something is not written, only where it is known.
  void quit(bool is_known) {
    is_over_ = edits_.is_saved() || is_known;
    if (edits_.is_saved()) return;
    was_warned_ = true;
    io::print(is_over_ ? "what was not written is lost\n"
                       : "not all is written: write it, or quit again and lose it\n");
  }

  io::Source source_;
  std::string with_, out_, file_text_;
  ClauseFinder find_;
  EditSession edits_;
  LineReader lines_;
  std::size_t number_ = 0;
  bool is_over_ = false, was_warned_ = false;
};

}  // namespace

int edit_interactively(SessionCall call) { return Session(std::move(call)).run(); }

}  // namespace durero::cli
