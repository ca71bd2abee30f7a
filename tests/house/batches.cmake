# The sources of every target in batches that compile as one file each: headers and templates are then read once
# a batch, which halves the time of a whole build and more, but makes a file's change dear. For builds from scratch.
set(ashlar_batch_size 12 CACHE STRING "Sources compiled as one")
find_program(awk NAMES awk REQUIRED)
set_property(DIRECTORY "${PROJECT_SOURCE_DIR}" APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS
  "${CMAKE_CURRENT_LIST_DIR}/batches.awk")

# Files whose local names clash come into different batches, so the batches follow the files' text.
function(ashlar_batch target)
  get_target_property(sources ${target} SOURCES)
  get_target_property(folder ${target} SOURCE_DIR)
  list(FILTER sources INCLUDE REGEX "\\.cpp$")
  if(NOT sources)
    return()
  endif()
  list(TRANSFORM sources PREPEND "${folder}/" REGEX "^[^/]")
  list(TRANSFORM sources PREPEND "${target}\t")
  list(JOIN sources "\n" lines)
  set(list "${CMAKE_BINARY_DIR}/batches/${target}.txt")
  file(WRITE "${list}" "${lines}\n")
  # Headers are looked for from the top, wherever CMake was called.
  execute_process(COMMAND "${awk}" -v most=${ashlar_batch_size} -f "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/batches.awk" "${list}"
    WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}"
    OUTPUT_VARIABLE batches COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCHALL "[^\n]+" batches "${batches}")
  foreach(batch IN LISTS batches)
    string(REGEX MATCH "^([0-9]+)\t.*\t(.*)$" batch "${batch}")
    set_property(SOURCE "${CMAKE_MATCH_2}" TARGET_DIRECTORY ${target} PROPERTY UNITY_GROUP ${CMAKE_MATCH_1})
    set_property(DIRECTORY "${PROJECT_SOURCE_DIR}" APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${CMAKE_MATCH_2}")
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()

function(ashlar_batches_below folder)
  get_property(targets DIRECTORY "${folder}" PROPERTY BUILDSYSTEM_TARGETS)
  foreach(target IN LISTS targets)
    get_target_property(type ${target} TYPE)
    if(type MATCHES "LIBRARY|EXECUTABLE")
      ashlar_batch(${target})
    endif()
  endforeach()
  get_property(folders DIRECTORY "${folder}" PROPERTY SUBDIRECTORIES)
  foreach(below IN LISTS folders)
    ashlar_batches_below("${below}")
  endforeach()
endfunction()

ashlar_batches_below("${PROJECT_SOURCE_DIR}")
