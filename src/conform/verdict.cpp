#include "durero/conform/verdict.hpp"

#include "durero/contract/contract.hpp"

namespace durero::conform {

std::string_view name(Verdict verdict) {
  switch (verdict) {
    case Verdict::exact:
      return "exact";
    case Verdict::right:
      return "right";
    case Verdict::off:
      return "off";
    case Verdict::phantom:
      return "phantom";
    case Verdict::missed:
      return "missed";
    case Verdict::wrong_element:
      return "wrong_element";
    case Verdict::far_root:
      return "far_root";
    case Verdict::misplaced:
      return "misplaced";
    case Verdict::non_finite:
      return "non_finite";
    case Verdict::crashed:
      return "crashed";
    case Verdict::hung:
      return "hung";
    case Verdict::skipped:
      return "skipped";
  }
  contract::unreachable();
}

bool is_gross(Verdict verdict) {
  switch (verdict) {
    case Verdict::phantom:
    case Verdict::missed:
    case Verdict::wrong_element:
    case Verdict::far_root:
    case Verdict::misplaced:
    case Verdict::non_finite:
    case Verdict::crashed:
    case Verdict::hung:
      return true;
    case Verdict::exact:
    case Verdict::right:
    case Verdict::off:
    case Verdict::skipped:
      return false;
  }
  contract::unreachable();
}

}  // namespace durero::conform
