# Installs the library into a folder of its own, builds the outside project against it, and runs what it built; then
# configures the same project with Sunder as a subfolder and sees that no test, program or benchmark of ours comes along.
#   cmake -DSOURCE_DIR= -DBUILD_DIR= -DGENERATOR= -DCXX= -DBUILD_TYPE= -P run.cmake
set(work ${BUILD_DIR}/consumer)
file(REMOVE_RECURSE ${work})
set(consumer ${SOURCE_DIR}/tests/consumer)
set(options -G ${GENERATOR} -DCMAKE_CXX_COMPILER=${CXX} -DCMAKE_BUILD_TYPE=${BUILD_TYPE})

function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    list(JOIN ARGV " " line)
    message(FATAL_ERROR "${line}\n${output}\nended with ${result}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${work}/prefix --component library)
file(GLOB_RECURSE others ${work}/prefix/*_test.h ${work}/prefix/*gtest*)
if(others)
  message(FATAL_ERROR "installed, but not for consumers: ${others}")
endif()

run(${CMAKE_COMMAND} -S ${consumer} -B ${work}/build ${options} -DCMAKE_PREFIX_PATH=${work}/prefix)
file(STRINGS ${work}/build/CMakeCache.txt found REGEX "^sunder_DIR:")
if(NOT found MATCHES "${work}/prefix")
  message(FATAL_ERROR "another installed Sunder was found: ${found}")
endif()
run(${CMAKE_COMMAND} --build ${work}/build)
run(${work}/build/touching_cubes)
run(${work}/build/hull_of_file)
run(${work}/build/all_front_doors)

run(${CMAKE_COMMAND} -S ${consumer} -B ${work}/subfolder ${options} -DSUNDER_FROM_SOURCE=${SOURCE_DIR})
run(${CMAKE_COMMAND} --build ${work}/subfolder --target help)
if(output MATCHES "sunder_(cli|unit|verifier)|bench_|_fuzz|_test")
  message(FATAL_ERROR "a consumer's build has our tests or program:\n${output}")
endif()
