#!/bin/sh
# A source includes the header of each function of GLM and of fmt that it calls, and of each type and function of this program
# that it names (includes.py). An include of its neighbours holds for it in the builds that group sources or precompile
# headers, and in no other.
status=0
git ls-files -z -- '*.hpp' '*.cpp' | xargs -0 awk '
  BEGIN {
    calls["glm/common.hpp"] = "abs ceil clamp floor fract isinf isnan max min mix mod round sign trunc"
    calls["glm/exponential.hpp"] = "exp log pow sqrt"
    calls["glm/geometric.hpp"] = "cross distance dot length normalize reflect refract"
    calls["glm/gtc/constants.hpp"] = "pi"
    calls["glm/matrix.hpp"] = "determinant inverse outerProduct transpose"
    calls["glm/trigonometric.hpp"] = "acos asin atan cos degrees radians sin tan"
    calls["glm/vector_relational.hpp"] = "all any equal greaterThan greaterThanEqual lessThan lessThanEqual not_ notEqual"
    calls["fmt/core.h"] = "format format_to format_to_n print"
    calls["fmt/format.h"] = "memory_buffer to_string"
    calls["fmt/ranges.h"] = "join"
    for (header in calls) {
      split(calls[header], functions, " ")
      for (i in functions) header_of[substr(header, 1, 3) "::" functions[i]] = header
    }
    brings["fmt/format.h"] = "fmt/core.h"
    brings["fmt/ranges.h"] = "fmt/core.h"
  }
  FNR == 1 { delete is_there }
  /^#include <(glm|fmt)\// {
    sub(/^#include </, "")
    sub(/>.*/, "")
    is_there[$0] = is_there[brings[$0]] = 1
    next
  }
  {
    sub(/\/\/.*/, "")
    for (rest = $0; match(rest, /(glm|fmt)::[A-Za-z_0-9]+/); rest = substr(rest, RSTART + RLENGTH)) {
      called = substr(rest, RSTART, RLENGTH)
      if (!(called in header_of) || (header_of[called] in is_there)) continue
      is_there[header_of[called]] = 1
      print FILENAME ":" FNR ": calls " called " by the include of another file; expected #include <" header_of[called] ">"
    }
  }' | { ! grep .; } || status=1
git ls-files 'include/*.h' '*.hpp' '*.cpp' | python3 "$(dirname "$0")/includes.py" || status=1
exit $status
