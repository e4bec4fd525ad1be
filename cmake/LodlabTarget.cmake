# The one place that says how every target of lodlab is compiled.

# Same bits from every compiler, level and instruction set: no fused multiply-add, no fast-math.
add_library(lodlab_settings INTERFACE)
target_compile_features(lodlab_settings INTERFACE cxx_std_20)
target_compile_options(lodlab_settings INTERFACE -ffp-contract=off)

add_library(lodlab_warnings INTERFACE)
target_compile_options(lodlab_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow)
if(CMAKE_UNITY_BUILD)  # sources compiled together see each other's helpers, and are no main file
  target_compile_options(lodlab_warnings INTERFACE -Wno-shadow $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
endif()

# Every library's headers are included as <lodlab/NAME/header.hpp>, here and where they are installed.
set(lodlab_includes ${PROJECT_BINARY_DIR}/include)
if(POLICY CMP0205)  # where links are not allowed, folders are copied with all that is in them
  cmake_policy(SET CMP0205 NEW)
endif()
file(MAKE_DIRECTORY ${lodlab_includes}/lodlab)

# lodlab_library(NAME sources...): a library, static unless BUILD_SHARED_LIBS. Its target is lodlab_NAME, so that a
# game that takes the sources may have a target NAME of its own; whoever links it calls it lodlab::NAME, as where it is
# installed.
function(lodlab_library name)
  set(target lodlab_${name})
  add_library(${target} ${ARGN})
  add_library(lodlab::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES
    EXPORT_NAME ${name} CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ON
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  get_filename_component(folder ${CMAKE_CURRENT_SOURCE_DIR} NAME)
  file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR} ${lodlab_includes}/lodlab/${folder}
       SYMBOLIC COPY_ON_ERROR)
  target_include_directories(${target}
    PUBLIC $<BUILD_INTERFACE:${lodlab_includes}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
    PRIVATE ${PROJECT_SOURCE_DIR})
  target_link_libraries(${target} PUBLIC lodlab_settings PRIVATE $<BUILD_INTERFACE:lodlab_warnings>)
  # A square root is one instruction where it need not set errno; a call within a library may be
  # inlined where nobody may put another function in its place.
  target_compile_options(${target} PRIVATE -fno-math-errno)
  if(EMSCRIPTEN)
    set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE OFF)
  else()
    target_compile_options(${target} PRIVATE -fno-semantic-interposition)
  endif()
  # A shared library shows what is lodlab's own, and hides what it took in (Eigen, parsers).
  if(BUILD_SHARED_LIBS AND UNIX AND NOT APPLE)
    target_link_options(${target} PRIVATE
      -Wl,--version-script,${PROJECT_SOURCE_DIR}/cmake/exports.map)
    set_target_properties(${target} PROPERTIES
      LINK_DEPENDS ${PROJECT_SOURCE_DIR}/cmake/exports.map)
  endif()
endfunction()
