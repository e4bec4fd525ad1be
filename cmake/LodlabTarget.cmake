# The one place that says how every target of lodlab is compiled.

# Same bits from every compiler and level: no fused multiply-add, no fast-math.
add_library(lodlab_settings INTERFACE)
target_compile_features(lodlab_settings INTERFACE cxx_std_20)
target_compile_options(lodlab_settings INTERFACE -ffp-contract=off)

add_library(lodlab_warnings INTERFACE)
target_compile_options(lodlab_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow)

# lodlab_library(NAME sources...): a static library, public headers included as "NAME/header.hpp".
function(lodlab_library name)
  add_library(${name} STATIC ${ARGN})
  add_library(lodlab::${name} ALIAS ${name})
  set_target_properties(${name} PROPERTIES POSITION_INDEPENDENT_CODE ON OUTPUT_NAME lodlab_${name}
                                           CXX_EXTENSIONS OFF)
  target_include_directories(${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/lodlab>)
  target_link_libraries(${name} PUBLIC lodlab_settings PRIVATE $<BUILD_INTERFACE:lodlab_warnings>)
  # A square root is one instruction where it need not set errno.
  target_compile_options(${name} PRIVATE -fno-math-errno)
endfunction()
