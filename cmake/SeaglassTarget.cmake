# What every Seaglass target is compiled with. Private, so that nothing leaks into a consumer's build.
function(seaglass_target target)
  target_compile_features(${target} PRIVATE cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ON)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wconversion
    # Vulkan's structs are begun by their sType alone; the rest is zero by the language.
    -Wno-missing-field-initializers
    # A fused multiply-add that only some machines have would make their results differ.
    -ffp-contract=off
    $<$<BOOL:${SEAGLASS_WARNINGS_AS_ERRORS}>:-Werror>)
  if(SEAGLASS_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=${SEAGLASS_SANITIZE} -fno-omit-frame-pointer
      -fno-sanitize-recover=all)
    target_link_options(${target} PRIVATE -fsanitize=${SEAGLASS_SANITIZE})
  endif()
endfunction()
