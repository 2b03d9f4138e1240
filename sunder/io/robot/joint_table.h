// Many placements of a robot in one file: the values of its joints, a placement a row, as CSV or NPY.
#pragma once

#include <sunder/base/error.h>
#include <sunder/certificate/origin.h>
#include <sunder/io/robot/urdf.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sunder::io {

// The values are finite. Radians, or metres.
struct JointTable {
  std::string file;                 // for messages
  std::vector<std::string> joints;  // names of the columns, each once; of an NPY file none, but that many columns
  std::size_t columns = 0;
  std::vector<double> values;        // row by row
  std::vector<std::uint32_t> lines;  // of each row in a CSV file; of an NPY file none

  std::size_t rows() const { return columns == 0 ? 0 : values.size() / columns; }
  std::span<const double> row(std::size_t k) const { return std::span(values).subspan(k * columns, columns); }
  std::string place(std::size_t row) const;  // "FILE:7", or "FILE: row 6", from 0
};

// CSV (RFC 4180): the first line has the names of the joints. NPY: an array of two dimensions, as io/text/npy.h reads it.
// It is NPY iff it begins as such files do.
// Throws Error bad_file with file and line, or row: no name is a joint's, a name comes twice, a row with too few or too
// many fields, what is no finite number; an array of another kind or shape; a file that is cut off or goes on too long;
// no row. inputs: as of read_file. threads: numbers of a CSV file are read on so many. Cost: linear.
JointTable read_joint_table(const std::string& file, InputFiles* inputs = nullptr, std::size_t threads = 1);

// The same, from memory.
JointTable parse_joint_table(std::string_view bytes, std::string_view place, std::size_t threads = 1);

// Fits the columns to the robot, with a remark for each that changes: a column of times ("t", "time", "time [s]",
// "stamp" and the like), where the robot has no joint of that name, is dropped; one named JOINT_deg, "JOINT [deg]" or the like becomes
// the joint's, its values turned into radians, which rounds them. Other names stay as they are. Throws Error bad_call
// where degrees are given for a joint that slides, or a joint has two columns. Cost: linear, where something changes.
void fit_joint_table(const Robot& robot, JointTable& table, std::vector<std::string>& remarks);

}  // namespace sunder::io
