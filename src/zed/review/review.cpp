#include "durero/zed/review/review.hpp"

#include <algorithm>

namespace durero::zed {

std::vector<Defect> review(const Specification& specification) { return review(specification, check(specification)); }

std::vector<Defect> review(const Specification& specification, const Typing& typing) {
  std::vector<Defect> defects = specification.defects;
  defects.insert(defects.end(), typing.defects.begin(), typing.defects.end());
  const bool right = defects.empty();
  defects.insert(defects.end(), specification.warnings.begin(), specification.warnings.end());
  for (const auto& check :
       {doubled_operations, open_frames, repeated_parents, predicates_of_let, unused_names, partial_applications})
    if (right || (check != partial_applications && check != predicates_of_let))
      for (Defect& defect : check(specification, typing)) defects.push_back(std::move(defect));
  return defects;
}

std::vector<Defect> without_paragraphs(const std::vector<std::string>& files, const Specification& specification) {
  std::vector<Defect> defects;
  for (const std::string& file : files)
    if (std::ranges::find(specification.sections, file, &Section::file) == specification.sections.end())
      defects.push_back({file,
                         {1, 1},
                         "no Z paragraph",
                         "expected \\begin{zed}, axdef, schema, gendef or zsection, or a box of Unicode",
                         Defect::Severity::error});
  return defects;
}

}  // namespace durero::zed
