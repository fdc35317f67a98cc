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

# The headers that most sources include, compiled once for each way of compiling: half the time of an average source.
# Sources still include what they use; clang-tidy reads them without this. A header compiled at one level crashes g++ 12
# at another, hence a carrier per level.
set(MORPHKIT_COMMON_HEADERS
  <algorithm> <cmath> <filesystem> <functional> <memory> <optional> <span> <string> <variant> <vector>
  <fmt/format.h> <opencv2/core.hpp>)
file(CONFIGURE OUTPUT "${PROJECT_BINARY_DIR}/headers.cpp" CONTENT "// Carries the precompiled headers.\n")
if(NOT CMAKE_DISABLE_PRECOMPILE_HEADERS)
  target_compile_options(morphkit_options INTERFACE
    # The first is for ccache, and so is clang's. Warnings of precompiled headers are not told from ours, and g++ 12 has
    # false ones about std::string.
    "$<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess;-Wno-array-bounds;-Wno-restrict;-Wno-stringop-overflow>"
    "$<$<CXX_COMPILER_ID:Clang>:SHELL:-Xclang -fno-pch-timestamp>")
  # One way of including fmt, whether or not a target links it.
  target_compile_definitions(morphkit_options INTERFACE $<TARGET_PROPERTY:fmt::fmt,INTERFACE_COMPILE_DEFINITIONS>)
endif()

# morphkit_headers(<name> <level> LIBS...): the carrier morphkit_headers_<name>, compiled at -O<level> in a release.
function(morphkit_headers name level)
  add_library(morphkit_headers_${name} OBJECT "${PROJECT_BINARY_DIR}/headers.cpp")
  target_link_libraries(morphkit_headers_${name} PRIVATE morphkit_options opencv_core fmt::fmt ${ARGN})
  target_compile_options(morphkit_headers_${name} PRIVATE $<$<CONFIG:Release>:-O${level}>)
  target_precompile_headers(morphkit_headers_${name} PRIVATE ${MORPHKIT_COMMON_HEADERS})
endfunction()
morphkit_headers(1 1)
morphkit_headers(3 3)
set_target_properties(morphkit_headers_1 morphkit_headers_3 PROPERTIES POSITION_INDEPENDENT_CODE ON)
if(MORPHKIT_BUILD_TESTS)
  morphkit_headers(test 1 GTest::gtest)
  target_precompile_headers(morphkit_headers_test PRIVATE <gtest/gtest.h>)
endif()

# morphkit_compile(<target> <level>): how a library of ours is compiled. Only what touches pixels gains from -O3; the rest
# compiles in half the time at -O1.
function(morphkit_compile target level)
  target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:morphkit_options>)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O${level}>)
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_precompile_headers(${target} REUSE_FROM morphkit_headers_${level})
endfunction()

# morphkit_library(<name> SOURCES ... HEADERS ... PUBLIC ... PRIVATE ... [PIXELS])
# A static library morphkit_<name>, alias morphkit::<name>, whose headers are included from the root of the tree.
# PIXELS: it has loops over pixels.
function(morphkit_library name)
  cmake_parse_arguments(ARG "PIXELS" "" "SOURCES;HEADERS;PUBLIC;PRIVATE" ${ARGN})
  add_library(morphkit_${name} STATIC ${ARG_SOURCES})
  if(ARG_PIXELS)
    morphkit_compile(morphkit_${name} 3)
  else()
    morphkit_compile(morphkit_${name} 1)
  endif()
  add_library(morphkit::${name} ALIAS morphkit_${name})
  set_target_properties(morphkit_${name} PROPERTIES EXPORT_NAME ${name})
  target_include_directories(morphkit_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/morphkit>)
  target_compile_features(morphkit_${name} PUBLIC cxx_std_20)
  target_link_libraries(morphkit_${name} PUBLIC ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE})
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
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
  target_precompile_headers(${target} REUSE_FROM morphkit_headers_test)
  add_test(NAME ${name} COMMAND ${target})
endfunction()
