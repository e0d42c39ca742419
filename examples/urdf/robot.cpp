// A robot from its URDF file, by urdfdom (Debian's liburdfdom-dev), and edges between its configurations.
#include <urdf_parser/urdf_parser.h>

#include <cstdio>
#include <map>
#include <stdexcept>
#include <string>
#include <tamis/tamis.hpp>

tamis::Pose pose_of(const urdf::Pose& pose) {
  const auto& [x, y, z, w] = pose.rotation;
  return tamis::pose_of_quaternion({w, x, y, z}, {pose.position.x, pose.position.y, pose.position.z});
}

// Boxes alone. Here you would read meshes, too, by a reader of your own: points, and three corners for each triangle.
tamis::Shape shape_of(const urdf::Link& link) {
  const auto* box = dynamic_cast<const urdf::Box*>(link.collision->geometry.get());
  if (!box || link.collision_array.size() > 1)
    throw std::runtime_error("link " + link.name + " is more than one box: this example reads one box a link");
  std::vector<tamis::Point> corners;
  for (int i = 0; i < 8; ++i)
    corners.push_back(
        {box->dim.x * ((i & 4) / 4 - 0.5), box->dim.y * ((i & 2) / 2 - 0.5), box->dim.z * ((i & 1) - 0.5)});
  return {tamis::Mesh(8, {{0, 1, 3},
                          {0, 3, 2},
                          {4, 6, 7},
                          {4, 7, 5},
                          {0, 4, 5},
                          {0, 5, 1},
                          {2, 3, 7},
                          {2, 7, 6},
                          {0, 2, 6},
                          {0, 6, 4},
                          {1, 5, 7},
                          {1, 7, 3}}),
          corners};
}

class Robot {
 public:
  Robot(tamis::World& world, const urdf::ModelInterface& model) : world_(world) {
    for (const auto& joint : model.getRoot()->child_joints) add(*joint, -1, model);
    for (const auto& [name, link] : model.links_)  // two links that a joint connects never count
      if (link->getParent() && bodies_.count(name) && bodies_.count(link->getParent()->name))
        world_.set_may_touch(bodies_[name], bodies_[link->getParent()->name], false);
  }
  tamis::Linkage linkage() const { return {joints_, carried_}; }

 private:
  // Joints stand after those that carry them, and so do their numbers in a configuration.
  void add(const urdf::Joint& joint, tamis::Index parent, const urdf::ModelInterface& model) {
    const bool turns = joint.type == urdf::Joint::REVOLUTE || joint.type == urdf::Joint::CONTINUOUS;
    const bool moves = turns || joint.type == urdf::Joint::PRISMATIC;
    if (!moves && joint.type != urdf::Joint::FIXED)
      throw std::runtime_error("joint " + joint.name + " floats: this example reads joints with one number");
    if (joint.mimic) throw std::runtime_error("joint " + joint.name + " mimics another: give both one coordinate");
    joints_.push_back({parent,
                       pose_of(joint.parent_to_joint_origin_transform),
                       !moves  ? tamis::JointKind::fixed
                       : turns ? tamis::JointKind::turning
                               : tamis::JointKind::sliding,
                       {joint.axis.x, joint.axis.y, joint.axis.z},
                       moves ? coordinates_++ : -1});
    const auto number = static_cast<tamis::Index>(joints_.size() - 1);
    const auto link = model.getLink(joint.child_link_name);
    if (link->collision) {
      bodies_[link->name] = world_.add(shape_of(*link), tamis::Static{});
      carried_.push_back({bodies_[link->name], number, pose_of(link->collision->origin)});
    }
    for (const auto& child : link->child_joints) add(*child, number, model);
  }

  tamis::World& world_;
  std::vector<tamis::Joint> joints_;
  std::vector<tamis::CarriedBody> carried_;
  std::map<std::string, tamis::BodyId> bodies_;
  tamis::Index coordinates_ = 0;
};

int main(int count, char** arguments) try {
  const auto model = urdf::parseURDFFile(count > 1 ? arguments[1] : "arm.urdf");
  if (!model) throw std::runtime_error("no URDF file can be read there");
  tamis::World world;
  const tamis::Linkage arm = Robot(world, *model).linkage();
  const tamis::Shape post(tamis::Mesh(3, {{0, 1, 2}}), {{1.5, 0.6, -1}, {1.5, 0.6, 1}, {1.6, 0.6, 0}});
  world.add(post, tamis::Static{});

  const std::vector<double> starts{0, 0, 0, 0}, ends{0, 1, -1, 0};  // two edges: the elbow alone, the shoulder alone
  for (const tamis::EdgeAnswer& edge : world.last_valid(arm, starts, ends))
    if (edge.is_free())
      std::printf("free\n");
    else
      std::printf("free until %.4f: then bodies %d and %d meet\n", edge.fraction, edge.bodies[0], edge.bodies[1]);
} catch (const std::exception& error) {
  std::printf("%s\n", error.what());
  return 1;
}
