#pragma once
/// For each source of this layer that is compiled for several instruction sets. GCC 12 without optimisation passes
/// vectors wider than the baseline's wrongly and stores them where they are not aligned: lanes then hold other numbers,
/// or the program stops. So such a source is compiled with -Og at least (CMakeLists.txt), and else not at all.

#if defined(__GNUC__) && !defined(__clang__) && !defined(__OPTIMIZE__)
#error "GCC without optimisation gives wrong numbers in lanes; compile this source with -Og at least"
#endif
