#include "studies/config/urdf_arm.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <console_bridge/console.h>
#include <urdf_model/model.h>
#include <urdf_parser/urdf_parser.h>

#include "core/scenario/attitude.hpp"
#include "core/scenario/robot.hpp"
#include "core/scenario/vectors.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {
namespace {

using Vector = std::array<double, 3>;

struct Frame {
  Vector place{};
  Attitude attitude;
};
Frame frame_of(const urdf::Pose& pose) {
  const urdf::Rotation& q = pose.rotation;
  return {{pose.position.x, pose.position.y, pose.position.z}, {q.w, {q.x, q.y, q.z}}};
}
Frame behind(const Frame& first, const Frame& second) {
  return {sum(first.place, turned(first.attitude, second.place)), first.attitude * second.attitude};
}

/// Mass, first moment and moments of inertia about the origin of a frame: xx, yy, zz, xy, xz, yz.
struct Body {
  double mass = 0.0;
  Vector first{};
  std::array<double, 6> second{};

  void add_point(double m, const Vector& r) {
    mass += m;
    for (std::size_t d = 0; d < 3; ++d) first[d] += m * r[d];
    const double square = dot(r, r);
    for (std::size_t d = 0; d < 3; ++d) second[d] += m * (square - r[d] * r[d]);
    second[3] -= m * r[0] * r[1];
    second[4] -= m * r[0] * r[2];
    second[5] -= m * r[1] * r[2];
  }
};

/// I in axes that the attitude has turned.
std::array<double, 6> turned_inertia(const Attitude& attitude, const urdf::Inertial& own) {
  const double I[3][3] = {{own.ixx, own.ixy, own.ixz}, {own.ixy, own.iyy, own.iyz}, {own.ixz, own.iyz, own.izz}};
  const Vector axes[3] = {turned(attitude, {1, 0, 0}), turned(attitude, {0, 1, 0}), turned(attitude, {0, 0, 1})};
  const auto entry = [&](std::size_t a, std::size_t b) {
    double value = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) value += axes[i][a] * I[i][j] * axes[j][b];
    }
    return value;
  };
  return {entry(0, 0), entry(1, 1), entry(2, 2), entry(0, 1), entry(0, 2), entry(1, 2)};
}

Value array_of(const double* numbers, std::size_t count) {
  Value value;
  value.kind = Value::Kind::array;
  for (std::size_t i = 0; i < count; ++i) value.items.push_back(number_value(numbers[i]));
  return value;
}

/// Remembers what urdfdom complains about, instead of printing it.
class Complaints final : public console_bridge::OutputHandler {
 public:
  Complaints() { console_bridge::useOutputHandler(this); }
  ~Complaints() override { console_bridge::restorePreviousOutputHandler(); }
  Complaints(const Complaints&) = delete;
  Complaints& operator=(const Complaints&) = delete;
  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    if (level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR && first.empty()) first = text;
  }

  std::string first;
};

class ArmReader {
 public:
  ArmReader(const UrdfText& text, Problems& problems) : text_(text), problems_(problems) {}

  std::vector<Entry> read() {
    if (text_.content.find("<xacro:") != std::string_view::npos) {
      return refuse("", "is a xacro file: make a URDF file of it first, with `xacro FILE -o robot.urdf`");
    }
    Complaints complaints;
    try {
      model_ = urdf::parseURDF(std::string(text_.content));
    } catch (const std::exception& error) {
      return refuse("", "is no URDF file: " + std::string(error.what()));
    }
    if (!model_ || !model_->getRoot()) {
      return refuse("", "is no URDF file" + (complaints.first.empty() ? "" : ": " + complaints.first));
    }
    if (!find_tip() || !find_chain()) return {};
    return chain_entries();
  }

 private:
  std::vector<Entry> refuse(const std::string& what, const std::string& rule) {
    problems_.add(origin(), what.empty() ? std::string("robot.urdf") : what, rule);
    return {};
  }
  [[nodiscard]] Origin origin() const { return {text_.file, text_.rank, 1}; }

  bool find_tip() {
    std::vector<std::string> ends;
    for (const auto& [name, link] : model_->links_) {
      if (link->child_joints.empty()) ends.push_back(name);
    }
    tip_ = text_.tip_link.empty() && ends.size() == 1 ? ends.front() : text_.tip_link;
    if (!tip_.empty() && model_->getLink(tip_)) return true;
    if (tip_.empty()) {
      refuse("", "has several links at an end, " + listed(ends, "and") +
                     "; robot.tip_link says which one carries "
                     "the gripper");
    } else {
      refuse("robot.tip_link", "there is no link \"" + tip_ + "\"; links at an end are " + listed(ends, "and"));
    }
    return false;
  }

  bool find_chain() {
    for (urdf::LinkConstSharedPtr link = model_->getLink(tip_); link && link->parent_joint;
         link = model_->getLink(link->parent_joint->parent_link_name)) {
      chain_.push_back(link->parent_joint);
    }
    std::reverse(chain_.begin(), chain_.end());
    std::size_t moving = 0;
    for (const urdf::JointSharedPtr& joint : chain_) {
      if (joint->type == urdf::Joint::FIXED) continue;
      ++moving;
      if (!is_followed(*joint)) return false;
    }
    if (moving == 0) refuse("", "has no joint that turns between its root and \"" + tip_ + "\"");
    return moving > 0;
  }

  bool is_followed(const urdf::Joint& joint) {
    const std::string name = "joint \"" + joint.name + "\"";
    if (joint.mimic) {
      refuse(name, "mimics \"" + joint.mimic->joint_name + "\": only joints that turn by themselves are followed");
      return false;
    }
    if (joint.type != urdf::Joint::REVOLUTE && joint.type != urdf::Joint::CONTINUOUS) {
      const bool slides = joint.type == urdf::Joint::PRISMATIC;
      refuse(name, std::string("is ") + (slides ? "prismatic" : "neither revolute nor continuous") +
                       ": only joints that turn are followed");
      return false;
    }
    if (!joint.limits) {
      refuse(name, "has no <limit>: its speed and torque must be known");
      return false;
    }
    const urdf::JointLimits& limits = *joint.limits;
    for (const auto& [word, value] :
         {std::pair{"velocity", limits.velocity}, std::pair{"effort", limits.effort}}) {
      if (value > 0.0) continue;
      refuse(name, "has the limit " + std::string(word) + " = " + spelled(value) + ": must be > 0");
      return false;
    }
    if (joint.type == urdf::Joint::REVOLUTE && !(limits.lower < limits.upper)) {
      refuse(name, "has the limits lower = " + spelled(limits.lower) + ", upper = " + spelled(limits.upper) +
                       ": lower must be < upper");
      return false;
    }
    return true;
  }

  [[nodiscard]] bool is_in_chain(const urdf::Joint& joint) const {
    return std::any_of(chain_.begin(), chain_.end(), [&](const auto& other) { return other.get() == &joint; });
  }

  /// Adds a link and all that is fast to it; behind a moving joint of the chain the next body begins.
  void add_link(const urdf::Link& link, const Frame& frame, Body& body) const {
    if (link.inertial) {
      const Frame own = behind(frame, frame_of(link.inertial->origin));
      body.add_point(link.inertial->mass, own.place);
      const auto inertia = turned_inertia(own.attitude, *link.inertial);
      for (std::size_t d = 0; d < 6; ++d) body.second[d] += inertia[d];
    }
    for (const urdf::JointSharedPtr& joint : link.child_joints) {
      if (joint->type != urdf::Joint::FIXED && is_in_chain(*joint)) continue;
      const auto child = model_->getLink(joint->child_link_name);
      if (child) add_link(*child, behind(frame, frame_of(joint->parent_to_joint_origin_transform)), body);
    }
  }

  std::vector<Entry> chain_entries() {
    std::vector<Entry> entries;
    Frame way;
    std::size_t index = 0;
    for (const urdf::JointSharedPtr& joint : chain_) {
      way = behind(way, frame_of(joint->parent_to_joint_origin_transform));
      if (joint->type == urdf::Joint::FIXED) continue;
      Body body;
      add_link(*model_->getLink(joint->child_link_name), {}, body);
      if (!(body.mass > 0.0)) {
        return refuse("link \"" + joint->child_link_name + "\"",
                      "has no <inertial> with a mass > 0: the torques of the arm need its mass and inertia");
      }
      add_joint(*joint, way, body, "robot.joint[" + std::to_string(index++) + "].", entries);
      way = {};
    }
    const Vector rotation = rotation_to(way.attitude);
    entries.push_back({"robot.flange_place_m", array_of(way.place.data(), 3), origin()});
    entries.push_back({"robot.flange_rotation_rad", array_of(rotation.data(), 3), origin()});
    return entries;
  }

  void add_joint(const urdf::Joint& joint, const Frame& frame, const Body& body, const std::string& path,
                 std::vector<Entry>& entries) const {
    const auto add = [&](const std::string& leaf, Value value) {
      entries.push_back({path + leaf, std::move(value), origin()});
    };
    const Vector rotation = rotation_to(frame.attitude);
    const Vector axis = {joint.axis.x, joint.axis.y, joint.axis.z};
    add("place_m", array_of(frame.place.data(), 3));
    add("rotation_rad", array_of(rotation.data(), 3));
    add("axis", array_of(axis.data(), 3));
    if (joint.type == urdf::Joint::REVOLUTE) {
      add("lower_rad", number_value(joint.limits->lower));
      add("upper_rad", number_value(joint.limits->upper));
    }
    add("speed_rad_s", number_value(joint.limits->velocity));
    add("torque_N_m", number_value(joint.limits->effort));
    add("mass_kg", number_value(body.mass));
    Vector middle{};
    for (std::size_t d = 0; d < 3; ++d) middle[d] = body.first[d] / body.mass;
    add("center_of_mass_m", array_of(middle.data(), 3));
    Body shifted;
    shifted.second = body.second;
    shifted.add_point(-body.mass, middle);
    add("inertia_kg_m2", array_of(shifted.second.data(), 6));
  }

  const UrdfText& text_;
  Problems& problems_;
  urdf::ModelInterfaceSharedPtr model_;
  std::string tip_;
  std::vector<urdf::JointSharedPtr> chain_;
};

}  // namespace

std::vector<Entry> urdf_entries(const UrdfText& text, Problems& problems) {
  return ArmReader(text, problems).read();
}

}  // namespace unbruised::studies
