#include <gtest/gtest.h>

#include "../../evaluation/temporary_folder.hpp"
#include "multipath_localization/core/parameters.hpp"
#include "ros/localization_node/pose_persistence.hpp"

namespace multipath_localization {
namespace {

const Geodetic kDatum{52.5, 13.4, 40.0};
const OdometryState kThen{100.0, {40.0, 2.0, 0.5}, 1.5, 0.0};
const OdometryState kNow{101.0, {41.0, 2.5, 0.5}, 1.5, 0.0};
constexpr double kMaxAge = 60.0;

SavedPose some_pose() {
  return {kDatum, {12.5, -7.25, 3.0}, 0.01 * Eigen::Matrix3d::Identity(), kThen, true};
}

/// A file with that pose.
std::string saved_in(const TemporaryFolder& folder) {
  const std::string file = folder.path() + "/pose.yaml";
  PosePersistence(file, kMaxAge).save(some_pose());  // written when it ends
  return file;
}

TEST(PosePersistence, TheNextRunStartsWhereThisOneWas) {
  const TemporaryFolder folder;
  const PosePersistence persistence(saved_in(folder), kMaxAge);
  const auto start = persistence.start(kNow, nullptr);
  ASSERT_TRUE(start);
  EXPECT_TRUE(start->prior.confirmed);
  EXPECT_LT((start->prior.pose.position() - Eigen::Vector2d(12.5, -7.25)).norm(), 2.0);
  EXPECT_EQ(start->datum.latitude_deg, kDatum.latitude_deg);
}

TEST(PosePersistence, NothingWasSavedAtTheFirstRunNorWithoutAFile) {
  const TemporaryFolder folder;
  EXPECT_FALSE(PosePersistence(folder.path() + "/pose.yaml", kMaxAge).start(kNow, nullptr));
  EXPECT_FALSE(PosePersistence("", kMaxAge).start(kNow, nullptr));
}

TEST(PosePersistence, APoseOfAnotherMapDoesNotCount) {
  const TemporaryFolder folder;
  const PosePersistence persistence(saved_in(folder), kMaxAge);
  const LocalFrame same(kDatum);
  EXPECT_TRUE(persistence.start(kNow, &same));
  const LocalFrame other(Geodetic{52.501, 13.4, 40.0});
  EXPECT_THROW(static_cast<void>(persistence.start(kNow, &other)), ParameterError);
}

TEST(PosePersistence, APoseThatIsTooOldDoesNotCount) {
  const TemporaryFolder folder;
  const PosePersistence persistence(saved_in(folder), kMaxAge);
  OdometryState late = kNow;
  late.stamp = kThen.stamp + 2.0 * kMaxAge;
  EXPECT_THROW(static_cast<void>(persistence.start(late, nullptr)), ParameterError);
}

TEST(PosePersistence, SavesOnceASecondOfStamps) {
  const TemporaryFolder folder;
  PosePersistence persistence(folder.path() + "/pose.yaml", kMaxAge);
  EXPECT_TRUE(persistence.due(kThen.stamp));
  persistence.save(some_pose());
  EXPECT_FALSE(persistence.due(kThen.stamp + 0.5));
  EXPECT_TRUE(persistence.due(kThen.stamp + 1.5));
  EXPECT_TRUE(persistence.due(kThen.stamp - 1.5)) << "stamps have gone back";
  EXPECT_FALSE(PosePersistence("", kMaxAge).due(kThen.stamp));
}

}  // namespace
}  // namespace multipath_localization
