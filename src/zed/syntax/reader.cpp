#include "durero/zed/syntax/reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <span>
#include <system_error>
#include <tuple>
#include <utility>

#include "durero/text/file.hpp"
#include "zed/syntax/bag_toolkit.hpp"
#include "zed/syntax/block_parser.hpp"
#include "zed/syntax/characters.hpp"
#include "zed/syntax/lexer.hpp"

namespace durero::zed {
namespace {

/// Returns the text of a file, or nothing where it cannot be read. A byte more than the limit tells that it is too
/// large.
std::optional<std::string> on_disk(const std::string& file) {
  try {
    return text::read_file(file, max_bytes + 1);
  } catch (const std::system_error&) {
    return std::nullopt;
  }
}

/// The files that a parent is looked for in.
constexpr std::array<std::string_view, 4> endings = {".tex", ".utf8", ".zed", ".zed8"};

/// Says whether a text begins with the mark of UTF-16.
bool is_utf16(std::string_view text) { return text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"); }

class SpecificationReader {
 public:
  /// The place of parents that no text has.
  enum class Parents : std::uint8_t { beside_files, nowhere_else };

  /// Reads `texts`, by name of file, instead of files on disk.
  explicit SpecificationReader(std::map<std::string, std::optional<std::string>> texts = {},
                               Parents parents = Parents::beside_files)
      : texts_(std::move(texts)), parents_(parents) {}

  /// Tells where the sections of a file are, without reading them.
  void index(const std::string& path) {
    const auto& read = contents(path);
    if (!read) return;
    for (const Block& block : pieces(*read, path).blocks) {
      if (block.environment != "zsection") continue;
      try {
        where_.emplace(parse_header(lex(block, {}, {})).name, path);
      } catch (const ZError&) {  // it is reported when the file is read
      }
    }
  }

  void file(const std::string& path) {
    std::error_code none;  // a pipe has no other name
    const std::string canonical = std::filesystem::weakly_canonical(path, none).string();
    if (!files_.insert(none ? path : canonical).second) return;
    if (const auto& read = contents(path)) return text(*read, path);
    specification_.defects.push_back({path, {1, 1}, "the file cannot be read", "expected a file of Z text", {}});
  }

  void text(const std::string& source, const std::string& path) {
    if (source.size() > max_bytes) {
      specification_.defects.push_back({path, {1, 1}, "the file is too large", "expected at most a MiB of Z text", {}});
      return;
    }
    if (is_utf16(source)) {
      specification_.defects.push_back({path, {1, 1}, "the file is in UTF-16", "expected UTF-8", {}});
      return;
    }
    std::optional<Section> open;
    const auto& [blocks, defects] = pieces(source, path);
    if (!blocks.empty() && blocks.front().spivey) {
      const SpiveyText& known = *blocks.front().spivey;
      specification_.spivey[path] = fmt::format("{} at line {}", known.sign, known.place.line);
    }
    specification_.defects.insert(specification_.defects.end(), defects.begin(), defects.end());
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      const Block& block = blocks[i];
      try {
        if (block.environment == "zsection") {
          close(open);
          open.emplace();
          header(block, path, *open);
          templates(std::span(blocks).subspan(i + 1), *open);
        } else {
          if (!open) {
            open = anonymous(block, path);
            templates(std::span(blocks).subspan(i), *open);
          }
          paragraphs(block, *open);
        }
      } catch (const ZError& error) {
        specification_.defects.push_back(error.in(path));
      }
    }
    close(open);
  }

  Specification take() {
    std::stable_sort(
        specification_.defects.begin(), specification_.defects.end(), [](const Defect& a, const Defect& b) {
          return std::tuple(a.file, a.place.line, a.place.column) < std::tuple(b.file, b.place.line, b.place.column);
        });
    return std::move(specification_);
  }

 private:
  struct Pieces {
    std::vector<Block> blocks;
    std::vector<Defect> defects;
  };
  /// Cuts the text of a file, once.
  const Pieces& pieces(const std::string& text, const std::string& path) {
    const auto [at, added] = pieces_.try_emplace(path);
    if (added) at->second.blocks = cut(text, path, at->second.defects);
    return at->second;
  }

  /// Returns the text of a file, which is read once; nothing where it cannot be read.
  const std::optional<std::string>& contents(const std::string& file) {
    if (const auto known = texts_.find(file); known != texts_.end()) return known->second;
    return texts_.emplace(file, on_disk(file)).first->second;
  }

  /// Begins a section; one with a bad header is read all the same, for the defects in it.
  void header(const Block& block, const std::string& path, Section& section) {
    section = {path, "a section without a name", {}, {}, block.begin, {}};
    const SectionHeader read = parse_header(lex(block, {}, {}));
    section.name = read.name;
    section.parents = read.parents;
    if (is_toolkit(section.name) || !started_.insert(section.name).second)
      throw ZError(block.place, "a second section " + section.name, "expected a name of its own");
    Markup& mine = specification_.markup[section.name];
    mine.insert(block.directives.begin(), block.directives.end());
    for (const std::string& parent : section.parents) inherit(section.name, parent, path, block.place);
    if (const std::string word = word_of_toolkit(specification_.operators[section.name], toolkit_[section.name]);
        !word.empty())
      refuse_word(word, path, block.place);
  }

  void inherit(const std::string& child, const std::string& parent, const std::string& path, Place place) {
    if (const auto given = ToolkitSections::of(parent)) {
      toolkit_[child] |= *given;
      return;
    }
    if (parent == bag_toolkit) begin_bags();
    if (!started_.contains(parent)) find(parent, path);
    if (!specification_.find(parent)) no_parent(parent, place);
    const Markup& theirs = specification_.markup[parent];
    Markup& mine = specification_.markup[child];
    mine.insert(theirs.begin(), theirs.end());
    toolkit_[child] |= toolkit_[parent];
    const Operators& known = specification_.operators[parent];
    for (const auto& [word, part] : known)
      if (is_otherwise_associated(child, *part.of, {path, place})) break;
    specification_.operators[child].insert(known.begin(), known.end());
  }

  /// Says whether an operator associates to the other side than one of its precedence in the section, which is a defect
  /// at that place.
  bool is_otherwise_associated(const std::string& section, const OperatorTemplate& added,
                               const std::pair<std::string, Place>& at) {
    const std::string other = otherwise_associated(specification_.operators[section], toolkit_[section], added);
    if (other.empty()) return false;
    specification_.defects.push_back({at.first,
                                      at.second,
                                      fmt::format("{} and {}, of precedence {}, associate to different sides",
                                                  added.name(), other, added.precedence),
                                      "expected one side, or another precedence",
                                      {}});
    return true;
  }

  /// Reads the section of bags, which is the program's own, once.
  void begin_bags() {
    const std::string name(bag_toolkit);
    if (started_.contains(name)) return;
    text(std::string(bag_toolkit_text), name);
    for (const std::string_view command : bag_commands)
      specification_.markup[name].emplace(command, *spivey_command(command));
  }

  /// Says why a parent is missing: a section that was begun and has not ended is an ancestor of itself, and one whose
  /// file was begun stands behind its child there.
  [[noreturn]] void no_parent(const std::string& parent, Place place) const {
    if (started_.contains(parent))
      throw ZError(place, "the parents go in a cycle, back to " + parent,
                   "expected no section among its own ancestors");
    if (where_.contains(parent))
      throw ZError(place, "the parent " + parent + " stands behind its child",
                   "expected it before, or in another file");
    throw ZError(place, "unknown parent " + parent, "expected a section, or a file " + parent + ".tex");
  }

  /// Reads the file that a section stands in: one of those given, or one in the folder of the file that names it.
  void find(const std::string& parent, const std::string& path) {
    if (!where_.contains(parent) && parents_ == Parents::beside_files) {
      std::filesystem::path folder = std::filesystem::path(path).parent_path();
      if (folder.empty()) folder = ".";
      std::error_code unreadable;
      std::set<std::string> beside;  // their order makes the answer independent of the file system
      for (const auto& entry : std::filesystem::directory_iterator(folder, unreadable))
        if (std::ranges::find(endings, entry.path().extension()) != endings.end())
          beside.insert(entry.path().lexically_normal().string());
      for (const std::string& file : beside) index(file);
    }
    if (const auto at = where_.find(parent); at != where_.end()) file(at->second);
  }

  Section anonymous(const Block& block, const std::string& path) {
    Section section{path, "Specification", {"standard_toolkit"}, {}, block.begin, {}};
    toolkit_[section.name] = ToolkitSections::all();
    if (!started_.insert(section.name).second)
      throw ZError(block.begin, "a second file without a section header", "expected \\begin{zsection}");
    if (block.spivey && block.spivey->has_bags) {
      section.parents.emplace_back(bag_toolkit);
      inherit(section.name, section.parents.back(), path, block.begin);
    }
    return section;
  }

  /// Reads the templates of a section before all else, as they hold in all of it.
  void templates(std::span<const Block> blocks, const Section& section) {
    Markup markup = specification_.markup[section.name];
    for (const Block& block : blocks) {
      if (block.environment == "zsection") return;
      for (const auto& [command, meaning] : block.directives) markup[command] = meaning;
      for (const OperatorTemplate& read : block.operators)
        add_operator(specification_.operators[section.name], read, toolkit_[section.name]);
      if (block.environment == "zed" && may_have_template(block.body)) add_templates(block, markup, section);
    }
  }

  static bool may_have_template(std::string_view body) {
    static constexpr std::array<std::string_view, 3> words = {"function", "generic", "relation"};
    return std::any_of(words.begin(), words.end(),
                       [body](std::string_view word) { return body.find(word) != body.npos; });
  }

  void add_templates(const Block& block, const Markup& markup, const Section& section) {
    Operators& operators = specification_.operators[section.name];
    for (const ReadTemplate& found : templates_in(lex(block, markup, operators))) {
      warn_of_joined_operands(found, block, section);
      is_otherwise_associated(section.name, found.read, {section.file, found.place});
      if (const std::string taken = add_operator(operators, found.read, toolkit_[section.name]); !taken.empty())
        refuse_word(taken, section.file, found.place);
    }
  }

  void refuse_word(const std::string& word, const std::string& file, Place place) {
    specification_.defects.push_back({file,
                                      place,
                                      "the word " + word + " of an operator has a meaning already",
                                      "expected a word that is no operator's",
                                      {}});
  }

  /// Where no ~ stands beside \_ in LaTeX, nor a blank beside _ in Unicode, it is a letter of the operator's word.
  void warn_of_joined_operands(const ReadTemplate& found, const Block& block, const Section& section) {
    for (const Token& token : found.tokens) {
      if (token.type != Token::Type::word || !has_joined_operand(block.body.substr(token.from, token.to - token.from)))
        continue;
      const std::string word = token.text.substr(0, token.text.find("_"));
      specification_.warnings.push_back(
          {section.file, token.place, "the _ in " + token.text + " is a letter of this operator's word, and no operand",
           block.unicode ? "expected a blank before an operand: " + word + " _"
                         : "expected ~ before an operand, as LaTeX joins what blanks separate: " + word + "~\\_",
           Defect::Severity::warning});
    }
  }

  static bool has_joined_operand(std::string_view word) {
    const std::size_t at = word.find("\\_");
    const std::size_t behind = at == word.npos ? at : at + 2;
    return word.ends_with('_') || (at != word.npos && (is_space(word[at - 1]) || is_space(word[behind])));
  }

  void paragraphs(const Block& block, Section& into) {
    Markup& markup = specification_.markup[into.name];
    for (const auto& [command, meaning] : block.directives) markup[command] = meaning;
    const Operators& operators = specification_.operators[into.name];
    for (const Place place : grouping_braces(block))
      specification_.warnings.push_back({into.file, place, "these braces only group, as in TeX",
                                         "expected \\{ and \\} for a set, or none", Defect::Severity::warning});
    const std::vector<Token> tokens = lex(block, markup, operators);
    std::vector<ZError> mended;
    try {
      std::vector<Paragraph> read = parse_block(block.environment, tokens, mended, block.spivey != nullptr);
      std::move(read.begin(), read.end(), std::back_inserter(into.paragraphs));
    } catch (const ZError& error) {
      const std::vector<Name> lost = names_declared(block.environment, tokens);
      into.lost.insert(into.lost.end(), lost.begin(), lost.end());
      mended.push_back(error);
    }
    for (const ZError& error : mended) specification_.defects.push_back(error.in(into.file));
  }

  void close(std::optional<Section>& open) {
    if (open) specification_.sections.push_back(std::move(*open));
    open.reset();
  }

  std::map<std::string, std::optional<std::string>> texts_;  // a file that cannot be read has no contents
  Parents parents_;
  std::map<std::string, Pieces> pieces_;  // of these
  Specification specification_;
  std::set<std::string> files_, started_;
  std::map<std::string, ToolkitSections> toolkit_;  // each section has these of the toolkit among its ancestors
  std::map<std::string, std::string> where_;        // a section leads to its file
};

}  // namespace

const Section* Specification::find(const std::string& name) const {
  for (const Section& section : sections)
    if (section.name == name) return &section;
  return nullptr;
}

bool is_toolkit(const std::string& section) { return ToolkitSections::of(section).has_value(); }

bool is_built_in(const Section& section) { return section.file == bag_toolkit; }

Specification read_files(const std::vector<std::string>& files) {
  SpecificationReader reader;
  for (const std::string& path : files) reader.index(path);
  for (const std::string& path : files) reader.file(path);
  return reader.take();
}

namespace {

/// Reads texts of files, which it keeps, and the parents that they name.
template <class Texts>
Specification read_each(const Texts& texts, SpecificationReader::Parents parents) {
  SpecificationReader reader({texts.begin(), texts.end()}, parents);
  for (const auto& [file, text] : texts) reader.index(file);
  for (const auto& [file, text] : texts) reader.file(file);
  return reader.take();
}

}  // namespace

Specification read_sources(const std::vector<std::pair<std::string, std::string>>& sources) {
  return read_each(sources, SpecificationReader::Parents::beside_files);
}

Specification read_texts(const std::map<std::string, std::string>& texts) {
  return read_each(texts, SpecificationReader::Parents::nowhere_else);
}

Specification read_text(const std::string& text, const std::string& file) {
  SpecificationReader reader;
  reader.text(text, file);
  return reader.take();
}

}  // namespace durero::zed
