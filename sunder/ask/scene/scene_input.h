// The bodies of `sunder scene` out of files: meshes, scenes and one robot, where they are, and which pairs are allowed
// to meet.
#pragma once

#include <sunder/ask/objects.h>
#include <sunder/ask/said_of.h>
#include <sunder/ask/scene/allowed_pairs.h>

#include <sunder/io/packages.h>
#include <sunder/io/robot_bodies.h>
#include <sunder/io/robot_motion.h>
#include <sunder/io/srdf.h>
#include <sunder/io/urdf.h>
#include <sunder/scene/scene.h>
#include <sunder/solid/object/affine_product.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace sunder::ask {

class SceneInput {
 public:
  // Each name is a file, or FILE@POSE. poses: "NAME=POSE" each, NAME as shown by `names`. Where leave_out, shapes of
  // a robot that are not read, also meshes, are left out. inputs: as of io::read_file. packages: where the robot's
  // meshes are. parts: of meshes, but those of a robot. Throws Error, also where there is no body at all.
  SceneInput(const std::vector<std::string>& files, const std::vector<std::string>& poses, bool require_convex,
             bool leave_out, InputFiles* inputs, const io::Packages& packages = {},
             io::PartsOf parts = io::PartsOf::objects);

  // The bodies in the order of the files; links without shapes are none. Throws Error for joints that do not exist or
  // are out of their limits.
  std::vector<scene::Body> bodies(const std::map<std::string, double>& joints) const;

  // Pairs of bodies out of: "adjacent" (links joined by a joint, or by joints through links without shapes),
  // "NAME,NAME", or a file with two names a line. Lines that name a link without a shape are passed over, with a
  // remark. inputs: as of io::read_file. Throws Error.
  std::vector<AllowedPair> allowed(const std::string& text, InputFiles* inputs) const;

  // The pairs that the file of --srdf disables, each once; those with links that have no shape, or that the robot does
  // not have, are passed over. Notes say how many, and why. Throws Error where there is no robot.
  std::vector<AllowedPair> allowed(const io::Srdf& srdf, const std::string& file) const;

  // The pairs that scene files allow, and these files as they were named.
  const std::vector<AllowedPair>& allowed_by_files() const { return allowed_by_files_; }
  const std::vector<std::string>& scene_files() const { return scene_files_; }
  const std::string& unit() const { return unit_; }  // of lengths, as a scene file says it; empty: none does

  // Leaves out the links that are in none of these groups; told with the answer, and in a note. Throws Error, also
  // where nothing is left.
  void keep_groups(const io::Srdf& srdf, const std::vector<std::string>& names);

  // The values that --state means, with notes about what is not taken. Throws Error.
  io::JointValues state(const io::Srdf& srdf, const std::string& text) const;

  // Says which of these values are beyond the limits of their joints: one note, however many there are.
  void note_limits(const std::vector<io::JointValues>& placements) const;

  // The robot, whose links are some of the bodies. Throws Error bad_call, for this option, where there is none.
  const io::Robot& robot(const std::string& option) const;

  // Calls place(part, pose) for each part of each link, where the links are at these places in the robot's frame. Parts
  // are numbered through all bodies. Throws Error bad_pose where a pose overflows or is singular.
  template <class Place>
  void place_links(std::span<const Affine3> links, const Place& place) const {
    std::uint32_t number = 0;
    for (const Body& body : bodies_) {
      if (!body.link) {
        number += static_cast<std::uint32_t>(body.parts.size());
        continue;
      }
      const Affine3 &input = inputs_[body.input].pose.affine(), &link = links[*body.link];
      const Affine3 body_at = io::is_identity(input) ? link : solid::affine_product(input, link);
      for (const io::BodyPart& part : body.parts) {
        const Affine3& inner = part.pose.affine();
        const Affine3 at = io::is_identity(inner) ? body_at : solid::affine_product(body_at, inner);
        place(number++, solid::Pose::from_matrix(at.linear, at.translation));
      }
    }
  }

  // Its index. Throws Error bad_call with this place where there is none.
  std::uint32_t body_named(const std::string& name, const std::string& place) const;

  bool is_hull(std::uint32_t body, std::uint32_t part) const;  // does it stand for a mesh?
  std::vector<const io::BodyPart*> parts() const;              // of all bodies, in order
  // What a proof says that each part of each body is made of.
  std::vector<std::vector<Said>> said(const InputFiles& inputs) const;
  std::vector<const MeshBody*> meshes() const;                                       // of those that have no radius
  const LeftOutList& left_out() const { return left_out_; }                          // what is not read: must be shown
  const std::vector<std::filesystem::path>& meshes_read() const { return meshes_; }  // those that files name

 private:
  struct Body {
    std::string name;
    std::size_t input = 0;              // which of the files
    std::optional<std::uint32_t> link;  // of the robot
    std::vector<io::BodyPart> parts;
  };
  struct Input {
    std::string name;
    solid::Pose pose;
  };

  void add_mesh(const std::string& file, bool require_convex, InputFiles* inputs, io::PartsOf parts);
  void add_robot(const std::string& file, bool require_convex, InputFiles* inputs, const io::Packages& packages);
  void add_scene(const std::string& file, bool require_convex, InputFiles* inputs, io::PartsOf parts);
  void take_unit(const std::string& unit, const std::string& file);
  void tell(std::span<const io::LeftOut> left_out);
  void require_some_body() const;
  std::string unused_name(const std::string& wish) const;
  std::optional<std::uint32_t> body_of_link(const std::string& name) const;
  bool is_link(const std::string& name) const;
  bool is_outside(const std::string& name) const;
  std::vector<AllowedPair> adjacent() const;

  std::vector<Input> inputs_;
  std::vector<Body> bodies_;
  std::optional<io::Robot> robot_;
  std::string robot_file_;
  io::RobotBodies robot_bodies_;  // without their parts, which are those of bodies_
  std::vector<AllowedPair> allowed_by_files_;
  std::vector<std::string> scene_files_;
  std::string unit_, unit_file_;  // and the file that says so
  std::vector<std::filesystem::path> meshes_;
  std::vector<std::string> outside_;  // links with shapes that are in none of the groups
  LeftOutList left_out_;
};

}  // namespace sunder::ask
