# Builds the libraries as `preset` says, warnings being errors, and runs the unit tests if it has any; for Windows, whose
# programs do not run here, installs them and links somebody else's project with them.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/../run.cmake)

foreach(program IN LISTS needs)
  find_program(found ${program} NO_CACHE)
  if(NOT found)
    message("not run: ${program} is not here, expected: scripts/setup --nightly")
    return()
  endif()
  unset(found)
endforeach()

file(REMOVE_RECURSE ${work})
set(build ${work}/build)
run(${CMAKE_COMMAND} -S ${source} --preset ${preset} -B ${build} -D SEAGLASS_WARNINGS_AS_ERRORS=ON -D SEAGLASS_DEMOS=OFF
  -D CMAKE_DISABLE_PRECOMPILE_HEADERS=ON ${arguments})
run(${CMAKE_COMMAND} --build ${build})
if(arguments MATCHES "SEAGLASS_TESTS=OFF")
  return()
endif()
if(NOT preset STREQUAL "mingw")
  run(${CMAKE_CTEST_COMMAND} --test-dir ${build} --output-on-failure --label-regex "^unit$" --exclude-regex "^Consumer[.](Find|Pkg)"
    --no-tests=error)
  message("${said}")
  return()
endif()

set(prefix ${work}/prefix)
run(${CMAKE_COMMAND} --install ${build} --prefix ${prefix})
run(${CMAKE_COMMAND} -G Ninja -S ${CMAKE_CURRENT_LIST_DIR}/../consumer/project -B ${work}/consumer -D WAY=find_package
  -D FFTW=OFF -D CMAKE_BUILD_TYPE=Debug -D CMAKE_CXX_STANDARD=17 -D CMAKE_FIND_ROOT_PATH=${prefix}
  --toolchain ${source}/cmake/toolchains/mingw.cmake)
run(${CMAKE_COMMAND} --build ${work}/consumer)
foreach(name reflection sea water)
  file(READ ${work}/consumer/${name}_alone.exe magic LIMIT 2 HEX)
  if(NOT magic STREQUAL "4d5a")
    message(FATAL_ERROR "${name}_alone.exe is no program for Windows: it begins with ${magic}")
  endif()
endforeach()
# <windows.h> has macros for words such as near, far and small.
run(x86_64-w64-mingw32-g++-posix -std=c++17 -Wall -Wextra -Wpedantic -Wconversion -Werror -fsyntax-only
  -I ${prefix}/include -isystem ${build}/headers/include ${CMAKE_CURRENT_LIST_DIR}/beside_windows.cpp)
