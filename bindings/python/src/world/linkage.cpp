// Joints and the bodies that they carry, from arrays.
#include "tamis/linkage.hpp"

#include "python/src/answers.hpp"
#include "python/src/bindings.hpp"
#include "python/src/paths/pose_rows.hpp"
#include "python/src/world/configurations.hpp"

namespace tamis::python {
namespace {

/// REQUIRES: as many rows of each, which the Python side sees to.
void make_linkage(Linkage* linkage, const Indices& parents, const PoseRows& places, const Indices& kinds,
                  const PointRows& axes, const Indices& coordinates, const Numbers& factors, const Numbers& offsets,
                  const Indices& bodies, const Indices& carriers, const PoseRows& body_places) {
  std::vector<Joint> joints;
  for (std::size_t i = 0; i < parents.shape(0); ++i)
    joints.push_back({parents(i), row<Pose>(places, i), static_cast<JointKind>(kinds(i)), row<Point>(axes, i),
                      coordinates(i), factors(i), offsets(i)});
  std::vector<CarriedBody> carried;
  for (std::size_t i = 0; i < bodies.shape(0); ++i)
    carried.push_back({bodies(i), carriers(i), row<Pose>(body_places, i)});
  new (linkage) Linkage(std::move(joints), std::move(carried));
}

/// For each motion and body a chain. Shorter chains end in links of zeros.
nb::object motions(const Linkage& linkage, const ConfigurationRows& starts, const ConfigurationRows& ends) {
  const std::vector<BodyMotion> all = linkage.motions(numbers_of(starts), numbers_of(ends));
  const std::size_t bodies = linkage.bodies().size();
  std::size_t longest = 1;
  for (const BodyMotion& motion : all) longest = std::max(longest, std::get<Rigid>(motion).chain.size());
  std::vector<RigidLink> links(all.size() * longest);
  for (std::size_t i = 0; i < all.size(); ++i)
    std::ranges::copy(std::get<Rigid>(all[i]).chain, links.begin() + static_cast<std::ptrdiff_t>(i * longest));
  return own_in_shape<double>(std::move(links), {starts.shape(0), bodies, longest, 4, 3});
}

}  // namespace

void bind_linkage(nb::module_& module) {
  nb::class_<Linkage>(module, "Linkage")
      .def("__init__", &make_linkage)
      .def("dimension", &Linkage::dimension)
      .def("motions", &motions);
}

}  // namespace tamis::python
