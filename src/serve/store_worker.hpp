#pragma once
/// The one thread that uses a store. Edits that wait are made durable together: as many as the disk lets wait.

#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <variant>

#include "durero/engine/engine.hpp"
#include "durero/store/store.hpp"
#include "durero/store/store_reading.hpp"
#include "edit_feed.hpp"

namespace durero::serve {

/// The scene of an event, and what answers rays on it, which is made when it is first asked for. Any thread may ask.
class SceneAt {
 public:
  SceneAt(store::EventNumber event, scene::GroupedScene scene) : event_(event), scene_(std::move(scene)) {}

  store::EventNumber event() const noexcept { return event_; }
  const scene::GroupedScene& grouped() const noexcept { return scene_; }
  /// Of the usual engine.
  const engine::Engine& engine() const;

 private:
  store::EventNumber event_;
  scene::GroupedScene scene_;
  mutable std::once_flag made_;
  mutable std::unique_ptr<const engine::Engine> engine_;
};

/// A transaction that somebody asks for.
struct AskedEdit {
  std::string operations;                         ///< lines of a script
  store::Provenance by;                           ///< of the transaction
  bool all_or_nothing = false;                    ///< whether a refusal leaves nothing of it
  store::EventNumber expected = store::no_event;  ///< where HEAD must be; no_event: anywhere
};

/// What it has come to.
struct EditOutcome {
  store::EditResult result;  ///< as the store says
  store::EventNumber head;   ///< where HEAD is now
  bool is_stale = false;     ///< whether HEAD was elsewhere than expected, and nothing was done
};

/// JSON lines as an array of JSON.
std::string as_array(const std::string& lines);

/// Takes a store for itself.
class StoreWorker {
 public:
  /// Throws io::FileError where the store cannot be written, or cannot be read. A store that is followed is written by
  /// others: the feed tells where HEAD is each time that it moves.
  StoreWorker(std::string store, store::StoreAccess access, EditFeed& feed);
  /// Ends what was taken, and then the thread.
  ~StoreWorker();

  /// Carries an edit out, durably. Throws what the store throws.
  EditOutcome edit(AskedEdit asked);
  /// What the task answers, which uses the store alone. Throws what the task throws, and io::FileError where the store
  /// was lost and is not found again.
  template <class Task>
  auto ask(Task task) {
    using Answer = std::invoke_result_t<Task&, store::Store&>;
    auto promise = std::make_shared<std::promise<Answer>>();
    auto answer = promise->get_future();
    put([this, promise, task = std::move(task)]() mutable {
      try {
        store::Store& of = opened();
        std::optional<store::StoreReading> reading;
        if (is_followed()) reading.emplace(of);
        if constexpr (std::is_void_v<Answer>) {
          task(of);
          promise->set_value();
        } else {
          promise->set_value(task(of));
        }
      } catch (...) {
        promise->set_exception(std::current_exception());
      }
    });
    return answer.get();
  }
  /// The scene of HEAD.
  std::shared_ptr<const SceneAt> scene();

 private:
  struct PendingEdit {
    AskedEdit asked;
    std::promise<EditOutcome> answer;
  };
  using Task = std::function<void()>;
  using Pending = std::variant<std::shared_ptr<PendingEdit>, Task>;

  void put(Pending pending);
  void work();
  void carry_out(std::deque<std::shared_ptr<PendingEdit>>& edits);

  bool is_followed() const noexcept { return access_ == store::StoreAccess::follow; }
  /// The store; where its server was gone, opened anew.
  store::Store& opened();
  /// Tells where HEAD is, if it has moved.
  void follow();

  static constexpr std::size_t most_together = 256;
  /// How often a store that is followed is asked where its HEAD is.
  static constexpr std::chrono::milliseconds pace{200};

  std::string path_;
  store::StoreAccess access_;
  std::unique_ptr<store::Store> store_;
  EditFeed& feed_;
  store::EventNumber followed_ = store::no_event;  // where HEAD was last; of a store that is followed
  std::shared_ptr<const SceneAt> scene_{};
  std::mutex mutex_{};
  std::condition_variable arrived_{};
  std::deque<Pending> waiting_{};
  bool ends_ = false;
  std::thread thread_{};
};

}  // namespace durero::serve
