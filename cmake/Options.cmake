# The rules every target is compiled under. They are part of the meaning: a result is the exact value rounded
# once, and the error bounds in the sources assume each operation is one IEEE 754 binary64 operation.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

# A compilation takes one precompiled header, so flags that include a file of their own go before.
if(CMAKE_CXX_FLAGS MATCHES "-include ")
  set(DURERO_PCH OFF)
endif()

find_program(CCACHE ccache)
if(CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
  if(DURERO_PCH)  # what ccache asks for, to keep what includes a precompiled header
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${CCACHE})
  endif()
endif()

# Shared libraries find each other, and the program finds them, from where they stand: in whatever prefix that is.
if(BUILD_SHARED_LIBS)
  include(GNUInstallDirs)
  file(RELATIVE_PATH to_libraries /${CMAKE_INSTALL_BINDIR} /${CMAKE_INSTALL_LIBDIR})
  set(CMAKE_INSTALL_RPATH $ORIGIN $ORIGIN/${to_libraries})
endif()

# What whoever includes the headers must compile with too; the warnings are for our own sources alone.
add_library(durero_options INTERFACE)
target_compile_features(durero_options INTERFACE cxx_std_20)
target_compile_options(durero_options INTERFACE -ffp-contract=off -fno-fast-math
  # A violated clause says where it was evaluated: from the root, so that the same sources give the same bytes in any folder.
  $<BUILD_INTERFACE:-ffile-prefix-map=${PROJECT_SOURCE_DIR}/=>)
if(PROJECT_IS_TOP_LEVEL)
  target_compile_options(durero_options INTERFACE "$<BUILD_INTERFACE:-Wall;-Wextra;-Wpedantic;-Wconversion>"
    # Where several sources are compiled as one, a name of one may hide another's.
    "$<BUILD_INTERFACE:$<$<NOT:$<BOOL:$<TARGET_PROPERTY:UNITY_BUILD>>>:-Wshadow>>"
    # And GCC takes them for a header, in which a type would better not depend on names of one source.
    "$<BUILD_INTERFACE:$<$<AND:$<CXX_COMPILER_ID:GNU>,$<BOOL:$<TARGET_PROPERTY:UNITY_BUILD>>>:-Wno-subobject-linkage>>"
    # A closed set is known everywhere, or it does not compile.
    "$<BUILD_INTERFACE:-Werror=switch;-Werror=return-type>")
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND DURERO_PCH)
  target_compile_options(durero_options INTERFACE $<BUILD_INTERFACE:-fpch-preprocess>)  # ccache asks for it too
endif()
target_include_directories(durero_options INTERFACE
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:include>)
set_target_properties(durero_options PROPERTIES EXPORT_NAME options)

if(DURERO_TIDY)
  find_program(CLANG_TIDY NAMES clang-tidy-16 clang-tidy REQUIRED)
  set(CMAKE_CXX_CLANG_TIDY ${CLANG_TIDY})
endif()
