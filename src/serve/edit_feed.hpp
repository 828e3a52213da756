#pragma once
/// The edits of a store as they are kept, for whoever watches.

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <string>

namespace durero::serve {

/// Messages in their order, numbered from 1. The last thousand are kept for those who come later.
class EditFeed {
 public:
  /// A message that was sent.
  struct Message {
    std::uint64_t number;
    std::string text;
  };

  void send(std::string text);
  /// The first message behind that number, as soon as there is one; nothing where none comes in that time, or the feed
  /// is closed.
  std::optional<Message> after(std::uint64_t number, std::chrono::milliseconds patience) const;
  /// The number of the last message; 0 where there is none.
  std::uint64_t last() const;
  /// Whoever waits, waits no longer.
  void close();
  bool is_closed() const;

 private:
  static constexpr std::size_t most_kept = 1000;

  mutable std::mutex mutex_;
  mutable std::condition_variable changed_;
  std::deque<Message> kept_;
  std::uint64_t last_ = 0;
  bool closed_ = false;
};

}  // namespace durero::serve
