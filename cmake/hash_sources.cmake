# Writes a C++ source with a function that gives the SHA-256 over the names and bytes of source files: two programs
# whose hashes are the same were made of the same text.
# Usage: cmake -D OUTPUT=FILE.cpp -D ROOT=FOLDER -D LIST=FILE -P hash_sources.cmake
#        LIST: names below ROOT, a line each
file(STRINGS "${LIST}" names)
set(all "")
foreach(name IN LISTS names)
  file(SHA256 "${ROOT}/${name}" hash)
  string(APPEND all "${hash} ${name}\n")
endforeach()
string(SHA256 hash "${all}")
file(WRITE "${OUTPUT}" "#include \"lodlab/live/sources.hpp\"\n\nnamespace live {\n\nconst char* sources() {\n    return \"${hash}\";\n}\n\n}  // namespace live\n")
