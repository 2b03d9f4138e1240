// Many placements of a cell's robot, a row of joint values each, as a timeline (scene/timeline.h) takes them.
#pragma once

#include <sunder/base/error.h>
#include <sunder/io/robot/joint_table.h>
#include <sunder/io/robot/robot_motion.h>
#include <sunder/robot/cell.h>
#include <sunder/scene/timeline.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace sunder::robot {

class Rows {
 public:
  static std::string row_number(std::size_t row) { return "row " + std::to_string(row); }

  // joints: the names of the columns. values: `count` rows one after the other. name: of a row, for errors. Keeps a
  // reference to the cell and to the values. Throws Error as RobotMotion does, and where the cell has no robot.
  Rows(const Cell& cell, std::span<const std::string> joints, std::span<const double> values, std::size_t count,
       std::function<std::string(std::size_t)> name = &row_number)
      : cell_(cell),
        motion_(cell.robot("joints"), joints),
        values_(values),
        columns_(joints.size()),
        count_(count),
        name_(std::move(name)) {}

  // Keeps a reference to the table, too, whose joints have names.
  Rows(const Cell& cell, const io::JointTable& table)
      : Rows(cell, table.joints, table.values, table.rows(), [&table](std::size_t row) { return table.place(row); }) {}

  std::size_t size() const { return count_; }
  std::string name(std::size_t row) const { return name_(row); }
  const io::RobotMotion& motion() const { return motion_; }
  std::span<const double> operator[](std::size_t row) const { return values_.subspan(row * columns_, columns_); }

  auto placer() const {
    return [this, links = std::vector<Affine3>(cell_.robot("joints").links.size())](std::size_t row,
                                                                                    const auto& put) mutable {
      motion_.place((*this)[row], links);
      cell_.place_links(links, put);
    };
  }

 private:
  const Cell& cell_;
  io::RobotMotion motion_;
  std::span<const double> values_;
  std::size_t columns_, count_;
  std::function<std::string(std::size_t)> name_;
};

// The cell's bodies, moved to one row after another.
class RowBodies {
 public:
  RowBodies(const Rows& rows, std::vector<scene::Body> bodies)
      : rows_(rows), placer_(rows.placer()), bodies_(std::move(bodies)) {
    for (scene::Body& body : bodies_) {
      for (scene::Part& part : body.parts) parts_.push_back(&part);
    }
  }
  RowBodies(const RowBodies&) = delete;
  RowBodies& operator=(const RowBodies&) = delete;

  // Where they are in a row; holds until the next one is asked for. Throws Error with the row's name.
  std::span<const scene::Body> at(std::size_t row) {
    scene::place_row(rows_, row, placer_,
                     [&](std::uint32_t part, const solid::Pose& pose) { parts_[part]->pose = pose; });
    return bodies_;
  }

 private:
  const Rows& rows_;
  decltype(std::declval<const Rows&>().placer()) placer_;
  std::vector<scene::Body> bodies_;
  std::vector<scene::Part*> parts_;
};

}  // namespace sunder::robot
