# How every target of the project is compiled, and the two helpers that make one.

# Language, warnings, determinism and sanitizers, for our own code only.
add_library(morphkit_options INTERFACE)
target_compile_features(morphkit_options INTERFACE cxx_std_20)
target_compile_options(morphkit_options INTERFACE
  # g++ otherwise fuses multiplies and adds behind our back: results would depend on the instruction set.
  -ffp-contract=off
  -Wall -Wextra -Wshadow -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor -Woverloaded-virtual)
if(MORPHKIT_SANITIZE)
  target_compile_options(morphkit_options INTERFACE
    -fsanitize=${MORPHKIT_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=undefined
    # Where variables live at each instruction takes g++ as long as all the rest of a kernel; stack traces need none of it.
    $<$<CXX_COMPILER_ID:GNU>:-fno-var-tracking>)
  target_link_options(morphkit_options INTERFACE -fsanitize=${MORPHKIT_SANITIZE})
endif()

# Only what touches pixels gains from -O3; the rest compiles in half the time at -O1.
function(morphkit_optimize target level)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O${level}>)
endfunction()

# morphkit_library(<name> SOURCES ... HEADERS ... PUBLIC ... PRIVATE ... [PIXELS])
# A static library morphkit_<name>, alias morphkit::<name>, whose headers are included from the root of the tree.
# PIXELS: it has loops over pixels.
function(morphkit_library name)
  cmake_parse_arguments(ARG "PIXELS" "" "SOURCES;HEADERS;PUBLIC;PRIVATE" ${ARGN})
  add_library(morphkit_${name} STATIC ${ARG_SOURCES})
  morphkit_optimize(morphkit_${name} $<IF:$<BOOL:${ARG_PIXELS}>,3,1>)
  add_library(morphkit::${name} ALIAS morphkit_${name})
  set_target_properties(morphkit_${name} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON)
  target_include_directories(morphkit_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/morphkit>)
  target_compile_features(morphkit_${name} PUBLIC cxx_std_20)
  target_link_libraries(morphkit_${name} PUBLIC ${ARG_PUBLIC}
    PRIVATE $<BUILD_INTERFACE:morphkit_options> ${ARG_PRIVATE})
  set_property(GLOBAL APPEND PROPERTY MORPHKIT_LIBRARIES morphkit_${name})
  file(RELATIVE_PATH folder "${PROJECT_SOURCE_DIR}" "${CMAKE_CURRENT_SOURCE_DIR}")
  install(FILES ${ARG_HEADERS} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/morphkit/${folder} COMPONENT development)
endfunction()

# morphkit_test(<name> SOURCES ... LIBS ...)
# One GoogleTest binary and one ctest entry <name>. A binary, not a test case, is the unit: start-up is paid once.
function(morphkit_test name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LIBS" ${ARGN})
  string(REPLACE "." "_" target "test_${name}")
  add_executable(${target} ${ARG_SOURCES})
  target_link_libraries(${target} PRIVATE morphkit_options ${ARG_LIBS} GTest::gtest_main)
  target_include_directories(${target} PRIVATE "${PROJECT_SOURCE_DIR}")
  morphkit_optimize(${target} 1)
  add_test(NAME ${name} COMMAND ${target})
endfunction()
