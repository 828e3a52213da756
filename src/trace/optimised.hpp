#pragma once
/// Refuses a source for several instruction sets that GCC compiles without optimisation. GCC 12 then passes vectors
/// wider than the baseline's wrongly and stores them unaligned: lanes hold other numbers, or the program stops.
/// CMakeLists.txt therefore compiles such sources with -Og at least.

#if defined(__GNUC__) && !defined(__clang__) && !defined(__OPTIMIZE__)
#error "GCC without optimisation gives wrong numbers in lanes; compile this source with -Og at least"
#endif
