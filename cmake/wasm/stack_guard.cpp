// Debian's compiler runtime for WebAssembly is compiled with guards on its stack, and asks for them by these names.
#include <cstdint>
#include <cstdlib>

extern "C" {

std::uintptr_t __stack_chk_guard = 0xe2dee396;
[[noreturn]] void __stack_chk_fail() { std::abort(); }

}  // extern "C"
