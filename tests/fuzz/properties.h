// What must hold whatever the bytes. Each function returns "" if all its properties hold, else the first that fails, as
// a sentence. Time is bounded by the input's size, and nothing but the bytes decides.
#pragma once

#include <string>
#include <string_view>

/// An archive, or behind a first line "pack" lines "path=text" to be packed. A file's path stays within the archive,
/// sizes stay within the limits, reading again gives the same, and what was packed comes back.
std::string check_archive(std::string_view bytes);

/// A roster of Canvas, a worksheet of Moodle, or any CSV file. What we write is read back the same, no cell we write is
/// a formula, and a grade goes into one cell of one row.
std::string check_csv(std::string_view text);

/// An HTTP request as it comes over the wire, with its body. The head is the same however the bytes arrive in pieces,
/// the address of the client is one, and a program in a form comes out as it went in.
std::string check_http(std::string_view bytes);

/// The names of the files of a download, one a line; folders end in '/'. Each reading has every part of the name, every
/// name that a system writes is read as it was written, and a file that may be several students' is nobody's.
std::string check_lms_name(std::string_view names);

/// A Gradescope export's metadata file. Names are texts within their limits, and what Gradescope would write of a
/// class, whose names are the lines of the bytes, is read back.
std::string check_metadata(std::string_view yaml);

/// A C++ source. Its tokens cover it, its words lie in it, and a scene that is written into it changes the scene's
/// numbers and nothing else.
std::string check_source(std::string_view source);

/// An assignment. Its scenes are read as the same from what is printed of them; what is wrong has a line in the file.
std::string check_toml(std::string_view toml);

/// A program's output. Each item occurs once and in order, values have the shapes of their items, lines lie within the
/// output, texts stay within their limits, line ends and the digits of answers decide nothing, and an item is read from
/// where a person says that it stands.
std::string check_transcript(std::string_view output);
