# Runs one screenshot test: what seaglassScreenshotTest.cmake wrote for it sets name, reference, out, reports, seaglass
# and limits, and defines draw().
cmake_minimum_required(VERSION 3.25)

# One page of all tests, renewed behind each. Tests that run at once wait for each other.
function(write_page)
  file(LOCK ${reports}/lock GUARD FUNCTION TIMEOUT 60)
  execute_process(COMMAND ${seaglass} report ${reports})
endfunction()
# The test fails, and the page says why.
function(fail why)
  string(REGEX REPLACE "[\"\\]" "'" quoted "${why}")
  file(MAKE_DIRECTORY ${reports}/${name})
  file(WRITE ${reports}/${name}/report.json
    "[{\"name\":\"\",\"code\":2,\"why\":\"${quoted}\",\"badness\":0,\"advice\":false,\"section\":\"\"}]\n")
  write_page()
  message(FATAL_ERROR "${name}: ${why}")
endfunction()

# Nothing of an earlier run is taken for this one's.
file(REMOVE_RECURSE ${out} ${reports}/${name})
file(MAKE_DIRECTORY ${out})
draw()
if(NOT code EQUAL 0)
  fail("what draws it ended with ${code}, expected 0")
endif()
string(REGEX REPLACE "([][*?])" "[\\1]" folder "${out}")
file(GLOB_RECURSE files LIST_DIRECTORIES false RELATIVE "${out}" "${folder}/*")
if(NOT files MATCHES "[.]([Pp][Nn][Gg]|[Ee][Xx][Rr]|[Hh][Dd][Rr])(;|$)")
  fail("no PNG, EXR or HDR in ${out}, expected the command to write one there")
endif()
execute_process(COMMAND ${seaglass} compare ${reference} ${out} ${limits} --report ${reports}/${name} --junit ${out}.xml
  RESULT_VARIABLE code)
if(NOT EXISTS ${reports}/${name}/report.json)
  fail("seaglass compare ended with ${code}, and left no report")
endif()
write_page()
if(NOT code EQUAL 0)
  message(FATAL_ERROR "${name}: not as its references")
endif()
