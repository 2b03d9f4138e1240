# Tests by the place and name of their files (see CONTRIBUTING.md):
#   sunder/<layer>/**/x_test.cpp   one executable a layer, ctest unit_<layer>, or in shards:   labels unit, <layer>
#                                  unit_<layer>_1, ..
#   verifier/, cli/ x_test.cpp     the same: unit_verifier, unit_cli
#   cli/calls/x.toml               calls of the program, run by cli/calls_test.py: calls_x    labels unit, program
#   tests/<layer>/x_<kind>_test.cpp   a ctest entry each: x_<kind>_test                       labels tests, <kind>
#                                  all of a layer are two executables: <layer>_fast and <layer>_light (see below)
#   tests/support/*.cpp            linked to all of these
#   tests/tools/x.cpp              an executable each, in <build>/tools
#   examples/x.cpp                 an executable each, run: example_x                         label example
#   verifier/, cli/, tests/ x_test.py   run by Python: x_test_py (test_x.py does too)          label script
#   python/tests/test_x.py         run by pytest, where the package is installed: python       labels python, slow
# The label slow (kind slow, the consumer, and Python) is left out by ./do test --quick.
# The environment: SUNDER_TEST_SCALE multiplies the numbers of random instances, SUNDER_TEST_SEED moves their seeds.
find_package(GTest REQUIRED)
find_package(rapidcheck REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(Python3 REQUIRED COMPONENTS Interpreter)
# Itself, not what chooses it at every call, as pyenv does; and what it compiles is kept here, beside no source.
execute_process(COMMAND ${Python3_EXECUTABLE} -c "import sys; print(sys.executable)" OUTPUT_VARIABLE python
                OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)

set(environment SUNDER_CASES_DIR=${PROJECT_SOURCE_DIR}/cases SUNDER_SOURCE_DIR=${PROJECT_SOURCE_DIR}
                PYTHONDONTWRITEBYTECODE= PYTHONPYCACHEPREFIX=${PROJECT_BINARY_DIR}/bytecode)
set(libraries sunder_core)
foreach(target sunder_io sunder_verifier)
  if(TARGET ${target})
    list(APPEND libraries ${target})
  endif()
endforeach()
# One file knows the names of folders, so that a compiler cache serves all clones.
set(places SUNDER_SOURCE_DIR="${PROJECT_SOURCE_DIR}" SUNDER_PYTHON="${python}")
if(TARGET sunder_cli)
  list(APPEND environment SUNDER_PROGRAM=$<TARGET_FILE:sunder_cli>)
endif()
set_source_files_properties(${PROJECT_SOURCE_DIR}/tests/support/places.cpp PROPERTIES COMPILE_DEFINITIONS "${places}")

sunder_glob(sources "tests/support/*.cpp")
if(sources)
  sunder_batches(sources sunder_test_support EXCEPT tests/support/places.cpp tests/support/test_main.cpp)
  add_library(sunder_test_support STATIC ${sources})
  target_link_libraries(sunder_test_support PUBLIC ${libraries} GTest::gtest rapidcheck nlohmann_json::nlohmann_json)
  sunder_own_code(sunder_test_support)
  list(APPEND libraries sunder_test_support)
endif()

# Tests compile at -O1; those in which most of the time is run (FAST: differentials, and what counts) as the library
# does; those that read small files at -O0 (PLAIN), and all of them under sanitizers, where few instances are run and
# what is instrumented takes long to optimize. The headers of others are compiled
# once, but for FAST by GCC, whose -O3 may take them for the place of what it warns of.
set(precompiled plain light)
if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  list(APPEND precompiled fast)
endif()
function(sunder_test_code target speed)
  sunder_own_code(${target})
  if(speed STREQUAL "plain" OR SUNDER_SANITIZE)
    target_compile_options(${target} PRIVATE -O0)
  elseif(speed STREQUAL "light")
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>
      $<$<AND:$<CONFIG:Release>,$<CXX_COMPILER_ID:GNU>>:-Wno-maybe-uninitialized>)  # at -O1 it warns of what is set
  endif()
endfunction()
foreach(speed ${precompiled})
  set(headers sunder_${speed}_test_headers)
  add_library(${headers} OBJECT ${PROJECT_SOURCE_DIR}/tests/support/places.cpp)
  target_link_libraries(${headers} PRIVATE ${libraries})
  set_target_properties(${headers} PROPERTIES POSITION_INDEPENDENT_CODE OFF)  # but as executables are compiled:
  target_compile_options(${headers} PRIVATE -fPIE)
  sunder_test_code(${headers} ${speed})
  set(others "")
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "GNU")  # which instantiates again, for each source, what headers need
    set(others <nlohmann/json.hpp> <boost/multiprecision/cpp_int.hpp>)
  endif()
  sunder_precompile(${headers} <gtest/gtest.h> ${others})
endforeach()

function(sunder_add_executable target folder)
  cmake_parse_arguments(PARSE_ARGV 2 arg "FAST;LIGHT;PLAIN" "" "SOURCES;LINK")
  sunder_batches(arg_SOURCES ${target})
  add_executable(${target} ${arg_SOURCES})
  set_target_properties(${target} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/${folder})
  target_link_libraries(${target} PRIVATE ${libraries} ${arg_LINK})
  set(speed light)
  if(arg_FAST)
    set(speed fast)
  elseif(arg_PLAIN)
    set(speed plain)
  endif()
  sunder_test_code(${target} ${speed})
  if(SUNDER_PRECOMPILED_HEADERS AND speed IN_LIST precompiled)
    target_precompile_headers(${target} REUSE_FROM sunder_${speed}_test_headers)
  endif()
endfunction()

function(sunder_add_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "TIMEOUT" "COMMAND;LABELS;ENVIRONMENT")
  add_test(NAME ${name} COMMAND ${arg_COMMAND} WORKING_DIRECTORY ${PROJECT_BINARY_DIR})
  set_tests_properties(${name} PROPERTIES TIMEOUT ${arg_TIMEOUT} LABELS "${arg_LABELS}"
    ENVIRONMENT "${environment};${arg_ENVIRONMENT}")
endfunction()

# Beside the sources.
foreach(folder ${SUNDER_CORE_LAYERS} io robot picture ask verifier cli)
  set(place sunder/${folder})
  set(link rapidcheck)
  set(speed "")
  if(folder MATCHES "^(io|robot|picture|ask|cli)$")
    set(speed PLAIN)
  endif()
  if(folder STREQUAL "verifier")
    set(place verifier)
  elseif(folder MATCHES "picture|ask")
    list(APPEND link sunder_${folder})
  elseif(folder STREQUAL "cli")
    set(place cli)
    list(APPEND link sunder_cli_verbs)
  endif()
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${place}/*_test.cpp)
  if(sources)
    sunder_add_executable(sunder_unit_${folder} tests ${speed} SOURCES ${sources} LINK ${link})
    list(LENGTH sources shards)
    math(EXPR shards "(${shards} + 14) / 15")
    foreach(shard RANGE 1 ${shards})
      set(name unit_${folder})
      if(shards GREATER 1)
        string(APPEND name _${shard})
      endif()
      math(EXPR index "${shard} - 1")
      sunder_add_test(${name} COMMAND sunder_unit_${folder} TIMEOUT 600 LABELS unit ${folder}
        ENVIRONMENT GTEST_TOTAL_SHARDS=${shards} GTEST_SHARD_INDEX=${index})
    endforeach()
  endif()
endforeach()

if(TARGET sunder_cli)
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/cli/calls/*.toml)
  foreach(source ${sources})
    cmake_path(GET source STEM name)
    sunder_add_test(calls_${name} COMMAND ${python} ${PROJECT_SOURCE_DIR}/cli/calls_test.py --jobs 1 ${name}
      TIMEOUT 600 LABELS unit program)
  endforeach()
endif()

# What is not one file's unit test. Tests against GEOS (LGPL) are built where it is found: Debian's libgeos-dev.
find_path(SUNDER_GEOS_INCLUDE geos_c.h)
find_library(SUNDER_GEOS_LIBRARY geos_c)
mark_as_advanced(SUNDER_GEOS_INCLUDE SUNDER_GEOS_LIBRARY)
if(NOT SUNDER_GEOS_INCLUDE OR NOT SUNDER_GEOS_LIBRARY)
  message(STATUS "GEOS is not found: tests against it are left out (Debian: libgeos-dev)")
endif()
file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/*_test.cpp)
if(sources)
  message(FATAL_ERROR "A test lies in the folder of its layer, tests/<layer>/: ${sources}")
endif()
foreach(folder planar solid polytope scene support)
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/${folder}/*_test.cpp)
  if(SUNDER_SANITIZE)  # counts are the same there, and what is counted runs in the differentials too
    list(FILTER sources EXCLUDE REGEX "_complexity_test\\.cpp$")
  endif()
  set(with_geos ${sources})
  list(FILTER with_geos INCLUDE REGEX "_geos_[a-z]+_test\\.cpp$")
  if(with_geos AND NOT (SUNDER_GEOS_INCLUDE AND SUNDER_GEOS_LIBRARY))
    list(REMOVE_ITEM sources ${with_geos})
    set(with_geos "")
  endif()
  set(fast ${sources})
  list(FILTER fast INCLUDE REGEX "_(differential|complexity)_test\\.cpp$")
  set(light ${sources})
  list(REMOVE_ITEM light "" ${fast})
  foreach(speed fast light)
    if(NOT ${speed})
      continue()
    endif()
    string(TOUPPER ${speed} upper)
    sunder_add_executable(${folder}_${speed} tests ${upper} SOURCES ${${speed}} LINK rapidcheck)
    foreach(source ${${speed}})
      cmake_path(GET source STEM name)
      string(REGEX REPLACE "^(.*_)?([a-z]+)_test$" "\\2" kind ${name})
      sunder_add_test(${name} COMMAND ${folder}_${speed} --file=${name} TIMEOUT 900 LABELS tests ${kind})
    endforeach()
  endforeach()
  if(with_geos)
    target_include_directories(${folder}_fast SYSTEM PRIVATE ${SUNDER_GEOS_INCLUDE})
    target_link_libraries(${folder}_fast PRIVATE ${SUNDER_GEOS_LIBRARY})
  endif()
endforeach()

file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/tools/*.cpp)
foreach(source ${sources})
  cmake_path(GET source STEM name)
  sunder_add_executable(${name} tools SOURCES ${source})
endforeach()

file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/examples/*.cpp)
set(placements 100000)
if(SUNDER_SANITIZE)
  set(placements 2000)
endif()
set(arguments_of_robot
  ${PROJECT_SOURCE_DIR}/cases/panda/panda.urdf ${placements} ${PROJECT_BINARY_DIR}/examples/robot.json)
foreach(source ${sources})
  cmake_path(GET source STEM name)
  sunder_add_executable(example_${name} examples SOURCES ${source})
  sunder_add_test(example_${name} COMMAND example_${name} ${arguments_of_${name}} TIMEOUT 60 LABELS example)
endforeach()

# Scripts: what they say about this tree, and their own tests.
foreach(name check_layers check_links check_contracts)
  sunder_add_test(${name} COMMAND ${python} ${PROJECT_SOURCE_DIR}/tests/${name}.py ${PROJECT_SOURCE_DIR}
    TIMEOUT 60 LABELS script)
endforeach()
if(TARGET sunder_cli)
  set(program $<TARGET_FILE:sunder_cli>)
endif()
sunder_add_test(check_papers_table COMMAND ${python} ${PROJECT_SOURCE_DIR}/tests/check_papers_table.py
  ${PROJECT_SOURCE_DIR} ${program} TIMEOUT 60 LABELS script)
if(TARGET sunder_cli)
  sunder_add_test(check_pages COMMAND ${python} ${PROJECT_SOURCE_DIR}/tests/check_pages.py
    ${PROJECT_SOURCE_DIR} $<TARGET_FILE:sunder_cli> TIMEOUT 120 LABELS script)
endif()
set(sources "")
foreach(folder tests verifier/python/tests cli)
  file(GLOB files CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${folder}/*_test.py ${PROJECT_SOURCE_DIR}/${folder}/test_*.py)
  list(APPEND sources ${files})
endforeach()
list(FILTER sources EXCLUDE REGEX "/cli/calls_test\\.py$")  # above
foreach(source ${sources})
  cmake_path(GET source STEM name)
  cmake_path(GET source PARENT_PATH folder)
  if(folder MATCHES "verifier/python/tests$")
    string(REPLACE "test_" "claims_" name ${name})
  endif()
  sunder_add_test(${name}_py COMMAND ${python} ${source} TIMEOUT 600 LABELS script)
endforeach()

# The Python package, installed as users do; what this build has compiled comes from the compiler cache. And a tiny
# outside project finds the installed package. Not from instrumented builds, whose flags they would have to know.
if(NOT SUNDER_SANITIZE AND NOT SUNDER_COVERAGE AND NOT SUNDER_FUZZ)
  sunder_add_test(python TIMEOUT 1200 LABELS python slow COMMAND ${python}
    ${PROJECT_SOURCE_DIR}/python/tests/run.py ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR} ${CMAKE_CXX_COMPILER}
    ${SUNDER_WARNINGS_AS_ERRORS})
  sunder_add_test(consumer TIMEOUT 300 LABELS consumer slow COMMAND ${CMAKE_COMMAND}
    -DSOURCE_DIR=${PROJECT_SOURCE_DIR} -DBUILD_DIR=${PROJECT_BINARY_DIR} -DGENERATOR=${CMAKE_GENERATOR}
    -DCXX=${CMAKE_CXX_COMPILER} -DBUILD_TYPE=${CMAKE_BUILD_TYPE} -P ${PROJECT_SOURCE_DIR}/tests/consumer/run.cmake)
endif()

# The longest are begun first, so that no core waits for them at the end.
foreach(name unit_solid_1 unit_solid_2 unit_solid_3 unit_solid_4 unit_planar_1 unit_planar_2 unit_predicate_1 unit_predicate_2
             python solid_drums_complexity_test polytope_pair_differential_test solid_pair_differential_test
             solid_pair_by_drums_differential_test solid_polygon_differential_test solid_distance_differential_test
             solid_hierarchy_complexity_test segments_growth_complexity_test
             polygon_sets_complexity_test solid_line_complexity_test reports_test_py claims_limits_py calls_simple
             calls_sets calls_space files_and_lists_test_py)
  if(TEST ${name})
    set_tests_properties(${name} PROPERTIES COST 100)
  endif()
endforeach()
