# seaglass_shaders(target FILE...): compiles each GLSL file to SPIR-V while building and embeds it, so that a
# program carries its shaders. `shaders/sspr_scatter.comp` becomes
#     #include "spirv/sspr_scatter.comp.h"     ->     const uint32_t sspr_scatter_comp[] = {...};
find_program(GLSLANG_VALIDATOR glslangValidator REQUIRED)

function(seaglass_shaders target)
  set(out_dir ${CMAKE_CURRENT_BINARY_DIR}/generated/spirv)
  file(MAKE_DIRECTORY ${out_dir})
  foreach(source IN LISTS ARGN)
    cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE)
    cmake_path(GET source FILENAME name)
    string(REPLACE "." "_" symbol ${name})
    set(header ${out_dir}/${name}.h)
    add_custom_command(
      OUTPUT ${header}
      COMMAND ${GLSLANG_VALIDATOR} --quiet -V --target-env vulkan1.3 -I${PROJECT_SOURCE_DIR}/shaders/common
              --depfile ${header}.d --vn ${symbol} -o ${header} ${source}
      DEPENDS ${source}
      DEPFILE ${header}.d
      COMMENT "SPIR-V ${name}"
      VERBATIM)
    target_sources(${target} PRIVATE ${header})
  endforeach()
  target_include_directories(${target} PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/generated)
endfunction()
