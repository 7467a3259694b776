# cmake -D OUT=FILE.cpp -D NAMESPACE=NAME -D HEADER=HEADER -D FILES=FILE,FILE… -P embed.cmake
# Writes a source that defines a text for every file, in the namespace and as the header declares them: student.mustache is
# student_mustache. The program needs no files at run time.
string(REPLACE "," ";" files "${FILES}")
set(source "#include \"${HEADER}\"\n\nnamespace ${NAMESPACE} {\n\n")
foreach(file IN LISTS files)
  file(READ "${file}" text)
  get_filename_component(name "${file}" NAME)
  string(REPLACE "." "_" name "${name}")
  string(APPEND source "const std::string_view ${name} = R\"text(${text})text\";\n")
endforeach()
string(APPEND source "\n}  // namespace ${NAMESPACE}\n")
file(WRITE "${OUT}" "${source}")
