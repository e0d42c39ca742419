// Tamis: a world of the two bodies.
#include "benchmarks/contenders/bodies/bodies.hpp"
#include "tamis/world.hpp"

namespace tamis::bench {
namespace {

class Tamis final : public BodyContender {
 public:
  std::string name() const override { return "Tamis"; }
  bool knows(const BodyScene&) const override { return true; }

  void take(const MovingPair& pair, bool) override {
    pair_ = &pair;
    world_ = World({.threads = 1});
    for (const MovingBody* const body : {&pair.first, &pair.second})
      world_.add(Shape(Mesh(static_cast<Index>(body->shape.points.size()), body->shape.faces), body->shape.points),
                 Static{});
  }

  double first_contact() override {
    world_.move(0, motion_of(pair_->first));
    world_.move(1, motion_of(pair_->second));
    const EarliestBodyContact earliest = world_.earliest();
    return earliest.contact ? earliest.toi_lower : kNever;
  }

 private:
  static Rigid motion_of(const MovingBody& body) { return {turned_chain({body.from, {}}, body.turn, body.to)}; }

  const MovingPair* pair_ = nullptr;
  World world_;
};

}  // namespace

void add_tamis(BodyContenders& list) { list.push_back(std::make_unique<Tamis>()); }

}  // namespace tamis::bench
