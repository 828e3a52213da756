#include "edit_feed.hpp"

#include <algorithm>
#include <utility>

namespace durero::serve {

void EditFeed::send(std::string text) {
  const std::scoped_lock lock(mutex_);
  kept_.push_back({++last_, std::move(text)});
  if (kept_.size() > most_kept) kept_.pop_front();
  changed_.notify_all();
}

std::optional<EditFeed::Message> EditFeed::after(std::uint64_t number, std::chrono::milliseconds patience) const {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, patience, [&] { return closed_ || last_ > number; });
  if (closed_ || last_ <= number) return std::nullopt;
  return *std::ranges::find_if(kept_, [&](const Message& each) { return each.number > number; });
}

std::uint64_t EditFeed::last() const {
  const std::scoped_lock lock(mutex_);
  return last_;
}

void EditFeed::close() {
  const std::scoped_lock lock(mutex_);
  closed_ = true;
  changed_.notify_all();
}

bool EditFeed::is_closed() const {
  const std::scoped_lock lock(mutex_);
  return closed_;
}

}  // namespace durero::serve
