// libhwy measures, whenever it is loaded, how finely a timer of it counts, for benchmarks that it has and nobody runs
// here. That takes 4 ms, as long as all else that a call of the program needs to start. The program's own function of
// this name stands before the library's.
#include <hwy/nanobenchmark.h>

std::uint64_t hwy::platform::TimerResolution() { return 1; }
