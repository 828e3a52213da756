# What cmake --install puts in place: the program and its systems, the layers as libraries with their public headers, and
# what find_package(durero CONFIG) and pkg-config read. durero::durero is all layers.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

get_property(layers GLOBAL PROPERTY DURERO_LAYERS)
list(TRANSFORM layers PREPEND durero_ OUTPUT_VARIABLE layer_targets)
add_library(durero_all INTERFACE)
add_library(durero::durero ALIAS durero_all)
target_link_libraries(durero_all INTERFACE ${layer_targets})
set_target_properties(durero_all PROPERTIES EXPORT_NAME durero)

install(TARGETS durero)
install(TARGETS durero_all durero_options ${layer_targets} EXPORT durero)

# `./x build` builds this target: every target that cmake --install installs, and no test.
add_custom_target(durero_installation DEPENDS durero ${layer_targets})
install(DIRECTORY include/durero TYPE INCLUDE FILES_MATCHING PATTERN "*.h" PATTERN "*.hpp")
install(DIRECTORY systems DESTINATION ${CMAKE_INSTALL_DATADIR}/durero PATTERN __pycache__ EXCLUDE)
install(DIRECTORY schemas DESTINATION ${CMAKE_INSTALL_DATADIR}/durero)
install(FILES LICENSE README.md TYPE DOC)

# The manual's pages, and what completes calls in a shell: the program writes them of what it declares.
set(manual ${PROJECT_BINARY_DIR}/manual)
file(MAKE_DIRECTORY ${manual})
add_custom_command(TARGET durero POST_BUILD VERBATIM
  COMMAND durero man --directory ${manual}/man1
  COMMAND durero completion bash > ${manual}/durero
  COMMAND durero completion zsh > ${manual}/_durero
  COMMAND durero completion fish > ${manual}/durero.fish)
install(DIRECTORY ${manual}/man1 DESTINATION ${CMAKE_INSTALL_MANDIR})
install(FILES ${manual}/durero DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(FILES ${manual}/_durero DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions)
install(FILES ${manual}/durero.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)

# Who links the static library needs libpq where the library was built with it.
set(find_libpq "")
set(pc_libpq "")
if(DURERO_POSTGRESQL AND libpq_FOUND)
  set(find_libpq "pkg_check_modules(libpq REQUIRED IMPORTED_TARGET libpq)")
  set(pc_libpq " libpq")
endif()

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/durero)
install(EXPORT durero NAMESPACE durero:: FILE durero-targets.cmake DESTINATION ${package})
configure_package_config_file(cmake/durero-config.cmake.in durero-config.cmake INSTALL_DESTINATION ${package}
  NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(durero-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/durero-config.cmake ${PROJECT_BINARY_DIR}/durero-config-version.cmake
  DESTINATION ${package})

# A static library stands before those that it needs.
set(pc_libraries "")
foreach(layer IN LISTS layers)
  get_target_property(type durero_${layer} TYPE)
  if(NOT type STREQUAL INTERFACE_LIBRARY)
    string(PREPEND pc_libraries " -ldurero_${layer}")
  endif()
endforeach()
file(RELATIVE_PATH pc_to_include /${CMAKE_INSTALL_LIBDIR}/pkgconfig /${CMAKE_INSTALL_INCLUDEDIR})
# A compiler of C links no library of C++ by itself: these are named for it.
set(pc_runtime "")
foreach(library IN LISTS CMAKE_CXX_IMPLICIT_LINK_LIBRARIES)
  if(library MATCHES "^(stdc[+][+]|c[+][+]|m)$")
    string(APPEND pc_runtime " -l${library}")
  endif()
endforeach()
# durero is for programs in C++, durero-c for programs in C, whose compiler refuses flags of C++.
set(pc_name durero)
set(pc_flags " -std=c++20 -ffp-contract=off -fno-fast-math")
configure_file(cmake/durero.pc.in durero.pc @ONLY)
set(pc_name durero-c)
set(pc_flags "")
configure_file(cmake/durero.pc.in durero-c.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/durero.pc ${PROJECT_BINARY_DIR}/durero-c.pc
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
