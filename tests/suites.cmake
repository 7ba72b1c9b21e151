# Lists a GoogleTest program's suites for CTest, a case each: a process of its own for each test would take as long to begin
# as most tests take.
#   cmake -D program=PROGRAM -D emulator=EMULATOR -D filter=FILTER -D suffix=SUFFIX -D cost=SECONDS
#         -D properties=PROPERTY;VALUE;... -D written=FILE -P suites.cmake
# A case is named PROGRAM.SUITE. `filter` says which tests count, `suffix` is put behind the name, `cost` is what a test takes.
cmake_minimum_required(VERSION 3.25)

execute_process(COMMAND ${emulator} ${program} --gtest_list_tests --gtest_filter=${filter} OUTPUT_VARIABLE listed
  COMMAND_ERROR_IS_FATAL ANY)
string(REGEX REPLACE " *#[^\n]*" "" listed "${listed}")
string(REGEX MATCHALL "[^\n]+" lines "${listed}")

set(text "")
cmake_path(GET program STEM stem)
list(JOIN properties " " properties)
set(tests "")
# What ends the last suite as the next one's name would.
list(APPEND lines "the end.")
foreach(line IN LISTS lines)
  if(line MATCHES "^  (.+)")
    list(APPEND tests "${suite}.${CMAKE_MATCH_1}")
  elseif(line MATCHES "^(.+)[.]$")
    if(tests)
      list(LENGTH tests count)
      math(EXPR whole "${cost} * ${count}")
      list(JOIN tests ":" tests)
      set(name ${stem}.${suite}${suffix})
      string(APPEND text "add_test([=[${name}]=] ${emulator} [=[${program}]=] [=[--gtest_filter=${tests}]=])\n"
        "set_tests_properties([=[${name}]=] PROPERTIES COST ${whole} ${properties})\n")
    endif()
    set(suite ${CMAKE_MATCH_1})
    set(tests "")
  endif()
endforeach()
file(WRITE ${written} "${text}")
