#include <gtest/gtest.h>

#include "broadcast.hpp"
#include "rinex/glonass_orbit.hpp"

namespace multipath_localization {
namespace {

const SatelliteId kR01{Constellation::kGlonass, 1};

GlonassOrbit orbit_at(const char* message, int hour, int minute) {
  return orbit_of<GlonassOrbit>(message, kR01, on_24_june(hour, minute, 18.0));
}

TEST(GlonassOrbit, ReachesTheNextMessage) {
  const GlonassOrbit first = orbit_at(kGlonass1At815, 8, 15);
  const GlonassOrbit second = orbit_at(kGlonass1At845, 8, 45);
  EXPECT_DOUBLE_EQ(second.reference - first.reference, 1800.0);
  const SatelliteState later = satellite_state(first, second.reference);
  EXPECT_LT((later.position - second.position).norm(), 3.0);
  EXPECT_LT((later.velocity - second.velocity).norm(), 5e-3);
  EXPECT_NEAR(later.clock, second.clock, 2e-9);
  const SatelliteState back = satellite_state(second, first.reference);
  EXPECT_LT((back.position - first.position).norm(), 3.0);
}

TEST(GlonassOrbit, AtItsReferenceIsTheMessage) {
  const GlonassOrbit orbit = orbit_at(kGlonass1At815, 8, 15);
  const SatelliteState state = satellite_state(orbit, orbit.reference);
  EXPECT_EQ(state.position, orbit.position);
  EXPECT_EQ(state.velocity, orbit.velocity);
  EXPECT_DOUBLE_EQ(state.clock, orbit.clock);
  EXPECT_DOUBLE_EQ(state.clock_drift, orbit.clock_drift);
}

TEST(GlonassOrbit, VelocityIsTheDerivativeOfPosition) {
  const GlonassOrbit orbit = orbit_at(kGlonass1At815, 8, 15);
  for (const double since : {-870.5, 0.0, 433.3}) {
    const GnssTime time = orbit.reference + since;
    EXPECT_LT((satellite_state(orbit, time).velocity - difference_quotient(orbit, time)).norm(), 2e-5);
  }
}

}  // namespace
}  // namespace multipath_localization
