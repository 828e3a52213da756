#pragma once
/// Rows on the way back to the first event. Their numbers mostly descend by one, so that a run of them is read at once:
/// a server far away is asked a few times, and not for each.

#include <algorithm>
#include <vector>

#include "durero/io/source.hpp"
#include "durero/store/history_event.hpp"

namespace durero::store {

/// `Read` gives the rows of numbers from the first to the last, ascending, that are there. A row has its number.
template <class Row, class Read>
class RowsBack {
 public:
  explicit RowsBack(Read read) : read_(std::move(read)) {}

  /// The row of a number; null where it, or one near it, cannot be read so. Valid until the next call.
  const Row* find(EventNumber number) {
    if (number < first_ || number > last_) load(number);
    const auto found = std::ranges::lower_bound(rows_, number, {}, &Row::number);
    return found == rows_.end() || found->number != number ? nullptr : &*found;
  }

 private:
  /// A single event is often all that is asked for; of a long way most runs are long.
  static constexpr EventNumber first_length = 4, greatest_length = 1024;

  void load(EventNumber number) {
    last_ = number;
    first_ = std::max(EventNumber{1}, number - length_ + 1);
    length_ = std::min(2 * length_, greatest_length);
    try {
      rows_ = read_(first_, last_);
    } catch (const io::FileError&) {  // of a row that is perhaps not asked for
      rows_.clear();
    }
  }

  Read read_;
  EventNumber first_ = 0, last_ = -1;  // what was read
  EventNumber length_ = first_length;  // of the next run
  std::vector<Row> rows_{};
};

}  // namespace durero::store
