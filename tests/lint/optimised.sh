#!/bin/sh
# GCC without optimisation gives wrong numbers in lanes: a source that is compiled for every instruction set is so by
# src/lanes/for_each_target.hpp, which refuses to be so compiled, and CMake optimises it in every build.
set -u
for source in $(git grep -lE '^#define HWY_TARGET_INCLUDE|^#include <hwy/foreach_target.h>' -- 'src/*.cpp'); do
  grep -qxF '#include "lanes/for_each_target.hpp"' "$source" ||
    echo "$source:1: compiles without optimisation; expected #include \"lanes/for_each_target.hpp\""
  awk -v source="$source" '/^set_source_files_properties/ { named = 0 } index($0, source) { named = 1 }
    named && /COMPILE_OPTIONS "\$<\$<CONFIG:Debug>:-Og>"/ { optimised = 1 } END { exit !optimised }' CMakeLists.txt ||
    echo "$source:1: is not optimised in Debug; expected it among those of CMakeLists.txt"
done | { ! grep .; }
