# ashlar_module(NAME … SOURCES … [LIBRARIES …] [HEADERS …]) builds one module, in this tree or outside it:
#   a static library ashlar_module_NAME with its code (for its own tests), and
#   the shared object ashlar_NAME.so that the program opens on demand,
# installs the headers that modules elsewhere may include (as "NAME/header.hpp"),
# and puts the module's module.lua (its schemas) beside it, in the build's modules/NAME.
include(GNUInstallDirs)

function(ashlar_module)
  cmake_parse_arguments(M "" "NAME" "SOURCES;LIBRARIES;HEADERS" ${ARGN})
  add_library(ashlar_module_${M_NAME} STATIC ${M_SOURCES})
  target_link_libraries(ashlar_module_${M_NAME} PUBLIC ashlar::framework ${M_LIBRARIES})
  target_include_directories(ashlar_module_${M_NAME} PUBLIC "${CMAKE_CURRENT_SOURCE_DIR}/..")
  target_compile_features(ashlar_module_${M_NAME} PUBLIC cxx_std_20)
  set_target_properties(ashlar_module_${M_NAME} PROPERTIES POSITION_INDEPENDENT_CODE ON)

  set(folder "${CMAKE_BINARY_DIR}/modules/${M_NAME}")
  # The same objects: a module library needs sources of its own, and none may be dropped by the linker.
  add_library(ashlar_${M_NAME} MODULE "$<TARGET_OBJECTS:ashlar_module_${M_NAME}>")
  target_link_libraries(ashlar_${M_NAME} PRIVATE ashlar::framework ${M_LIBRARIES})
  # An installed module finds the framework three folders up, in the library folder.
  set_target_properties(ashlar_${M_NAME} PROPERTIES PREFIX "" LINKER_LANGUAGE CXX
    LIBRARY_OUTPUT_DIRECTORY "${folder}" INSTALL_RPATH "$ORIGIN/../../..")
  configure_file(module.lua "${folder}/module.lua" COPYONLY)
  if(TARGET program)
    add_dependencies(program ashlar_${M_NAME})
  endif()

  set(installed "${CMAKE_INSTALL_LIBDIR}/ashlar/modules/${M_NAME}")
  install(TARGETS ashlar_${M_NAME} LIBRARY DESTINATION "${installed}")
  install(FILES module.lua DESTINATION "${installed}")
  install(FILES ${M_HEADERS} DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/ashlar/${M_NAME}")
endfunction()
