// What must hold whatever the bytes. Each function returns "" if all its properties hold, else the first that fails, as
// a sentence. Time is bounded by the input's size, and nothing but the bytes decides.
#pragma once

#include <string>
#include <string_view>

/// Rays for `raygrade cast`, as lines and as records. Each has its answer in order, whatever the number of threads, and
/// a walk through a scene's tree finds what trying each object finds.
std::string check_cast(std::string_view bytes);

/// The names of the files of a download, one a line; folders end in '/'. Each reading has every part of the name, every
/// name that a system writes is read as it was written, and a file that may be several students' is nobody's.
std::string check_lms_name(std::string_view names);

/// A C++ source. Its tokens cover it, its words lie in it, and a scene that is written into it changes the scene's
/// numbers and nothing else.
std::string check_source(std::string_view source);

/// An assignment. Its scenes are read as the same from what is printed of them; what is wrong has a line in the file.
std::string check_toml(std::string_view toml);

/// A program's output. Each item occurs once and in order, values have the shapes of their items, lines lie within the
/// output, texts stay within their limits, line ends and the digits of answers decide nothing, and an item is read from
/// where a person says that it stands.
std::string check_transcript(std::string_view output);
