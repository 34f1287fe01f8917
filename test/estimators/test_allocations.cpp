#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <memory>
#include <new>

#include "estimators/nishida/conventional_particle_filter.hpp"
#include "estimators/nishida/fix_particle_filter.hpp"
#include "estimators/nishida/nishida_particle_filter.hpp"
#include "multipath_localization/estimators/make_estimator.hpp"
#include "pseudorange_drive.hpp"
#include "winding_drive.hpp"

namespace {

std::atomic<std::size_t> allocations{0};

}  // namespace

// All others of the standard library come down to these, a sanitizer's own only by their delete, which the
// one that throws nothing has to match. Inlined, new and delete would not look like a pair.
__attribute__((noinline)) void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
__attribute__((noinline)) void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++allocations;
  return std::malloc(size);
}
__attribute__((noinline)) void operator delete(void* memory) noexcept { std::free(memory); }
__attribute__((noinline)) void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace multipath_localization {
namespace {

/// Allocations during ten more seconds of a drive.
template <class Drive, class Filter>
std::size_t allocations_of(Drive& drive, Filter& filter) {
  drive.run(filter, 30.0);
  const std::size_t before = allocations;
  drive.run(filter, 10.0);
  return allocations - before;
}

TEST(Allocations, AreCounted) {
  const std::size_t before = allocations;
  const auto kept = std::make_unique<int>(1);
  EXPECT_EQ(allocations - before, 1U);
}

TEST(Allocations, FiltersOfFixAndOdometryNeedNoneOnTheirWay) {
  for (const char* name : {"nishida_particle_filter", "conventional_particle_filter"}) {
    WindingDrive drive(1);
    const auto filter = make_estimator(name, YAML::Load("{}"), 1);
    filter->start(std::nullopt);
    EXPECT_EQ(allocations_of(drive, *filter), 0U) << name;
  }
}

TEST(Allocations, OfTheDefaultFilterAreAFewPerFixAndNonePerIncrement) {
  WindingDrive drive(4);
  const auto filter = make_estimator("multipath_particle_filter", YAML::Load("{}"), 1);
  filter->start(std::nullopt);
  drive.run(*filter, 30.0);
  for (int fix = 0; fix < 20; ++fix) {
    std::size_t before = allocations;
    for (int i = 0; i < kStepsPerFix; ++i) filter->predict(drive.next());
    EXPECT_EQ(allocations - before, 0U);
    const GnssFix z = drive.fix();
    before = allocations;
    filter->update(z);
    EXPECT_LT(allocations - before, 40U);  // of 400 particles
  }
}

TEST(Allocations, ResamplingAtEveryFixNeedsNone) {
  NishidaParticleFilterParameters parameters;
  parameters.sampling.min_particles = parameters.sampling.max_particles = 30000;
  parameters.ess_threshold = 60000.0;
  WindingDrive drive(2);
  FixParticleFilter filter(parameters, 2);
  filter.start(std::nullopt);
  drive.run(filter, 1.0);
  const std::size_t before = allocations;
  drive.run(filter, 1.0);
  EXPECT_EQ(allocations - before, 0U);
}

using Counts = std::pair<std::size_t, std::size_t>;

/// Of ten increments and of one epoch, the most over ten epochs well under way.
Counts allocations_on_pseudoranges(const char* name, const std::string& parameters) {
  PseudorangeDrive drive(3);
  const auto filter = make_estimator(name, YAML::Load(parameters), 1);
  filter->start(std::nullopt);
  Counts most;
  for (int epoch = 0; epoch < 60; ++epoch) {
    std::size_t before = allocations;
    for (int i = 1; i <= 10; ++i) filter->predict({0.5 * epoch + 0.05 * i, 0.05, 0.0, 0.0});
    const std::size_t moving = allocations - before;
    drive.time = 0.5 * (epoch + 1);
    const PseudorangeEpoch measured = drive.epoch();
    before = allocations;
    filter->update(measured);
    if (epoch >= 50) most = {std::max(most.first, moving), std::max(most.second, allocations - before)};
  }
  return most;
}

TEST(Allocations, OfTheParticleFilterOfPseudorangesAreByTheEpochAndNotByTheParticle) {
  const Counts few = allocations_on_pseudoranges("pseudorange_particle_filter", "{particles: 100}");
  const Counts many = allocations_on_pseudoranges("pseudorange_particle_filter", "{particles: 500}");
  EXPECT_EQ(few.first, 0U);
  EXPECT_EQ(many.first, 0U);
  EXPECT_EQ(few.second, many.second);
}

TEST(Allocations, OfTheMixtureFilterAreByTheEpochAndNotByTheHypothesis) {
  const Counts few = allocations_on_pseudoranges("pseudorange_mixture_filter", "{hypotheses: 20}");
  const Counts many = allocations_on_pseudoranges("pseudorange_mixture_filter", "{hypotheses: 400}");
  EXPECT_EQ(few.first, 0U);
  EXPECT_EQ(many.first, 0U);
  EXPECT_LT(few.second, 60U);
  EXPECT_LT(many.second, 60U);
}

}  // namespace
}  // namespace multipath_localization
