# Runs one screenshot test: what seaglassScreenshotTest.cmake wrote for it sets name, reference, out, report, seaglass
# and limits, and defines draw().
cmake_minimum_required(VERSION 3.25)

# Nothing of an earlier run is taken for this one's.
file(REMOVE_RECURSE ${out} ${report})
file(MAKE_DIRECTORY ${out})
draw()
if(NOT code EQUAL 0)
  message(FATAL_ERROR "${name}: what draws it ended with ${code}, expected 0")
endif()
file(GLOB_RECURSE pictures ${out}/*.png ${out}/*.exr ${out}/*.hdr)
if(NOT pictures)
  message(FATAL_ERROR "${name}: no PNG, EXR or HDR in ${out}, expected the command to write one there")
endif()
execute_process(COMMAND ${seaglass} compare ${reference} ${out} ${limits} --report ${report} --junit ${out}.xml
  RESULT_VARIABLE code)
if(NOT code EQUAL 0)
  message(FATAL_ERROR "${name}: not as its references")
endif()
