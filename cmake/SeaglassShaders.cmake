# seaglass_shaders(target FILE... [NAME name] [DEFINES NAME...]): compiles each GLSL file to SPIR-V while building and
# embeds it, so that a program carries its shaders. `shaders/reflection/sspr/scatter.comp` becomes
#     #include "spirv/scatter.comp.h"     ->     const uint32_t scatter_comp[] = {...};
# With DEFINES, one file gives several variants; NAME then replaces the file's name. But for those that are NAMED they carry no
# names of functions and variables, which would be a fifth of their bytes. Tests then tell them by number.
find_program(GLSLANG_VALIDATOR NAMES glslangValidator glslang REQUIRED)
# SPIR-V 1.6 states group sizes by id, which needs the feature maintenance4; 1.5 serves and asks for nothing.
set(SEAGLASS_GLSLANG_FLAGS --quiet -V --target-env vulkan1.2)
option(SEAGLASS_SHADER_LINES "Shaders know their files and lines" OFF)
if(SEAGLASS_SHADER_LINES)
  list(APPEND SEAGLASS_GLSLANG_FLAGS -g)
endif()

# Names of files are their own in all of them, so that an #include is a name alone.
file(GLOB_RECURSE seaglass_shader_folders LIST_DIRECTORIES true CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/shaders/*)
list(FILTER seaglass_shader_folders EXCLUDE REGEX "\\.[a-z]+$")
list(TRANSFORM seaglass_shader_folders PREPEND -I OUTPUT_VARIABLE SEAGLASS_SHADER_FOLDERS)

# For tests: shaders whose arithmetic is as unlike a CPU device's as Vulkan lets it be.
set(SEAGLASS_HOSTILE_ARITHMETIC "" CACHE STRING "Of NaN, min and max give the \"other\" operand, or \"nan\"; see tests/spirv/hostile_arithmetic.py")
set(seaglass_hostile "")
if(SEAGLASS_HOSTILE_ARITHMETIC)
  find_package(Python3 REQUIRED COMPONENTS Interpreter)
  find_program(SPIRV_OPT spirv-opt REQUIRED)
  set(seaglass_hostile_script ${PROJECT_SOURCE_DIR}/tests/spirv/hostile_arithmetic.py)
  set(seaglass_hostile COMMAND ${Python3_EXECUTABLE} -B ${seaglass_hostile_script} ${SEAGLASS_HOSTILE_ARITHMETIC} ${SPIRV_OPT})
endif()

# For SEAGLASS_SHADER_RELOAD: the header that is included tells the library by what name it may be given other words than
# those of `words`; the global property SEAGLASS_SHADERS holds how each is compiled. So it is for the shaders of tests that call
# functions of shaders.
function(seaglass_name_shader header words name symbol source defines)
  file(CONFIGURE OUTPUT ${header} CONTENT [[
#include "@words@"
#include "gpu/interface/shader_reload.h"
namespace { const seaglass::gpu::ShaderName @symbol@_name(@symbol@, "@name@"); }
]] @ONLY)
  cmake_path(RELATIVE_PATH source BASE_DIRECTORY ${PROJECT_SOURCE_DIR}/shaders)
  list(JOIN defines " " defines)
  set_property(GLOBAL APPEND_STRING PROPERTY SEAGLASS_SHADERS "${name} ${source} ${defines}\n")
endfunction()

function(seaglass_shaders target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "NAMED" "NAME" "DEFINES")
  set(out_dir ${CMAKE_CURRENT_BINARY_DIR}/generated/spirv)
  file(MAKE_DIRECTORY ${out_dir})
  set(names "")
  if(NOT arg_NAMED AND NOT SEAGLASS_SHADER_LINES)
    set(names -g0)
  endif()
  list(TRANSFORM arg_DEFINES PREPEND "-D")
  foreach(source IN LISTS arg_UNPARSED_ARGUMENTS)
    cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE)
    cmake_path(GET source FILENAME name)
    if(arg_NAME)
      set(name ${arg_NAME})
    endif()
    string(REPLACE "." "_" symbol ${name})
    set(header ${out_dir}/${name}.h)
    if(SEAGLASS_SHADER_RELOAD AND target MATCHES "^(seaglass|reflection|water)_")
      set(words ${out_dir}/words_${name}.h)
      seaglass_name_shader(${header} ${words} ${name} ${symbol} ${source} "${arg_DEFINES}")
      set(header ${words})
    endif()
    set(hostile ${seaglass_hostile})
    if(hostile)
      list(APPEND hostile ${header})
    endif()
    add_custom_command(
      OUTPUT ${header}
      COMMAND ${GLSLANG_VALIDATOR} ${SEAGLASS_GLSLANG_FLAGS} ${SEAGLASS_SHADER_FOLDERS}
              ${names} ${arg_DEFINES} --depfile ${header}.d --vn ${symbol} -o ${header} ${source}
      ${hostile}
      DEPENDS ${source} ${seaglass_hostile_script}
      DEPFILE ${header}.d
      COMMENT "SPIR-V ${name}"
      VERBATIM)
    target_sources(${target} PRIVATE ${header})
    set_property(GLOBAL APPEND PROPERTY SEAGLASS_SPIRV ${header})
  endforeach()
  target_include_directories(${target} PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/generated)
endfunction()

# seaglass_shader_folder(target FOLDER [BUT file...]): every shader of a folder as it is, but those named.
function(seaglass_shader_folder target folder)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "" "BUT")
  file(GLOB_RECURSE found CONFIGURE_DEPENDS ${folder}/*.comp ${folder}/*.frag ${folder}/*.vert)
  foreach(name IN LISTS arg_BUT)
    list(FILTER found EXCLUDE REGEX "/${name}$")
  endforeach()
  seaglass_shaders(${target} ${found})
endfunction()
