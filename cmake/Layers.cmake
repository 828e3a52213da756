# The headers of other projects that most sources include, compiled once for all layers, with DURERO_PCH: to read them
# takes most of the time of a short source. Nothing of this project is among them, so that a change here compiles only
# what depends on it. What a source includes without need of it is then not seen missing, which the builds by Clang and for
# clang-tidy see: their presets have it off.
set(durero_foreign_headers <algorithm> <array> <charconv> <cmath> <cstdint> <functional> <limits> <map> <memory>
  <numeric> <optional> <set> <span> <stdexcept> <string> <string_view> <tuple> <unordered_map> <utility> <variant>
  <vector> <boost/container/small_vector.hpp> <boost/multiprecision/cpp_int.hpp> <boost/multiprecision/gmp.hpp>
  <fmt/format.h> <glm/geometric.hpp> <glm/vec3.hpp>)

# durero_precompile(TARGET HEADERS...): compiles them for TARGET and for each target that durero_precompiled gives them.
# The definitions that they depend on are those of every target, or a compiler would not take them.
function(durero_precompile TARGET)
  if(DURERO_PCH)
    target_precompile_headers(${TARGET} PRIVATE ${ARGN})
  endif()
endfunction()

function(durero_precompiled TARGET FROM)
  if(DURERO_PCH)
    target_precompile_headers(${TARGET} REUSE_FROM ${FROM})
  endif()
endfunction()

# durero_united(TARGET COUNT): with DURERO_UNITY, so many of its sources are compiled as one, which reads the headers and
# compiles the templates that they share once. What Highway compiles again for each instruction set stands alone.
function(durero_united TARGET COUNT)
  if(DURERO_UNITY)
    set_target_properties(${TARGET} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${COUNT})
  endif()
endfunction()

# durero_shareable(TARGET): its objects may stand in a shared library, such as Python's module; that another library
# could put a function of its own in the place of one of ours is not provided for, so they lose no speed by it.
function(durero_shareable TARGET)
  set_target_properties(${TARGET} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_compile_options(${TARGET} PRIVATE -fno-semantic-interposition)
endfunction()

# After the packages are found.
function(durero_foreign)
  if(NOT DURERO_PCH)
    return()
  endif()
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/foreign.cpp CONTENT "")
  add_library(durero_foreign OBJECT ${PROJECT_BINARY_DIR}/foreign.cpp)
  foreach(package fmt::fmt Boost::headers)
    target_compile_definitions(durero_options INTERFACE $<TARGET_PROPERTY:${package},INTERFACE_COMPILE_DEFINITIONS>)
  endforeach()
  target_link_libraries(durero_foreign PRIVATE durero_options fmt::fmt Boost::headers glm::glm PkgConfig::gmp)
  durero_shareable(durero_foreign)
  durero_precompile(durero_foreign ${durero_foreign_headers})
endfunction()

# durero_layer(NAME DEPENDS <layers above it> LIBRARIES <packages> UNITED <count>): one target a layer, made of
# include/durero/NAME/ and the sources in src/NAME/ and its folders; header-only while there are none. A static library,
# or with BUILD_SHARED_LIBS a shared one.
function(durero_sources OUT DIR)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${DIR}/*.cpp)
  set(${OUT} ${sources} PARENT_SCOPE)
endfunction()

# durero_target(NAME UNITED SOURCES...): the library of a layer or of a part of one.
function(durero_target NAME UNITED)
  add_library(durero_${NAME} ${ARGN})
  add_library(durero::${NAME} ALIAS durero_${NAME})
  set_target_properties(durero_${NAME} PROPERTIES VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}
    EXPORT_NAME ${NAME})
  target_include_directories(durero_${NAME} PRIVATE ${PROJECT_SOURCE_DIR}/src)
  durero_shareable(durero_${NAME})
  durero_united(durero_${NAME} ${UNITED})
  durero_precompiled(durero_${NAME} durero_foreign)
endfunction()

function(durero_layer NAME)
  cmake_parse_arguments(LAYER "" "UNITED" "DEPENDS;LIBRARIES" ${ARGN})
  if(NOT LAYER_UNITED)
    set(LAYER_UNITED 10)
  endif()
  list(TRANSFORM LAYER_DEPENDS PREPEND durero::)
  durero_sources(sources src/${NAME})
  if(sources)
    durero_target(${NAME} ${LAYER_UNITED} ${sources})
    set(scope PUBLIC)
  else()
    add_library(durero_${NAME} INTERFACE)
    add_library(durero::${NAME} ALIAS durero_${NAME})
    set_target_properties(durero_${NAME} PROPERTIES EXPORT_NAME ${NAME})
    set(scope INTERFACE)
  endif()
  target_link_libraries(durero_${NAME} ${scope} durero_options ${LAYER_DEPENDS} ${LAYER_LIBRARIES})
  set_property(GLOBAL APPEND PROPERTY DURERO_LAYERS ${NAME})
endfunction()

# durero_part(NAME OF LAYER FILES <what leaves the layer's target> DEPENDS <further layers>): a target of its own, in the
# same folders, for what a program of that layer may do without.
function(durero_part NAME)
  cmake_parse_arguments(PART "" "OF" "FILES;DEPENDS" ${ARGN})
  list(JOIN PART_FILES "|" files)
  get_target_property(sources durero_${PART_OF} SOURCES)
  set(part ${sources})
  list(FILTER part INCLUDE REGEX "/src/${PART_OF}/(${files})")
  list(REMOVE_ITEM sources ${part})
  set_target_properties(durero_${PART_OF} PROPERTIES SOURCES "${sources}")
  get_target_property(united durero_${PART_OF} UNITY_BUILD_BATCH_SIZE)
  durero_target(${NAME} "${united}" ${part})
  list(TRANSFORM PART_DEPENDS PREPEND durero::)
  target_link_libraries(durero_${NAME} PUBLIC durero::${PART_OF} ${PART_DEPENDS})
  set_property(GLOBAL APPEND PROPERTY DURERO_LAYERS ${NAME})
endfunction()

# durero_embed(TARGET FUNCTION ROOT FILES...): files as text in the program, by their names from ROOT, through the
# function durero::embedded::FUNCTION().
function(durero_embed TARGET FUNCTION ROOT)
  set(out ${CMAKE_CURRENT_BINARY_DIR}/embedded/${FUNCTION}.cpp)
  add_custom_command(OUTPUT ${out}
    COMMAND ${CMAKE_COMMAND} -D OUT=${out} -D FUNCTION=${FUNCTION} -D ROOT=${ROOT} "-DFILES=${ARGN}"
      -P ${PROJECT_SOURCE_DIR}/cmake/EmbedText.cmake
    DEPENDS ${ARGN} ${PROJECT_SOURCE_DIR}/cmake/EmbedText.cmake VERBATIM)
  # Alone, so that what stands beside it compiles without what a build makes.
  set_source_files_properties(${out} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  target_sources(${TARGET} PRIVATE ${out})
endfunction()

# The program carries where each label of the Z text stands: cmake/label_index.sh.
function(durero_embed_labels TARGET)
  file(GLOB_RECURSE labelled CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/spec/*.tex
    ${PROJECT_SOURCE_DIR}/include/durero/model/*.hpp ${PROJECT_SOURCE_DIR}/src/model/*.cpp
    ${PROJECT_SOURCE_DIR}/include/durero/scene/*.hpp ${PROJECT_SOURCE_DIR}/src/scene/*.cpp
    ${PROJECT_SOURCE_DIR}/include/durero/surface/*.hpp ${PROJECT_SOURCE_DIR}/src/surface/*.cpp
    ${PROJECT_SOURCE_DIR}/tests/*.cpp ${PROJECT_SOURCE_DIR}/proofs/*.v)
  set(index ${CMAKE_CURRENT_BINARY_DIR}/embedded/labels.txt)
  add_custom_command(OUTPUT ${index} COMMAND sh ${PROJECT_SOURCE_DIR}/cmake/label_index.sh > ${index}
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} DEPENDS ${labelled} ${PROJECT_SOURCE_DIR}/cmake/label_index.sh VERBATIM)
  durero_embed(${TARGET} labels ${CMAKE_CURRENT_BINARY_DIR}/embedded ${index})
endfunction()

# What calls answer of texts that they carry (docs/formats/call.md).
function(durero_embed_for_calls TARGET)
  file(GLOB printed CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/spec/impresa/*.tex
    ${PROJECT_SOURCE_DIR}/spec/impresa/dibujo/*.tex ${PROJECT_SOURCE_DIR}/spec/impresa/dibujo/*.json)
  durero_embed(${TARGET} errata ${PROJECT_SOURCE_DIR}/spec ${PROJECT_SOURCE_DIR}/spec/erratas.md ${printed})
  durero_embed(${TARGET} assumptions ${PROJECT_SOURCE_DIR}/proofs ${PROJECT_SOURCE_DIR}/proofs/assumptions.txt)
  durero_embed_labels(${TARGET})
endfunction()
