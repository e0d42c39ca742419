// Embree, rtcCollide: a hierarchy of swept boxes (user geometry), Morton build. Apache-2.0.
#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include "benchmarks/contenders/swept_boxes.hpp"

namespace tamis::bench {
namespace {

void give_bounds(const RTCBoundsFunctionArguments* arguments) {
  const auto& box = static_cast<const SweptBox*>(arguments->geometryUserPtr)[arguments->primID];
  RTCBounds& bounds = *arguments->bounds_o;
  bounds.lower_x = box.low[0];
  bounds.lower_y = box.low[1];
  bounds.lower_z = box.low[2];
  bounds.upper_x = box.high[0];
  bounds.upper_y = box.high[1];
  bounds.upper_z = box.high[2];
}

/// A scene with one geometry. Each box is a primitive.
class BoxScene {
 public:
  BoxScene(RTCDevice device, std::vector<SweptBox>& boxes) : scene_(rtcNewScene(device)) {
    rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_LOW);
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_LOW);
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(boxes.size()));
    rtcSetGeometryUserData(geometry, boxes.data());
    rtcSetGeometryBoundsFunction(geometry, give_bounds, nullptr);
    rtcSetGeometryIntersectFunction(geometry, [](const RTCIntersectFunctionNArguments*) {});
    rtcSetGeometryOccludedFunction(geometry, [](const RTCOccludedFunctionNArguments*) {});
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
  }
  ~BoxScene() { rtcReleaseScene(scene_); }
  BoxScene(const BoxScene&) = delete;
  BoxScene& operator=(const BoxScene&) = delete;

  RTCScene get() const { return scene_; }

 private:
  RTCScene scene_;
};

void count_vf(void* user, RTCCollision* collisions, unsigned count) {
  auto& counter = *static_cast<PairCounter*>(user);
  PairCounter::Batch batch;
  for (unsigned i = 0; i < count; ++i) counter.add_vf(collisions[i].primID0, collisions[i].primID1, batch);
  counter.commit(PairKind::vertex_face, batch);
}

/// A scene against itself gives each pair in both orders: counts one of them.
void count_ee(void* user, RTCCollision* collisions, unsigned count) {
  auto& counter = *static_cast<PairCounter*>(user);
  PairCounter::Batch batch;
  for (unsigned i = 0; i < count; ++i)
    if (collisions[i].primID0 < collisions[i].primID1)
      counter.add_ee(collisions[i].primID0, collisions[i].primID1, batch);
  counter.commit(PairKind::edge_edge, batch);
}

class Embree final : public Contender {
 public:
  ~Embree() override {
    if (device_ != nullptr) rtcReleaseDevice(device_);
  }
  std::string name() const override { return "Embree rtcCollide"; }
  Field field() const override { return Field::broad_phase; }
  Cost run(const Task& task) override {
    const Stopwatch watch;
    if (device_ == nullptr) device_ = rtcNewDevice(nullptr);
    counter_ = std::make_unique<PairCounter>(task);
    boxes_.compute(task);
    const BoxScene points(device_, boxes_.points), edges(device_, boxes_.edges), faces(device_, boxes_.faces);
    rtcCollide(points.get(), faces.get(), count_vf, counter_.get());
    rtcCollide(edges.get(), edges.get(), count_ee, counter_.get());
    return watch.cost();
  }
  Answer answer(const Task& task) override { return counter_->answer(task); }

 private:
  RTCDevice device_ = nullptr;
  SweptBoxes boxes_;
  std::unique_ptr<PairCounter> counter_;
};

}  // namespace

void add_embree(Contenders& list) { list.push_back(std::make_unique<Embree>()); }

}  // namespace tamis::bench
