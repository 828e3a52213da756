#pragma once
/// Several questions to a store that others may write between two of them.

#include "durero/store/store.hpp"

namespace durero::store {

/// While it lives, a store is read as it was at the first question, whoever writes it beside. Precondition: nothing is
/// written by that store meanwhile. One that is open for reading is read so anyhow.
class StoreReading {
 public:
  /// Begins.
  explicit StoreReading(Store& of);
  /// Ends.
  ~StoreReading();
  StoreReading(const StoreReading&) = delete;
  StoreReading& operator=(const StoreReading&) = delete;

 private:
  Store& of_;
  bool is_begun_;  // by this; not where the store is open for reading
};

}  // namespace durero::store
