/// Renames by the occurrences of a referent. That nothing is captured is not derived: what was written is read, and its
/// names are compared.

#include "durero/zed/names/rename.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <ranges>

#include "zed/names/tokenized_block.hpp"
#include "zed/print/spelling.hpp"
#include "zed/syntax/lexer.hpp"
#include "zed/syntax/token_stream.hpp"

namespace durero::zed {
namespace {

const Markup& markup_of(const CheckedTexts& of, const std::string& section) {
  static const Markup none;
  const auto at = of.read.markup.find(section);
  return at == of.read.markup.end() ? none : at->second;
}

/// Reads a new name as one word; it may have the sign and the strokes of the occurrence.
std::string word_of(const CheckedTexts& of, const Occurrence& occurrence, const std::string& typed) {
  const Markup& markup = markup_of(of, occurrence.section);
  const auto operators = of.read.operators.find(occurrence.section);
  static const Operators none;
  const Operators& known = operators == of.read.operators.end() ? none : operators->second;
  Block block;
  block.environment = "zed";
  block.body = typed;
  block.place = {1, 1};
  const bool latex = typed.find('\\') != typed.npos;
  const std::vector<Token> tokens = latex ? lex_latex(block, markup, known) : lex_unicode(typed, known);
  const auto refuse = [&](const char* what) { throw ZError(occurrence.place, typed + what, "expected one name"); };
  if (tokens.size() != 2 || tokens[1].type != Token::Type::end) refuse(" is no word of Z");
  if (!TokenStream::is_name(tokens[0])) refuse(" has a meaning in Z");
  if (!tokens[0].strokes.empty() && tokens[0].strokes != occurrence.name.strokes)
    throw ZError(occurrence.place, typed + " has other strokes than " + occurrence.name.text(),
                 "expected a name without strokes, as each place keeps its own");
  std::string word = tokens[0].text;
  if (!occurrence.sign.empty() && word.starts_with(occurrence.sign) && word != occurrence.sign)
    word.erase(0, occurrence.sign.size());
  return word;
}

/// Spells a name as the text around it is written.
std::string spelled(const Name& name, const Markup& markup, bool unicode, std::string_view before) {
  Token token;
  token.type = Token::Type::word;
  token.text = name.word;
  token.strokes = name.strokes;
  if (!unicode) return Spelling(markup).latex(token, true);
  std::string text = Spelling::unicode(token);
  static constexpr std::string_view prime = "′";
  if (before.find('\'') == before.npos) return text;
  for (std::size_t at = text.find(prime); at != text.npos; at = text.find(prime, at))
    text.replace(at, prime.size(), "'");
  return text;
}

/// The renaming of one referent.
class ReferentRenaming {
 public:
  ReferentRenaming(const CheckedTexts& of, const CrossReference& names, std::size_t referent, std::string word)
      : of_(of), names_(names), referent_(referent), word_(std::move(word)) {}

  std::map<std::string, std::vector<Replacement>> replacements() const {
    std::map<std::string, std::vector<Replacement>> all;
    for (const auto& [file, occurrences] : names_.files) {
      const std::string& text = of_.texts.at(file);
      const bool unicode = is_unicode(text);
      for (const Occurrence& each : occurrences) {
        if (each.referent != referent_) continue;
        const Name now = renamed_name(each);
        const std::string_view before = std::string_view(text).substr(each.from, each.to - each.from);
        all[file].push_back({each.from, each.to, spelled(now, markup_of(of_, each.section), unicode, before)});
      }
    }
    return all;
  }

  /// Refuses a renamed text in which a name has another referent than before.
  void compare(const CheckedTexts& after) const {
    if (!after.ok()) {
      const Defect& first = after.read.ok() ? after.typing.defects.front() : after.read.defects.front();
      throw ZError(first.place, fmt::format("with the name {}, {}", word_, first.what), "expected another name");
    }
    const CrossReference now = cross_reference(after);
    std::map<std::size_t, std::size_t> there, back;
    for (const auto& [file, before] : names_.files) {
      const auto behind = now.files.find(file);
      if (behind == now.files.end() || behind->second.size() != before.size()) refuse({});
      for (std::size_t i = 0; i < before.size(); ++i)
        if (!is_same(before[i], behind->second[i], there, back)) refuse(before[i]);
    }
    if (!now.complete) refuse({});
  }

 private:
  Name renamed_name(const Occurrence& of) const { return {of.sign + word_, of.name.strokes}; }

  bool is_same(const Occurrence& was, const Occurrence& is, std::map<std::size_t, std::size_t>& there,
               std::map<std::size_t, std::size_t>& back) const {
    const Name expected = was.referent == referent_ ? renamed_name(was) : was.name;
    if (is.name != expected || is.declares != was.declares || is.sign != was.sign ||
        is.referent.has_value() != was.referent.has_value())
      return false;
    if (!was.referent) return true;
    return there.emplace(*was.referent, *is.referent).first->second == *is.referent &&
           back.emplace(*is.referent, *was.referent).first->second == *was.referent;
  }

  [[noreturn]] void refuse(const Occurrence& at) const {
    throw ZError(at.place, fmt::format("with the name {}, {} would stand for something else", word_, at.name.text()),
                 "expected a name that nothing in scope has");
  }

  const CheckedTexts& of_;
  const CrossReference& names_;
  std::size_t referent_;
  std::string word_;
};

}  // namespace

std::string replaced(std::string_view text, const std::vector<Replacement>& replacements) {
  std::string made;
  std::size_t at = 0;
  for (const Replacement& each : replacements) {
    made += text.substr(at, each.from - at);
    made += each.text;
    at = each.to;
  }
  return made += text.substr(at);
}

std::string word_to_rename(const CheckedTexts& of, const CrossReference& names, const Occurrence& occurrence) {
  const auto refuse = [&](const std::string& what, const char* expected) {
    throw ZError(occurrence.place, what, expected);
  };
  const std::string name = occurrence.name.text();
  if (occurrence.is_operator) refuse(name + " is an operator", "expected a name to rename");
  if (!occurrence.referent) refuse(name + " is not declared", "expected a declared name to rename");
  if (names.referents[*occurrence.referent].form == Referent::Form::toolkit)
    refuse(name + " is a name of the toolkit", "expected a name that the text declares");
  if (!of.ok() || !names.complete)
    refuse("the text has errors", "expected one that is read and typed, to rename in it");
  return occurrence.name.word.substr(occurrence.sign.size());
}

std::map<std::string, std::vector<Replacement>> renamed(const CheckedTexts& of, const CrossReference& names,
                                                        const Occurrence& occurrence, const std::string& to) {
  const std::string word = word_to_rename(of, names, occurrence);
  const std::string wanted = word_of(of, occurrence, to);
  if (wanted == word) return {};
  const ReferentRenaming renaming(of, names, *occurrence.referent, wanted);
  auto replacements = renaming.replacements();
  std::map<std::string, std::string> texts = of.texts;
  for (const auto& [file, edits] : replacements) texts[file] = replaced(texts[file], edits);
  renaming.compare(checked(std::move(texts)));
  return replacements;
}

}  // namespace durero::zed
