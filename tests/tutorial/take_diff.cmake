# Installs Seaglass, and builds its demos/tutorial against it as docs/integrating.md has it: before, as it is, with water.diff, and
# after mirrors.diff besides.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "${ARGN}\nended with ${code}:\n${said}")
  endif()
endfunction()

file(REMOVE_RECURSE ${work})
run(${CMAKE_COMMAND} --install ${seaglass_build} --prefix ${work}/prefix)
set(before)
set(first water.diff)
set(after water.diff mirrors.diff)
foreach(state before first after)
  file(COPY ${work}/prefix/share/doc/seaglass/demos/tutorial/ DESTINATION ${work}/${state})
  foreach(diff ${${state}})
    run(${patch} --batch --fuzz=0 -p1 --directory ${work}/${state} --input ${work}/${state}/${diff})
  endforeach()
  run(${CMAKE_COMMAND} -G ${generator} -S ${work}/${state} -B ${work}/${state}/build -D CMAKE_BUILD_TYPE=Debug
    -D CMAKE_PREFIX_PATH=${work}/prefix -D CMAKE_CXX_FLAGS=-Werror)
  run(${CMAKE_COMMAND} --build ${work}/${state}/build)
endforeach()
