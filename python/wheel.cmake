# A wheel: the module, the command durero with its systems, its manual and what completes its calls, and one library of which
# both are made, libdurero.so, so that a wheel has the layers once. The library lies in the package. The command finds it there
# from where it stands: the folders of a scheme of Python's, and of `pip install --target`, are the same everywhere.
list(TRANSFORM layers REPLACE "(.+)" "$<TARGET_OBJECTS:\\1>" OUTPUT_VARIABLE objects)  # the module calls what the commands do not
add_library(durero_wheel SHARED ${objects})
target_link_libraries(durero_wheel PRIVATE durero_cli durero_commands ${layers})
target_link_libraries(durero_wheel INTERFACE durero_options Boost::headers glm::glm fmt::fmt PkgConfig::gmp PkgConfig::hwy TBB::tbb)
# Python takes a file in a package that ends in .so for a module.
set_target_properties(durero_wheel PROPERTIES OUTPUT_NAME durero SUFFIX .so.${PROJECT_VERSION} LIBRARY_OUTPUT_DIRECTORY ${package}
  LINKER_LANGUAGE CXX LINK_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/library.map)
# Calls within the library stay in it, whatever else a process has loaded.
target_link_options(durero_wheel PRIVATE LINKER:--version-script=${CMAKE_CURRENT_SOURCE_DIR}/library.map
  LINKER:-Bsymbolic LINKER:--as-needed)

set(manual ${PROJECT_BINARY_DIR}/wheel/manual)
file(MAKE_DIRECTORY ${manual})
add_executable(durero_command ${program_source})
target_include_directories(durero_command PRIVATE ${PROJECT_SOURCE_DIR}/src)
target_link_libraries(durero_command PRIVATE durero_wheel)
set(of_python python${Python_VERSION_MAJOR}.${Python_VERSION_MINOR})
set(from_command lib/${of_python}/site-packages lib64/${of_python}/site-packages lib/${of_python}/dist-packages .)
list(TRANSFORM from_command REPLACE "(.+)" "$ORIGIN/../\\1/durero")
set_target_properties(durero_command PROPERTIES OUTPUT_NAME durero RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/wheel
  INSTALL_RPATH "${from_command}")
add_custom_command(TARGET durero_command POST_BUILD VERBATIM
  COMMAND durero_command man --directory ${manual}/man1
  COMMAND durero_command completion bash > ${manual}/durero
  COMMAND durero_command completion zsh > ${manual}/_durero
  COMMAND durero_command completion fish > ${manual}/durero.fish)
set_target_properties(durero_python PROPERTIES INSTALL_RPATH $ORIGIN)
# No folder of the build is in them, not even in the digest that the linker makes of what it links.
set_target_properties(durero_python durero_command PROPERTIES BUILD_RPATH_USE_ORIGIN ON)

set(shared ${SKBUILD_DATA_DIR}/share)
install(TARGETS durero_python durero_wheel LIBRARY DESTINATION durero COMPONENT python)
install(TARGETS durero_command RUNTIME DESTINATION ${SKBUILD_SCRIPTS_DIR} COMPONENT python)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/systems DESTINATION ${shared}/durero COMPONENT python PATTERN __pycache__ EXCLUDE)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/schemas DESTINATION ${shared}/durero COMPONENT python)
install(DIRECTORY ${manual}/man1 DESTINATION ${shared}/man COMPONENT python)
install(FILES ${manual}/durero DESTINATION ${shared}/bash-completion/completions COMPONENT python)
install(FILES ${manual}/_durero DESTINATION ${shared}/zsh/site-functions COMPONENT python)
install(FILES ${manual}/durero.fish DESTINATION ${shared}/fish/vendor_completions.d COMPONENT python)
