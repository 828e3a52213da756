#!/bin/sh
# GCC without optimisation gives wrong numbers in lanes (src/trace/optimised.hpp): a source that is compiled for every
# instruction set refuses to be so compiled, and CMake optimises it in every build.
set -u
for source in $(git grep -lE '^#include <hwy/foreach_target.h>' -- 'src/*.cpp'); do
  grep -qE '^#include "(trace/optimised|accel/wide/wide_lanes-inl)\.hpp"' "$source" ||
    echo "$source:1: compiles without optimisation; expected #include \"trace/optimised.hpp\", or its like"
  awk -v source="$source" '/^set_source_files_properties/ { named = 0 } index($0, source) { named = 1 }
    named && /COMPILE_OPTIONS "\$<\$<CONFIG:Debug>:-Og>"/ { optimised = 1 } END { exit !optimised }' CMakeLists.txt ||
    echo "$source:1: is not optimised in Debug; expected it among those of CMakeLists.txt"
done | { ! grep .; }
