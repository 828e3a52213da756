#include "durero/store/store_reading.hpp"

#include "journal.hpp"

namespace durero::store {

StoreReading::StoreReading(Store& of) : of_(of), is_begun_(!of.journal().database.is_in_transaction()) {
  if (is_begun_) of_.journal().database.begin_reading();
}

StoreReading::~StoreReading() {
  if (!is_begun_) return;
  try {
    of_.journal().database.commit();
  } catch (const std::exception&) {  // of what was only read nothing is to be kept
  }
}

}  // namespace durero::store
