// tamis_stages: times each stage of the default method, each filter, and the decision of one pair alone.
// `--benchmark_filter=search` selects by name.
#include <benchmark/benchmark.h>

#include "benchmarks/stages/workload.hpp"
#include "curves/motions/chain_motion.hpp"
#include "paper/filters/filters.hpp"
#include "tamis/pair.hpp"

namespace tamis::bench {
namespace {

using State = benchmark::State;

constexpr std::size_t kMostPairs = 100'000;

std::string name(PairKind kind) { return std::string(name_of(kind)); }

void pairs_per_second(State& state, std::size_t pairs) {
  state.counters["pairs"] = static_cast<double>(pairs);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(pairs));
}

template <class Run>
void add(const Workload& work, const std::string& what, const Run& run) {
  benchmark::RegisterBenchmark((what + "/" + work.name()).c_str(), run)->Unit(benchmark::kMicrosecond);
}

void add_trees(Workload& work) {
  add(work, "bounds", [&work](State& state) {
    PackedMotion motion;
    for (auto _ : state) motion.assign(work.step(), work.mesh().points(), {kSeparation});
  });
  add(work, "order_and_build", [&work](State& state) {
    for (auto _ : state)
      for (BlockTree* tree : work.trees()) tree->build(work.motion(), {}, work.kernels().bound_leaf);
  });
  add(work, "refit", [&work](State& state) {
    for (auto _ : state)
      for (BlockTree* tree : work.trees()) tree->refit(work.motion(), work.kernels().bound_leaf);
  });
}

void add_search(const Workload& work, PairKind kind) {
  add(work, "search_" + name(kind), [&work, kind](State& state) {
    std::size_t pairs = 0;
    for (auto _ : state) {
      pairs = 0;
      work.search(kind, [&](PairBuffer& found) {
        pairs += static_cast<std::size_t>(found.count);
        found.count = 0;
      });
    }
    pairs_per_second(state, pairs);
  });
}

/// Adds a stage that takes a buffer: `run(buffer)`.
template <class Run>
void add_stage(const Workload& work, const std::string& what, const Buffers& buffers, const Run& run) {
  add(work, what, [&buffers, run](State& state) {
    std::size_t pairs = 0;
    for (const auto& buffer : buffers) pairs += static_cast<std::size_t>(buffer->count);
    for (auto _ : state)
      for (const auto& buffer : buffers) run(*buffer);
    pairs_per_second(state, pairs);
  });
}

void add_stages(const Workload& work, PairKind kind) {
  struct Scratch {
    PairBuffer out;
    DecisionScratch scratch;
    DecisionRoom<PairBuffer::kCapacity> room;
  };
  const auto scratch = std::make_shared<Scratch>();
  const PairKernels& k = work.kernels().of(kind);
  const MotionView motion = work.motion().view();
  const auto slab = k.slab;
  const auto filter = k.filter;
  const auto decide = k.decide;
  const StageInputs& inputs = work.inputs(kind);
  add_stage(work, "slab_" + name(kind), inputs.slab, [=](const PairBuffer& in) {
    scratch->out.count = 0;
    slab(motion, in, scratch->out);
  });
  add_stage(work, "dnf_ncf_" + name(kind), inputs.filter, [=](const PairBuffer& in) {
    scratch->out.count = 0;
    filter(motion, in, scratch->out);
  });
  add_stage(work, "decide_in_lanes_" + name(kind), inputs.solve, [=](const PairBuffer& in) {
    LaneDecisions decisions = scratch->room.lists();
    decide(motion, 1, in, scratch->scratch, decisions);
  });
}

void add_filters(const Workload& work, PairKind kind) {
  const auto motions =
      std::make_shared<std::vector<PairMotion<double>>>(work.motions(kind, work.inputs(kind).slab, kMostPairs));
  for (const lab::FilterStage& filter : lab::filter_stages()) {
    const std::string what = "filter_" + std::string(filter.name) + "_" + name(kind);
    add(work, what, [motions, &filter, kind](State& state) {
      constexpr std::size_t kAtOnce = 1024;
      std::vector<std::uint16_t> alive(kAtOnce);
      std::size_t left = 0;
      for (auto _ : state) {
        left = 0;
        for (std::size_t first = 0; first < motions->size(); first += kAtOnce) {
          alive.resize(std::min(kAtOnce, motions->size() - first));
          for (std::size_t i = 0; i < alive.size(); ++i) alive[i] = static_cast<std::uint16_t>(i);
          left += (kind == PairKind::vertex_face ? filter.vf : filter.ee)(motions->data() + first, alive);
        }
      }
      pairs_per_second(state, motions->size());
      state.counters["left"] =
          static_cast<double>(left) / static_cast<double>(std::max<std::size_t>(1, motions->size()));
    });
  }
}

/// Decides the pairs that reach the solver one by one. Most of them touch.
void add_one_pair(const Workload& work, PairKind kind) {
  const auto pairs = std::make_shared<std::vector<PairPoints>>(work.points(work.inputs(kind).solve, kMostPairs));
  const std::string what = "one_pair_" + name(kind);
  add(work, what, [pairs, kind](State& state) {
    std::size_t touching = 0;
    for (auto _ : state) {
      touching = 0;
      for (const PairPoints& p : *pairs)
        touching +=
            (kind == PairKind::vertex_face ? vertex_face(p.start, p.end) : edge_edge(p.start, p.end)).touches ? 1 : 0;
    }
    pairs_per_second(state, pairs->size());
    state.counters["touching"] = static_cast<double>(touching);
  });
}

/// The pose of a body that turns about one axis: in doubles, and for a turn too large for doubles in double-double.
void add_poses() {
  for (const auto& [name, angle] : {std::pair{"pose", 1.0}, std::pair{"pose_far", 5.0}}) {
    const RigidChain chain(interpolated_chain({{1, 2, 3}, {0, 0, angle}}, {{2, 3, 4}, {0, 0, angle / 2}}));
    benchmark::RegisterBenchmark(name, [chain](State& state) {
      double time = 0;
      for (auto _ : state) benchmark::DoNotOptimize(transform_at(chain, time += 0x1p-40));
    });
  }
}

}  // namespace
}  // namespace tamis::bench

int main(int argc, char** argv) {
  using namespace tamis;
  benchmark::Initialize(&argc, argv);
  const auto workloads = bench::make_workloads();
  for (const auto& work : workloads) {
    bench::add_trees(*work);
    for (const PairKind kind : {PairKind::vertex_face, PairKind::edge_edge}) {
      bench::add_search(*work, kind);
      bench::add_stages(*work, kind);
      bench::add_filters(*work, kind);
      bench::add_one_pair(*work, kind);
    }
  }
  bench::add_poses();
  benchmark::RunSpecifiedBenchmarks();
}
