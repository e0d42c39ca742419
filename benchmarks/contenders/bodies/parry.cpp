// parry 0.31 (Rust): cast_shapes_nonlinear in doubles, through the library that cargo makes of the folder parry/.
// Apache-2.0.
#include "benchmarks/contenders/bodies/bodies.hpp"

extern "C" {
struct ParryShape;
ParryShape* parry_shape(const double* points, std::size_t point_count, const int* faces, std::size_t face_count,
                        bool is_convex);
void parry_free(ParryShape*);
/// Each motion: from, way, turn. -1: no answer; 2: never.
double parry_first_contact(const ParryShape* first, const double* first_motion, const ParryShape* second,
                           const double* second_motion);
}

namespace tamis::bench {
namespace {

class Parry final : public BodyContender {
 public:
  std::string name() const override { return "parry cast_shapes_nonlinear"; }
  bool knows(const BodyScene&) const override { return true; }

  void take(const MovingPair& pair, bool is_convex) override {
    pair_ = &pair;
    first_ = shape_of(pair.first.shape, is_convex);
    second_ = shape_of(pair.second.shape, is_convex);
  }

  double first_contact() override {
    if (!first_ || !second_) return kNoAnswer;
    const auto first = motion_of(pair_->first), second = motion_of(pair_->second);
    return parry_first_contact(first_.get(), first.data(), second_.get(), second.data());
  }

 private:
  struct Free {
    void operator()(ParryShape* shape) const { parry_free(shape); }
  };
  using Owned = std::unique_ptr<ParryShape, Free>;

  static Owned shape_of(const scenes::Shape& shape, bool is_convex) {
    return Owned(parry_shape(shape.points.data()->data(), shape.points.size(), shape.faces.data()->data(),
                             shape.faces.size(), is_convex));
  }

  static std::array<double, 9> motion_of(const MovingBody& body) {
    std::array<double, 9> motion;
    for (std::size_t k = 0; k < 3; ++k) {
      motion[k] = body.from[k];
      motion[3 + k] = body.to[k] - body.from[k];
      motion[6 + k] = body.turn[k];
    }
    return motion;
  }

  const MovingPair* pair_ = nullptr;
  Owned first_, second_;
};

}  // namespace

void add_parry(BodyContenders& list) { list.push_back(std::make_unique<Parry>()); }

}  // namespace tamis::bench
