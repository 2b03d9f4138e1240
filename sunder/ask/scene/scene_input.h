// The bodies of `sunder scene`, out of the words of a call (robot/cell.h), and what reports say of them.
#pragma once

#include <sunder/ask/objects.h>
#include <sunder/ask/said_of.h>
#include <sunder/ask/scene/allowed_pairs.h>

#include <sunder/io/robot/joint_values.h>
#include <sunder/io/robot/srdf.h>
#include <sunder/robot/cell.h>

#include <array>
#include <string>
#include <type_traits>
#include <vector>

namespace sunder::ask {

// A word of a call that names a file: FILE, FILE@POSE, NAME=FILE or NAME=FILE@POSE. The whole, or what is before the last
// '@', is the file where there is one of this name.
struct FileWord {
  std::string name, file, pose;  // name, pose: empty where none is given
};
FileWord file_word(const std::string& word);

// Each file is as of file_word; its name is, where none is given, that of the file without folder and ending. poses:
// "NAME=POSE" each. inputs: as of io::read_file. Notes what the cell remarks. Throws Error.
robot::Cell read_cell(Talk& talk, const std::vector<std::string>& files, const std::vector<std::string>& poses,
                      const robot::CellOptions& options, InputFiles* inputs);

// "NAME=LINK" or "NAME=LINK@POSE" each (Cell::attach). Throws Error.
void attach(const std::vector<std::string>& words, robot::Cell& cell);

// What is attached, and the link: of robots, then of bodies. [{"name": "gripper", "link": "tool0"}, ..]
std::vector<std::array<std::string, 2>> attached_names(const robot::Cell& cell);
Json attached_json(const robot::Cell& cell);

// Pairs of bodies out of a word of --allow: "adjacent", "NAME,NAME", or a file with two names a line. Throws Error.
std::vector<AllowedPair> allowed_by_word(Talk& talk, const robot::Cell& cell, const std::string& word,
                                         InputFiles* inputs);

// What a function of the cell, or of what belongs to it, returns, called with where it adds remarks, which are noted.
template <class Function>
auto noting(Talk& talk, const Function& function) {
  std::vector<std::string> remarks;
  if constexpr (std::is_void_v<decltype(function(remarks))>) {
    function(remarks);
    talk.note_all(remarks);
  } else {
    auto result = function(remarks);
    talk.note_all(remarks);
    return result;
  }
}

// Notes which of these values are beyond the limits of their joints: one note, however many there are.
void note_limits(Talk& talk, const robot::Cell& cell, const std::vector<io::JointValues>& placements);

// What a proof says that each part of each body is made of; as_meshes: as it is, of a mesh.
std::vector<std::vector<Said>> said_of(const robot::Cell& cell, const InputFiles& inputs, bool as_meshes = false);

std::vector<const MeshBody*> meshes_of(const robot::Cell& cell);  // of the parts that have no radius

}  // namespace sunder::ask
