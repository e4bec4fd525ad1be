# cmake -D PROGRAM=path -D PATTERN=regex -P says.cmake: runs a program; fails where it does, or prints something else.
execute_process(COMMAND ${PROGRAM} OUTPUT_VARIABLE said RESULT_VARIABLE result)
message("${said}")
if(NOT result EQUAL 0 OR NOT said MATCHES "${PATTERN}")
  message(FATAL_ERROR "${PROGRAM} ended with ${result}; it should end with 0 and print what matches ${PATTERN}")
endif()
