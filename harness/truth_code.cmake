# Writes OUTPUT, the definition of truth_code() (reference/truth_code.hpp): the hash of all sources in FOLDER that truths
# are computed by, with their paths there, and of what COMPILED_BY says of compiler and libraries.
set(texts "${COMPILED_BY}\n")
foreach(layer core scene reference)
  file(GLOB_RECURSE sources RELATIVE ${FOLDER} ${FOLDER}/${layer}/*.cpp ${FOLDER}/${layer}/*.hpp)
  list(SORT sources)
  foreach(source IN LISTS sources)
    file(SHA256 ${FOLDER}/${source} hash)
    string(APPEND texts "${source} ${hash}\n")
  endforeach()
endforeach()
string(SHA256 hash "${texts}")
file(WRITE ${OUTPUT} "#include \"reference/truth_code.hpp\"

namespace reliefbench {

std::string_view truth_code() {
    return \"${hash}\";
}

}  // namespace reliefbench
")
