#pragma once
/// The paragraphs of the Z text by the names that they declare, and where each of their labels is carried out.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "durero/zed/syntax/reader.hpp"

namespace durero::spec {

/// A place of a label of the text.
struct LabelPlace {
  std::string kind;   ///< `text`, `clause`, `function`, `test`, `theorem`, or of a name `type`
  std::string place;  ///< FILE:LINE
  std::string name;   ///< what stands there, such as the name of the theorem; empty where it has none
};

/// Where each label of the text stands: in the text, in a clause or function of the program, in its tests, in a
/// theorem.
class LabelIndex {
 public:
  /// `table`: a line for each place, of the label or name, the kind, FILE:LINE and a name, between tabs
  /// (cmake/label_index.sh).
  explicit LabelIndex(std::string table);
  LabelIndex(const LabelIndex&) = delete;
  LabelIndex& operator=(const LabelIndex&) = delete;

  /// The theorem that discharges the label; empty where there is none.
  std::string theorem(const std::string& label) const;
  /// The clause or function of the program that carries the label out, or the type of model that has the name,
  /// FILE:LINE; empty where there is none.
  std::string carried_out(const std::string& label_or_name) const;
  /// The label, then a line for each place; the label alone where none is known.
  std::string places(const std::string& label) const;
  /// Every place of the label, in the order of the table.
  std::vector<LabelPlace> all(const std::string& label) const;

 private:
  struct Entry {
    std::string_view label, kind, place, name;  // they are in the table
  };
  std::span<const Entry> of(std::string_view label) const;

  std::string table_;
  std::vector<Entry> entries_;  // by their labels, those of one label in the order of the table
};

/// The paragraph that declares the name or bears the label, in Unicode, and the places of its labels; else the first
/// schema with a component of that name; else, of ΔS and ΞS, what they stand for, and S. Empty where the text has none
/// of these. The name is in either mark-up.
std::string shown(const zed::Specification& specification, const std::string& name, const LabelIndex& index);

/// The location of a name: its paragraph in the text, and what carries that out.
struct NameLocation {
  std::string text;       ///< FILE:LINE of the paragraph
  std::string paragraph;  ///< the first name that it declares
  std::string program;    ///< FILE:LINE of its type in model, or of what carries out its first label; empty without
};

/// The place of a name in the text: the paragraph that declares it; else the first schema with a component of that
/// name; else the first paragraph that has it as a variable. Nothing where the text has no such name.
std::optional<NameLocation> name_location(const zed::Specification& specification, const std::string& name,
                                          const LabelIndex& index);

/// Every name that the text declares, and every label.
std::vector<std::string> names_and_labels(const zed::Specification& specification);

/// The name in Unicode: `mi\_radio` and `\real` as the text's mark-up has them; any other text as it is.
std::string in_unicode(const zed::Specification& specification, const std::string& name);

}  // namespace durero::spec
