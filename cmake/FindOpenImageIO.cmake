# OpenImageIO::OpenImageIO by pkg-config. The CMake package that Debian 12 ships insists on the command-line tools and on
# Python bindings, which bring a desktop's worth of packages with them.
find_package(PkgConfig QUIET)
if(PkgConfig_FOUND)
  pkg_check_modules(OpenImageIO_PC QUIET IMPORTED_TARGET OpenImageIO)
endif()
if(OpenImageIO_PC_FOUND AND NOT TARGET OpenImageIO::OpenImageIO)
  add_library(OpenImageIO::OpenImageIO INTERFACE IMPORTED)
  target_link_libraries(OpenImageIO::OpenImageIO INTERFACE PkgConfig::OpenImageIO_PC)
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(OpenImageIO
  REQUIRED_VARS OpenImageIO_PC_FOUND
  VERSION_VAR OpenImageIO_PC_VERSION)
