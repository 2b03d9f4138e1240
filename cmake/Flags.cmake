# Answers must be the same for every compiler and vector unit: no contraction into fused multiply-adds, no fast-math.
# Public, because templates of the library are compiled in the consumer's code. Order matters to Clang.
function(sunder_exact_arithmetic target)
  target_compile_options(${target} PUBLIC
    $<$<COMPILE_LANG_AND_ID:CXX,GNU,Clang,AppleClang>:-fno-fast-math;-ffp-contract=off>)
endfunction()

# For our own code only, never exported. After the target, where a release gains nothing by -O3: what is enough.
function(sunder_own_code target)
  if(NOT PROJECT_IS_TOP_LEVEL)
    return()
  endif()
  target_compile_options(${target} PRIVATE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wold-style-cast -Wdouble-promotion
    $<$<CXX_COMPILER_ID:GNU>:-Wuseless-cast>
    # GCC 12 sees overlapping memory in "text" + std::string (bug 105651, mended in 13).
    $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-restrict>
    # In a batch it warns of anonymous namespaces as if sources were headers.
    $<$<AND:$<CXX_COMPILER_ID:GNU>,$<BOOL:${SUNDER_BATCHES}>>:-Wno-subobject-linkage>
    $<$<BOOL:${SUNDER_WARNINGS_AS_ERRORS}>:-Werror> $<$<CONFIG:Release>:${ARGN}>)
endfunction()

# Large headers that our own code sees, compiled once. What a source needs it includes all the same:
# ./do soak builds without, and every header is compiled alone by ./do check.
function(sunder_precompile target)
  if(SUNDER_PRECOMPILED_HEADERS)  # never in a consumer's build
    target_precompile_headers(${target} PRIVATE ${ARGN})
    target_compile_options(${target} PRIVATE  # so that the compiler cache takes part
      $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess> "$<$<CXX_COMPILER_ID:Clang>:SHELL:-Xclang -fno-pch-timestamp>")
  endif()
endfunction()

# Compiles the sources of a folder eight at a time (a unity build): headers are read, and templates compiled, once for
# all eight. So names in anonymous namespaces must differ within a folder; EXCEPT names sources that stay alone. A batch
# includes its sources by their path in the project, so that the compiler's cache serves all clones. `variable` holds the
# sources, absolute, and then what is to be compiled. ./do soak builds and tests each source alone.
function(sunder_batches variable target)
  if(NOT SUNDER_BATCHES)  # never in a consumer's build
    return()
  endif()
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "" "EXCEPT")
  set(result ${arg_EXCEPT})
  list(TRANSFORM result PREPEND "${PROJECT_SOURCE_DIR}/")
  set(sources ${${variable}})
  list(REMOVE_ITEM sources ${result})
  set(folders "")
  foreach(source IN LISTS sources)
    cmake_path(RELATIVE_PATH source BASE_DIRECTORY ${PROJECT_SOURCE_DIR})
    cmake_path(GET source PARENT_PATH folder)
    list(APPEND folders ${folder})
    list(APPEND in_${folder} ${source})
  endforeach()
  list(REMOVE_DUPLICATES folders)
  foreach(folder IN LISTS folders)
    list(LENGTH in_${folder} count)
    math(EXPR last "${count} - 1")
    string(REPLACE "/" "_" name ${folder})
    foreach(begin RANGE 0 ${last} 8)
      list(SUBLIST in_${folder} ${begin} 8 batch)
      list(LENGTH batch size)
      if(size EQUAL 1)
        list(APPEND result ${PROJECT_SOURCE_DIR}/${batch})
      elseif(size GREATER 1)
        list(TRANSFORM batch REPLACE "(.+)" "#include <\\1>\n")
        list(JOIN batch "" text)
        file(CONFIGURE OUTPUT batches/${target}/${name}_${begin}.cpp CONTENT "${text}" @ONLY)
        list(APPEND result ${PROJECT_BINARY_DIR}/batches/${target}/${name}_${begin}.cpp)
      endif()
    endforeach()
  endforeach()
  set(${variable} ${result} PARENT_SCOPE)
endfunction()

# What fuzzers are to find their way through counts its branches for them; what reads their bytes (READS) also shows
# them what it compares, which takes a quarter of the time to compile and more to run.
function(sunder_fuzzed target)
  if(NOT SUNDER_FUZZ)
    return()
  endif()
  cmake_parse_arguments(PARSE_ARGV 1 arg "READS" "" "")
  if(arg_READS)
    target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link)
  else()
    target_compile_options(${target} PRIVATE -fsanitize-coverage=inline-8bit-counters,pc-table)
  endif()
endfunction()

# Arithmetic that is not IEEE double, through flags or by the machine (x87), is refused before anything is compiled.
include(CheckCXXSourceCompiles)
check_cxx_source_compiles("
  #include <cfloat>
  #include <limits>
  #if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__) || defined(__ASSOCIATIVE_MATH__)
  #error fast-math
  #endif
  static_assert(FLT_EVAL_METHOD == 0 && std::numeric_limits<double>::is_iec559);
  int main() {}" SUNDER_IEEE_ARITHMETIC)
if(NOT SUNDER_IEEE_ARITHMETIC)
  unset(SUNDER_IEEE_ARITHMETIC CACHE)  # asked again when the flags have changed
  message(FATAL_ERROR "Sunder needs IEEE double arithmetic: remove -ffast-math, -Ofast and the like from the flags "
    "('${CMAKE_CXX_FLAGS}' with build type '${CMAKE_BUILD_TYPE}'); on 32-bit x86 add -msse2 -mfpmath=sse.")
endif()
