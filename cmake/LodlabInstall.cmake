# What an installed lodlab is: headers, libraries, the program, its scenes, and how others find
# them, by find_package(lodlab COMPONENTS ...) or by pkg-config (one lodlab-NAME.pc a library).
include(CMakePackageConfigHelpers)

set(lodlab_package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/lodlab)

# lodlab_install(NAME [FOLDER folder] [EXCEPT folder] DESCRIPTION text [LODLAB names] [MODULES modules])
# makes the umbrella header of a library and installs both, if LODLAB_INSTALL, with the headers of its folder, which is
# named like it where none is given, but not those of the folder EXCEPT within it, which is another library's: those
# that are public, and those that these include (cmake/headers). LODLAB names the libraries of ours that it stands on,
# MODULES the pkg-config modules that it links, which a program links too where the library is static. What
# find_package needs for the same stands in lodlab-config.cmake.in.
function(lodlab_install name)
  set(target lodlab_${name})
  if(NOT TARGET ${target})
    return()
  endif()
  cmake_parse_arguments(arg "" "DESCRIPTION;FOLDER;EXCEPT" "LODLAB;MODULES" ${ARGN})
  if(NOT arg_FOLDER)
    set(arg_FOLDER ${name})
  endif()
  get_target_property(type ${target} TYPE)
  set(LIBRARY "")
  set(headers)
  if(type STREQUAL INTERFACE_LIBRARY)
    lodlab_umbrella(${name} INCLUDES ${arg_LODLAB})
  else()
    set(LIBRARY "-L\${libdir} -l${target}")
    lodlab_umbrella(${name} FOLDER ${arg_FOLDER} EXCEPT ${arg_EXCEPT})
    lodlab_headers_of(headers LISTS public reached FOLDER ${arg_FOLDER} EXCEPT ${arg_EXCEPT})
  endif()
  if(NOT LODLAB_INSTALL)
    return()
  endif()
  install(TARGETS ${target} EXPORT lodlab-${name} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
          LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  install(EXPORT lodlab-${name} NAMESPACE lodlab:: FILE lodlab-${name}-targets.cmake
          DESTINATION ${lodlab_package_folder})
  foreach(header ${headers})
    get_filename_component(folder ${header} DIRECTORY)
    install(FILES ${PROJECT_SOURCE_DIR}/${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/lodlab/${folder})
  endforeach()
  install(FILES ${lodlab_includes}/lodlab/${name}.hpp DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/lodlab)

  set(NAME ${name})
  set(DESCRIPTION "${arg_DESCRIPTION}")
  list(TRANSFORM arg_LODLAB PREPEND lodlab-)
  list(JOIN arg_LODLAB " " REQUIRES)
  list(JOIN arg_MODULES " " REQUIRES_PRIVATE)
  if(NOT BUILD_SHARED_LIBS)
    string(APPEND REQUIRES " ${REQUIRES_PRIVATE}")
    set(REQUIRES_PRIVATE "")
  endif()
  file(RELATIVE_PATH UP /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/lodlab.pc.in lodlab-${name}.pc @ONLY)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/lodlab-${name}.pc
          DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
  set_property(GLOBAL APPEND PROPERTY LODLAB_COMPONENTS ${name})
endfunction()

# Sets `result` to the headers below FOLDER, without those below EXCEPT in it, of the LISTS of cmake/headers.
function(lodlab_headers_of result)
  cmake_parse_arguments(arg "" "FOLDER;EXCEPT" "LISTS" ${ARGN})
  set(all)
  foreach(list ${arg_LISTS})
    set(file ${PROJECT_SOURCE_DIR}/cmake/headers/${list}.txt)
    set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    file(STRINGS ${file} headers REGEX "^${arg_FOLDER}/")
    list(APPEND all ${headers})
  endforeach()
  if(arg_EXCEPT)
    list(FILTER all EXCLUDE REGEX "^${arg_FOLDER}/${arg_EXCEPT}/")
  endif()
  set(${result} ${all} PARENT_SCOPE)
endfunction()

# One header with all of a library's public ones, <lodlab/NAME.hpp>, here and where they are installed; without the
# one that wants Eigen. FOLDER and EXCEPT as above; INCLUDES: those of other libraries, for one that has
# no headers.
function(lodlab_umbrella name)
  cmake_parse_arguments(arg "" "FOLDER;EXCEPT" "INCLUDES" ${ARGN})
  set(includes)
  if(arg_FOLDER)
    lodlab_headers_of(headers LISTS public FOLDER ${arg_FOLDER} EXCEPT ${arg_EXCEPT})
    list(REMOVE_ITEM headers core/math/eigen.hpp)
    foreach(header ${headers})
      string(APPEND includes "#include <lodlab/${header}>\n")
    endforeach()
  endif()
  foreach(other ${arg_INCLUDES})
    string(APPEND includes "#include <lodlab/${other}.hpp>\n")
  endforeach()
  file(CONFIGURE OUTPUT ${lodlab_includes}/lodlab/${name}.hpp @ONLY
       CONTENT "#pragma once\n\n// All of lodlab's library ${name}.\n\n${includes}")
endfunction()

# Call once, after the libraries.
function(lodlab_install_package)
  if(NOT LODLAB_INSTALL)
    return()
  endif()
  set_target_properties(lodlab_settings PROPERTIES EXPORT_NAME settings)
  install(TARGETS lodlab_settings EXPORT lodlab-core)
  get_property(LODLAB_COMPONENTS GLOBAL PROPERTY LODLAB_COMPONENTS)
  configure_package_config_file(
    ${PROJECT_SOURCE_DIR}/cmake/lodlab-config.cmake.in lodlab-config.cmake
    INSTALL_DESTINATION ${lodlab_package_folder}
    NO_SET_AND_CHECK_MACRO)
  write_basic_package_version_file(lodlab-config-version.cmake COMPATIBILITY SameMinorVersion)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/lodlab-config.cmake
                ${CMAKE_CURRENT_BINARY_DIR}/lodlab-config-version.cmake
          DESTINATION ${lodlab_package_folder})
endfunction()
