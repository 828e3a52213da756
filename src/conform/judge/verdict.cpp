#include "durero/conform/judge/verdict.hpp"

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
    case Verdict::out_of_range:
      return "out_of_range";
    case Verdict::doubled:
      return "doubled";
    case Verdict::unsorted:
      return "unsorted";
    case Verdict::wrong_count:
      return "wrong_count";
    case Verdict::wrong_normal:
      return "wrong_normal";
    case Verdict::wrong_face:
      return "wrong_face";
    case Verdict::wrong_uv:
      return "wrong_uv";
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

std::string_view meaning(Verdict verdict) {
  switch (verdict) {
    case Verdict::exact:
      return "right to the bit, in the system's format";
    case Verdict::right:
      return "the answer of some data within 16ε of those given";
    case Verdict::off:
      return "the answer of no data within 16ε of those given, yet of the right element and near";
    case Verdict::phantom:
      return "a hit where there is none";
    case Verdict::missed:
      return "no hit where there is one";
    case Verdict::wrong_element:
      return "an element that is not first";
    case Verdict::far_root:
      return "a later crossing of the right element";
    case Verdict::misplaced:
      return "off by more than 0.001 of the element's size";
    case Verdict::out_of_range:
      return "a hit outside the range that was asked about";
    case Verdict::doubled:
      return "a hit of an element that is crossed less often there";
    case Verdict::unsorted:
      return "right hits that are not in the order of the ray";
    case Verdict::wrong_count:
      return "a number of hits that no data within 16ε have";
    case Verdict::wrong_normal:
      return "a right hit with a wrong normal";
    case Verdict::wrong_face:
      return "a right hit of the other side";
    case Verdict::wrong_uv:
      return "a right hit with wrong u and v";
    case Verdict::non_finite:
      return "a hit at what is no number";
    case Verdict::crashed:
      return "the system ended";
    case Verdict::hung:
      return "the system gave no answer in time";
    case Verdict::skipped:
      return "outside the profile";
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
    case Verdict::out_of_range:
    case Verdict::doubled:
    case Verdict::unsorted:
    case Verdict::wrong_count:
    case Verdict::wrong_normal:
    case Verdict::wrong_face:
    case Verdict::wrong_uv:
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
