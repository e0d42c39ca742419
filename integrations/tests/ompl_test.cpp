// Plans by OMPL, whose every edge Tamis has proven.
#include <gtest/gtest.h>
#include <ompl/base/DiscreteMotionValidator.h>
#include <ompl/base/goals/GoalState.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/prm/PRM.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <array>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "integrations/ompl/motion_validator.hpp"
#include "tamis/tamis.hpp"

namespace tamis::planning {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

Shape box(const Point& low, const Point& high) {
  std::vector<Point> corners;
  for (int i = 0; i < 8; ++i)
    corners.push_back({i & 4 ? high[0] : low[0], i & 2 ? high[1] : low[1], i & 1 ? high[2] : low[2]});
  std::vector<Face> faces{{0, 1, 3}, {0, 3, 2}, {4, 6, 7}, {4, 7, 5}, {0, 4, 5}, {0, 5, 1},
                          {2, 3, 7}, {2, 7, 6}, {0, 2, 6}, {0, 6, 4}, {1, 5, 7}, {1, 7, 3}};
  return {Mesh(8, std::move(faces)), std::move(corners)};
}

/// An arm of two rods that must fold to pass a post.
class Ompl : public testing::Test {
 protected:
  Ompl() {
    ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
    const Shape rod = box({0, -0.05, -0.05}, {1, 0.05, 0.05});
    links_ = {{world_.add(rod, Static{}), 0, {}}, {world_.add(rod, Static{}), 1, {}}};
    world_.set_may_touch(links_[0].body, links_[1].body, false);
    world_.add(box({1.5, -0.02, -0.5}, {1.6, 0.02, 0.5}), Static{});
    linkage_.emplace(std::vector<Joint>{{-1, {}, JointKind::turning, {0, 0, 1}, 0},
                                        {0, {{1, 0, 0.12}, {}}, JointKind::turning, {0, 0, 1}, 1}},
                     links_);
  }

  og::SimpleSetup setup(const std::array<double, 2>& start, const std::array<double, 2>& goal) {
    const auto space = std::make_shared<ob::RealVectorStateSpace>(2);
    space->setBounds(-3, 3);
    og::SimpleSetup made(space);
    set_world(made.getSpaceInformation(), {world_, *linkage_});
    ob::ScopedState<> from(space), to(space);
    for (unsigned i = 0; i < 2; ++i) from[i] = start[i], to[i] = goal[i];
    made.setStartAndGoalStates(from, to);
    return made;
  }

  World world_;
  std::vector<CarriedBody> links_;
  std::optional<Linkage> linkage_;
};

template <class Planner>
class OmplPlanner : public Ompl {};
using Planners = testing::Types<og::RRTConnect, og::PRM, og::BITstar>;
TYPED_TEST_SUITE(OmplPlanner, Planners);

TYPED_TEST(OmplPlanner, EveryEdgeOfAPlanIsProven) {
  og::SimpleSetup setup = this->setup({-0.6, 0.1}, {0.6, -0.1});
  setup.setPlanner(std::make_shared<TypeParam>(setup.getSpaceInformation()));
  ASSERT_TRUE(setup.solve(2.0));  // BIT* takes all of it
  ASSERT_TRUE(setup.haveExactSolutionPath());
  setup.simplifySolution(0.2);
  std::vector<double> waypoints;
  for (const ob::State* state : setup.getSolutionPath().getStates())
    for (unsigned i = 0; i < 2; ++i) waypoints.push_back(state->as<ob::RealVectorStateSpace::StateType>()->values[i]);
  ASSERT_GT(waypoints.size(), 4u);  // the straight way is barred
  EXPECT_FALSE(this->world_.first_bad_edge(*this->linkage_, waypoints).edge);
}

TEST_F(Ompl, SamplingPassesWhatTheProofFinds) {
  // Would catch a validator that OMPL does not call.
  og::SimpleSetup made = setup({-0.6, 0}, {0.6, 0});
  made.getSpaceInformation()->setStateValidityCheckingResolution(0.05);
  made.setup();
  const ob::State *from = made.getProblemDefinition()->getStartState(0),
                  *to = made.getGoal()->as<ob::GoalState>()->getState();
  EXPECT_FALSE(made.getSpaceInformation()->checkMotion(from, to));
  EXPECT_TRUE(ob::DiscreteMotionValidator(made.getSpaceInformation()).checkMotion(from, to));
}

TEST_F(Ompl, TheLastValidStateIsBeforeTheContact) {
  og::SimpleSetup made = setup({-0.6, 0}, {0.6, 0});
  made.setup();
  const auto& information = made.getSpaceInformation();
  std::pair<ob::State*, double> last{information->allocState(), 0};
  const ob::State *from = made.getProblemDefinition()->getStartState(0),
                  *to = made.getGoal()->as<ob::GoalState>()->getState();
  EXPECT_FALSE(information->checkMotion(from, to, last));
  EXPECT_NEAR(last.second, 0.46, 0.03);
  EXPECT_TRUE(information->isValid(last.first));
  EXPECT_TRUE(information->checkMotion(from, last.first));
  information->freeState(last.first);
}

TEST_F(Ompl, ASpaceOfOtherNumbersIsRefused) {
  const auto space = std::make_shared<ob::RealVectorStateSpace>(3);
  const auto information = std::make_shared<ob::SpaceInformation>(space);
  EXPECT_THROW(MotionValidator(information, {world_, *linkage_}), std::invalid_argument);
  EXPECT_THROW(StateChecker(information, {world_, *linkage_}), std::invalid_argument);
}

}  // namespace
}  // namespace tamis::planning
