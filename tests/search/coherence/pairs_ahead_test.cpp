// A detector that has listed pairs ahead answers every question as one that was never asked before, bit for bit.
#include <gtest/gtest.h>

#include "scenes/random.hpp"
#include "scenes/scene_list.hpp"
#include "support/as_new.hpp"
#include "support/copied.hpp"
#include "support/test_data.hpp"
#include "support/test_names.hpp"
#include "tamis/components.hpp"
#include "tamis/error.hpp"

namespace tamis::test {
namespace {

using scenes::Recipe, scenes::Scene;

/// Goes on along the scene's step, a part at a time, every vertex off its way by as much as `wobble`; now and then
/// something else: back, a jump, one vertex alone, a step that begins elsewhere, a longer or a shorter one.
struct Journey {
  const Scene& scene;
  scenes::Random random;
  double part, wobble;
  std::vector<Point> start = {}, end = {};
  double at = 0;

  std::vector<Point> place(double t) {
    std::vector<Point> points = between(scene.start, scene.end, t);
    for (Point& point : points)
      for (double& x : point) x += wobble * random.between(-1, 1);
    return points;
  }

  Asked question() { return static_cast<Asked>(random.below(random.below(4) == 0 ? kAsked : kAskedOfContacts)); }

  void go_on() {
    const Index choice = random.below(30);
    if (choice == 0) at = random.unit();
    if (choice == 1) part = -part;
    if (choice >= 24 && !end.empty()) {  // the same start, in the same direction
      end = between(start, end, choice == 24 ? random.between(1, 2) : random.unit());
      return;
    }
    start = choice == 2 || end.empty() ? place(at) : end;
    const double length = choice == 3 ? random.between(0, 3) : 1;
    at += length * part;
    end = place(at);
    if (choice == 4) end[static_cast<std::size_t>(random.below(scene.vertex_count()))] = scene.end[0];
  }
};

class PairsAhead : public testing::TestWithParam<Recipe> {};

/// How a journey goes, and who looks at it.
struct Setting {
  double wobble, separation;
  int threads;
  Isa isa = Isa::best;
  bool has_groups = false, has_radii = false;
};
constexpr Setting kSettings[] = {
    {0, 0, 1},
    {1e-7, 0, 2, Isa::baseline},
    {1e-4, 0, 1},
    {1e-7, 0x1p-9, 1},
    {1e-4, 0x1p-9, 2, Isa::baseline},
    {.wobble = 1e-7, .separation = 0, .threads = 1, .has_groups = true},
    {.wobble = 1e-7, .separation = 0x1p-9, .threads = 1, .has_radii = true},
};

// Bugs: room to deviate that is not searched, or not checked for one vertex; pairs left out at times when they are
// near; boxes of the way taken for those of the question; lists of another separation, or without radii.
TEST_P(PairsAhead, ChangeNoBitOfAnyAnswer) {
  int listed = 0;
  for (long seed = 71; seed < 71 + repetitions("TAMIS_JOURNEYS", 1); ++seed) {
    const auto number = static_cast<std::uint64_t>(seed);
    const Scene scene = GetParam().make(GetParam().scales ? 1000 : 150, number);
    for (const Setting& setting : kSettings) {
      Options options;
      options.threads = setting.threads;
      options.isa = setting.isa;
      options.min_separation = setting.separation;
      if (setting.has_groups) options.filter = PairFilter::no_self_contact(components_of(scene.mesh()).of_vertex);
      if (setting.has_radii) give_radii(options, scene.vertex_count());
      Detector kept(scene.mesh(), options);
      Journey journey{scene, scenes::Random(number), 1.0 / 32, setting.wobble};
      for (int i = 0; i < 32 && !HasFailure(); ++i) {
        journey.go_on();
        expect_as_new(kept, {journey.start, journey.end}, journey.question(),
                      scene.name + " " + std::to_string(seed) + ", question " + std::to_string(i),
                      {.min_separation = setting.separation * journey.random.below(3) / 2,
                       .at_start = i % 3 == 2 ? AtStart::ignore : AtStart::report});
        listed += was_listed(kept);
      }
    }
  }
  if (GetParam().scales) {
    EXPECT_GT(listed, 8) << "lists that nobody uses";
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, PairsAhead, testing::ValuesIn(scenes::recipes().begin(), scenes::recipes().end()),
                         scene_test_name);

/// Parts of the scene's step, one after the other.
class Substeps : public testing::Test {
 protected:
  Step part(int i) {
    start_ = between(scene.start, scene.end, i / 16.0);
    end_ = between(scene.start, scene.end, (i + 1) / 16.0);
    return {start_, end_};
  }
  void ask(Detector& detector, int first, int last) {
    for (int i = first; i < last; ++i) (void)detector.contacts(part(i));
  }

  const Scene scene = scenes::scene_by_name("folded-cloth", 4000, 3);

 private:
  std::vector<Point> start_, end_;
};

TEST_F(Substeps, AreListedByTheSecondAndSoAreLongerOnesWithinTheWay) {
  Detector kept(scene.mesh());
  ask(kept, 0, 2);
  EXPECT_GT(kept.statistics().seconds.build, 0);
  EXPECT_FALSE(was_listed(kept)) << "what listing costs is not said";
  ask(kept, 2, 3);
  EXPECT_TRUE(was_listed(kept));
  ask(kept, 3, 5);
  EXPECT_TRUE(was_listed(kept));
  EXPECT_EQ(kept.statistics().seconds.build, 0) << "boxes were made that nobody needs";
  const std::vector<Point> beyond = between(scene.start, scene.end, 1.5);
  expect_as_new(kept, {part(6).start, beyond}, Asked::contacts, "past the listed steps");
  EXPECT_FALSE(was_listed(kept));
}

// Bug: lists of a smaller separation, or of none, taken for a larger one.
TEST_F(Substeps, WithALargerSeparationAreNotThoseThatWereListed) {
  Detector kept(scene.mesh());
  ask(kept, 0, 4);
  ASSERT_TRUE(was_listed(kept));
  Options options;
  options.min_separation = 0.01;
  Detector fresh(scene.mesh(), options);
  EXPECT_EQ(bits_of(kept.contacts(part(4), {.min_separation = 0.01})), bits_of(fresh.contacts(part(4))));
  EXPECT_GT(kept.statistics().seconds.build, 0);
  EXPECT_EQ(bits_of(kept.contacts(part(5), {.min_separation = 0.0})),
            bits_of(contacts_of(Detector(scene.mesh()), part(5))));
}

// Bug: with a thickness each step is searched as if it were the first.
TEST_F(Substeps, OfWhatHasRadiiAreListed) {
  Options options;
  give_radii(options, scene.vertex_count());
  options.radii = {0, 0x1p-10, 0x1p-9};  // below an edge: what is listed has a limit
  Detector kept(scene.mesh(), options);
  ask(kept, 0, 2);
  expect_as_new(kept, part(2), Asked::contacts, "a listed step");
  EXPECT_TRUE(was_listed(kept));
}

// Bug: half a list, or boxes of the way ahead, left by a question that ended in the middle.
TEST_F(Substeps, AfterAnInterruptionAreAnsweredInFull) {
  int asked = 0, cancel_at = -1;
  Options options;
  options.threads = 1;
  options.is_cancelled = [&] { return asked++ == cancel_at; };
  Detector kept(scene.mesh(), options);
  for (const int at : {0, 1, 3}) {
    ask(kept, 0, 1);
    asked = 0;
    cancel_at = at;
    EXPECT_THROW((void)kept.contacts(part(1)), Cancelled) << at;
    cancel_at = -1;
    for (int i = 1; i < 5; ++i)
      EXPECT_EQ(bits_of(kept.contacts(part(i))), bits_of(contacts_of(Detector(scene.mesh()), part(i)))) << at;
  }
}

// Bug: a tree that was being built anew is asked for by lists that need none.
TEST_F(Substeps, AreAnsweredByTheirListsThoughATreeIsHalfBuilt) {
  int left = -1;
  Options options;
  options.threads = 1;
  options.is_cancelled = [&] { return left-- == 0; };
  std::vector<Point> jumbled = scene.start;
  for (std::size_t v = 0; v < jumbled.size(); ++v) jumbled[v] = scene.start[v * 7919 % jumbled.size()];
  int cancelled = 0;
  for (int at = 0; at < 12; ++at) {
    Detector kept(scene.mesh(), options);
    ask(kept, 0, 3);
    left = at;
    try {
      (void)kept.is_free({jumbled, jumbled});
    } catch (const Cancelled&) {
      ++cancelled;
    }
    left = -1;
    EXPECT_EQ(bits_of(kept.contacts(part(3))), bits_of(contacts_of(Detector(scene.mesh()), part(3)))) << at;
  }
  EXPECT_GT(cancelled, 5);
}

// A question that ends at its first contact promises nothing to others like it, but takes nothing from the others.
TEST_F(Substeps, AreListedWhereAllQuestionsAreAskedOfEach) {
  Detector kept(scene.mesh());
  for (int i = 10; i < 14; ++i) {
    (void)kept.contacts(part(i));
    if (i > 11) {
      EXPECT_TRUE(was_listed(kept)) << i;
    }
    (void)kept.earliest(part(i));
    EXPECT_FALSE(kept.is_free(part(i))) << i;
  }
}

// Bug: a filter that is asked once, when pairs are listed, and not in each question.
TEST_F(Substeps, AskTheFilterEachTime) {
  bool accepts = true;
  Options options;
  options.threads = 1;
  options.filter.accepts = [&](PairKind, const std::array<Index, 4>&) { return accepts; };
  Detector kept(scene.mesh(), options);
  ask(kept, 0, 5);
  ASSERT_TRUE(was_listed(kept));
  accepts = false;
  EXPECT_TRUE(kept.contacts(part(5)).empty());
  accepts = true;
  EXPECT_EQ(bits_of(kept.contacts(part(6))), bits_of(contacts_of(Detector(scene.mesh()), part(6))));
}

/// One start, and steps of several lengths in one direction.
class LineSearch : public testing::Test {
 protected:
  Step to(double length) {
    end_ = between(scene.start, scene.end, length);
    return {scene.start, end_};
  }

  const Scene scene = scenes::scene_by_name("folded-cloth", 4000, 3);

 private:
  std::vector<Point> end_;
};

// Bugs: lists made when nobody comes back; a list of a shorter step, or until the first contact, taken for more.
TEST_F(LineSearch, IsListedByItsSecondQuestionAndLongerStepsAreNot) {
  for (const Asked asked : {Asked::contacts, Asked::earliest}) {
    Detector kept(scene.mesh());
    expect_as_new(kept, to(1), asked, "first");
    expect_as_new(kept, to(0.75), asked, "second");
    EXPECT_FALSE(was_listed(kept)) << "what listing costs is not said";
    for (const double length : {0.5, 0.75, 0.25, 0x1p-20}) {
      expect_as_new(kept, to(length), asked, "within what is listed");
      EXPECT_TRUE(was_listed(kept)) << length;
    }
    expect_as_new(kept, to(1.5), asked, "beyond what is listed");
    if (asked == Asked::contacts) {
      EXPECT_FALSE(was_listed(kept));
    }
  }
}

// Bug: contacts behind the first one, which are not listed, left out or taken for free.
TEST_F(LineSearch, AsksAllQuestionsInAnyOrder) {
  scenes::Random random(5);
  for (const double reach : {1.0, 0.03, 4.0}) {
    Detector kept(scene.mesh());
    for (int i = 0; i < 60 && !HasFailure(); ++i) {
      const double length = reach * (random.below(4) == 0 ? 1.0 : random.unit());
      const auto asked = static_cast<Asked>(random.below(kAskedOfContacts));
      expect_as_new(kept, to(length), asked, "question " + std::to_string(i) + " to " + std::to_string(length));
    }
  }
}

}  // namespace
}  // namespace tamis::test
