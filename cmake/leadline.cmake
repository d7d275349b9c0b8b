# How every Leadline library, program and test is compiled: one place for flags.

find_program(CCACHE ccache)
if(CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # Relative paths and no build folder in the key: every build folder of the tree shares what was compiled.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_NOHASHDIR=1
    CCACHE_SLOPPINESS=pch_defines,time_macros ${CCACHE})
endif()

add_library(leadline_flags INTERFACE)
target_include_directories(leadline_flags INTERFACE ${PROJECT_SOURCE_DIR})
# No fused multiply-add and no fast-math: a golden number does not depend on the processor.
target_compile_options(leadline_flags INTERFACE -ffp-contract=off -Wall -Wextra -Wpedantic -Wshadow
  -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor -Woverloaded-virtual -Wimplicit-fallthrough
  -Wformat=2 -Werror=format-security
  -Wno-missing-field-initializers)  # designated initialisers leave the rest to the defaults
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # GCC 12 reports uninitialised members of std::optional inside std::variant that are never read.
  target_compile_options(leadline_flags INTERFACE -Wno-maybe-uninitialized)
  target_compile_options(leadline_flags INTERFACE -fpch-preprocess)  # lets ccache see through precompiled headers
endif()
if(LEADLINE_STRICT)
  target_compile_options(leadline_flags INTERFACE -Werror)
endif()
if(LEADLINE_SANITIZE)
  target_compile_options(leadline_flags INTERFACE -fsanitize=${LEADLINE_SANITIZE} -fno-omit-frame-pointer
    -fno-sanitize-recover=all)
  target_link_options(leadline_flags INTERFACE -fsanitize=${LEADLINE_SANITIZE})
endif()

# leadline_library(core_geo SOURCES a.cpp b.cpp LINKS core_types): the static library of one folder.
# Its headers are spelt from the root: #include "core/geo/geodesy.h".
function(leadline_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS;PRIVATE_LINKS" ${ARGN})
  add_library(${name} STATIC ${ARG_SOURCES})
  target_link_libraries(${name} PUBLIC leadline_flags ${ARG_LINKS} PRIVATE ${ARG_PRIVATE_LINKS})
endfunction()

# leadline_core_part(core_flow SOURCES a.cpp PRIVATE_LINKS fmt::fmt): one folder of libleadline-core.so. The
# name then stands for the whole library; core_flow_part is the folder's objects alone.
function(leadline_core_part name)
  cmake_parse_arguments(ARG "" "" "SOURCES;PRIVATE_LINKS" ${ARGN})
  add_library(${name} ALIAS leadline-core)
  if(ARG_SOURCES)
    add_library(${name}_part OBJECT ${ARG_SOURCES})
    target_link_libraries(${name}_part PUBLIC leadline_flags Eigen3::Eigen ${ARG_PRIVATE_LINKS})
    # Calls inside the library stay as direct as they were in a static one.
    target_compile_options(${name}_part PRIVATE -fno-semantic-interposition)
    target_sources(leadline-core PRIVATE $<TARGET_OBJECTS:${name}_part>)
    target_link_libraries(leadline-core PRIVATE ${ARG_PRIVATE_LINKS})
  endif()
endfunction()

# leadline_test(unit_core_geo [GUI] SOURCES ... LINKS ...): one GoogleTest binary for one folder. GUI: with a
# QApplication and test::expect_picture(); such tests carry the label "screenshot".
function(leadline_test name)
  cmake_parse_arguments(ARG "GUI" "" "SOURCES;LINKS" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE leadline_flags ${ARG_LINKS} GTest::gmock
    $<IF:$<BOOL:${ARG_GUI}>,test_gui,GTest::gtest_main>)
  target_compile_definitions(${name} PRIVATE LEADLINE_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
    LEADLINE_BINARY_DIR="${PROJECT_BINARY_DIR}" LEADLINE_TEST_DATA="${PROJECT_SOURCE_DIR}/tests/data")
  target_precompile_headers(${name} PRIVATE <gmock/gmock.h> <gtest/gtest.h> <string> <vector>)
  add_test(NAME ${name} COMMAND ${name})
  if(ARG_GUI)
    set_tests_properties(${name} PROPERTIES LABELS screenshot)
  endif()
endfunction()
