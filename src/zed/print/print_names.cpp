/// Prints names and symbols, each as it is spelled in the mark-up.

#include <algorithm>

#include "durero/text/utf8.hpp"
#include "zed/print/printer.hpp"
#include "zed/syntax/symbols.hpp"

namespace durero::zed {

void Printer::space() {
  if (out_.empty() || out_.back() == ' ' || out_.back() == '~' || out_.back() == '\n') return;
  for (const std::string_view open : {"(", "[", "{", "⟨"})
    if (out_.ends_with(open)) return;
  out_ += ' ';
}

std::string Printer::letters(std::string_view word) const {
  std::string text;
  while (!word.empty()) {
    const std::string_view character = text::first(word);
    word.remove_prefix(character.size());
    if (character == "_") {
      text += "\\_";
    } else if (character == "↘" || character == "↗") {
      while (text.ends_with(' ')) text.pop_back();
      text += character == "↘" ? "_{" : "^{";
    } else if (character == "↖" || character == "↙") {
      text += '}';
    } else if (const auto own = own_.find(character); own != own_.end()) {
      text += own->second + " ";
    } else if (is_letter_symbol(character)) {
      text += std::string(*latex_of(character)) + " ";
    } else {
      text += character;
    }
  }
  while (text.ends_with(' ')) text.pop_back();
  return text;
}

std::string Printer::spelled(std::string_view unicode) const {
  if (!latex_) return std::string(unicode);
  std::string_view base = unicode;
  std::string index;
  if (unicode.size() > 3 && unicode.ends_with("₁")) {
    base.remove_suffix(std::string_view("₁").size());
    index = "_1";
  }
  if (const auto own = own_.find(base); own != own_.end()) return own->second + index;
  if (unicode == "+" || unicode == "-" || unicode == "*") return std::string(unicode);
  if (const auto known = latex_of(base)) return std::string(*known) + index;
  return letters(base) + index;
}

void Printer::symbol(std::string_view unicode) {
  space();
  tight(unicode);
}

void Printer::tight(std::string_view unicode) { out_ += spelled(unicode); }

void Printer::name(const Name& name) {
  if (is_template_name(name.word)) {
    space();
    out_ += '(';
    declared(name);
    out_ += ')';
    return;
  }
  if (is_operator_name(name.word)) {
    space();
    out_ += '(';
    std::string_view rest = name.word;
    while (!rest.empty()) {
      const bool hole = rest[0] == '_';
      const std::string_view part = hole ? rest.substr(0, 1) : rest.substr(0, rest.find('_'));
      part == "↗" || part == "↙" ? enclosing(part) : symbol(part);
      rest.remove_prefix(part.size());
    }
    out_ += ')';
    return;
  }
  symbol(name.word);
  strokes(name.strokes);
}

void Printer::strokes(std::string_view rest) {
  while (!rest.empty()) {
    const std::string_view character = text::first(rest);
    rest.remove_prefix(character.size());
    if (latex_ && character.size() > 1) {
      out_ += "_";
      out_ += static_cast<char>('0' + (static_cast<unsigned char>(character.back()) & 0x0F));  // ₀ is U+2080
    } else {
      out_ += character;
    }
  }
}

void Printer::names(const std::vector<Name>& listed) {
  for (std::size_t i = 0; i < listed.size(); ++i) {
    if (i > 0) out_ += ',';
    declared(listed[i]);
  }
}

void Printer::declared(const Name& declared, const std::vector<Name>& formals) {
  if (!is_template_name(declared.word)) return name(declared);
  std::size_t operand = 0;
  for (std::string_view rest = declared.word; !rest.empty();) {
    const std::string_view part = rest.substr(0, rest.find(' '));
    rest.remove_prefix(std::min(part.size() + 1, rest.size()));
    if (part == "_" && operand < formals.size()) {
      name(formals[operand++]);
    } else {
      symbol(part);
    }
    if (!rest.empty()) out_ += latex_ ? '~' : ' ';  // a blank of LaTeX would join two words
  }
}

}  // namespace durero::zed
