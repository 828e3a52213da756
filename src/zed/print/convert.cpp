/// Writes a text token by token in the other mark-up. That it says the same is not believed: what was written is read.

#include "durero/zed/print/convert.hpp"

#include <algorithm>
#include <utility>

#include "durero/text/utf8.hpp"
#include "zed/print/block_writer.hpp"
#include "zed/syntax/bag_toolkit.hpp"
#include "zed/syntax/block_parser.hpp"
#include "zed/syntax/cursor.hpp"
#include "zed/syntax/lexer.hpp"

namespace durero::zed {
namespace {

/// Writes a text: its prose, and each paragraph between.
class TextWriter {
 public:
  TextWriter(std::string_view text, Form to, const Specification& read) : text_(text), to_(to), read_(read) {}

  std::string run() {
    const std::vector<Block> blocks = cut_of(text_);
    for (const Block& block : blocks) {
      prose(start_of(block));
      if (!out_.empty() && out_.back() != '\n') out_ += '\n';
      if (block.spivey) say_in_iso(block, &block == &blocks.front());
      const std::size_t from = out_.size();
      out_ += in_other_form(block, dialect(block));
      compare(block, std::string_view(out_).substr(from));
      at_ = end_of(block);
    }
    prose(text_.size());
    if (!blocks.empty()) agree(blocks.size() + added_);
    return std::move(out_);
  }

 private:
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

  /// Writes what Spivey's Z says without a paragraph, or does not say: the bags among the parents, and the templates of
  /// its operators. ISO has no place for a constraint in a zed.
  void say_in_iso(const Block& block, bool is_first) {
    if (is_first && block.spivey->has_bags)
      add_paragraph("section Specification parents standard_toolkit, " + std::string(bag_toolkit));
    for (const OperatorTemplate& op : block.operators) {
      const std::string kind = op.role == Role::function  ? "function"
                               : op.role == Role::generic ? "generic"
                                                          : "relation";
      const bool binds = op.role != Role::relation && op.has_left() && op.has_right();
      const std::string strength =
          binds ? std::to_string(op.precedence) + (op.right ? " rightassoc " : " leftassoc ") : "";
      add_paragraph(kind + " " + strength + "(" + op.name() + ")");
    }
    if (block.environment != "zed") return;
    const Dialect by = dialect(block);
    std::vector<ZError> mended;
    for (const Paragraph& paragraph : parse_block("zed", lex(block, by.markup, by.operators), mended, true))
      if (const auto* const box = std::get_if<Axiomatic>(&paragraph.form))
        if (box->text.declarations.empty())
          throw ZError(paragraph.place, "a predicate by itself cannot be written in ISO's mark-up",
                       "expected it in an axdef");
  }
  void add_paragraph(const std::string& text) {
    out_ += "─ " + text + " └\n";
    ++added_;
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

  /// Reads what was written for a block, and asks that it is the same. The place is that of the first token which is
  /// another.
  void compare(const Block& block, std::string_view written) {
    const Dialect by = dialect(block);
    const std::vector<Token> before = tokens_of(block, by);
    const std::vector<Block> again = cut_of(written);
    std::vector<Token> after;
    if (again.size() == 1 && again[0].environment == block.environment) after = tokens_of(again[0], by);
    const auto [left, right] = std::mismatch(before.begin(), before.end(), after.begin(), after.end(), is_same);
    if (left != before.end()) refuse(left->place, left->text);
    if (right != after.end() || !same_trees(block, before, after)) refuse(block.begin, "this paragraph");
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
  static bool same_trees(const Block& block, const std::vector<Token>& before, const std::vector<Token>& after) {
    if (block.environment == "zsection") return true;  // its tokens are all of it
    std::vector<ZError> mended;
    return parse_block(block.environment, before, mended, block.spivey != nullptr) ==
           parse_block(block.environment, after, mended);
  }
  [[noreturn]] void refuse(Place place, const std::string& what) const {
    const bool line = what.empty() || what == "\n";
    throw ZError(place,
                 (line ? "what ends here" : what) + std::string(" cannot be written in ") +
                     (to_ == Form::latex ? "LaTeX mark-up" : "Unicode"),
                 "expected it in another form, or a directive %%Zchar or %%Zword that names it");
  }

  /// All of what was written is cut into as many paragraphs as there were.
  void agree(std::size_t count) const {
    if (out_.size() > max_bytes)
      throw ZError({1, 1}, "the text would be too large to be read", "expected one of less than a MiB when written");
    if (cut_of(out_).size() != count || form_of(out_) != to_)
      throw ZError({1, 1}, "the prose would be read as Z in the other mark-up", "expected prose without its signs");
  }

  std::string_view text_;
  Form to_;
  const Specification& read_;
  std::size_t at_ = 0;
  std::size_t added_ = 0;  // paragraphs that the text says otherwise
  std::string section_ = "Specification", out_;
};

}  // namespace

Form form_of(std::string_view text) { return is_unicode(text) ? Form::unicode : Form::latex; }

bool is_iso(std::string_view text) { return is_unicode(text) || !spivey_text(text); }

std::string converted(std::string_view text, Form to, const Specification& read) {
  if (form_of(text) != to) return TextWriter(text, to, read).run();
  if (is_iso(text)) return std::string(text);
  const std::string unicode = TextWriter(text, Form::unicode, read).run();
  return TextWriter(unicode, to, read_text(unicode, "the text in Unicode")).run();
}

}  // namespace durero::zed
