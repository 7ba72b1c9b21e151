# `cmake --install`, find_package(seaglass), pkg-config and `cpack -G DEB`.
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/seaglass)
set(libraries seaglass_gpu seaglass_reflection seaglass_sea seaglass_water)
install(TARGETS ${libraries} EXPORT seaglass)
install(EXPORT seaglass NAMESPACE seaglass:: FILE seaglassTargets.cmake DESTINATION ${package_dir})
foreach(part gpu reflection water)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${part}/include/seaglass DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
    PATTERN waves_fftw.h EXCLUDE)
endforeach()

# A file of its own, which is read where a consumer asks for it by name: FFTW is GPL.
if(SEAGLASS_FFTW)
  install(TARGETS seaglass_waves_fftw EXPORT seaglass_waves_fftw)
  install(EXPORT seaglass_waves_fftw NAMESPACE seaglass:: FILE seaglassWavesFftwTargets.cmake DESTINATION ${package_dir})
  install(FILES ${PROJECT_SOURCE_DIR}/water/include/seaglass/waves_fftw.h
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/seaglass)
endif()

# What a host's own shaders include to look reflections up, and to lie in the water's fog.
set(glsl_dir ${CMAKE_INSTALL_DATADIR}/seaglass/glsl)
foreach(name medium reflection_blur reflection_info reflection_source reflection_texels shore_wetness)
  install(FILES ${seaglass_GLSL_DIR}/${name}.glsl DESTINATION ${glsl_dir})
endforeach()

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/seaglassConfig.cmake.in
  ${PROJECT_BINARY_DIR}/seaglassConfig.cmake INSTALL_DESTINATION ${package_dir} PATH_VARS glsl_dir CMAKE_INSTALL_BINDIR)
# Until 1.0 any minor version may break (SemVer).
write_basic_package_version_file(${PROJECT_BINARY_DIR}/seaglassConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/seaglassConfig.cmake ${PROJECT_BINARY_DIR}/seaglassConfigVersion.cmake
  ${CMAKE_CURRENT_LIST_DIR}/seaglassScreenshotTest.cmake ${CMAKE_CURRENT_LIST_DIR}/seaglassRunScreenshotTest.cmake
  DESTINATION ${package_dir})

# seaglass_pkg_config(NAME DESCRIPTION LIBS [OURS module...] [OTHERS module...]): who links a static library links what it
# requires as well, who links a shared one does not.
function(seaglass_pkg_config name description libs)
  cmake_parse_arguments(PARSE_ARGV 3 arg "" "" "OURS;OTHERS")
  # Wherever the tree is moved to.
  file(RELATIVE_PATH up /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
  if(BUILD_SHARED_LIBS)
    list(JOIN arg_OURS ", " requires)
    list(JOIN arg_OTHERS ", " requires_private)
  else()
    set(all ${arg_OURS} ${arg_OTHERS})
    list(JOIN all ", " requires)
  endif()
  configure_file(${CMAKE_CURRENT_FUNCTION_LIST_DIR}/seaglass.pc.in ${PROJECT_BINARY_DIR}/${name}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/${name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endfunction()
seaglass_pkg_config(seaglass-sea "the sea and its heights, without Vulkan" "-lseaglass_sea")
seaglass_pkg_config(seaglass-reflection "reflections of floors and mirrors" "-lseaglass_reflection -lseaglass_gpu")
seaglass_pkg_config(seaglass "water" "-lseaglass_water" OURS seaglass-reflection seaglass-sea)
if(SEAGLASS_FFTW)
  seaglass_pkg_config(seaglass-waves-fftw "waves on the CPU (GPL)" "-lseaglass_waves_fftw -pthread"
    OURS seaglass-sea OTHERS fftw3f)
endif()

if(TARGET seaglass)
  install(TARGETS seaglass)
endif()
# The pages, and the demos that build against what is installed, where the README's links find them.
foreach(page LICENSE README.md CHANGELOG.md CONTRIBUTING.md)
  install(FILES ${PROJECT_SOURCE_DIR}/${page} DESTINATION ${CMAKE_INSTALL_DOCDIR})
endforeach()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs DESTINATION ${CMAKE_INSTALL_DOCDIR}
  FILES_MATCHING PATTERN *.md PATTERN images/*)
foreach(folder demos/minimal demos/tutorial demos/scenes textures)
  cmake_path(GET folder PARENT_PATH parent)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder} DESTINATION ${CMAKE_INSTALL_DOCDIR}/${parent}
    PATTERN __pycache__ EXCLUDE)
endforeach()

if(PROJECT_IS_TOP_LEVEL)
  set(CPACK_PACKAGE_NAME seaglass)
  set(CPACK_PACKAGE_CONTACT "The Seaglass project")
  set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
  set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
  set(CPACK_DEBIAN_PACKAGE_SECTION libdevel)
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_PACKAGE_DEPENDS libvulkan-dev)
  set(CPACK_DEBIAN_PACKAGE_SUGGESTS libfftw3-dev)
  set(CPACK_STRIP_FILES ON)
  include(CPack)
endif()
