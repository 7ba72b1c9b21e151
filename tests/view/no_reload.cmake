# Nothing of SEAGLASS_SHADER_RELOAD is in `program`.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/../run.cmake)

run(nm --demangle ${program})
if(NOT said MATCHES "seaglass::createContext")
  message(FATAL_ERROR "nm does not name what is in ${program}")
endif()
if(said MATCHES "[Rr]eloadShader|ShaderReload")
  message(FATAL_ERROR "${program} has ${CMAKE_MATCH_0}, expected it in builds with SEAGLASS_SHADER_RELOAD alone")
endif()
