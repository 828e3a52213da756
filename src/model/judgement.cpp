#include "durero/model/judgement.hpp"

#include <algorithm>

namespace durero::model {

bool all_hold(const Judgements& judgements) noexcept { return std::ranges::all_of(judgements, &Judgement::holds); }

}  // namespace durero::model
