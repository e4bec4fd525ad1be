# Toolchain of the preset wasm: emscripten as Debian has it. Of /usr/include it sees those folders alone
# whose headers need no library and no system; they are linked into one folder of the build.
find_program(EM_CONFIG em-config REQUIRED)  # package emscripten
execute_process(COMMAND ${EM_CONFIG} EMSCRIPTEN_ROOT OUTPUT_VARIABLE emscripten
                OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE BOTH)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE BOTH)
include(${emscripten}/cmake/Modules/Platform/Emscripten.cmake)

set(headers ${CMAKE_BINARY_DIR}/headers_of_others)
file(MAKE_DIRECTORY ${headers})
foreach(folder boost nlohmann toml++ fast_float)
  file(CREATE_LINK /usr/include/${folder} ${headers}/${folder} SYMBOLIC)
endforeach()
set(CMAKE_CXX_STANDARD_INCLUDE_DIRECTORIES ${headers})
list(APPEND CMAKE_INCLUDE_PATH ${headers})
# Packages name /usr/include as theirs; the C library's headers there are another's.
set(CMAKE_CXX_IMPLICIT_INCLUDE_DIRECTORIES /usr/include)
set(CMAKE_CXX_FLAGS_INIT -fwasm-exceptions)
