# Builds the GPU tests over shaders whose arithmetic is as unlike a CPU device's as Vulkan lets it be, and runs them: by those
# drivers do what this one does not. `mode`: hostile_arithmetic.py.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/../run.cmake)

file(REMOVE_RECURSE ${work})
run(${CMAKE_COMMAND} -S ${source} --preset release -B ${work} -D SEAGLASS_WARNINGS_AS_ERRORS=ON -D SEAGLASS_TESTS=ON
  -D SEAGLASS_HOSTILE_ARITHMETIC=${mode})
set(ENV{MALLOC_PERTURB_} 1)
foreach(program ${programs})
  run(${CMAKE_COMMAND} --build ${work} --target ${program})
  run(${work}/bin/${program} --gtest_brief=1 --gtest_filter=-${without})
  message("${said}")
endforeach()
