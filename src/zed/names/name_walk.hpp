#pragma once
/// A walk over the trees of a section in the order of the text, beside the tokens that they were read from: so each
/// name of a tree meets its token. Paragraphs are walked in paragraph_walk.cpp, expressions in
/// name_walk.cpp, and schemas in schema_walk.cpp.

#include <functional>
#include <map>
#include <string>
#include <unordered_set>
#include <vector>

#include "zed/names/referent_table.hpp"
#include "zed/names/tokenized_block.hpp"

namespace durero::zed {

/// A name in a scope, with its type where that is known.
struct ScopedName {
  Name name;
  std::size_t referent;
  std::optional<Type> type;
};
/// A scope has each name once.
using NameScope = std::vector<ScopedName>;

class NameWalk {
 public:
  /// Is told of each term, as the walk reaches it, with the scopes there, the innermost last.
  using Observer = std::function<void(const Term& term, const std::vector<NameScope>& scopes)>;

  explicit NameWalk(const CheckedTexts& of, Observer observer = {})
      : read_(of.read), typing_(of.typing), observer_(std::move(observer)) {}

  /// Walks the paragraphs of a section that stand in these blocks of its file. Parents go before their children.
  void section(const Section& section, const std::vector<TokenizedBlock>& blocks);

  /// Returns what was found: the referents of a file, and whether each name met its token.
  CrossReference take();

 private:
  struct Meaning {
    std::optional<std::size_t> referent;
    std::optional<ComponentReferents> components;  // of a schema
    std::string sign;
  };

  void block(const TokenizedBlock& block);
  void paragraph(const Paragraph& paragraph);
  void paragraph(const GivenTypes& given, Place place);
  void paragraph(const FreeType& type, Place place);
  void paragraph(const Definition& definition, Place place);
  void paragraph(const Axiomatic& box, Place place);
  void paragraph(const Schema& box, Place place);
  void paragraph(const Conjecture& conjecture, Place place);
  void formals(const std::vector<Name>& names);
  Meaning declared_global(const Name& name, Place place);
  void declare_global(const Name& name, Place place);
  void declare_operator(const Name& name, Place place);
  void rest_of_names();
  void operator_tokens(const TokenizedBlock& block);

  std::optional<ComponentReferents> term(const Term& term);
  void predicate(const Term& term);
  void predicates(const SchemaText& text);
  void children(const Node& node);
  void quantified(const Node& node, bool of_predicates);
  std::optional<ComponentReferents> reference(const Term& term);
  void selection(const Node& node);
  void binding_extension(const Term& term);
  void theta(const Node& node);

  /// The components of a schema: those that the walk finds, or those of its type.
  ComponentReferents schema(const Term& term);
  ComponentReferents schema_of(const Node& node);
  ComponentReferents renaming(const Node& node);
  ComponentReferents hiding(const Node& node);
  ComponentReferents joined(const Node& node, const std::string& left_stroke, const std::string& right_stroke);
  ComponentReferents schema_quantifier(const Node& node);
  ComponentReferents merged(ComponentReferents to, const ComponentReferents& more);
  /// The components of a schema that stands as a predicate, or behind θ, are those of the scope.
  void link(const ComponentReferents& components, const std::string& strokes = {});
  /// What a schema text declares.
  NameScope signature(const SchemaText& text, Referent::Form form);
  void declare(const Declaration& declaration, Referent::Form form, NameScope& to);
  void join(NameScope& scope, ScopedName name);
  static ComponentReferents components_of(const NameScope& scope);

  Meaning meaning_of(const Name& name);
  std::size_t global(const Global& of);
  std::size_t toolkit_name(const Name& name);
  std::optional<Type> field_type(const Term& schema, const Name& name) const;

  /// Takes the token of a name: the next one, or that at a place. Null where the tree and the tokens disagree.
  const Token* take_token(const Name& name, Place place = {});
  void note(const Token* token, const Name& name, Meaning meaning, std::optional<Type> type, bool declares);

  const Specification& read_;
  const Typing& typing_;
  Observer observer_;
  ReferentTable table_;
  CrossReference found_;
  std::map<const Global*, std::size_t> globals_;
  std::map<const Global*, ComponentReferents> schemas_;
  std::map<Name, std::size_t> toolkit_names_;
  std::vector<NameScope> scopes_;

  const Section* section_ = nullptr;
  const TokenizedBlock* block_ = nullptr;
  std::vector<const Token*> names_;          // those of the block, in order
  std::vector<bool> taken_;                  // in step with them
  std::size_t next_ = 0;                     // the first of them that the walk did not pass yet
  std::size_t first_ = 0;                    // the first occurrence of the block
  std::vector<Occurrence>* into_ = nullptr;  // those of the file
  bool chained_ = false;                     // an operator of the text is in the block: a term may stand in two links
  std::unordered_set<const Node*> passed_;   // then, the terms that were walked
};

}  // namespace durero::zed
