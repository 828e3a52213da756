#!/bin/sh
# A source includes the header of each function of GLM that it calls. What its neighbours include is there in the builds that
# group sources or precompile headers, and in no other.
git ls-files -z -- '*.hpp' '*.cpp' | xargs -0 awk '
  BEGIN {
    header_of["common"] = "abs ceil clamp floor fract isinf isnan max min mix mod round sign trunc"
    header_of["exponential"] = "exp log pow sqrt"
    header_of["geometric"] = "cross distance dot length normalize reflect refract"
    header_of["matrix"] = "determinant inverse outerProduct transpose"
    header_of["trigonometric"] = "acos asin atan cos degrees radians sin tan"
    header_of["vector_relational"] = "all any equal greaterThan greaterThanEqual lessThan lessThanEqual not_ notEqual"
    header_of["gtc/constants"] = "pi"
    for (header in header_of) {
      split(header_of[header], functions, " ")
      for (i in functions) header_with[functions[i]] = header
    }
  }
  FNR == 1 { delete is_included; delete is_told }
  /^#include <glm\// { sub(/^#include <glm\//, ""); sub(/[.]hpp>.*/, ""); is_included[$0] = 1; next }
  {
    sub(/\/\/.*/, "")
    for (rest = $0; match(rest, /glm::[A-Za-z_0-9]+[(<]/); rest = substr(rest, RSTART + RLENGTH)) {
      called = substr(rest, RSTART + 5, RLENGTH - 6)
      if (!(called in header_with)) continue
      header = header_with[called]
      if ((header in is_included) || (header in is_told)) continue
      is_told[header] = 1
      print FILENAME ":" FNR ": calls glm::" called " by another file; expected #include <glm/" header ".hpp>"
    }
  }' | { ! grep .; }
