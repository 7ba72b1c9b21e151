# Installs Seaglass, and builds its demos/tutorial against it as docs/tutorial.md has it: before, and after each of its steps; and
# demos/minimal after sea.diff.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "${ARGN}\nended with ${code}:\n${said}")
  endif()
endfunction()

file(REMOVE_RECURSE ${work})
run(${CMAKE_COMMAND} --install ${seaglass_build} --prefix ${work}/prefix)
function(build state)
  run(${CMAKE_COMMAND} -G ${generator} -S ${work}/${state} -B ${work}/${state}/build -D CMAKE_BUILD_TYPE=Debug
    -D CMAKE_PREFIX_PATH=${work}/prefix -D CMAKE_CXX_FLAGS=-Werror)
  run(${CMAKE_COMMAND} --build ${work}/${state}/build)
endfunction()

set(steps)
foreach(state before water cove mirrors foam dive)
  file(COPY ${work}/prefix/share/doc/seaglass/demos/tutorial/ DESTINATION ${work}/${state})
  if(NOT state STREQUAL "before")
    list(APPEND steps ${state})
  endif()
  foreach(step IN LISTS steps)
    run(${patch} --batch --fuzz=0 -p1 --directory ${work}/${state} --input ${work}/${state}/${step}.diff)
  endforeach()
  build(${state})
endforeach()

# The triangle of demos/minimal, likewise.
file(COPY ${work}/prefix/share/doc/seaglass/demos/minimal/ DESTINATION ${work}/sea)
run(${patch} --batch --fuzz=0 -p1 --directory ${work}/sea --input ${work}/sea/sea.diff)
build(sea)
