# cmake -D BUILD=folder -P installs_itself.cmake: what the project installs is its program, which runs.
file(REMOVE_RECURSE ${BUILD}/prefix)
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${BUILD}/prefix COMMAND_ERROR_IS_FATAL ANY)
file(GLOB_RECURSE files RELATIVE ${BUILD}/prefix ${BUILD}/prefix/*)
if(NOT files STREQUAL "bin/bodies")
  message(FATAL_ERROR "installed: ${files}; the project's program alone was expected")
endif()
execute_process(COMMAND ${BUILD}/prefix/bin/bodies COMMAND_ERROR_IS_FATAL ANY)
