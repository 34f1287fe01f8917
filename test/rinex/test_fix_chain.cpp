#include <gtest/gtest.h>

#include "rinex/fix_chain.hpp"

namespace multipath_localization {
namespace {

/// East at that speed, once a second.
std::vector<ChainLink> way(int count, double speed, bool doppler) {
  std::vector<ChainLink> links;
  for (int i = 0; i < count; ++i) {
    ChainLink link;
    link.stamp = i;
    link.position.x() = speed * i;
    link.redundancy = 3;
    if (doppler) link.speed = speed;
    links.push_back(link);
  }
  return links;
}

using Marks = std::vector<bool>;

TEST(FixChain, AWayThatIsDrivenIsWhole) {
  EXPECT_EQ(on_its_way({}), Marks());
  EXPECT_EQ(on_its_way(way(1, 0.0, false)), Marks{true});
  EXPECT_EQ(on_its_way(way(20, 15.0, false)), Marks(20, true));
  EXPECT_EQ(on_its_way(way(20, 190.0, true)), Marks(20, true)) << "an aeroplane";
}

TEST(FixChain, LeavesOutWhatCannotBeReached) {
  for (const Eigen::Vector3d& off : {Eigen::Vector3d(0.0, 3955.0, 0.0), Eigen::Vector3d(0.0, 0.0, -400.0)}) {
    for (const std::size_t bad : {0u, 7u, 19u}) {
      auto links = way(20, 10.0, true);
      links[bad].position += off;
      links[bad].redundancy = 0;
      Marks expected(20, true);
      expected[bad] = false;
      EXPECT_EQ(on_its_way(links), expected) << bad;
    }
  }
}

TEST(FixChain, LeavesOutARunThatAgreesWithItself) {
  auto links = way(20, 10.0, true);
  Marks expected(20, true);
  for (std::size_t i = 8; i < 12; ++i) {
    links[i].position.z() = -380.0;
    expected[i] = false;
  }
  EXPECT_EQ(on_its_way(links), expected);
}

TEST(FixChain, OfTwoThatContradictTheBetterCheckedStays) {
  auto links = way(2, 0.0, true);
  links[1].position.y() = 500.0;
  links[0].redundancy = 0;
  EXPECT_EQ(on_its_way(links), (Marks{false, true}));
}

TEST(FixChain, AfterAnOutageItMayBeAnywhere) {
  auto links = way(20, 10.0, true);
  for (std::size_t i = 10; i < 20; ++i) links[i].stamp += 100.0, links[i].position.y() += 5000.0;
  EXPECT_EQ(on_its_way(links), Marks(20, true));
}

}  // namespace
}  // namespace multipath_localization
