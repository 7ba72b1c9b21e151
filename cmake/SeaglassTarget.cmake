# What every Seaglass target is compiled with. Private, so that nothing leaks into a consumer's build.
function(seaglass_target target)
  target_compile_features(${target} PRIVATE cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wconversion
    # Vulkan's structs are begun by their sType alone; the rest is zero by the language.
    -Wno-missing-field-initializers
    # A fused multiply-add that only some machines have would make their results differ.
    -ffp-contract=off
    # Among several files at once GCC takes each for a header, whose structs may not use anonymous namespaces.
    $<$<AND:$<BOOL:${SEAGLASS_JOIN}>,$<CXX_COMPILER_ID:GNU>>:-Wno-subobject-linkage>
    $<$<BOOL:${SEAGLASS_WARNINGS_AS_ERRORS}>:-Werror>)
  if(SEAGLASS_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=${SEAGLASS_SANITIZE} -fno-omit-frame-pointer
      -fno-sanitize-recover=all)
    target_link_options(${target} PRIVATE -fsanitize=${SEAGLASS_SANITIZE})
  endif()
endfunction()

# A library of ours, with its public headers in include/ beside it: static, or shared where BUILD_SHARED_LIBS says so.
function(seaglass_library target)
  string(REPLACE seaglass_ "" part ${target})
  add_library(seaglass::${part} ALIAS ${target})
  target_include_directories(${target}
    PUBLIC $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
    PRIVATE ${PROJECT_SOURCE_DIR})
  # Public headers carry no macros, so a shared library shows all it has; until 1.0 any minor version may break.
  # They find each other where they are installed.
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${part} WINDOWS_EXPORT_ALL_SYMBOLS ON INSTALL_RPATH "$ORIGIN"
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR} POSITION_INDEPENDENT_CODE ON)
  seaglass_target(${target})
  if(SEAGLASS_COVERAGE)
    # Threads count alike, and lines stay what they are in the source.
    target_compile_options(${target} PRIVATE --coverage -fprofile-update=atomic -O1)
    target_link_options(${target} INTERFACE --coverage)
  else()
    seaglass_precompiled(${target})
  endif()
endfunction()

# What most files read, compiled once: it is a third of the time that a file takes. Portable.* go without, and see what a
# file forgot to include. One that is position-independent, as the libraries are, and one that is not. GCC 12 then warns
# falsely of std::string("a") + b + "c" (-Warray-bounds, as for its own headers): append() says the same.
if(PROJECT_IS_TOP_LEVEL)
  file(CONFIGURE OUTPUT precompiled.cpp CONTENT "")
  foreach(name seaglass_precompiled seaglass_precompiled_apart)
    add_library(${name} OBJECT ${PROJECT_BINARY_DIR}/precompiled.cpp)
    target_precompile_headers(${name} PRIVATE <algorithm> <array> <cmath> <cstdint> <cstring> <filesystem> <functional>
      <limits> <map> <memory> <optional> <ostream> <span> <sstream> <string> <string_view> <utility> <vector>
      <glm/glm.hpp>)
    seaglass_target(${name})
  endforeach()
  set_target_properties(seaglass_precompiled_apart PROPERTIES POSITION_INDEPENDENT_CODE ON)
endif()

function(seaglass_precompiled target)
  if(NOT PROJECT_IS_TOP_LEVEL)
    return()
  endif()
  get_target_property(apart ${target} POSITION_INDEPENDENT_CODE)
  if(apart)
    target_precompile_headers(${target} REUSE_FROM seaglass_precompiled_apart)
  else()
    target_precompile_headers(${target} REUSE_FROM seaglass_precompiled)
  endif()
endfunction()
