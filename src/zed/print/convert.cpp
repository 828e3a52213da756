/// Writes a text token by token in another mark-up. That it says the same is not believed: what was written is read.

#include "durero/zed/print/convert.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "durero/text/utf8.hpp"
#include "zed/print/block_writer.hpp"
#include "zed/print/layout.hpp"
#include "zed/print/pieces.hpp"
#include "zed/print/spelling.hpp"
#include "zed/print/spivey_grammar.hpp"
#include "zed/syntax/bag_toolkit.hpp"
#include "zed/syntax/block_parser.hpp"
#include "zed/syntax/characters.hpp"
#include "zed/syntax/cursor.hpp"
#include "zed/syntax/lexer.hpp"

namespace durero::zed {
namespace {

std::string in_words(Form form) {
  switch (form) {
    case Form::latex:
      return "LaTeX mark-up";
    case Form::unicode:
      return "Unicode";
    case Form::spivey:
      return "Spivey's Z";
  }
  return {};
}

/// The parents of a section that Spivey's Z has without saying so.
bool is_of_spivey(const std::vector<std::string>& parents) {
  return std::ranges::find(parents, "standard_toolkit") != parents.end() &&
         std::ranges::all_of(parents, [](const std::string& name) { return is_toolkit(name) || name == bag_toolkit; });
}

/// Writes a text: its prose, and each paragraph between.
class TextWriter {
 public:
  TextWriter(std::string_view text, Form to, const Specification& read) : text_(text), to_(to), read_(read) {}

  std::string run() {
    const std::vector<Block> blocks = cut_of(text_);
    for (const Block& block : blocks) {
      prose(start_of(block));
      begin_line();
      if (block.spivey) say_in_iso(block, &block == &blocks.front());
      if (block.environment == "zsection") {
        to_ == Form::spivey ? header_in_spivey(block, &block == &blocks.front()) : write({block}, dialect(block));
      } else {
        pieces(block);
      }
      at_ = end_of(block);
    }
    prose(text_.size());
    if (!blocks.empty()) agree();
    return std::move(out_);
  }

 private:
  void begin_line() {
    if (!out_.empty() && out_.back() != '\n') out_ += '\n';
  }

  void pieces(const Block& block) {
    const Dialect by = dialect(block);
    bool is_first = true;
    for (const BlockPiece& piece : pieces_of(block, by)) {
      if (!is_first) begin_line();
      is_first = false;
      if (to_ != Form::spivey) {
        write(piece, by);
      } else if (piece.share == Share::operators) {
        directives(piece, by);
      } else {
        for (const Paragraph& paragraph : piece.paragraphs) {
          add_schema_name(paragraph, schemas_);
          require_spivey(paragraph, schemas_);
          require_operands(paragraph, piece, by);
        }
        write(piece, by);
      }
    }
  }

  /// Refuses a definition of an operator by its name with _, as fuzz takes it by its operands alone.
  static void require_operands(const Paragraph& paragraph, const BlockPiece& piece, const Dialect& by) {
    const auto* const definition = std::get_if<Definition>(&paragraph.form);
    if (definition == nullptr || !is_template_name(definition->name.word)) return;
    const std::vector<Token> tokens = lex(piece.block, by.markup, by.operators);
    auto at = std::ranges::find(tokens, paragraph.place, &Token::place);
    for (; at != tokens.end() && !at->is("=="); ++at)
      if (at->is("_"))
        throw ZError(at->place, "a definition of an operator by _ cannot be written in Spivey's Z",
                     "expected a box, or names as operands");
  }

  void write(const BlockPiece& piece, const Dialect& by) {
    std::string text = in_other_form(piece, to_, by, schemas_);
    if (piece.block.spivey == nullptr || piece.block.environment == "zsection") {
      compare(piece, by, text);
    } else if (!is_so(piece, by, text)) {
      std::string regrouped = in_other_form(piece, to_, by, schemas_, true);
      if (!is_same_tree(piece, by, regrouped)) compare(piece, by, text);
      text = std::move(regrouped);
    }
    out_ += text;
    ++count_;
  }
  bool is_so(const BlockPiece& piece, const Dialect& by, std::string_view written) const {
    try {
      compare(piece, by, written);
    } catch (const ZError&) {  // parentheses may help
      return false;
    }
    return true;
  }
  /// Says whether what was written is one block, and is read as the same paragraphs.
  static bool is_same_tree(const BlockPiece& piece, const Dialect& by, std::string_view written) {
    std::vector<Block> again = cut_of(written);
    if (again.size() == 1) again[0].spivey = nullptr;
    return again.size() == 1 && !other_tree(piece, again[0].environment, tokens_of(again[0], by), false);
  }

  /// Writes operator templates as directives of fuzz, a line each, and the comments that stood among them.
  void directives(const BlockPiece& piece, const Dialect& by) {
    const std::vector<Token> tokens = lex(piece.block, by.markup, by.operators);
    for (const ReadTemplate& each : templates_in(tokens)) {
      const auto word =
          std::ranges::find_if(each.tokens, [](const Token& token) { return token.own && token.own->first(); });
      out_ += spivey_directive_of(each.read, Spelling(by.markup).latex(*word, true), each.place) + "\n";
    }
    for (std::size_t i = 0; i < tokens.size(); ++i) {
      const std::size_t from = i == 0 ? 0 : tokens[i - 1].to;
      if (tokens[i].type == Token::Type::newline) continue;
      const std::size_t to = tokens[i].type == Token::Type::end ? piece.block.body.size() : tokens[i].from;
      const std::string_view between = piece.block.body.substr(from, std::max(from, to) - from);
      for (const LayoutLine& line : piece.block.unicode ? layout_of_unicode(between) : layout_of_latex(between))
        if (!line.comment.empty()) out_ += line.comment + "\n";
    }
  }

  /// Writes the header of a section as a comment: Spivey's Z has one section, of which no header tells.
  void header_in_spivey(const Block& block, bool is_first) {
    const SectionHeader header = parse_header(lex(block, {}, {}));
    section_ = header.name;
    if (!is_first)
      throw ZError(block.begin, "a second section cannot be written in Spivey's Z", "expected one, before all else");
    if (!is_of_spivey(header.parents))
      throw ZError(block.begin, "a section of these parents cannot be written in Spivey's Z",
                   "expected standard_toolkit, and no section of one's own");
    if (header.name == "Specification") return;
    out_ += "% section " + header.name + " parents";
    for (const std::string& parent : header.parents) out_ += (&parent == &header.parents.front() ? " " : ", ") + parent;
    out_ += "\n";
  }

  static std::vector<Block> cut_of(std::string_view text) {
    std::vector<Defect> defects;
    return cut(text, {}, defects);
  }

  std::size_t start_of(const Block& block) const { return static_cast<std::size_t>(block.whole.data() - text_.data()); }
  std::size_t end_of(const Block& block) const { return start_of(block) + block.whole.size(); }

  /// Takes prose up to a byte of the text; in Unicode it must not be taken for Z, nor for the rule of a box.
  void prose(std::size_t to) {
    const std::string_view kept = text_.substr(at_, to - at_);
    if (to_ == Form::unicode && (has_box_line(kept) || (at_ > 0 && kept.starts_with("─"))))
      throw ZError(place_of(at_), "behind this, prose begins a line as a box of Unicode does",
                   "expected it to begin otherwise");
    out_ += kept;
    at_ = to;
  }
  bool has_box_line(std::string_view kept) const {
    const std::string line = (at_ == 0 ? "" : " ") + std::string(kept);
    return has_box(line);
  }
  Place place_of(std::size_t byte) const {
    Place place{1, 1};
    for (std::size_t at = 0; at < byte; ++at) {
      if (text_[at] == '\n') {
        place = {place.line + 1, 1};
      } else if (!text::continues(text_[at])) {
        ++place.column;
      }
    }
    return place;
  }

  /// Writes what Spivey's Z says without a paragraph: the bags among the parents, and the templates of its operators.
  /// In LaTeX a header tells that the text is ISO's, whatever package it uses.
  void say_in_iso(const Block& block, bool is_first) {
    const bool has_bags = block.spivey->has_bags;
    if (is_first && (has_bags || to_ == Form::latex))
      add_header(has_bags ? "standard_toolkit, " + std::string(bag_toolkit) : "standard_toolkit");
    for (const OperatorTemplate& op : block.operators) {
      if (to_ == Form::latex) name_command(block, op.parts[op.has_left() ? 1 : 0]);
      const std::string kind = op.role == Role::function  ? "function"
                               : op.role == Role::generic ? "generic"
                                                          : "relation";
      const bool binds = op.role != Role::relation && op.has_left() && op.has_right();
      const std::string strength =
          binds ? std::to_string(op.precedence) + (op.right ? " rightassoc " : " leftassoc ") : "";
      add_paragraph(kind + " " + strength + "(" + op.name() + ")", "zed");
    }
  }
  /// The command of a directive of fuzz is one of ISO's text by a directive.
  void name_command(const Block& block, const std::string& word) {
    for (const auto& [command, meaning] : block.directives)
      if (meaning == word && std::ranges::all_of(word, is_letter)) out_ += "%%Zword \\" + command + " " + word + "\n";
  }
  void add_header(const std::string& parents) { add_paragraph("section Specification parents " + parents, "zsection"); }

  /// Adds a paragraph that is written in Unicode here.
  void add_paragraph(const std::string& text, const std::string& environment) {
    Block block;
    block.environment = environment;
    block.body = text;
    block.place = block.begin = {1, 1};
    block.unicode = true;
    const auto markup = read_.markup.find(section_);
    static const Operators no_operators;
    static const Markup no_markup;
    const Dialect by{markup == read_.markup.end() ? no_markup : markup->second, no_operators};
    out_ += to_ == Form::unicode ? "─ " + text + " └" : in_other_form({block}, to_, by, schemas_);
    out_ += "\n";
    ++count_;
  }

  Dialect dialect(const Block& block) {
    static const Markup no_markup;
    static const Operators no_operators;
    if (block.environment == "zsection") {
      section_ = parse_header(lex(block, {}, {})).name;
      return {no_markup, no_operators};
    }
    const auto markup = read_.markup.find(section_);
    const auto operators = read_.operators.find(section_);
    return {markup == read_.markup.end() ? no_markup : markup->second,
            operators == read_.operators.end() ? no_operators : operators->second};
  }

  /// Reads what was written for a piece, and asks that it is the same. The place is that of the first token which is
  /// another. Spivey's Z has other tokens, and the same tree.
  void compare(const BlockPiece& piece, const Dialect& by, std::string_view written) const {
    const Block& block = piece.block;
    std::vector<Token> before = tokens_of(block, by);
    std::vector<Block> again = cut_of(written);
    std::vector<Token> after;
    std::string environment;
    if (again.size() == 1) {
      again[0].spivey = to_ == Form::spivey ? spivey_with_schemas() : nullptr;
      environment = again[0].environment;
      after = tokens_of(again[0], by);
    }
    const std::optional<Place> other = other_tree(piece, environment, after, to_ == Form::spivey);
    if (to_ != Form::spivey) compare_tokens(block, std::move(before), std::move(after));
    if (other)
      throw ZError(*other, "this paragraph would be another in " + in_words(to_),
                   "expected parentheses where operators bind otherwise there, or another form");
  }
  void compare_tokens(const Block& block, std::vector<Token> before, std::vector<Token> after) const {
    if (!before.empty() && before.front().is("|") != (!after.empty() && after.front().is("|")))
      drop_where(before), drop_where(after);
    const auto [left, right] = std::mismatch(before.begin(), before.end(), after.begin(), after.end(), is_same);
    if (left != before.end()) refuse(left->place, left->text);
    if (right != after.end()) refuse(block.begin, "this paragraph");
  }
  std::shared_ptr<const SpiveyText> spivey_with_schemas() const {
    auto text = std::make_shared<SpiveyText>();
    text->schemas = schemas_;
    return text;
  }
  /// Whether a line ends behind the title of a box tells nothing: it is left out.
  static std::vector<Token> tokens_of(const Block& block, const Dialect& by) {
    std::vector<Token> tokens = lex(block, by.markup, by.operators);
    const std::size_t title = in_title(block, tokens);
    if (title > 0 && tokens[title].type == Token::Type::newline)
      tokens.erase(tokens.begin() + static_cast<std::ptrdiff_t>(title));
    return tokens;
  }
  /// Whether a sign counts as a word tells no parser anything.
  static bool is_same(const Token& a, const Token& b) {
    const auto is_text = [](const Token& token) {
      return token.type == Token::Type::word || token.type == Token::Type::symbol;
    };
    return (a.type == b.type || (is_text(a) && is_text(b))) && a.text == b.text && a.strokes == b.strokes &&
           a.label == b.label && a.own == b.own;
  }
  /// A predicate by itself has a box without declarations in ISO's mark-up, and none in Spivey's.
  static void drop_where(std::vector<Token>& tokens) {
    if (!tokens.empty() && tokens.front().is("|")) tokens.erase(tokens.begin());
  }
  /// The place of the first paragraph that is another when it is read again; nothing where all are the same.
  static std::optional<Place> other_tree(const BlockPiece& piece, const std::string& environment,
                                         const std::vector<Token>& after, bool spivey) {
    if (piece.block.environment == "zsection") return {};  // its tokens are all of it
    std::vector<Paragraph> again;
    try {
      std::vector<ZError> mended;
      if (!after.empty()) again = parse_block(environment, after, mended, spivey);
    } catch (const ZError&) {  // then none is read, and the first is another
    }
    const auto [left, right] =
        std::mismatch(piece.paragraphs.begin(), piece.paragraphs.end(), again.begin(), again.end());
    if (left == piece.paragraphs.end() && right == again.end()) return {};
    return left == piece.paragraphs.end() ? piece.block.begin : left->place;
  }
  [[noreturn]] void refuse(Place place, const std::string& what) const {
    const bool line = what.empty() || what == "\n";
    throw ZError(place, (line ? "what ends here" : what) + std::string(" cannot be written in ") + in_words(to_),
                 "expected it in another form, or a directive %%Zchar or %%Zword that names it");
  }

  /// All of what was written is cut into as many paragraphs as were written, in their mark-up.
  void agree() {
    if (count_ == 0)
      throw ZError({1, 1}, "a section without a paragraph cannot be written in " + in_words(to_),
                   "expected one or more");
    if (to_ == Form::spivey && form_of(out_) != to_) out_.insert(0, spivey_sign);
    if (out_.size() > max_bytes)
      throw ZError({1, 1}, "the text would be too large to be read", "expected one of less than a MiB when written");
    if (cut_of(out_).size() != count_ || form_of(out_) != to_)
      throw ZError({1, 1}, "the prose would be read as Z in the other mark-up", "expected prose without its signs");
    if (to_ == Form::spivey) agree_as_a_whole();
  }

  /// Spivey's Z is known by signs, and has own readings of them, all over a text: it is read again as a whole.
  void agree_as_a_whole() const {
    const Specification again = read_text(out_, "the text in Spivey's Z");
    const Section* const before = read_.find(section_);
    if (before == nullptr || again.sections.empty()) return;
    const std::vector<Paragraph>&expected = before->paragraphs, &found = again.sections.back().paragraphs;
    const auto [left, right] = std::mismatch(expected.begin(), expected.end(), found.begin(), found.end());
    if (left != expected.end()) refuse(left->place, "this paragraph");
    if (right != found.end() || !again.ok()) refuse({1, 1}, "this text");
  }

  /// A line that LaTeX and fuzz pass over, and by which a text is known.
  static constexpr std::string_view spivey_sign = "%% \\usepackage{fuzz}\n";

  std::string_view text_;
  Form to_;
  const Specification& read_;
  std::size_t at_ = 0;
  std::size_t count_ = 0;  // paragraphs that were written
  SchemaNames schemas_;    // of the text so far
  std::string section_ = "Specification", out_;
};

}  // namespace

Form form_of(std::string_view text) {
  return is_unicode(text) ? Form::unicode : spivey_text(text) ? Form::spivey : Form::latex;
}

std::string converted(std::string_view text, Form to, const Specification& read) {
  return form_of(text) == to ? std::string(text) : TextWriter(text, to, read).run();
}

}  // namespace durero::zed
