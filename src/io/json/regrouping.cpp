#include "regrouping.hpp"

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string_view>

namespace durero::io {
namespace {

/// Let the groups `from` be a forest, and U the groups that are dissolved. What stays of `from` then holds its own
/// members, and in place of each member in U that member's own, and so on. An edit adds nothing to a group that is
/// there, so U is right if and only if each group outside it is then as in `to`; the others of `to` are made anew, and
/// their members are in no group then, for `to` has each of them once. The edits are #U and those made anew, which are
/// the groups of `to` that `from` has not, and U's.
///
/// A group that stays decides about the groups in it: a member that it keeps in `to` stays, and any other is dissolved,
/// whose members are then its own. So a group has one way to stay, of a cost that the groups below it give. A group
/// that is dissolved, below none that stays, leaves its members free. The least cost follows from small to large.
class Regrouping {
 public:
  Regrouping(const scene::Groups& from, const scene::Groups& to) : from_(from), to_(to) {
    for (const std::string_view g : from.bottom_up()) decide(g);
  }

  std::vector<scene::GroupEdit> edits() {
    std::vector<scene::GroupEdit> edits;
    const std::vector<std::string_view> small_to_large = from_.bottom_up();
    for (auto g = small_to_large.rbegin(); g != small_to_large.rend(); ++g)
      if (!settle(*g)) edits.emplace_back(scene::Ungrouping{std::string(*g)});
    for (const std::string_view g : to_.bottom_up())
      if (!staying_.contains(g)) edits.emplace_back(scene::Grouping{std::string(g), to_.table().find(g)->second});
    return edits;
  }

 private:
  /// What becomes of a group of `from`, by the number of edits in it and below it.
  struct Decision {
    std::optional<std::size_t> staying;  // nothing: it cannot stay
    std::size_t dissolved;               // itself, and the groups in it as is best
    bool best_stays() const { return staying && *staying <= dissolved; }
    std::size_t best() const { return best_stays() ? *staying : dissolved; }
  };

  const scene::Group* wanted(std::string_view g) const {
    const auto found = to_.table().find(g);
    return found == to_.table().end() ? nullptr : &found->second;
  }

  /// It is dissolved, and made anew where `to` has it.
  std::size_t cost_of_dissolving(std::string_view g) const { return wanted(g) == nullptr ? 1 : 2; }

  void decide(std::string_view g) {
    Decision made{{}, cost_of_dissolving(g)};
    for (const std::string& in : from_.table().find(g)->second.groups) made.dissolved += decisions_.at(in).best();
    if (wanted(g) != nullptr) try_staying(g, *wanted(g), made);
    decisions_.emplace(g, std::move(made));
  }

  void try_staying(std::string_view g, const scene::Group& as, Decision& made) const {
    std::size_t cost = 0, elementos = 0, kept = 0;
    std::vector<std::string_view> opened{g};
    while (!opened.empty()) {
      const scene::Group& group = from_.table().find(opened.back())->second;
      opened.pop_back();
      for (const std::string& e : group.elementos)
        if (!as.elementos.contains(e)) return;
      elementos += group.elementos.size();
      for (const std::string& in : group.groups) {
        if (!as.groups.contains(in)) {
          cost += cost_of_dissolving(in);
          opened.push_back(in);
        } else if (decisions_.at(in).staying) {
          cost += *decisions_.at(in).staying;
          ++kept;
        } else {
          return;
        }
      }
    }
    if (elementos != as.elementos.size() || kept != as.groups.size()) return;
    made.staying = cost;
  }

  /// Whether a group stays. Precondition: it was asked of the groups above, from large to small.
  bool settle(std::string_view g) {
    const std::string_view in = from_.of_group(g);
    const std::string_view owner = in.empty() || staying_.contains(in) ? in : owner_.at(in);
    owner_.emplace(g, owner);
    const bool stays = owner.empty() ? decisions_.at(g).best_stays() : wanted(owner)->groups.contains(g);
    if (stays) staying_.insert(g);
    return stays;
  }

  const scene::Groups& from_;
  const scene::Groups& to_;
  std::map<std::string_view, Decision> decisions_{};
  std::set<std::string_view> staying_{};
  std::map<std::string_view, std::string_view> owner_{};  // the next group above that stays; empty where there is none
};

}  // namespace

std::vector<scene::GroupEdit> regrouping(const scene::Groups& from, const scene::Groups& to) {
  return Regrouping(from, to).edits();
}

}  // namespace durero::io
