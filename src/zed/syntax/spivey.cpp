#include "zed/syntax/spivey.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>
#include <vector>

#include "durero/zed/syntax/defect.hpp"
#include "zed/syntax/characters.hpp"
#include "zed/syntax/symbols.hpp"

namespace durero::zed {
namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 17> commands = {{
    {"defs", "=="},
    {"empty", "∅"},
    {"spot", "•"},
    {"bsup", "↗"},
    {"esup", "↙"},
    {"bag", "bag"},
    {"lbag", "⟦"},
    {"rbag", "⟧"},
    {"uplus", "⊎"},
    {"uminus", "⩁"},
    {"otimes", "⊗"},
    {"bcount", "♯"},
    {"inbag", "⋿"},
    {"subbageq", "⊑"},
    {"inseq", "infix"},
    {"inrel", "\\inrel"},
    {"ldots", ""},
}};

/// The packages of LaTeX that typeset Spivey's Z; oz typesets ISO's, too.
constexpr std::array<std::string_view, 5> packages = {"fuzz", "zed-csp", "oz", "zed", "zed2e"};
/// The package of CZT that typesets ISO's.
constexpr std::string_view iso_package = "czt";

/// The keywords of ISO Z that are commands in Spivey's, or nothing.
constexpr std::array<std::string_view, 12> keywords = {"section",  "parents",   "function",   "generic",
                                                       "relation", "leftassoc", "rightassoc", "if",
                                                       "then",     "else",      "let",        "pre"};

/// Says whether a word is of an operator of ISO's toolkit.
bool is_operator_word(std::string_view word) {
  const Symbol& known = symbol_of(word);
  return known.prefix != nullptr || known.infix != nullptr || known.postfix != nullptr;
}

struct KindName {
  std::string_view name;
  SpiveyDirective::Kind kind;
  Role role;
  bool left, right;  // operands stand there
};
constexpr std::array<KindName, 12> kinds = {{
    {"inop", SpiveyDirective::Kind::operators, Role::function, true, true},
    {"postop", SpiveyDirective::Kind::operators, Role::function, true, false},
    {"inrel", SpiveyDirective::Kind::operators, Role::relation, true, true},
    {"prerel", SpiveyDirective::Kind::operators, Role::relation, false, true},
    {"ingen", SpiveyDirective::Kind::operators, Role::generic, true, true},
    {"pregen", SpiveyDirective::Kind::operators, Role::generic, false, true},
    {"ignore", SpiveyDirective::Kind::ignored, {}, false, false},
    {"unchecked", SpiveyDirective::Kind::unchecked, {}, false, false},
    {"type", SpiveyDirective::Kind::passed, {}, false, false},
    {"tame", SpiveyDirective::Kind::passed, {}, false, false},
    {"pname", SpiveyDirective::Kind::passed, {}, false, false},
    {"line", SpiveyDirective::Kind::passed, {}, false, false},
}};

const KindName* kind_of(std::string_view line) {
  const std::string_view behind = line.substr(std::min<std::size_t>(2, line.size()));
  const auto end = std::ranges::find_if_not(behind, is_letter);
  const std::string_view name = behind.substr(0, static_cast<std::size_t>(end - behind.begin()));
  const auto found = std::ranges::find(kinds, name, &KindName::name);
  return found == kinds.end() ? nullptr : &*found;
}

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  while (!line.empty()) {
    const std::size_t begin = line.find_first_not_of(" \t\r");
    if (begin == line.npos) break;
    line.remove_prefix(begin);
    const std::size_t end = std::min(line.find_first_of(" \t\r"), line.size());
    words.push_back(line.substr(0, end));
    line.remove_prefix(end);
  }
  return words;
}

/// A name as its word is read: `\_` is an underscore.
std::string name_at(std::string_view text) {
  std::string name;
  while (!text.empty()) {
    if (text.starts_with("\\_")) {
      name += '_';
      text.remove_prefix(2);
    } else if (is_letter(text[0]) || (is_digit(text[0]) && !name.empty())) {
      name += text[0];
      text.remove_prefix(1);
    } else {
      break;
    }
  }
  return name;
}

/// A name in a line, and where it begins.
struct NameBefore {
  std::string name;
  std::size_t begin;
};

/// The name that ends before a byte of a line, but for blanks and generic formals.
NameBefore name_before(std::string_view line, std::size_t end) {
  const auto drop_blanks = [&] {
    while (end > 0 && (is_space(line[end - 1]) || line[end - 1] == '~')) --end;
  };
  drop_blanks();
  if (end > 0 && line[end - 1] == ']') end = std::min(line.rfind('[', end), end);
  drop_blanks();
  std::size_t begin = end;
  while (begin > 0 &&
         (is_letter(line[begin - 1]) || is_digit(line[begin - 1]) || (begin > 1 && line.substr(begin - 2, 2) == "\\_")))
    begin -= line[begin - 1] == '_' ? 2 : 1;
  return {name_at(line.substr(begin, end - begin)), begin};
}

/// Looks through the lines of a text for what tells whose Z it is.
class SignSearch {
 public:
  std::shared_ptr<const SpiveyText> run(std::string_view text) {
    lines(text, [this](std::string_view line) { look(line); });
    if (is_iso_) return nullptr;
    if (has_iso_package_) found_.sign.clear();
    // Alone, S' may be a name of ISO's: it tells in a whole document of LaTeX.
    if (found_.sign.empty() && text.find("\\begin{document}") != text.npos)
      lines(text, [this](std::string_view line) { look_for_decoration(line); });
    return found_.sign.empty() ? nullptr : std::make_shared<const SpiveyText>(std::move(found_));
  }

 private:
  template <class Look>
  void lines(std::string_view text, Look&& look_at) {
    line_ = 0;
    while (!text.empty() && !is_iso_) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      ++line_;
      look_at(text.substr(0, end));
      text.remove_prefix(std::min(end + 1, text.size()));
    }
  }

  static std::string_view without_comment(std::string_view line) {
    for (std::size_t at = 0; at < line.size(); ++at) {
      if (line[at] == '\\') {
        ++at;
      } else if (line[at] == '%') {
        return line.substr(0, at);
      }
    }
    return line;
  }

  void tell(std::string_view sign, std::size_t at) {
    if (found_.sign.empty()) found_.sign = sign, found_.place = {line_, static_cast<std::uint32_t>(at + 1)};
  }

  void look(std::string_view line) {
    if (line.starts_with("%%")) {
      if (const KindName* const kind = kind_of(line)) tell("%%" + std::string(kind->name), 0);
      if (!is_hidden_line(line)) return;
      line.remove_prefix(2);
    }
    line = without_comment(line);
    if (line.find("\\begin{zsection}") != line.npos) is_iso_ = true;
    look_for_package(line);
    look_for_names(line);
    for (std::size_t at = line.find('\\'); at != line.npos; at = line.find('\\', at + 1)) look_at_command(line, at);
  }

  void look_for_package(std::string_view line) {
    const std::size_t style = line.find("\\documentstyle");
    const bool is_style = style != line.npos;
    const std::size_t use = is_style ? style : line.find("\\usepackage");
    if (use == line.npos) return;
    const std::size_t begin = line.find(is_style ? '[' : '{', use), end = line.find_first_of("}]", begin + 1);
    if (begin == line.npos || end == line.npos) return;
    std::string_view names = line.substr(begin + 1, end - begin - 1);
    while (!names.empty()) {
      const std::size_t comma = std::min(names.find(','), names.size());
      std::string_view name = names.substr(0, comma);
      while (!name.empty() && is_space(name.front())) name.remove_prefix(1);
      while (!name.empty() && is_space(name.back())) name.remove_suffix(1);
      if (name == iso_package && found_.sign.empty()) has_iso_package_ = true;
      if (std::ranges::find(packages, name) != packages.end()) {
        is_by_oz_ = is_by_oz_ || (found_.sign.empty() && name == "oz");
        tell(std::string(is_style ? "\\documentstyle[" : "\\usepackage{") + std::string(name) + (is_style ? "]" : "}"),
             use);
      }
      names.remove_prefix(std::min(comma + 1, names.size()));
    }
  }

  void look_at_command(std::string_view line, std::size_t at) {
    static constexpr std::array<std::string_view, 5> own = {"defs", "spot", "inrel", "lbag", "bsup"};
    const std::string_view rest = line.substr(at + 1);
    const auto end = std::ranges::find_if_not(rest, is_letter);
    const std::string_view name = rest.substr(0, static_cast<std::size_t>(end - rest.begin()));
    if (std::ranges::find(own, name) != own.end()) tell("\\" + std::string(name), at);
    if (name == "lblot" && is_by_oz_) {  // oz typesets ISO's bindings, too, which Spivey's Z has not
      found_.sign.clear();
      is_by_oz_ = false;
    }
    found_.has_bags = found_.has_bags || std::ranges::find(bag_commands, name) != bag_commands.end();
    if (name == "defs") add_schema(name_before(line, at).name);
    if (rest.starts_with("begin{syntax}")) tell("\\begin{syntax}", at);
    static constexpr std::string_view schema = "begin{schema}{";
    if (rest.starts_with(schema)) add_schema(name_at(rest.substr(schema.size())));
  }

  /// A word that stands before : or == or \\ldata, or as a branch of a free type, is declared.
  void look_for_names(std::string_view line) {
    for (std::size_t at = 0; at < line.size();) {
      const std::size_t begin = at;
      while (at < line.size() && (is_letter(line[at]) || (at > begin && is_digit(line[at])))) ++at;
      if (at == begin) {
        ++at;
        continue;
      }
      const bool is_command = begin > 0 && (line[begin - 1] == '\\' || line[begin - 1] == '_');
      const std::string_view word = line.substr(begin, at - begin);
      if (!is_command && is_operator_word(word) && declares(line.substr(0, begin), line.substr(at)))
        found_.names.emplace(word);
    }
  }
  static bool declares(std::string_view before, std::string_view behind) {
    behind = without_blanks(behind);
    if (behind.starts_with("\\ldata")) return true;
    while (!before.empty() && (is_space(before.back()) || before.back() == '~' || before.back() == '&'))
      before.remove_suffix(1);
    const bool is_branch = before.ends_with('|') || before.ends_with("::=");
    if (is_branch && (behind.empty() || behind[0] == '|' || behind[0] == '.' || behind.starts_with("\\\\")))
      return true;
    while (behind.starts_with(',')) behind = without_blanks(without_name(without_blanks(behind.substr(1))));
    return behind.starts_with(':') || behind.starts_with("==");
  }
  static std::string_view without_blanks(std::string_view text) {
    while (!text.empty() && (is_space(text[0]) || is_stroke(text[0]) || text[0] == '~' || text[0] == '&'))
      text.remove_prefix(1);
    return text;
  }
  static std::string_view without_name(std::string_view text) {
    while (!text.empty() && (is_letter(text[0]) || is_digit(text[0]) || text.starts_with("\\_")))
      text.remove_prefix(text[0] == '\\' ? 2 : 1);
    return text;
  }

  void add_schema(std::string name) {
    if (!name.empty()) found_.schemas.insert(std::move(name));
  }

  /// S' where a schema of the text is called S.
  void look_for_decoration(std::string_view line) {
    line = without_comment(line);
    for (std::size_t at = line.find('\''); at != line.npos; at = line.find('\'', at + 1)) {
      const auto [name, begin] = name_before(line, at);
      if (at > 0 && !is_space(line[at - 1]) && line[at - 1] != '~' && found_.schemas.contains(name))
        tell(name + "'", begin);
    }
  }

  SpiveyText found_;
  std::uint32_t line_ = 0;
  bool is_iso_ = false, has_iso_package_ = false, is_by_oz_ = false;
};

/// The Unicode text of a directive's word.
std::string meaning_of(std::string_view word) {
  if (!word.starts_with('\\')) return std::string(word);
  word.remove_prefix(1);
  if (const auto known = spivey_command(word)) return std::string(*known);
  return std::string(unicode_of_command(word).value_or(word));
}

}  // namespace

std::optional<std::string_view> spivey_command(std::string_view command) {
  const auto found = std::ranges::find(commands, command, &std::pair<std::string_view, std::string_view>::first);
  return found == commands.end() ? std::nullopt : std::optional(found->second);
}

bool is_name_of_spivey(std::string_view word, const SpiveyText& text) {
  return std::ranges::find(keywords, word) != keywords.end() || text.names.contains(word);
}

std::shared_ptr<const SpiveyText> spivey_text(std::string_view text) { return SignSearch().run(text); }

bool is_hidden_line(std::string_view line) {
  return line.starts_with("%%") && (line.size() == 2 || !is_letter(line[2]));
}

std::optional<SpiveyDirective> spivey_directive(std::string_view line, Place place) {
  const KindName* const kind = kind_of(line);
  if (kind == nullptr) return std::nullopt;
  SpiveyDirective directive{kind->kind, {}, {}};
  std::vector<std::string_view> words = words_of(line.substr(2 + kind->name.size()));
  int precedence = kind->role == Role::generic && kind->left ? 5 : 0;  // as that of the arrows
  if (kind->name == "inop") {
    const bool has_priority = !words.empty() && words.back().size() == 1 && words.back() >= "1" && words.back() <= "6";
    if (!has_priority) throw ZError(place, "an %%inop without a priority", "expected one of 1 to 6 behind the words");
    precedence = 10 * (words.back()[0] - '0');
    words.pop_back();
  }
  const bool is_told = kind->kind == SpiveyDirective::Kind::operators || kind->kind == SpiveyDirective::Kind::ignored;
  if (is_told && words.empty())
    throw ZError(place, "a directive %%" + std::string(kind->name) + " of nothing", "expected words behind it");
  for (const std::string_view word : words) {
    directive.words.emplace_back(word.substr(word.starts_with('\\') ? 1 : 0));
    if (kind->kind != SpiveyDirective::Kind::operators) continue;
    OperatorTemplate read{kind->role, {}, precedence, kind->role == Role::generic};
    if (kind->left) read.parts.emplace_back("_");
    read.parts.push_back(meaning_of(word));
    if (kind->right) read.parts.emplace_back("_");
    directive.operators.push_back(std::move(read));
  }
  return directive;
}

}  // namespace durero::zed
