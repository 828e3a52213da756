#pragma once
/// Groups of elements, as whoever models a scene makes them by hand: of elements, then of groups that were made before.
/// They are a companion of a scene, and no part of Escena: no answer depends on them. A hierarchy of boxes may follow
/// them (accel/bvh.hpp). An element that is removed leaves its group; the group stays, were it empty.

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "durero/contract/contract.hpp"
#include "durero/model/operation.hpp"

namespace durero::scene {

class Scene;

/// Names of elements, or of groups. A group has a name as elements have (model::Elemento); both may have the same.
using Names = std::set<std::string, std::less<>>;

/// What is directly in a group.
struct Group {
  Names elementos;  ///< the elements
  Names groups;     ///< the groups
  bool operator==(const Group&) const = default;
};

/// Makes a group of what is there and in no group yet.
struct Grouping {
  std::string g;  ///< what it is to be called
  Group of;       ///< what is to be in it
};

/// Takes a group away. What was in it is then in the group that it was in, if it was in one.
struct Ungrouping {
  std::string g;  ///< which
};

/// An edit of the groups of a scene.
using GroupEdit = std::variant<Grouping, Ungrouping>;

/// What an edit answers: in a word, and where it is refused, the precondition that does not hold.
struct Outcome {
  std::string_view r;                          ///< such as `grouped`
  const contract::clause* violated = nullptr;  ///< null where it is done
  /// Whether it is done.
  bool ok() const noexcept { return violated == nullptr; }
};

/// @{ The preconditions of both edits, and what follows from them and a scene file is asked for: that no group lies
/// within itself. Together they make the groups a forest, in which each element is at most once.
inline constexpr contract::clause group_pre_1{"group.pre.1", "g? ∉ dom groups"};
inline constexpr contract::clause group_pre_2{"group.pre.2", "elementos? ⊆ elementos"};
inline constexpr contract::clause group_pre_3{"group.pre.3", "groups? ⊆ dom groups"};
inline constexpr contract::clause group_pre_4{"group.pre.4",
                                              "∀ g : dom groups ⦁ elementos? ∩ (groups g).elementos = ∅"};
inline constexpr contract::clause group_pre_5{"group.pre.5", "∀ g : dom groups ⦁ groups? ∩ (groups g).groups = ∅"};
inline constexpr contract::clause ungroup_pre_1{"ungroup.pre.1", "g? ∈ dom groups"};
inline constexpr contract::clause groups_inv_1{"groups.inv.1", "∀ g : dom groups ⦁ g ∉ ((_ within _) ⁺) ⦇ { g } ⦈"};
/// @}

/// The groups of a scene. Edits cost O(log n) for each member; where memory runs out they change nothing.
class Groups {
 public:
  /// Every group by its name.
  using Table = std::map<std::string, Group, std::less<>>;

  /// There is none.
  bool empty() const noexcept { return table_.empty(); }
  /// All of them, ascending by name.
  const Table& table() const noexcept { return table_; }
  /// @{ The group that an element or a group is directly in; the empty name where it is in none.
  std::string_view of_element(std::string_view name) const noexcept;
  std::string_view of_group(std::string_view name) const noexcept;
  /// @}
  /// The names of all groups, each after those that are in it.
  std::vector<std::string_view> bottom_up() const;

  /// The total edit: where a precondition does not hold it changes nothing and answers so, the first in the order of
  /// their labels. Precondition: the groups are of that scene.
  Outcome apply_total(const GroupEdit& edit, const Scene& scene);
  /// Puts an element into a group, and takes it out of the one that it was in. Where memory runs out nothing changes.
  /// Precondition: the group exists.
  void put(const std::string& element, std::string_view group);
  /// Takes an element out of its group, if it is in one.
  void take_out(std::string_view element) noexcept;
  /// After an operation was carried out on the scene: an element that was removed leaves its group. One that was added
  /// is in none.
  void follow(const model::Operation& done) noexcept;
  /// After a mesh was edited: each face that is no more leaves its group. O(members).
  void follow_meshes(const Scene& scene) noexcept;

  bool operator==(const Groups& other) const { return table_ == other.table_; }  ///< in name and in what they hold

 private:
  using Index = std::map<std::string, std::string, std::less<>>;  // from a member to its group

  Index::iterator leave(Index::iterator element) noexcept;
  void make(const Grouping& in);
  void dissolve(std::string_view g);

  Table table_;
  Index of_element_, of_group_;
};

}  // namespace durero::scene
