// A robot and what stands around it, out of files: bodies with their names, where they are for given values of joints,
// which pairs are allowed to meet and why, what was left out, and the unit of lengths.
// Also called: planning scene; robot cell, work cell; collision world.
//
// Files are meshes (a body each), scenes (io/robot/scene_file.h) and at most one robot (URDF), whose links with shapes are
// bodies. Nothing is printed: what people should hear is added to `remarks`, a line each. `place` of a function is for
// messages, such as "--allow". All functions that read files throw Error as their readers do.
#pragma once

#include <sunder/base/error.h>
#include <sunder/certificate/origin.h>
#include <sunder/io/robot/packages.h>
#include <sunder/io/robot/robot_bodies.h>
#include <sunder/io/robot/robot_motion.h>
#include <sunder/io/robot/srdf.h>
#include <sunder/io/robot/urdf.h>
#include <sunder/io/text/left_out.h>
#include <sunder/scene/scene.h>
#include <sunder/solid/object/affine_product.h>
#include <sunder/solid/object/pose.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace sunder::robot {

// A pair of bodies that is not asked about, and why.
struct AllowedPair {
  std::array<std::uint32_t, 2> bodies;
  std::string reason;  // of an SRDF its own ("Never"); "adjacent"; the file that has it; what the caller says
};

// Adds those that are not there yet; of a pair the first reason holds.
void add_allowed(std::span<const AllowedPair> more, std::vector<AllowedPair>& list);

std::vector<std::array<std::uint32_t, 2>> bodies_of(std::span<const AllowedPair> list);
std::vector<std::string> reason_of_each(std::span<const AllowedPair> list);

struct CellFile {
  std::string file;    // a robot where it ends in .urdf, a scene where it ends in .json, else a mesh
  std::string name{};  // of a mesh that of its body. No other body gets it; empty: of a robot and a scene, none
  solid::Pose pose{};  // of the file's frame in the world
};

struct CellOptions {
  bool require_convex = false;               // a mesh that is not is an error; else its hull stands for it
  bool leave_out = false;                    // consent to what is not read (io/text/left_out.h)
  io::Packages packages{};                   // where the robot's meshes are
  io::PartsOf parts = io::PartsOf::objects;  // of meshes, but those of the robot
};

struct CellBody {
  std::string name;
  std::size_t file = 0;               // which of the files
  std::optional<std::uint32_t> link;  // of the robot
  std::vector<io::BodyPart> parts;
};

// Is this a robot's file, by its name?
bool is_urdf(const std::string& file);

class Cell {
 public:
  // Bodies are in the order of the files, links in that of the robot, those without shapes left out. A name that is
  // taken gets a number: "post#2". inputs: as of io::read_file. Throws Error also where there is no body, unless the
  // robot has no collision shape at all and options.leave_out says that this is known.
  explicit Cell(std::span<const CellFile> files, const CellOptions& options = {}, InputFiles* inputs = nullptr,
                std::vector<std::string>* remarks = nullptr);

  const std::vector<CellBody>& bodies() const { return bodies_; }
  std::vector<const io::BodyPart*> parts() const;                                    // of all bodies, in order
  bool is_hull(std::uint32_t body, std::uint32_t part) const;                        // does it stand for a mesh?
  const io::LeftOutList& left_out() const { return left_out_; }                      // what is not read: to be shown
  const std::vector<std::filesystem::path>& meshes_read() const { return meshes_; }  // those that files name
  const std::string& unit() const { return unit_; }  // of lengths, as files say it; empty: none does
  bool has_robot() const { return robot_.has_value(); }

  // The robot. Throws Error bad_call where there is none.
  const io::Robot& robot(const std::string& place) const;

  // The body's index. Throws Error bad_call where none has this name.
  std::uint32_t body_named(const std::string& name, const std::string& place) const;

  // The file of this name, whose pose may be set. Throws Error bad_call where none has it.
  CellFile& file_named(const std::string& name, const std::string& place);

  // Leaves out the links that are in none of these groups; told with what was left out, and in a remark. Throws Error
  // bad_call, also where no link is left.
  void keep_groups(const io::Srdf& srdf, std::span<const std::string> names, const std::string& place,
                   std::vector<std::string>& remarks);

  // The pairs of links that are joined by a joint, or by joints through links without shapes. Throws Error bad_call
  // where there is no robot.
  std::vector<AllowedPair> adjacent(const std::string& place) const;

  // The pairs of a file with two names a line. Lines that name a link without a shape are passed over, with a remark.
  // inputs: as of io::read_file. Throws Error.
  std::vector<AllowedPair> pairs_in(const std::string& file, InputFiles* inputs,
                                    std::vector<std::string>& remarks) const;

  // The pairs that the SRDF of this file disables, each once; those with links that have no shape, or that the robot
  // does not have, are passed over. Remarks say how many, and why. Throws Error bad_call where there is no robot.
  std::vector<AllowedPair> disabled(const io::Srdf& srdf, const std::string& file, const std::string& place,
                                    std::vector<std::string>& remarks) const;

  // The pairs that scene files allow, and these files as they were named.
  const std::vector<AllowedPair>& allowed_by_files() const { return allowed_by_files_; }
  const std::vector<std::string>& scene_files() const { return scene_files_; }

  // The bodies where they are for these values of joints, by name; others as RobotMotion has them. Throws Error as
  // io::link_poses does, and bad_pose, naming the body, where a pose overflows.
  std::vector<scene::Body> place(const std::map<std::string, double>& joints = {}) const;

  // Calls put(part, pose) for each part of each link, where the links are at these places in the robot's frame. Parts
  // are numbered through all bodies. Throws Error bad_pose where a pose overflows or is singular.
  template <class Put>
  void place_links(std::span<const Affine3> links, const Put& put) const {
    std::uint32_t number = 0;
    for (const CellBody& body : bodies_) {
      if (!body.link) {
        number += static_cast<std::uint32_t>(body.parts.size());
        continue;
      }
      const Affine3 &file = files_[body.file].pose.affine(), &link = links[*body.link];
      const Affine3 body_at = io::is_identity(file) ? link : solid::affine_product(file, link);
      for (const io::BodyPart& part : body.parts) {
        const Affine3& inner = part.pose.affine();
        const Affine3 at = io::is_identity(inner) ? body_at : solid::affine_product(body_at, inner);
        put(number++, solid::Pose::from_matrix(at.linear, at.translation));
      }
    }
  }

 private:
  void add_mesh(const CellOptions& options, InputFiles* inputs);
  void add_robot(const CellOptions& options, InputFiles* inputs);
  void add_scene(const CellOptions& options, InputFiles* inputs);
  void take_unit(const std::string& unit);
  void tell(std::span<const io::LeftOut> left_out);
  void require_some_body(std::vector<std::string>* remarks) const;
  std::string unused_name(const std::string& wish) const;
  std::optional<std::uint32_t> body_of_link(const std::string& name) const;
  bool is_link(const std::string& name) const;
  bool is_outside(const std::string& name) const;

  std::vector<CellFile> files_;
  std::vector<CellBody> bodies_;
  std::optional<io::Robot> robot_;
  std::string robot_file_;
  io::RobotBodies robot_bodies_;  // without their parts, which are those of bodies_
  std::vector<AllowedPair> allowed_by_files_;
  std::vector<std::string> scene_files_;
  std::string unit_, unit_file_;  // and the file that says so
  std::vector<std::filesystem::path> meshes_;
  std::vector<std::string> outside_;  // links with shapes that are in none of the groups
  io::LeftOutList left_out_;
};

}  // namespace sunder::robot
