#pragma once
/// The fold of a store: the scene of an event, made of a snapshot and of the edits behind it, each of which must answer
/// what it answered when it was kept.

#include <set>
#include <span>
#include <utility>
#include <vector>

#include "durero/store/carry_out.hpp"
#include "records.hpp"

namespace durero::store {

/// An edited scene that is told where a transaction begins: what an addition answers of a group that was left depends
/// on the edits of its own transaction alone.
class FoldedScene final : public io::EditedScene {
 public:
  FoldedScene() = default;

  void begin_transaction() { put(std::move(of_)); }
  void put(scene::GroupedScene scene) { io::EditedScene::operator=(io::EditedScene(std::move(scene))); }
};

/// Stands at an event, whose scene it holds, or at none.
class Fold {
 public:
  explicit Fold(Records& records) : records_(records) {}

  EventNumber at() const noexcept { return at_; }
  const Digest& hash() const noexcept { return hash_; }
  FoldedScene& edited() noexcept { return edited_; }
  /// How many edits lie behind the nearest snapshot.
  std::size_t behind_snapshot() const noexcept { return behind_snapshot_; }
  /// Tells that the event where it stands has a snapshot now.
  void keep_snapshot() noexcept { behind_snapshot_ = 0; }

  /// Goes to an event: from where it stands, or from the snapshot that is nearest behind the event, but for those that
  /// are spoiled. Throws io::FileError where an event on the way is not as it was written, and stands at none then.
  void move_to(EventNumber to, const std::set<EventNumber>& spoiled = {});
  /// Stands at an event with that scene.
  void put(EventNumber at, const Digest& hash, scene::GroupedScene scene);
  /// Stands at none.
  void forget() { put(no_event, {}, {}); }
  /// Goes on to an event whose edit the scene has already.
  void advance(const HistoryEvent& to);

  /// Carries out edits that follow each other, the first where it stands. Throws io::FileError at the first that does
  /// not answer what it answered; at() is then its parent, and the scene is to be forgotten.
  void apply(std::span<const HistoryEvent> run, const CarryOut& by = carry_out);

 private:
  void require_hash(const HistoryEvent& event, const Digest& parent) const;
  void apply_one(const HistoryEvent& event, io::ScriptStep step, const CarryOut& by);
  std::vector<io::ScriptStep> read(std::span<const HistoryEvent> run) const;
  std::vector<HistoryEvent> next_run(std::vector<EventNumber>& way) const;
  [[noreturn]] void refuse(EventNumber event, const std::string& wrong) const;

  Records& records_;
  EventNumber at_ = no_event;
  Digest hash_{};
  std::size_t behind_snapshot_ = 0;
  FoldedScene edited_;
};

}  // namespace durero::store
