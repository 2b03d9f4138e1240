// Robots and what stands around them, out of files: bodies with their names, where they are for given values of joints,
// which pairs are allowed to meet and why, what was left out, and the unit of lengths.
// Also called: planning scene; robot cell, work cell; collision world.
//
// Files are meshes (a body each), scenes (io/robot/scene_file.h) and robots (URDF), whose links with shapes are bodies.
// One file may come several times, as two robots of one kind. A link or a joint has the name of its file, but where two
// robots have one of the same name: there it is ROBOT/NAME of each. Nothing is printed: what people should hear is added
// to `remarks`, a line each. `place` of a function is for messages, such as "--allow". All functions that read files
// throw Error as their readers do.
#pragma once

#include <sunder/base/error.h>
#include <sunder/certificate/origin.h>
#include <sunder/io/robot/joint_values.h>
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
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
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
  std::string name{};  // of a mesh that of its body, of a robot its own. No other body gets it. Where it is empty, a
                       // robot has the name of the file without folder and ending, and a scene none
  solid::Pose pose{};  // of the file's frame in the world
};

struct CellOptions {
  bool require_convex = false;               // a mesh that is not is an error
  bool hulls = false;                        // a mesh that is not is replaced by its hull; else it is as it is
  bool leave_out = false;                    // consent to what is not read (io/text/left_out.h)
  io::Packages packages{};                   // where the robot's meshes are
  io::PartsOf parts = io::PartsOf::objects;  // of meshes, but those of the robot
};

// What moves with a link, and the pose of its frame in that of the link.
struct Attachment {
  std::uint32_t link = 0;  // of Cell::robot()
  solid::Pose pose{};
};

struct CellBody {
  std::string name;
  std::size_t file = 0;               // which of the files
  std::optional<std::uint32_t> link;  // of Cell::robot(), where it is one
  std::vector<io::BodyPart> parts;
  std::optional<Attachment> attached{};
};

// One of the robots.
struct CellRobot {
  std::string name;
  std::size_t file = 0;
  io::Robot model;                                // as in its file
  std::uint32_t first_link = 0, first_joint = 0;  // in Cell::robot()
  std::optional<Attachment> attached{};           // its root, to a link of another one
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
  bool has_robot() const { return !robots_.empty(); }
  const std::vector<CellRobot>& robots() const { return robots_; }

  // All robots as one, the links and joints of each after those of the one before: a tree for each (RobotMotion takes
  // them). One robot is as in its file. Throws Error bad_call where there is none.
  const io::Robot& robot(const std::string& place) const;

  // The body's index. Throws Error bad_call where none has this name.
  std::uint32_t body_named(const std::string& name, const std::string& place) const;

  // The file of this name, whose pose may be set. Throws Error bad_call where none has it.
  CellFile& file_named(const std::string& name, const std::string& place);

  // Attaches a mesh, a body of a scene file, all bodies of such a file, or a robot (its root) to a link, which may have
  // no shape: it moves with it, and is `pose` in its frame, or what its file's pose is without. A name is that of a body,
  // else of a file. Throws Error bad_call: there is no such name or link, it is a body of a robot, it is attached, or a
  // robot would hang on itself.
  void attach(const std::string& name, const std::string& link, const std::string& place,
              const std::optional<solid::Pose>& pose = {});

  // The pairs that meet since one is attached to the other, as if a fixed joint joined them: of a link without a shape
  // the pairs with those beyond it. Their reason is "attached".
  std::vector<AllowedPair> attached() const;

  // Takes an SRDF for the functions below. robot: the name of its robot; empty: the robot, where there is one, else those
  // whose URDF have the name that the SRDF has, so all of one kind. Throws Error bad_call where there is none.
  void add_srdf(io::Srdf srdf, const std::string& file, const std::string& robot, const std::string& place);

  // Leaves out the links that are in none of these groups, of robots that have such a group: "NAME", or "ROBOT/NAME" of
  // one robot; told with what was left out, and in a remark. Throws Error bad_call, also where no link is left.
  void keep_groups(std::span<const std::string> names, const std::string& place, std::vector<std::string>& remarks);

  // The states that SRDFs have: "GROUP/NAME", of several robots "ROBOT/GROUP/NAME".
  std::vector<std::string> state_names() const;

  // The values of joints in states of the SRDFs, of all robots that have them: as io::state_values, also "ROBOT/NAME".
  io::JointValues state(const std::string& text, const std::string& place, std::vector<std::string>& remarks) const;

  // The pairs of links that are joined by a joint, or by joints through links without shapes. Throws Error bad_call
  // where there is no robot.
  std::vector<AllowedPair> adjacent(const std::string& place) const;

  // The pairs of a file with two names a line. Lines that name a link without a shape are passed over, with a remark.
  // inputs: as of io::read_file. Throws Error.
  std::vector<AllowedPair> pairs_in(const std::string& file, InputFiles* inputs,
                                    std::vector<std::string>& remarks) const;

  // The pairs that the SRDFs disable, each once; those with links that have no shape, or that the robot does not have,
  // are passed over. Remarks say how many, and why.
  std::vector<AllowedPair> disabled(std::vector<std::string>& remarks) const;

  // What SRDFs disable, what is attached, and what scene files allow; remarks as of disabled().
  std::vector<AllowedPair> allowed(std::vector<std::string>& remarks) const;

  // The pairs that scene files allow, and these files as they were named.
  const std::vector<AllowedPair>& allowed_by_files() const { return allowed_by_files_; }
  const std::vector<std::string>& scene_files() const { return scene_files_; }

  // The bodies where they are for these values of joints, by name; others as RobotMotion has them. Throws Error as
  // RobotMotion does, and bad_pose, naming the body, where a pose overflows.
  std::vector<scene::Body> place(const std::map<std::string, double>& joints = {}) const;

  // Where a link is in the world. links: where they are, each in the frame of its robot.
  Affine3 link_frame(std::uint32_t link, std::span<const Affine3> links) const {
    const CellRobot& robot = robots_[robot_of_link_[link]];
    if (robot.attached) return mounted(*robot.attached, links, links[link]);
    return product(files_[robot.file].pose.affine(), links[link]);
  }

  // Calls put(part, pose) for each part of each body that moves with a link, where the links are at these places, each in
  // the frame of its robot. Parts are numbered through all bodies. Throws Error bad_pose where a pose overflows or is
  // singular.
  template <class Put>
  void place_links(std::span<const Affine3> links, const Put& put) const {
    std::uint32_t number = 0;
    for (const CellBody& body : bodies_) {
      if (!body.link && !body.attached) {
        number += static_cast<std::uint32_t>(body.parts.size());
        continue;
      }
      const Affine3 body_at = body.link ? link_frame(*body.link, links) : mounted(*body.attached, links, {});
      for (const io::BodyPart& part : body.parts) {
        const Affine3& inner = part.pose.affine();
        const Affine3 at = io::is_identity(inner) ? body_at : solid::affine_product(body_at, inner);
        put(number++, solid::Pose::from_matrix(at.linear, at.translation));
      }
    }
  }

 private:
  struct CellSrdf {
    io::Srdf srdf;
    std::string file;
    std::vector<std::size_t> robots;
  };

  void add_mesh(const CellOptions& options, InputFiles* inputs);
  void keep_meshes();
  std::vector<io::LeftOut> add_robot(const CellOptions& options, InputFiles* inputs);
  void add_scene(const CellOptions& options, InputFiles* inputs);
  void take_unit(const std::string& unit);
  void give_names();
  void join_robots();
  void tell(const std::string& file, std::span<const io::LeftOut> left_out);
  void require_some_body(std::vector<std::string>* remarks) const;
  std::size_t file_number(const std::string& name, const std::string& place) const;
  std::vector<std::uint32_t> attached_bodies() const;
  bool is_outside(std::uint32_t link) const;
  std::vector<std::array<std::uint32_t, 2>> neighbours(const io::Robot& robot, const io::RobotBodies& bodies) const;
  std::optional<std::uint32_t> body_of_link(std::uint32_t link) const;
  std::uint32_t link_named(const std::string& name, const std::string& place) const;
  std::pair<std::optional<std::size_t>, std::string> robot_and_rest(const std::string& name) const;

  // An attached body's or robot's frame in the world, then `inner` in it.
  Affine3 mounted(const Attachment& to, std::span<const Affine3> links, const Affine3& inner) const {
    return product(product(link_frame(to.link, links), to.pose.affine()), inner);
  }
  static Affine3 product(const Affine3& outer, const Affine3& inner) {
    return io::is_identity(outer) ? inner : solid::affine_product(outer, inner);
  }

  std::map<std::array<std::size_t, 2>, std::vector<std::string>> by_robot(
      std::span<const std::string> texts, const std::string& place,
      const std::function<bool(const io::Srdf&, const std::string&)>& has) const;

  std::vector<CellFile> files_;
  std::vector<CellBody> bodies_;
  std::vector<CellRobot> robots_;
  io::Robot robot_;                           // all of them
  std::vector<std::uint32_t> robot_of_link_;  // of robot_
  io::RobotBodies robot_bodies_;              // of robot_, without their parts, which are those of bodies_
  std::vector<CellSrdf> srdfs_;
  std::vector<AllowedPair> allowed_by_files_;
  std::vector<std::string> scene_files_;
  std::string unit_, unit_file_;  // and the file that says so
  std::vector<std::filesystem::path> meshes_;
  std::vector<std::uint32_t> outside_;  // links with shapes that are in none of the groups
  io::LeftOutList left_out_;
};

}  // namespace sunder::robot
