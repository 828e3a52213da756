/// Compiles a source once for each instruction set that Highway dispatches to. The source first defines
/// HWY_TARGET_INCLUDE as its own name, as seen from src/ or tests/, and then includes this before all else; its part
/// under HWY_ONCE is compiled once. This header has no guard, because it is read again for each instruction set.
///
/// GCC without optimisation is refused. GCC 12 then passes vectors wider than the baseline's wrongly and stores them
/// unaligned: lanes hold other numbers, or the program stops. CMakeLists.txt therefore compiles such sources with -Og
/// at least.

#if defined(__GNUC__) && !defined(__clang__) && !defined(__OPTIMIZE__)
#error "GCC without optimisation gives wrong numbers in lanes; compile this source with -Og at least"
#endif

#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>
