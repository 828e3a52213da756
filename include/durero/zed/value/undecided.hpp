#pragma once
/// The errors of evaluations that lack something, by what they lack: a message says by it what would help.

#include <cstdint>
#include <string>

#include "durero/zed/value/value.hpp"

namespace durero::zed {

/// The thing that an evaluation lacks.
enum class Lack : std::uint8_t {
  members,   ///< a set that it goes through, or compares, has members that cannot be listed
  equation,  ///< no case of a definition gives a value at an argument
  end,       ///< applications nest without an end in sight
  number,    ///< the result of an operation has no exact form (Real)
  degree,    ///< a predicate depends on a number in a way that is not followed
  instance,  ///< a generic box defines neither a function nor a set
  ground     ///< a definition asks for the value that it gives
};

/// The error of an evaluation that lacks such a thing.
class LackingEvaluation : public EvaluationError {
 public:
  /// The lack, and what is not decided for it.
  LackingEvaluation(Lack lack, const std::string& undecided) : EvaluationError(undecided), lack_(lack) {}
  /// The thing that it lacks.
  Lack lack() const { return lack_; }

 private:
  Lack lack_;
};

}  // namespace durero::zed
