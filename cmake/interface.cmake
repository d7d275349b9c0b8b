# The plugin interface: a number, and a hash of every header a plugin compiles in. Both must match exactly,
# so that a message never has one layout in the program and another in a plugin.
set(LEADLINE_INTERFACE_NUMBER 1)
set(headers)
foreach(folder core/types core/messages core/flow core/geo plugins/sdk)
  file(GLOB found RELATIVE ${PROJECT_SOURCE_DIR} CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${folder}/*.h)
  if(NOT found)
    message(FATAL_ERROR "${folder} has no headers to hash")
  endif()
  list(APPEND headers ${found})
endforeach()
list(SORT headers)
set(hashes)
foreach(header ${headers})
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${header})
  file(SHA256 ${PROJECT_SOURCE_DIR}/${header} hash)
  string(APPEND hashes "${hash}  ${header}\n")  # as sha256sum prints it
endforeach()
string(SHA256 LEADLINE_INTERFACE_HASH "${hashes}")
