#pragma once
/// Sets that no rule lists may still be known to be infinite, by their form.

#include "durero/zed/value/value.hpp"

namespace durero::zed {

/// A set that knows by its form whether it is infinite.
class FormedSet : public Set {
 public:
  virtual bool is_infinite() const = 0;
};

}  // namespace durero::zed
