# The headers that are of no machine, for compilers that must see no other of this machine's /usr/include.
set(headers ${CMAKE_BINARY_DIR}/headers)
file(MAKE_DIRECTORY ${headers}/include ${headers}/share/cmake)
foreach(folder include/vulkan include/vk_video include/glm share/cmake/glm)
  if(EXISTS /usr/${folder})
    file(CREATE_LINK /usr/${folder} ${headers}/${folder} SYMBOLIC)
  endif()
endforeach()
list(APPEND CMAKE_FIND_ROOT_PATH ${headers})

# Programs run here; all else is the target's.
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
