// Whole files, in and out.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace sunder::io {

// The bytes of the file. Pipes and devices are read to their end, up to 256 MiB.
// Throws Error bad_file, "FILE: what is wrong; remedy": the name is empty, there is no such file, it is a folder, it
// cannot be opened or read, it is empty, or it does not fit into memory.
std::string read_file(const std::filesystem::path& path);

// Puts the text under this name: all of it, or, when anything fails, nothing (what was there before stays, and no
// other file is left behind). It is written to a new file in the same folder, which then takes the name; permissions
// of a file that is replaced are kept, and a symbolic link is followed. What is no regular file (/dev/stdout, a pipe)
// is written to directly. Not promised: that the text survives a power cut right after the return.
// Throws Error bad_file: "FILE: what is wrong; remedy".
void write_file_atomically(const std::filesystem::path& path, std::string_view text);

}  // namespace sunder::io
