// Measures the cost of the particle filter, whole and by its stages, beside a naive one and those of other
// libraries, in one process and by CPU time. usage: benchmark [--json FILE] [options of Google Benchmark]

#include <algorithm>
#include <cstdio>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "models/motion/steering_motion.hpp"
#include "simd/block_resampling.hpp"
#include "simd/particle_cloud.hpp"
#include "tools/benchmark/full_step.hpp"
#include "tools/benchmark/naive_filter.hpp"
#include "tools/benchmark/workload.hpp"

namespace multipath_localization {
namespace {

/// The product's filter as a node calls it: increment, fix, estimate.
class OurFilter {
 public:
  OurFilter(std::size_t size, InstructionSet set) : filter_(workload::parameters(size), 1, set) {
    PosePrior prior;
    prior.covariance = Eigen::Vector3d(0.09, 0.09, 0.0025).asDiagonal();
    filter_.start(prior);
  }
  void step(const OdometryIncrement& u, const GnssFix& fix) {
    filter_.predict(u);
    filter_.update(fix);
    x_ = filter_.estimate().pose.x;
  }
  [[nodiscard]] double x() const { return x_; }

 private:
  FixParticleFilter filter_;
  double x_ = 0.0;
};

struct Ours : OurFilter {
  explicit Ours(std::size_t size) : OurFilter(size, best_instruction_set()) {}
};

struct OursPlain : OurFilter {
  explicit OursPlain(std::size_t size) : OurFilter(size, InstructionSet::kPlain) {}
};

/// What the stages work on: the particles of a filter at its work.
struct Stages {
  InstructionSet set = best_instruction_set();
  ParticleCloud cloud{set};
  SteeringMotion motion{workload::kIncrement, SteeringNoiseParameters()};
  GnssLikelihood likelihood{
      workload::parameters(1).likelihood, workload::fix(0), 0.5, {{0.0, 0.0}, 0.5}, 0.0};
  RandomWords words;
  Normals normals;
  std::vector<std::uint32_t> ancestors;
  BlockWeights weights;
  BlockValues logs{};
  BlockValues factors{};

  explicit Stages(std::size_t size) {
    cloud.reset(size);
    random_words(set, 1, 0, 0, words);
    standard_normals(set, words, normals);
    for (std::size_t i = 0; i < size; ++i) {
      const auto n = static_cast<double>(normals.first()[i % kBlockSize]);
      cloud.set_pose(i, {0.3 * n, 0.3 * static_cast<double>(normals.second()[i % kBlockSize]), 0.05 * n});
    }
    weights.set_equal(size);
    factors.fill(1.0);
    systematic_resampling(set, cloud.weights(), size, 0.5, ancestors);
  }

  void each_block(const std::function<void(std::size_t)>& work) const {
    for (std::size_t block = 0; block < blocks_of(cloud.size()); ++block) work(block);
  }
};

using Stage = std::function<void(Stages&)>;

const std::vector<std::pair<std::string, Stage>>& stages() {
  static const std::vector<std::pair<std::string, Stage>> all = {
      {"random words",
       [](Stages& s) {
         s.each_block([&](std::size_t b) {
           random_words(s.set, 1, 2, static_cast<std::uint32_t>(block_begin(b)), s.words);
         });
       }},
      {"normals",
       [](Stages& s) { s.each_block([&](std::size_t) { standard_normals(s.set, s.words, s.normals); }); }},
      {"motion + moments",
       [](Stages& s) {
         s.cloud.move({},
                      [&](const PoseBlock& poses, std::uint32_t) { s.motion.move(s.set, poses, s.normals); });
       }},
      {"likelihood + weights",
       [](Stages& s) {
         s.cloud.weigh([&](const PoseBlock& poses, double* log_weight, double* factor, float* share) {
           s.likelihood.add_to(s.set, poses, log_weight, factor, share);
         });
       }},
      {"weights alone",
       [](Stages& s) {
         s.each_block([&](std::size_t b) { s.weights.set(s.set, b, s.logs.data(), s.factors.data()); });
         s.weights.normalise();
       }},
      {"dominant cluster",
       [](Stages& s) { benchmark::DoNotOptimize(s.cloud.dominant_neighbourhood(2.0, 0.6)); }},
      {"members + moments",
       [](Stages& s) {
         benchmark::DoNotOptimize(s.cloud.choose_members({{}, 2.0, 0.6}));
       }},
      {"ancestors",
       [](Stages& s) { systematic_resampling(s.set, s.cloud.weights(), s.cloud.size(), 0.5, s.ancestors); }},
      {"selection", [](Stages& s) { s.cloud.select(s.ancestors); }},
  };
  return all;
}

/// Keeps the best of the repetitions of each benchmark and prints their medians.
class BestOf : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.aggregate_name == "median") ConsoleReporter::ReportRuns({run});
      if (run.run_type != Run::RT_Iteration) continue;
      const double cost = run.counters.at(kPerParticle);
      const auto [best, is_new] = best_.emplace(run.run_name.function_name + "/" + run.run_name.args, cost);
      if (!is_new) best->second = std::min(best->second, cost);
    }
  }

  void print_ratio(const std::string& what, const std::string& slow, const std::string& fast) const {
    const auto a = best_.find(slow);
    const auto b = best_.find(fast);
    if (a == best_.end() || b == best_.end()) return;
    std::printf("%-44s %9.1f / %6.1f ns %8.2f\n", what.c_str(), a->second, b->second, a->second / b->second);
  }

 private:
  std::map<std::string, double> best_;
};

void print_ratios(const BestOf& best) {
  std::printf("\nCPU time per particle and step, best of the repetitions%24s\n", "ratio");
  for (const char* size : {"/1000", "/10000", "/100000"}) {
    best.print_ratio(std::string("naive / ours, M = ") + (size + 1), std::string("naive") + size,
                     std::string("ours") + size);
  }
  best.print_ratio("naive / ours without AVX2, M = 10000", "naive/10000", "ours, plain/10000");
  best.print_ratio("MRPT (cheaper likelihood) / ours, M = 10000", "MRPT/10000", "ours/10000");
  best.print_ratio("BFL (cheaper likelihood) / ours, M = 10000", "BFL/10000", "ours/10000");
  best.print_ratio("ours, M = 100000 / M = 1000", "ours/100000", "ours/1000");
}

void register_all() {
  register_full_step<Ours>("ours");
  register_full_step<OursPlain>("ours, plain");
  register_full_step<NaiveFilter>("naive");
#ifdef HAVE_MRPT
  register_mrpt();
#endif
#ifdef HAVE_BFL
  register_bfl();
#endif
  for (const auto& [name, stage] : stages()) {
    const auto work = stage;
    const auto one_stage = [work](benchmark::State& state) {
      Stages stages(static_cast<std::size_t>(state.range(0)));
      for (auto unused : state) work(stages);
      count_particles(state);
    };
    benchmark::RegisterBenchmark(("  " + name).c_str(), one_stage)
        ->Arg(10000)
        ->MinTime(0.02)
        ->Repetitions(15);
  }
}

/// --json FILE, in the words of Google Benchmark.
std::vector<std::string> translated(int argc, char** argv) {
  // Repetitions take turns, so that a machine that slows down for a while does so for all.
  std::vector<std::string> arguments = {argv[0], "--benchmark_enable_random_interleaving=true"};
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument != "--json" || i + 1 == argc) {
      arguments.push_back(argument);
      continue;
    }
    arguments.push_back("--benchmark_out=" + std::string(argv[++i]));
    arguments.emplace_back("--benchmark_out_format=json");
  }
  return arguments;
}

}  // namespace
}  // namespace multipath_localization

int main(int argc, char** argv) {
  using namespace multipath_localization;
  std::vector<std::string> arguments = translated(argc, argv);
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  int count = static_cast<int>(pointers.size());
  benchmark::Initialize(&count, pointers.data());
  if (benchmark::ReportUnrecognizedArguments(count, pointers.data())) return 1;
  register_all();
  BestOf best;
  benchmark::RunSpecifiedBenchmarks(&best);
  print_ratios(best);
  return 0;
}
