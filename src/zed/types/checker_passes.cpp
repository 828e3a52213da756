/// Checks a part of the text in passes, where the components of a schema are told only behind its use.
///
/// Names bind by the components of schemas, and so a use of a schema cannot be checked before they are known: `s ⧹ (x)`
/// with `s == g`, where `g[X] == X` and `s = [x, y : ℕ]` stands further on. A pass leaves such a use out, and takes a
/// fresh type for what it gives, and for each name that it might declare. So a pass solves fewer equations than the
/// rules of types give (ISO/IEC 13568, clause 13), and what it determines follows from all of them. The next pass
/// begins with it. The last pass leaves nothing out: a text is accepted by it alone.

#include "zed/types/checker.hpp"

namespace durero::zed {
namespace {

bool has_open_signature(const Type& type) {
  return type.is(Type::Kind::variable) || (type.is(Type::Kind::power) && type.parts()[0].is(Type::Kind::variable));
}

}  // namespace

/// Says whether a term that stands as a schema has components that are not known yet. They are those that a pass before
/// told, if one did.
bool Checker::awaits(const Node& node, const Type& type) {
  if (!has_open_signature(type)) return false;
  if (const auto told = told_.find(&node); told != told_.end()) {
    unify(type, told->second);
    return false;
  }
  if (is_strict_) return false;
  if (type.is(Type::Kind::variable)) unify(type, Type::power(fresh()));
  awaited_.emplace_back(&node, type);
  return true;
}

/// Says whether the pass left nothing out. Where it did, what it reported is dropped, as the next pass reports it
/// again.
bool Checker::is_last(const Pass& pass) {
  const bool is_last = awaited_.empty();
  bool is_told = false;
  for (const auto& [node, type] : awaited_) {
    if (has_open_signature(type)) continue;
    told_.insert_or_assign(node, type);
    is_told = true;
  }
  is_strict_ = !is_last && !is_told;
  if (is_last) {
    told_.clear();
    return true;
  }
  awaited_.clear();
  selections_.clear();
  into_.defects.erase(into_.defects.begin() + static_cast<std::ptrdiff_t>(pass.defects), into_.defects.end());
  generics_.erase(generics_.begin() + static_cast<std::ptrdiff_t>(pass.generics), generics_.end());
  return false;
}

}  // namespace durero::zed
