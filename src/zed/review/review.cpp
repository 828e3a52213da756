#include "durero/zed/review/review.hpp"

namespace durero::zed {

std::vector<Defect> review(const Specification& specification) {
  std::vector<Defect> defects = specification.defects;
  const Typing typing = check(specification);
  defects.insert(defects.end(), typing.defects.begin(), typing.defects.end());
  const bool right = defects.empty();
  for (const auto& check : {open_frames, unused_names, partial_applications})
    if (right || check != partial_applications)
      for (Defect& defect : check(specification, typing)) defects.push_back(std::move(defect));
  return defects;
}

}  // namespace durero::zed
