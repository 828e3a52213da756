#pragma once
/// The paragraphs of the Z text by the names that they declare, and where each of their labels is carried out.

#include <map>
#include <string>
#include <vector>

#include "durero/zed/syntax/reader.hpp"

namespace durero::oracle::spec {

/// Where each label of the text stands: in the text, in a clause or function of the program, in its tests, in a
/// theorem.
class LabelIndex {
 public:
  /// `table`: a line for each place, of the label, the kind, FILE:LINE and a name, between tabs (cmake/label_index.sh).
  explicit LabelIndex(const std::string& table);

  /// The theorem that discharges the label; empty where there is none.
  std::string theorem(const std::string& label) const;
  /// The label, then a line for each place; the label alone where none is known.
  std::string places(const std::string& label) const;

 private:
  struct Entry {
    std::string kind, place, name;
  };
  std::multimap<std::string, Entry> entries_;
};

/// The paragraph that declares the name or bears the label, in Unicode, and the places of its labels; else the first
/// schema with a component of that name; else, of ΔS and ΞS, what they stand for, and S. Empty where the text has none
/// of these. The name is in either mark-up.
std::string shown(const zed::Specification& specification, const std::string& name, const LabelIndex& index);

/// Every name that the text declares, and every label.
std::vector<std::string> names_and_labels(const zed::Specification& specification);

/// The name in Unicode: `mi\_radio` and `\real` as the text's mark-up has them; any other text as it is.
std::string in_unicode(const zed::Specification& specification, const std::string& name);

}  // namespace durero::oracle::spec
