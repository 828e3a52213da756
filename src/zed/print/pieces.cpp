#include "zed/print/pieces.hpp"

#include <utility>

#include "zed/syntax/block_parser.hpp"
#include "zed/syntax/lexer.hpp"

namespace durero::zed {
namespace {

/// Cuts the tokens of a `zed` block. A line end inside of brackets separates no paragraphs, so a line that does not
/// parse takes the next one in.
class PieceCutter {
 public:
  PieceCutter(const Block& block, const Dialect& dialect)
      : block_(block), tokens_(lex(block, dialect.markup, dialect.operators)) {}

  std::vector<BlockPiece> run() {
    for (std::size_t from = 0; from + 1 < tokens_.size();) from = take_line(from);
    return std::move(pieces_);
  }

 private:
  /// Takes the paragraphs of the shortest run of lines from a token on that can be parsed, and returns where the next
  /// begins.
  std::size_t take_line(std::size_t from) {
    for (std::size_t to = line_end(from);; to = line_end(to + 1)) {
      const bool is_last = to + 1 >= tokens_.size();
      try {
        add(from, parsed(from, to));
      } catch (const ZError&) {
        if (is_last) throw;
        continue;
      }
      return is_last ? tokens_.size() : to + 1;
    }
  }

  std::size_t line_end(std::size_t at) const {
    while (at + 1 < tokens_.size() && tokens_[at].type != Token::Type::newline) ++at;
    return at;
  }

  std::vector<Paragraph> parsed(std::size_t from, std::size_t to) const {
    std::vector<Token> line(tokens_.begin() + static_cast<std::ptrdiff_t>(from),
                            tokens_.begin() + static_cast<std::ptrdiff_t>(to));
    line.push_back(tokens_.back().type == Token::Type::error && to + 1 == tokens_.size() ? tokens_.back() : Token{});
    line.back().place = tokens_[to].place;
    std::vector<ZError> mended;
    return parse_block("zed", line, mended, block_.spivey != nullptr);
  }

  static Share share_of(const std::vector<Paragraph>& paragraphs) {
    if (paragraphs.empty()) return Share::operators;
    const auto& form = paragraphs.front().form;
    if (std::holds_alternative<Conjecture>(form)) return Share::claim;
    return std::holds_alternative<Axiomatic>(form) ? Share::constraint : Share::plain;
  }

  void add(std::size_t from, std::vector<Paragraph> paragraphs) {
    const Share share = share_of(paragraphs);
    if (share == Share::plain && !pieces_.empty() && pieces_.back().share == Share::plain) {
      for (Paragraph& paragraph : paragraphs) pieces_.back().paragraphs.push_back(std::move(paragraph));
      return;
    }
    BlockPiece piece{block_, share, std::move(paragraphs)};
    if (!pieces_.empty()) {
      const std::size_t begin = tokens_[from].from;
      Block& before = pieces_.back().block;
      before.body = block_.body.substr(begin_, begin - begin_);
      piece.block.body = block_.body.substr(begin);
      piece.block.begin = piece.block.place = tokens_[from].place;
      begin_ = begin;
    }
    pieces_.push_back(std::move(piece));
  }

  const Block& block_;
  std::vector<Token> tokens_;
  std::vector<BlockPiece> pieces_;
  std::size_t begin_ = 0;  // the last piece begins at this byte of the body
};

}  // namespace

std::vector<BlockPiece> pieces_of(const Block& block, const Dialect& dialect) {
  if (block.environment == "zed") return PieceCutter(block, dialect).run();
  std::vector<ZError> mended;
  return {
      {block, Share::plain,
       parse_block(block.environment, lex(block, dialect.markup, dialect.operators), mended, block.spivey != nullptr)}};
}

}  // namespace durero::zed
