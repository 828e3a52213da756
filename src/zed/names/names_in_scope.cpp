/// The scope at a place is found by reading the text with a name of its own there: where the walk meets that name, its
/// scopes are those of the place.

#include "durero/zed/names/names_in_scope.hpp"

#include <algorithm>
#include <ranges>
#include <set>

#include "zed/names/name_walk.hpp"
#include "zed/operators.hpp"
#include "zed/syntax/characters.hpp"
#include "zed/syntax/symbols.hpp"
#include "zed/syntax/token_stream.hpp"

namespace durero::zed {
namespace {

/// A word that stands nowhere in a text.
std::string absent_word(const std::string& text) {
  std::string word = "placeholder";
  while (text.find(word) != text.npos) word += 'z';
  return word;
}

/// Collects names, each once.
class VisibleNames {
 public:
  explicit VisibleNames(const CheckedTexts& of) : of_(of) {}

  void add(const Name& name, Referent::Form form, std::optional<Type> type) {
    if (seen_.insert(name).second) names_.push_back({name, form, std::move(type)});
  }
  void scopes(const std::vector<NameScope>& scopes) {
    for (const NameScope& scope : std::views::reverse(scopes))
      for (const ScopedName& each : scope) add(each.name, Referent::Form::variable, each.type);
  }
  void components(const Type& schema) {
    for (std::size_t i = 0; i < schema.fields().size(); ++i)
      add(schema.fields()[i], Referent::Form::component, schema.parts()[i]);
  }
  /// Adds the globals that a section sees in a block: those of its own file stand before its end.
  void globals(const TokenizedBlock& block, const std::string& file) {
    const auto scope = of_.typing.scopes.find(block.section);
    if (scope == of_.typing.scopes.end()) return;
    std::map<Name, const Global*> sorted;
    for (const auto& [name, global] : scope->second) sorted.emplace(name, global.get());
    for (const auto& [name, global] : sorted) {
      const bool behind = global->file == file && global->place.line > block.block.end.line;
      if (!behind && !is_operator_name(name.word)) add(name, Referent::Form::global, global->scheme.type);
    }
  }
  /// Adds what the tokens of a paragraph that cannot be read declare: names before a colon, and the components of the
  /// schemas that are named.
  void tokens(const TokenizedBlock& block) {
    for (std::size_t i = 0; i + 1 < block.tokens.size(); ++i) {
      const Token& token = block.tokens[i];
      if (!TokenStream::is_name(token)) continue;
      const Name name{token.text, token.strokes};
      const Token& behind = block.tokens[i + 1];
      if (behind.is(":") || behind.is(",") || behind.is("==")) add(name, Referent::Form::variable, std::nullopt);
      if (const Global* schema = named_schema(block.section, name)) components_in_state(token, schema->scheme.type);
    }
  }
  std::vector<VisibleName> take() { return std::move(names_); }

 private:
  static std::string_view sign_of(const Token& token) {
    for (const std::string_view sign : {"Δ", "Ξ"})
      if (token.text.starts_with(sign) && token.text.size() > sign.size()) return sign;
    return {};
  }
  const Global* named_schema(const std::string& section, const Name& name) const {
    const Global* global = of_.typing.find(section, name);
    for (const std::string_view sign : {"Δ", "Ξ"})
      if (!global && name.word.starts_with(sign) && name.word.size() > sign.size())
        global = of_.typing.find(section, {name.word.substr(sign.size()), name.strokes});
    return global && global->scheme.type.is_schema_set() ? global : nullptr;
  }
  void components_in_state(const Token& token, const Type& schema) {
    const Type& binding = schema.parts()[0];
    components(binding);
    if (sign_of(token).empty()) return;
    for (std::size_t i = 0; i < binding.fields().size(); ++i)
      add({binding.fields()[i].word, binding.fields()[i].strokes + "'"}, Referent::Form::component, binding.parts()[i]);
  }

  const CheckedTexts& of_;
  std::set<Name> seen_;
  std::vector<VisibleName> names_;
};

const TokenizedBlock* block_at(const std::vector<TokenizedBlock>& blocks, std::size_t byte) {
  for (const TokenizedBlock& each : blocks)
    if (each.offset <= byte && byte <= each.offset + each.block.body.size()) return &each;
  return nullptr;
}

}  // namespace

std::optional<std::vector<VisibleName>> names_in_scope(const std::map<std::string, std::string>& texts,
                                                       const std::string& file, std::size_t from, std::size_t to) {
  std::map<std::string, std::string> with_word = texts;
  std::string& text = with_word.at(file);
  const std::string word = absent_word(text);
  text.replace(from, to - from, word);
  const CheckedTexts of = checked(std::move(with_word));
  const std::vector<TokenizedBlock> blocks = tokenized(of.texts.at(file), of.read);
  const TokenizedBlock* block = block_at(blocks, from);
  if (!block || block->is_header()) return std::nullopt;
  VisibleNames names(of);
  bool selects = false, met = false;
  NameWalk walk(of, [&](const Term& term, const std::vector<NameScope>& scopes) {
    if (term->name.word != word) return;
    met = true;
    if (term->kind == Kind::reference) return names.scopes(scopes);
    selects = term->kind == Kind::selection;
    const auto binding = selects ? of.typing.type_of(term->children[0]) : std::nullopt;
    if (binding && binding->is(Type::Kind::schema)) names.components(*binding);
  });
  if (const Section* own = of.read.find(block->section)) walk.section(*own, blocks);
  if (selects) return names.take();
  if (!met) names.tokens(*block);
  names.globals(*block, file);
  std::vector<VisibleName> found = names.take();
  std::erase_if(found, [&](const VisibleName& each) { return each.name.word == word; });
  return found;
}

std::vector<std::string> plain_toolkit_names() {
  std::vector<std::string> names;
  for (const OperatorRow& row : operator_rows())
    if (row.command.empty() && is_letter(row.symbol().front())) names.emplace_back(row.symbol());
  return names;
}

std::vector<std::pair<std::string, std::string>> latex_commands(const Specification& read, const std::string& section) {
  std::map<std::string, std::string> commands;
  if (const auto own = read.markup.find(section); own != read.markup.end())
    commands.insert(own->second.begin(), own->second.end());
  for (const auto& [command, unicode] : command_spellings())
    if (is_letter(command.front())) commands.emplace(command, unicode);
  return {commands.begin(), commands.end()};
}

}  // namespace durero::zed
