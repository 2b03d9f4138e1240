# What is decided for a build of our own, and left to the consumer in a build of theirs.
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Release, RelWithDebInfo or Debug" FORCE)
endif()
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)          # for clang-tidy
set(CMAKE_POSITION_INDEPENDENT_CODE ON)        # for the Python package to come
set(CMAKE_VERIFY_INTERFACE_HEADER_SETS ON)     # target all_verify_interface_header_sets: every header stands alone

# A compiler's result is kept for all clones on a machine: what it saw is compared without the name of the folder. Which
# headers these are the compiler itself tells (CCACHE_DEPEND): the preprocessor alone would take a tenth of its time.
find_program(SUNDER_CCACHE ccache)
mark_as_advanced(SUNDER_CCACHE)
if(SUNDER_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_NOHASHDIR=1
      CCACHE_DEPEND=1 CCACHE_SLOPPINESS=pch_defines,time_macros ${SUNDER_CCACHE})
endif()

option(SUNDER_PRECOMPILED_HEADERS "Compile the headers of others once" ON)
option(SUNDER_BATCHES "Compile the sources of a folder eight at a time" ON)
if(SUNDER_FUZZ AND NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  message(FATAL_ERROR "Fuzzers need Clang: cmake --preset asan-ubsan -DCMAKE_CXX_COMPILER=clang++-19, or ./do build asan-ubsan")
endif()
if(SUNDER_SANITIZE)
  add_compile_options(-fsanitize=${SUNDER_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  if(SUNDER_SANITIZE MATCHES "address")  # which sees at the access what these see; they take long to compile
    add_compile_options(-fno-sanitize=pointer-overflow,object-size)
  endif()
  add_link_options(-fsanitize=${SUNDER_SANITIZE} -no-pie)  # what sanitizers say of each place need not be moved at start
endif()
if(SUNDER_COVERAGE)
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    message(FATAL_ERROR "Coverage needs GCC and gcovr: ./do soak coverage")
  endif()
  add_compile_options(--coverage -fprofile-update=atomic)
  add_link_options(--coverage)
endif()
