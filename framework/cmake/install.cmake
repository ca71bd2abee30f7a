# Headers, libraries, the program, its modules and scripts, and the package that lets modules be built elsewhere.
include(CMakePackageConfigHelpers)

set(package_folder "${CMAKE_INSTALL_LIBDIR}/cmake/Ashlar")

install(TARGETS ashlar EXPORT AshlarTargets LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}")
if(TARGET ashlar_program)
  install(TARGETS ashlar_program RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
endif()
install(DIRECTORY "${PROJECT_SOURCE_DIR}/framework/" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/ashlar"
  FILES_MATCHING PATTERN "*.hpp" PATTERN app EXCLUDE PATTERN cmake EXCLUDE)
install(DIRECTORY "${PROJECT_SOURCE_DIR}/scripts/" DESTINATION "${CMAKE_INSTALL_DATADIR}/ashlar/scripts"
  FILES_MATCHING PATTERN "*.lua")

install(EXPORT AshlarTargets NAMESPACE ashlar:: DESTINATION "${package_folder}")
configure_package_config_file("${CMAKE_CURRENT_LIST_DIR}/AshlarConfig.cmake.in"
  "${CMAKE_BINARY_DIR}/AshlarConfig.cmake" INSTALL_DESTINATION "${package_folder}")
# Modules share C++ types with the framework: only the same minor version fits.
write_basic_package_version_file("${CMAKE_BINARY_DIR}/AshlarConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${CMAKE_BINARY_DIR}/AshlarConfig.cmake" "${CMAKE_BINARY_DIR}/AshlarConfigVersion.cmake"
  "${CMAKE_CURRENT_LIST_DIR}/AshlarModule.cmake" DESTINATION "${package_folder}")
