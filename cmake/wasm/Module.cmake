# The build as WebAssembly: one module, durero_web, of the sources of the layers that `web` stands on, and nothing else of
# this project. What these take from GMP, FLINT, oneTBB and parts of the standard library that WASI lacks stands in this
# folder: headers in include/, which are found first, and sources that are compiled in the place of a layer's own.
set(headers ${PROJECT_BINARY_DIR}/headers)
file(MAKE_DIRECTORY ${headers})
foreach(header boost/version.hpp glm/glm.hpp fmt/format.h hwy/highway.h rapidjson/rapidjson.h)
  get_filename_component(package ${header} DIRECTORY)
  find_path(HEADERS_${package} ${header} PATHS /usr/include NO_DEFAULT_PATH REQUIRED)
endforeach()
# A link to each alone: beside them stand the headers of another system's C library.
foreach(package boost glm fmt hwy)
  file(CREATE_LINK ${HEADERS_${package}}/${package} ${headers}/${package} SYMBOLIC)
endforeach()
# RapidJSON 1.1 assigns to constants in a function that nobody calls, which Clang 19 refuses: a copy without it.
file(COPY ${HEADERS_rapidjson}/rapidjson DESTINATION ${headers})
file(READ ${headers}/rapidjson/document.h document)
string(REPLACE "{ s = rhs.s; length = rhs.length; }" "= delete;" document "${document}")
file(WRITE ${headers}/rapidjson/document.h "${document}")

# Whatever is compiled is compiled so.
add_library(durero_module INTERFACE)
target_include_directories(durero_module BEFORE INTERFACE ${CMAKE_CURRENT_LIST_DIR}/include)
target_include_directories(durero_module INTERFACE src)
target_include_directories(durero_module SYSTEM INTERFACE ${headers})
target_link_libraries(durero_module INTERFACE durero_options)
target_compile_definitions(durero_module INTERFACE DURERO_VERSION="${PROJECT_VERSION}" FMT_HEADER_ONLY HWY_COMPILE_ONLY_STATIC
  _LIBCPP_ENABLE_CXX17_REMOVED_UNARY_BINARY_FUNCTION)  # Boost 1.74 derives from one
# A text in a memory of 32 bits has fewer bytes than they count. ccache asks for the other.
target_compile_options(durero_module INTERFACE -Wno-shorten-64-to-32 "SHELL:-Xclang -fno-pch-timestamp")
# The C library does not copy descriptors; whoever asks for the standard input is refused.
set_source_files_properties(src/io/input.cpp PROPERTIES COMPILE_DEFINITIONS F_DUPFD_CLOEXEC=1030)

file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/foreign.cpp CONTENT "")
add_library(durero_foreign OBJECT ${PROJECT_BINARY_DIR}/foreign.cpp)
target_link_libraries(durero_foreign PRIVATE durero_module)
durero_precompile(durero_foreign ${durero_foreign_headers})

# The module's functions stand in module.cpp: it has no main program.
file(GLOB stand_ins CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/*.cpp)
add_executable(durero_web ${stand_ins})
target_link_libraries(durero_web PRIVATE durero_module)
durero_precompiled(durero_web durero_foreign)

foreach(layer text contract number algebra polygon mesh zed model scene spec surface oracle trace accel distance engine
    composed io written render shader web)
  durero_sources(sources src/${layer})
  if(layer STREQUAL io)  # what reads and writes scenes, rays and hits
    list(FILTER sources EXCLUDE REGEX "/src/io/(mesh|mitsuba|nff|pbrt|placed|pov|radiance|written|pictures)/")
    list(FILTER sources EXCLUDE REGEX
      "/src/io/(exported_files|formats|file_lock|output_file|scene_folder|spool|standard_output|temporary|rays/hits_file)\\.cpp$")
  elseif(layer STREQUAL render)  # what a shader is made of
    list(FILTER sources INCLUDE REGEX "/src/render/(still_scene|light/(directions|followed))\\.cpp$")
  endif()
  # What GMP and FLINT do in these, the sources of this folder do.
  list(FILTER sources EXCLUDE REGEX "/src/(number/(integers|memory)|algebra/coefficient)\\.cpp$")
  add_library(durero_of_${layer} OBJECT ${sources})
  target_link_libraries(durero_of_${layer} PRIVATE durero_module)
  durero_united(durero_of_${layer} 12)
  durero_precompiled(durero_of_${layer} durero_foreign)
  target_sources(durero_web PRIVATE $<TARGET_OBJECTS:durero_of_${layer}>)
endforeach()
file(GLOB z_text CONFIGURE_DEPENDS spec/*.tex)
durero_embed(durero_web z_text ${PROJECT_SOURCE_DIR} ${z_text})
durero_embed_for_calls(durero_web)

# A stack of 1 MiB stands below all else, so that what outgrows it is seen.
set_target_properties(durero_web PROPERTIES OUTPUT_NAME durero SUFFIX .wasm)
target_link_options(durero_web PRIVATE -mexec-model=reactor -Wl,--stack-first,-z,stack-size=1048576,--strip-all)
# The script that a page or node takes: web/engine.js with the module in it.
add_custom_command(TARGET durero_web POST_BUILD VERBATIM
  COMMAND sh ${CMAKE_CURRENT_LIST_DIR}/engine.sh durero.wasm ${PROJECT_SOURCE_DIR}/web/engine.js > durero.js)
set_property(TARGET durero_web PROPERTY LINK_DEPENDS ${PROJECT_SOURCE_DIR}/web/engine.js ${CMAKE_CURRENT_LIST_DIR}/engine.sh)
