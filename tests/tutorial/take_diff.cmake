# Installs Seaglass, and builds demos/tutorial twice against it: before, as it is, and after water.diff, as docs/integrating.md
# has it.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "${ARGN}\nended with ${code}:\n${said}")
  endif()
endfunction()

file(REMOVE_RECURSE ${work})
run(${CMAKE_COMMAND} --install ${seaglass_build} --prefix ${work}/prefix)
foreach(state before after)
  file(COPY ${seaglass_source}/demos/tutorial/ DESTINATION ${work}/${state})
  if(state STREQUAL "after")
    run(${patch} --batch --fuzz=0 -p1 --directory ${work}/after --input ${work}/after/water.diff)
  endif()
  run(${CMAKE_COMMAND} -G ${generator} -S ${work}/${state} -B ${work}/${state}/build -D CMAKE_BUILD_TYPE=Debug
    -D CMAKE_PREFIX_PATH=${work}/prefix -D CMAKE_CXX_FLAGS=-Werror)
  run(${CMAKE_COMMAND} --build ${work}/${state}/build)
endforeach()
