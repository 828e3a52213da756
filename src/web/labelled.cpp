#include "labelled.hpp"

#include <variant>

#include "durero/zed/print/print.hpp"

namespace durero::web {
namespace {

std::string declaration_text(const zed::Declaration& declaration) {
  std::string names;
  for (const zed::Name& name : declaration.names) names += (names.empty() ? "" : ", ") + name.text();
  switch (declaration.form) {
    case zed::Declaration::Form::typed:
      return names + " : " + zed::to_unicode(declaration.term);
    case zed::Declaration::Form::defined:
      return names + " == " + zed::to_unicode(declaration.term);
    case zed::Declaration::Form::included:
      return zed::to_unicode(declaration.term);
  }
  return names;
}

/// Lists what a notation holds.
class LineLister {
 public:
  explicit LineLister(const zed::Paragraph& paragraph) : paragraph_(paragraph) {}

  std::vector<LabelledLine> operator()(const zed::GivenTypes&) const { return whole(); }
  std::vector<LabelledLine> operator()(const zed::FreeType&) const { return whole(); }
  std::vector<LabelledLine> operator()(const zed::Definition& definition) const {
    zed::Definition without = definition;
    without.label.clear();
    return {{zed::to_unicode(zed::Paragraph{paragraph_.place, without}), definition.label, paragraph_.place}};
  }
  std::vector<LabelledLine> operator()(const zed::Axiomatic& box) const { return of(box.text); }
  std::vector<LabelledLine> operator()(const zed::Schema& box) const { return of(box.text); }
  std::vector<LabelledLine> operator()(const zed::Conjecture& conjecture) const {
    zed::Conjecture without = conjecture;
    without.claim.label.clear();
    return {
        {zed::to_unicode(zed::Paragraph{paragraph_.place, without}), conjecture.claim.label, conjecture.claim.place}};
  }

 private:
  std::vector<LabelledLine> whole() const { return {{zed::to_unicode(paragraph_), {}, paragraph_.place}}; }

  static std::vector<LabelledLine> of(const zed::SchemaText& text) {
    std::vector<LabelledLine> lines;
    for (const zed::Declaration& declaration : text.declarations)
      lines.push_back({declaration_text(declaration), {}, declaration.place, true});
    for (const zed::Predicate& predicate : text.predicates)
      lines.push_back({zed::to_unicode(predicate.term), predicate.label, predicate.place});
    return lines;
  }

  const zed::Paragraph& paragraph_;
};

struct KindWord {
  std::string_view operator()(const zed::GivenTypes&) const { return "given"; }
  std::string_view operator()(const zed::FreeType&) const { return "free"; }
  std::string_view operator()(const zed::Definition&) const { return "definition"; }
  std::string_view operator()(const zed::Axiomatic& box) const { return box.formals.empty() ? "axiom" : "generic"; }
  std::string_view operator()(const zed::Schema&) const { return "schema"; }
  std::string_view operator()(const zed::Conjecture&) const { return "conjecture"; }
};

}  // namespace

std::vector<LabelledLine> lines_of(const zed::Paragraph& paragraph) {
  std::vector<LabelledLine> lines = std::visit(LineLister(paragraph), paragraph.form);
  for (LabelledLine& line : lines)
    while (line.text.ends_with('\n')) line.text.pop_back();
  return lines;
}

std::string_view kind_of(const zed::Paragraph& paragraph) { return std::visit(KindWord(), paragraph.form); }

}  // namespace durero::web
