#pragma once

namespace durero::zed::coq {

/// The notations of Coq have levels: a greater one binds less tightly.
enum Level {
  atomic = 0,
  applied = 10,
  times = 40,
  plus = 50,
  related = 70,
  negated = 75,
  both = 80,
  either = 85,
  implied = 99,
  binder = 200
};

}  // namespace durero::zed::coq
