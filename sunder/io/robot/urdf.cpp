#include <sunder/io/robot/urdf.h>
#include <sunder/io/text/file.h>
#include <sunder/io/text/text.h>
#include <sunder/io/text/xml_internal.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <span>

namespace sunder::io {
namespace {

namespace fs = std::filesystem;

constexpr XmlKind urdf{"robot", "URDF", "a URDF", "robot"};

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

class UrdfParser {
 public:
  UrdfParser(std::string_view bytes, std::string_view place) : xml_(bytes, place, urdf) {}

  Robot parse() {
    const XMLElement& robot = xml_.root();
    if (const char* name = robot.Attribute("name")) robot_.name = one_line(name);
    refuse_xacro(robot);
    each_child(robot, [&](const XMLElement& child) {
      if (is(child, "link")) read_link(child);
    });
    if (robot_.links.empty()) fail(robot, "the robot has no link; export it again");
    each_child(robot, [&](const XMLElement& child) {
      if (is(child, "joint")) read_joint(child);
    });
    find_root(robot);
    resolve_mimics();
    sort_joints(robot);
    return std::move(robot_);
  }

 private:
  // A joint as it is read, with what is needed for messages and for mimics.
  struct Source {
    const XMLElement* element;
    const XMLElement* mimic;
  };

  // Within the element, at any depth (the reader of XML limits it).
  void refuse_xacro(const XMLElement& element) const {
    each_child(element, [&](const XMLElement& child) {
      if (std::string_view(child.Name()).starts_with("xacro:")) {
        fail(child, "this is xacro that was not expanded; run: xacro FILE > robot.urdf");
      }
      refuse_xacro(child);
    });
  }

  static bool is(const XMLElement& element, std::string_view name) { return XmlFile::is(element, name); }
  static std::string tag(const XMLElement& element) { return XmlFile::tag(element); }

  template <class Action>
  static void each_child(const XMLElement& element, Action action) {
    XmlFile::each_child(element, action);
  }

  [[noreturn]] void fail(const XMLElement& element, const std::string& text) const { xml_.fail(element, text); }

  UrdfOrigin origin(const XMLElement& owner) const {
    const XMLElement* element = owner.FirstChildElement("origin");
    if (element == nullptr) return {};
    return {xml_.triple_or(*element, "xyz", {0, 0, 0}), xml_.triple_or(*element, "rpy", {0, 0, 0})};
  }

  void read_link(const XMLElement& element) {
    Link link;
    link.name = xml_.name_of(element);
    each_child(element, [&](const XMLElement& child) {
      if (is(child, "collision")) read_collision(child, link);
    });
    if (element.FirstChildElement("collision") == nullptr) {
      each_child(element, [&](const XMLElement& child) {
        if (is(child, "visual")) robot_.left_out.push_back({std::string(visual_shape), link.name, 1});
      });
    }
    add_link(element, std::move(link));
  }

  void add_link(const XMLElement& element, Link link) {
    if (!links_.emplace(link.name, static_cast<std::uint32_t>(robot_.links.size())).second) {
      fail(element, fmt::format("the link {} comes twice; rename one", quote(link.name)));
    }
    robot_.links.push_back(std::move(link));
  }

  void read_collision(const XMLElement& element, Link& link) {
    const XMLElement* geometry = element.FirstChildElement("geometry");
    const XMLElement* kind = geometry ? geometry->FirstChildElement() : nullptr;
    if (kind == nullptr) {
      fail(element, fmt::format("a <collision> of link {} has no shape; expected <geometry><mesh .../></geometry>",
                                quote(link.name)));
    }
    if (kind->NextSiblingElement() != nullptr || geometry->NextSiblingElement("geometry") != nullptr) {
      fail(element, fmt::format("a <collision> of link {} has two shapes; give each a <collision> of its own",
                                quote(link.name)));
    }
    CollisionShape shape;
    if (const char* name = element.Attribute("name")) shape.name = one_line(name);
    shape.origin = origin(element);
    if (is(*kind, "mesh")) {
      shape.kind = ShapeKind::mesh;
      shape.mesh = xml_.attribute(*kind, "filename");
      if (shape.mesh.empty()) fail(*kind, "the filename of <mesh> is empty; name a file");
      shape.scale = xml_.triple_or(*kind, "scale", {1, 1, 1});
      if (shape.scale[0] == 0 || shape.scale[1] == 0 || shape.scale[2] == 0) {
        fail(*kind, "a scale of 0 makes the mesh flat; give 3 numbers that are not 0");
      }
    } else if (is(*kind, "box")) {
      xml_.attribute(*kind, "size");
      shape.size = xml_.triple_or(*kind, "size", {0, 0, 0});
      if (shape.size[0] < 0 || shape.size[1] < 0 || shape.size[2] < 0) {
        fail(*kind, "the size of a box is negative; give 3 numbers from 0");
      }
    } else if (is(*kind, "sphere")) {
      shape.kind = ShapeKind::sphere;
      read_radius(*kind, shape);
    } else if (is(*kind, "cylinder") || is(*kind, "capsule")) {
      shape.kind = is(*kind, "cylinder") ? ShapeKind::cylinder : ShapeKind::capsule;
      read_radius(*kind, shape);
      xml_.attribute(*kind, "length");
      shape.length = xml_.number_or(*kind, "length", 0);
      if (shape.length < 0) fail(*kind, "the length is negative; give a number from 0");
      if (shape.kind == ShapeKind::cylinder && shape.length / 2 == 0) {
        fail(*kind, "a cylinder of length 0 is flat; give a length above 0");
      }
    } else {
      robot_.left_out.push_back({shorten(kind->Name()), link.name, 1});
      return;
    }
    link.shapes.push_back(std::move(shape));
  }

  void read_radius(const XMLElement& element, CollisionShape& shape) const {
    xml_.attribute(element, "radius");
    shape.radius = xml_.number_or(element, "radius", 0);
    if (shape.radius < 0) fail(element, "the radius is negative; give a number from 0");
  }

  std::uint32_t link_number(const XMLElement& joint, const char* role) const {
    const XMLElement* element = joint.FirstChildElement(role);
    if (element == nullptr) fail(joint, fmt::format("the joint has no <{} link=\"...\"/>; add it", role));
    const std::string name = one_line(xml_.attribute(*element, "link"));
    const auto found = links_.find(name);
    if (found == links_.end()) fail(*element, fmt::format("there is no link {}; correct the name", quote(name)));
    return found->second;
  }

  JointType type_of(const XMLElement& element) const {
    const std::string_view type = xml_.attribute(element, "type");
    if (type == "fixed") return JointType::fixed;
    if (type == "revolute") return JointType::revolute;
    if (type == "continuous") return JointType::continuous;
    if (type == "prismatic") return JointType::prismatic;
    fail(element, fmt::format("the type of the joint is {}; known are fixed, revolute, continuous, prismatic, planar, "
                              "floating",
                              quote(type)));
  }

  void add_joint(const XMLElement& element, const XMLElement* mimic, Joint joint) {
    if (!joints_.emplace(joint.name, static_cast<std::uint32_t>(robot_.joints.size())).second) {
      fail(element, fmt::format("the joint {} comes twice; rename one", quote(joint.name)));
    }
    sources_.push_back({&element, mimic});
    robot_.joints.push_back(std::move(joint));
  }

  // A planar or floating joint: as many joints as it takes numbers, with links without shapes between them.
  void add_steps(const XMLElement& element, const Joint& joint, bool is_planar) {
    struct Step {
      const char* name;
      JointType type;
      std::array<double, 3> axis;
    };
    static constexpr Step x{"x", JointType::prismatic, {1, 0, 0}}, y{"y", JointType::prismatic, {0, 1, 0}},
        z{"z", JointType::prismatic, {0, 0, 1}}, yaw{"yaw", JointType::continuous, {0, 0, 1}},
        pitch{"pitch", JointType::continuous, {0, 1, 0}}, roll{"roll", JointType::continuous, {1, 0, 0}};
    static constexpr std::array planar{x, y, yaw};
    static constexpr std::array floating{x, y, z, yaw, pitch, roll};
    if (element.FirstChildElement("mimic") != nullptr) {
      fail(element, "a joint that takes several numbers follows no other; leave out its <mimic>");
    }
    if (is_planar && element.FirstChildElement("axis") && axis(element) != std::array<double, 3>{0, 0, 1}) {
      fail(element,
           "programs differ about a planar joint whose axis is not 0 0 1; give that axis, and turn its <origin>");
    }
    std::uint32_t parent = joint.parent;
    const std::span<const Step> steps = is_planar ? std::span<const Step>(planar) : floating;
    for (const Step& step : steps) {
      Joint one = joint;
      one.name += std::string("/") + step.name;
      one.type = step.type;
      one.parent = parent;
      one.axis = step.axis;
      if (&step != &steps.front()) one.origin = {};
      if (&step != &steps.back()) {
        parent = one.child = static_cast<std::uint32_t>(robot_.links.size());
        add_link(element, {one.name, {}});
      }
      add_joint(element, nullptr, std::move(one));
    }
  }

  void read_joint(const XMLElement& element) {
    Joint joint;
    joint.name = xml_.name_of(element);
    const std::string_view several = xml_.attribute(element, "type");
    const bool is_planar = several == "planar", is_floating = several == "floating";
    if (!is_planar && !is_floating) joint.type = type_of(element);
    joint.parent = link_number(element, "parent");
    joint.child = link_number(element, "child");
    joint.origin = origin(element);
    if (is_planar || is_floating) return add_steps(element, joint, is_planar);
    if (joint.type != JointType::fixed) joint.axis = axis(element);
    if (joint.type == JointType::revolute || joint.type == JointType::prismatic) read_limits(element, joint);
    const bool moves = joint.type != JointType::fixed;
    add_joint(element, moves ? element.FirstChildElement("mimic") : nullptr, std::move(joint));
  }

  std::array<double, 3> axis(const XMLElement& joint) const {
    const XMLElement* element = joint.FirstChildElement("axis");
    if (element == nullptr) return {1, 0, 0};
    xml_.attribute(*element, "xyz");
    std::array<double, 3> axis = xml_.triple_or(*element, "xyz", {1, 0, 0});
    // By the largest entry first, so that nothing overflows.
    const double largest = std::max({std::abs(axis[0]), std::abs(axis[1]), std::abs(axis[2])});
    if (largest == 0) fail(*element, "the axis is 0 0 0; give a direction");
    for (double& entry : axis) entry /= largest;
    const double length = std::hypot(axis[0], axis[1], axis[2]);
    for (double& entry : axis) entry /= length;
    return axis;
  }

  void read_limits(const XMLElement& element, Joint& joint) const {
    const XMLElement* limit = element.FirstChildElement("limit");
    if (limit == nullptr) {
      fail(element, fmt::format("the joint {} has no <limit lower=\"...\" upper=\"...\"/>; add it", quote(joint.name)));
    }
    joint.lower = xml_.number_or(*limit, "lower", 0);
    joint.upper = xml_.number_or(*limit, "upper", 0);
    if (joint.lower > joint.upper) {
      fail(*limit,
           fmt::format("the lower limit {} is above the upper one {}; exchange them", joint.lower, joint.upper));
    }
  }

  // The root is the link that is no child; every other link is the child of one joint.
  void find_root(const XMLElement& robot) {
    std::vector<std::uint32_t> joint_above(robot_.links.size(), none);
    for (std::uint32_t i = 0; i < robot_.joints.size(); ++i) {
      const Joint& joint = robot_.joints[i];
      std::uint32_t& above = joint_above[joint.child];
      if (above != none) {
        fail(*sources_[i].element,
             fmt::format("the link {} is the child of two joints, {} and {}; remove one",
                         quote(robot_.links[joint.child].name), quote(robot_.joints[above].name), quote(joint.name)));
      }
      above = i;
    }
    const auto first = std::find(joint_above.begin(), joint_above.end(), none);
    if (first == joint_above.end()) fail(robot, "every link is the child of a joint; one must be the root");
    const auto second = std::find(first + 1, joint_above.end(), none);
    robot_.root = static_cast<std::uint32_t>(first - joint_above.begin());
    if (second != joint_above.end()) {
      const std::string& first_name = robot_.links[robot_.root].name;
      const std::string& second_name = robot_.links[static_cast<std::size_t>(second - joint_above.begin())].name;
      fail(robot, fmt::format("the links {} and {} are both without a joint above; connect them", quote(first_name),
                              quote(second_name)));
    }
  }

  void resolve_mimics() {
    for (std::size_t i = 0; i < robot_.joints.size(); ++i) {
      const XMLElement* element = sources_[i].mimic;
      if (element == nullptr) continue;
      const std::string name = one_line(xml_.attribute(*element, "joint"));
      const auto found = joints_.find(name);
      if (found == joints_.end()) fail(*element, fmt::format("there is no joint {}; correct the name", quote(name)));
      robot_.joints[i].mimic =
          Mimic{found->second, xml_.number_or(*element, "multiplier", 1), xml_.number_or(*element, "offset", 0)};
    }
    check_mimics();
  }

  // Each joint follows at most one other: walk along, and mark where each walk came by.
  void check_mimics() const {
    constexpr std::size_t never = std::numeric_limits<std::size_t>::max();
    std::vector<std::size_t> walk_of(robot_.joints.size(), never);
    for (std::size_t walk = 0; walk < robot_.joints.size(); ++walk) {
      std::size_t i = walk;
      for (; walk_of[i] == never && robot_.joints[i].mimic; i = robot_.joints[i].mimic->joint) walk_of[i] = walk;
      if (walk_of[i] == walk) {
        fail(*sources_[i].element,
             fmt::format("the joint {} follows itself; correct its mimic", quote(robot_.joints[i].name)));
      }
    }
  }

  // Breadth first from the root, siblings in the order of the file.
  void sort_joints(const XMLElement& robot) {
    std::vector<std::vector<std::uint32_t>> below(robot_.links.size());
    for (std::uint32_t i = 0; i < robot_.joints.size(); ++i) below[robot_.joints[i].parent].push_back(i);
    std::vector<std::uint32_t> order = below[robot_.root];
    for (std::size_t k = 0; k < order.size(); ++k) {
      const std::vector<std::uint32_t>& next = below[robot_.joints[order[k]].child];
      order.insert(order.end(), next.begin(), next.end());
    }
    if (order.size() != robot_.joints.size()) fail(robot, "some joints run in a circle; the links must form a tree");

    std::vector<std::uint32_t> place_of(order.size());
    std::vector<Joint> sorted;
    for (std::uint32_t k = 0; k < order.size(); ++k) {
      place_of[order[k]] = k;
      sorted.push_back(std::move(robot_.joints[order[k]]));
    }
    for (Joint& joint : sorted) {
      if (joint.mimic) joint.mimic->joint = place_of[joint.mimic->joint];
    }
    robot_.joints = std::move(sorted);
  }

  XmlFile xml_;
  Robot robot_;
  std::map<std::string, std::uint32_t> links_, joints_;
  std::vector<Source> sources_;
};

}  // namespace

Robot parse_urdf(std::string_view bytes, std::string_view place) { return UrdfParser(bytes, place).parse(); }

Robot read_urdf(const fs::path& path, InputFiles* inputs) {
  Robot robot = parse_urdf(read_file(path, inputs), path.string());
  robot.folder = path.parent_path();
  return robot;
}

std::string_view name_of(ShapeKind kind) {
  switch (kind) {
    case ShapeKind::mesh: return "mesh";
    case ShapeKind::box: return "box";
    case ShapeKind::sphere: return "sphere";
    case ShapeKind::cylinder: return "cylinder";
    case ShapeKind::capsule: break;
  }
  return "capsule";
}

}  // namespace sunder::io
