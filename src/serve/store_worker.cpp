#include "store_worker.hpp"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "durero/composed/engine.hpp"
#include "durero/engine/prepared.hpp"

namespace durero::serve {

std::string as_array(const std::string& lines) {
  std::string array = "[";
  for (std::size_t begin = 0; begin < lines.size();) {
    const std::size_t end = lines.find('\n', begin);
    if (begin > 0) array += ",";
    array.append(lines, begin, end - begin);
    begin = end + 1;
  }
  return array + "]";
}

const engine::Engine& SceneAt::engine() const {
  std::call_once(
      made_, [&] { engine_ = composed::prepared(*engine::find(engine::default_engine), engine::automatic, scene_); });
  return *engine_;
}

StoreWorker::StoreWorker(std::string store, store::StoreAccess access, EditFeed& feed)
    : path_(std::move(store)), access_(access), store_(std::make_unique<store::Store>(path_, access)), feed_(feed) {
  if (is_followed()) followed_ = store_->head().event;
  thread_ = std::thread([this] { work(); });
}

StoreWorker::~StoreWorker() {
  {
    const std::scoped_lock lock(mutex_);
    ends_ = true;
  }
  arrived_.notify_all();
  thread_.join();
}

EditOutcome StoreWorker::edit(AskedEdit asked) {
  auto pending = std::make_shared<PendingEdit>(PendingEdit{std::move(asked), {}});
  auto answer = pending->answer.get_future();
  put(std::move(pending));
  return answer.get();
}

std::shared_ptr<const SceneAt> StoreWorker::scene() {
  return ask([this](store::Store& of) {
    const store::EventNumber head = of.head().event;
    if (!scene_ || scene_->event() != head) scene_ = std::make_shared<const SceneAt>(head, of.state(head));
    return scene_;
  });
}

store::Store& StoreWorker::opened() {
  if (store_->is_lost()) {
    scene_.reset();  // numbers of events may be others'
    store_ = std::make_unique<store::Store>(path_, access_);
  }
  return *store_;
}

/// Where the store is out of reach, whoever asks is told so; HEAD is asked for again later.
void StoreWorker::follow() {
  try {
    store::Store& of = opened();
    const store::StoreReading reading(of);
    const store::EventNumber head = of.head().event;
    if (head != followed_) feed_.send(fmt::format(R"({{"event":{}}})", head));
    followed_ = head;
  } catch (const io::FileError&) {
  }
}

void StoreWorker::put(Pending pending) {
  {
    const std::scoped_lock lock(mutex_);
    waiting_.push_back(std::move(pending));
  }
  arrived_.notify_one();
}

void StoreWorker::work() {
  auto due = std::chrono::steady_clock::now() + pace;
  for (;;) {
    std::deque<std::shared_ptr<PendingEdit>> edits;
    Task task;
    {
      std::unique_lock lock(mutex_);
      const auto is_awake = [&] { return ends_ || !waiting_.empty(); };
      if (is_followed())
        arrived_.wait_until(lock, due, is_awake);
      else
        arrived_.wait(lock, is_awake);
      if (ends_ && waiting_.empty()) return;
      while (!waiting_.empty() && edits.size() < most_together) {
        auto* const edit = std::get_if<std::shared_ptr<PendingEdit>>(&waiting_.front());
        if (edit == nullptr) break;
        edits.push_back(std::move(*edit));
        waiting_.pop_front();
      }
      if (edits.empty() && !waiting_.empty()) {
        task = std::get<Task>(std::move(waiting_.front()));
        waiting_.pop_front();
      }
    }
    if (task) task();
    if (!edits.empty()) carry_out(edits);
    if (is_followed() && std::chrono::steady_clock::now() >= due) {
      follow();
      due = std::chrono::steady_clock::now() + pace;
    }
  }
}

void StoreWorker::carry_out(std::deque<std::shared_ptr<PendingEdit>>& edits) {
  std::vector<io::Source> scripts;
  std::vector<store::EditCall> calls;
  scripts.reserve(edits.size());
  for (const auto& edit : edits) {
    scripts.emplace_back("operations", edit->asked.operations);
    store::EditCall call{scripts.back()};
    call.by = edit->asked.by;
    call.all_or_nothing = edit->asked.all_or_nothing;
    call.expected_head = edit->asked.expected;
    calls.push_back(std::move(call));
  }
  std::vector<store::EditAttempt> attempts;
  try {
    attempts = opened().edit_together(calls);
  } catch (...) {
    for (const auto& edit : edits) edit->answer.set_exception(std::current_exception());
    return;
  }
  for (std::size_t i = 0; i < edits.size(); ++i) {
    store::EditAttempt& attempt = attempts[i];
    if (attempt.error) {
      edits[i]->answer.set_exception(attempt.error);
      continue;
    }
    if (attempt.result.event != store::no_event)
      feed_.send(fmt::format(R"({{"event":{},"answers":{}}})", attempt.result.event, as_array(attempt.result.answers)));
    edits[i]->answer.set_value({std::move(attempt.result), attempt.head, attempt.is_stale});
  }
}

}  // namespace durero::serve
