# DURERO_STATIC=PREFIX: the program and a wheel carry the libraries that they use, those in PREFIX (release/libraries.sh) and
# Debian's archives. The program needs no more than the kernel, and a wheel glibc and libstdc++.
# Included before the packages are found; durero_static() after.
set(DURERO_STATIC "" CACHE PATH "Where the archives of release/libraries.sh are; empty: shared libraries are linked")
if(DURERO_STATIC OR SKBUILD)
  set(CMAKE_POSITION_INDEPENDENT_CODE ON)  # the commands stand in a library, too
endif()
# The options of code that runs once, or waits for others: quick to compile; and small where a wheel carries it, which has to
# stay below 10 MB: -Os takes a third off.
set(durero_cold_options "$<$<CONFIG:Release>:$<IF:$<BOOL:${DURERO_STATIC}>,-Os,-O1>>")
if(DURERO_STATIC)
  list(PREPEND CMAKE_PREFIX_PATH ${DURERO_STATIC})
  set(ENV{PKG_CONFIG_PATH} ${DURERO_STATIC}/lib/pkgconfig)
  set(CMAKE_FIND_LIBRARY_SUFFIXES .a)
  set(OPENSSL_USE_STATIC_LIBS ON)
  # A section for each function: the linker leaves out what nothing calls.
  add_compile_options(-ffunction-sections -fdata-sections)
  add_link_options(LINKER:--gc-sections)
endif()

# durero_static(): an archive does not say what it needs itself.
function(durero_static)
  if(NOT DURERO_STATIC)
    return()
  endif()
  find_library(MPFR_LIBRARY mpfr REQUIRED)
  add_library(flint INTERFACE IMPORTED GLOBAL)
  target_link_libraries(flint INTERFACE ${FLINT_LIBRARY} ${MPFR_LIBRARY} PkgConfig::gmp)
  foreach(needed bsd md tinfo)
    find_library(STATIC_${needed} ${needed} REQUIRED)
    target_link_libraries(PkgConfig::libedit INTERFACE ${STATIC_${needed}})
  endforeach()
endfunction()

# durero_static_program(TARGET): a program that needs no library of the machine that it runs on.
function(durero_static_program TARGET)
  if(DURERO_STATIC)
    target_link_options(${TARGET} PRIVATE -static-pie)
  endif()
endfunction()
