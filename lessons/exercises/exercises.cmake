# Exercises in C++: an exercise is tasks/PART/NAME.md, its words, reference solution and foreseen mistakes, and
# tasks/PART/NAME.cpp, its cases and the truth about them. This is their order, that of the lessons.

set(exercises
  detection/meet detection/surely_apart
  detection/holding_radius detection/owner
  detection/level_circles detection/seen_down_to
  detection/next_front detection/answer_in_time
  detection/verdict detection/latest_proof
  detection/cost_of_next_level detection/by_turns
  response/contact_point response/impulse
  response/net_impulses response/sharing_groups
  response/level_error response/good_from
  response/meeting_radius response/shadows_meet
  response/box_inertia response/spin_change
  frames/best_gain frames/keep_reserve
  frames/kinetic_energy frames/keeps_law
  frames/impact_time frames/safe_step)

add_executable(lodlab_embed_exercises
  exercises/embed_exercises.cpp exercises/told.cpp exercises/words.cpp)
target_include_directories(lodlab_embed_exercises PRIVATE ${PROJECT_SOURCE_DIR})
target_link_libraries(lodlab_embed_exercises PRIVATE lodlab::lesson_texts lodlab_warnings)

list(TRANSFORM exercises PREPEND exercises/tasks/ OUTPUT_VARIABLE tasks)
list(TRANSFORM tasks APPEND .md OUTPUT_VARIABLE words)
list(TRANSFORM tasks APPEND .cpp)
set(embedded ${CMAKE_CURRENT_BINARY_DIR}/exercises.cpp)
add_custom_command(
  OUTPUT ${embedded}
  COMMAND lodlab_embed_exercises ${embedded} ${PROJECT_SOURCE_DIR} ${exercises}
  DEPENDS lodlab_embed_exercises ${words} exercises/wire.hpp
  WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}
  COMMENT "Embedding the exercises" VERBATIM)
set_source_files_properties(${embedded} PROPERTIES COMPILE_OPTIONS "-w;-O1")  # mistakes are no model

lodlab_library(exercises STATIC
  exercises/attempt.cpp
  exercises/child.cpp
  exercises/compiler_errors.cpp
  exercises/exercise.cpp
  exercises/judge.cpp
  exercises/told.cpp
  exercises/words.cpp
  exercises/workshop.cpp
  ${tasks}
  ${embedded})
target_link_libraries(lodlab_exercises PUBLIC lodlab::core PRIVATE lodlab::lesson_texts lodlab::io lodlab::io_files)
file(RELATIVE_PATH installed_headers /${CMAKE_INSTALL_BINDIR} /${CMAKE_INSTALL_INCLUDEDIR})
set_source_files_properties(exercises/attempt.cpp PROPERTIES COMPILE_DEFINITIONS
  "LODLAB_INSTALLED_HEADERS=\"${installed_headers}\";LODLAB_BUILT_HEADERS=\"${lodlab_includes}\"")
target_precompile_headers(lodlab_exercises REUSE_FROM lodlab_core)
set_target_properties(lodlab_exercises PROPERTIES UNITY_BUILD OFF)  # each exercise has names of its own
