# Tests by the place and name of their files (see CONTRIBUTING.md):
#   sunder/<layer>/**/x_test.cpp   one executable a layer, ctest unit_<layer>                 labels unit, <layer>
#   verifier/, cli/ x_test.cpp     the same: unit_verifier, unit_cli
#   tests/x_<kind>_test.cpp        an executable and a ctest entry each: x_<kind>_test        labels tests, <kind>
#   tests/support/*.cpp            linked to all of these
#   tests/tools/x.cpp              an executable each, in <build>/tools
#   examples/x.cpp                 an executable each, run: example_x                         label example
#   verifier/, cli/, tests/ x_test.py   run by Python: x_test_py (test_x.py does too)          label script
# The label slow (kind slow, and the consumer) is left out by ./do test --quick.
# The environment: SUNDER_TEST_SCALE multiplies the numbers of random instances, SUNDER_TEST_SEED moves their seeds.
find_package(GTest REQUIRED)
find_package(rapidcheck REQUIRED)
find_package(Python3 REQUIRED COMPONENTS Interpreter)

set(definitions SUNDER_CASES_DIR="${PROJECT_SOURCE_DIR}/cases" SUNDER_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
                SUNDER_BUILD_DIR="${PROJECT_BINARY_DIR}")
set(environment SUNDER_CASES_DIR=${PROJECT_SOURCE_DIR}/cases SUNDER_SOURCE_DIR=${PROJECT_SOURCE_DIR}
                PYTHONDONTWRITEBYTECODE=1)
set(libraries sunder_core)
foreach(target sunder_io sunder_verifier)
  if(TARGET ${target})
    list(APPEND libraries ${target})
  endif()
endforeach()
if(TARGET sunder_cli)
  list(APPEND definitions SUNDER_PROGRAM="$<TARGET_FILE:sunder_cli>")
  list(APPEND environment SUNDER_PROGRAM=$<TARGET_FILE:sunder_cli>)
endif()

sunder_glob(sources "tests/support/*.cpp")
if(sources)
  add_library(sunder_test_support STATIC ${sources})
  target_link_libraries(sunder_test_support PUBLIC ${libraries} GTest::gtest rapidcheck)
  target_compile_definitions(sunder_test_support PUBLIC ${definitions})
  sunder_own_code(sunder_test_support)
  list(APPEND libraries sunder_test_support)
endif()

function(sunder_add_executable target folder)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "" "SOURCES;LINK")
  add_executable(${target} ${arg_SOURCES})
  set_target_properties(${target} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/${folder})
  target_compile_definitions(${target} PRIVATE ${definitions})
  target_link_libraries(${target} PRIVATE ${libraries} ${arg_LINK})
  sunder_own_code(${target})
endfunction()

function(sunder_add_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "TIMEOUT" "COMMAND;LABELS")
  add_test(NAME ${name} COMMAND ${arg_COMMAND} WORKING_DIRECTORY ${PROJECT_BINARY_DIR})
  set_tests_properties(${name} PROPERTIES TIMEOUT ${arg_TIMEOUT} LABELS "${arg_LABELS}" ENVIRONMENT "${environment}")
endfunction()

# Beside the sources.
foreach(folder ${SUNDER_CORE_LAYERS} io verifier cli)
  set(place sunder/${folder})
  set(link GTest::gtest_main rapidcheck)
  if(folder STREQUAL "verifier")
    set(place verifier)
  elseif(folder STREQUAL "cli")
    set(place cli)
    list(APPEND link sunder_cli_verbs)
  endif()
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${place}/*_test.cpp)
  if(sources)
    sunder_add_executable(sunder_unit_${folder} tests SOURCES ${sources} LINK ${link})
    sunder_add_test(unit_${folder} COMMAND sunder_unit_${folder} TIMEOUT 300 LABELS unit ${folder})
  endif()
endforeach()

# What is not one file's unit test.
file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/*_test.cpp)
foreach(source ${sources})
  cmake_path(GET source STEM name)
  string(REGEX REPLACE "^(.*_)?([a-z]+)_test$" "\\2" kind ${name})
  sunder_add_executable(${name} tests SOURCES ${source} LINK GTest::gtest_main rapidcheck)
  sunder_add_test(${name} COMMAND ${name} TIMEOUT 900 LABELS tests ${kind})
endforeach()

file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/tools/*.cpp)
foreach(source ${sources})
  cmake_path(GET source STEM name)
  sunder_add_executable(${name} tools SOURCES ${source})
endforeach()

file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/examples/*.cpp)
foreach(source ${sources})
  cmake_path(GET source STEM name)
  sunder_add_executable(example_${name} examples SOURCES ${source})
  sunder_add_test(example_${name} COMMAND example_${name} TIMEOUT 60 LABELS example)
endforeach()

# Scripts: what they say about this tree, and their own tests.
foreach(name check_layers check_papers_table check_links)
  sunder_add_test(${name} COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tests/${name}.py ${PROJECT_SOURCE_DIR}
    TIMEOUT 60 LABELS script)
endforeach()
set(sources "")
foreach(folder tests verifier cli)
  file(GLOB files CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${folder}/*_test.py ${PROJECT_SOURCE_DIR}/${folder}/test_*.py)
  list(APPEND sources ${files})
endforeach()
foreach(source ${sources})
  cmake_path(GET source STEM name)
  sunder_add_test(${name}_py COMMAND Python3::Interpreter ${source} TIMEOUT 300 LABELS script)
endforeach()

# A tiny outside project finds the installed package. Not from instrumented builds, whose flags it would have to know.
if(NOT SUNDER_SANITIZE AND NOT SUNDER_COVERAGE AND NOT SUNDER_FUZZ)
  sunder_add_test(consumer TIMEOUT 300 LABELS consumer slow COMMAND ${CMAKE_COMMAND}
    -DSOURCE_DIR=${PROJECT_SOURCE_DIR} -DBUILD_DIR=${PROJECT_BINARY_DIR} -DGENERATOR=${CMAKE_GENERATOR}
    -DCXX=${CMAKE_CXX_COMPILER} -DBUILD_TYPE=${CMAKE_BUILD_TYPE} -P ${PROJECT_SOURCE_DIR}/tests/consumer/run.cmake)
endif()
