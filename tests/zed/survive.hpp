#pragma once
/// What the reader owes to any input whatever: it ends, in one piece, and what it read it can print and read again.

#include <stdexcept>
#include <string>
#include <string_view>

#include "durero/zed/print/convert.hpp"
#include "durero/zed/print/print.hpp"
#include "durero/zed/review/review.hpp"
#include "durero/zed/syntax/parser.hpp"

namespace durero::zed::test {

inline void survive_term(std::string_view text) {
  Term term;
  try {
    term = parse_unicode(text);
  } catch (const ZError&) {
    return;
  }
  if (parse_unicode(to_unicode(term)) != term) throw std::logic_error("printed as another term: " + to_unicode(term));
  check_term(Typing(), "", term);
}

inline void survive_paragraph(const Paragraph& paragraph, const Operators& operators) {
  const auto* type = std::get_if<FreeType>(&paragraph.form);
  if (type && type->joined) return;  // is printed as one of its own
  if (parse_unicode_paragraph(to_unicode(paragraph), operators) != paragraph)
    throw std::logic_error("printed as another paragraph: " + to_unicode(paragraph));
}

/// What was written in another mark-up is read as what it was written from, or refused.
inline Specification survive_conversion(const std::string& from, const Specification& read, Form to,
                                        std::string& written) {
  written = converted(from, to, read);
  Specification again = read_text(written, "no-such-folder/input.tex");
  bool same = again.ok() && again.sections.size() == read.sections.size();
  for (std::size_t i = 0; same && i < read.sections.size(); ++i)
    same =
        again.sections[i].name == read.sections[i].name && again.sections[i].paragraphs == read.sections[i].paragraphs;
  if (!same) throw std::logic_error("written as another text: " + written);
  return again;
}

/// A text in Unicode is the same again after a way to LaTeX and back, where it came from LaTeX itself.
inline void survive_conversions(const std::string& text, const Specification& read) {
  const bool latex = form_of(text) == Form::latex;
  std::string first, back, again;
  Specification second;
  try {
    second = survive_conversion(text, read, latex ? Form::unicode : Form::latex, first);
  } catch (const ZError&) {
    return;
  }
  if (!latex) return;
  try {
    const Specification third = survive_conversion(first, second, Form::latex, back);
    survive_conversion(back, third, Form::unicode, again);
  } catch (const ZError& error) {
    if (error.what_is_wrong.find("too large") != std::string::npos) return;  // LaTeX is the longer
    throw std::logic_error(std::string("no way back: ") + error.what() + ": " + first);
  }
  if (again != first) throw std::logic_error("another text after a way to LaTeX and back: " + first);
}

/// The text as a file of Z in LaTeX mark-up, and as an expression in Unicode. Throws std::logic_error where the reader
/// breaks its word; a text that is refused is none of that.
inline void survive(const std::string& text) {
  survive_term(text);
  const Specification read = read_text(text, "no-such-folder/input.tex");
  for (const Section& section : read.sections)
    for (const Paragraph& paragraph : section.paragraphs) survive_paragraph(paragraph, read.operators.at(section.name));
  if (read.ok() && !read.sections.empty()) survive_conversions(text, read);
  for (const Defect& defect : review(read))
    if (defect.text().empty()) throw std::logic_error("a defect without a text");
}

}  // namespace durero::zed::test
