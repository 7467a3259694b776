# cmake -D OUT=FILE.cpp -D FILES=FILE,FILE… -P embed.cmake
# Writes a source that defines, for every file, a text of its name in harness::report::pages, as pages.h declares them:
# student.mustache is student_mustache. The program needs no files at run time.
string(REPLACE "," ";" files "${FILES}")
set(source "#include \"harness/report/pages/pages.h\"\n\nnamespace harness::report::pages {\n\n")
foreach(file IN LISTS files)
  file(READ "${file}" text)
  get_filename_component(name "${file}" NAME)
  string(REPLACE "." "_" name "${name}")
  string(APPEND source "const std::string_view ${name} = R\"page(${text})page\";\n")
endforeach()
string(APPEND source "\n}  // namespace harness::report::pages\n")
file(WRITE "${OUT}" "${source}")
