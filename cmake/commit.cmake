# cmake -D SOURCE=folder -D OUTPUT=commit.hpp -P commit.cmake: writes which commit the sources are of,
# only where that changed, so that nothing is built again without need.
cmake_minimum_required(VERSION 3.25)
set(commit "an unknown commit")
find_program(GIT git)
if(GIT AND EXISTS ${SOURCE}/.git)
  execute_process(COMMAND ${GIT} -C ${SOURCE} describe --always --dirty=+ --exclude *
                  OUTPUT_VARIABLE found OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(found)
    set(commit "commit ${found}")
  endif()
endif()
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT "#define LODLAB_COMMIT \"@commit@\"\n" @ONLY)
