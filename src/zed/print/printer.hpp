#pragma once
/// The printer prints terms and schema texts, for print.cpp. What operators make is printed in print_operations.cpp,
/// and names and symbols are in print_names.cpp.

#include <map>
#include <string>
#include <vector>

#include "durero/zed/syntax/ast.hpp"
#include "durero/zed/syntax/markup.hpp"

namespace durero::zed {

class Printer {
 public:
  /// Prints Unicode where `markup` is null, else LaTeX.
  explicit Printer(const Markup* markup);

  /// A term that binds less tightly than `least` (connectives.hpp) gets parentheses. `last` says that nothing follows
  /// that a quantifier, whose body reaches as far as it can, would take in.
  void term(const Term& term, int least, bool last = true);
  void schema_text(const SchemaText& text);  ///< prints it on one line
  void declaration(const Declaration& declaration);
  void name(const Name& name);
  void names(const std::vector<Name>& names);
  /// Prints a name as it is declared: an operator of a template without parentheses, with the formals for operands.
  void declared(const Name& name, const std::vector<Name>& formals = {});
  void symbol(std::string_view unicode);  ///< prints a space before it, where it needs one
  void tight(std::string_view unicode);   ///< prints no space before it
  void strokes(std::string_view rest);    ///< prints them as those of a name
  void raw(std::string_view text) { out_ += text; }

  std::string take() { return std::move(out_); }

 private:
  void bare(const Node& node, bool last);
  void quantified(const Node& node, std::string_view sign, bool last);
  void infix(const Node& node, std::string_view symbol, int left, int right, bool last);
  void application(const Node& node, bool last);
  void enclosing(std::string_view sign);
  void reference(const Node& node, bool last);
  void relation(const Node& node, bool last);
  void conditional(const Node& node, bool last);
  void theta(const Node& node);
  void decoration(const std::string& strokes);
  void suffixed(const Node& node);
  void list(std::string_view open, const std::vector<Term>& terms, std::string_view close);
  void braces(const Node& node);
  std::string spelled(std::string_view unicode) const;
  std::string letters(std::string_view word) const;
  void space();

  bool latex_;
  std::map<std::string, std::string, std::less<>> own_;  // a character leads to its command
  std::string out_;
};

}  // namespace durero::zed
