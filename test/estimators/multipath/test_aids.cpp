#include <gtest/gtest.h>

#include <cmath>

#include "estimators/multipath/aids.hpp"

namespace multipath_localization::multipath {
namespace {

Hypothesis believer(bool believes, double yaw, double weight) {
  Hypothesis h;
  h.heading.drawn = true;
  h.heading.believed = believes;
  h.mean(kYaw) = yaw;
  h.covariance(kYaw, kYaw) = 0.01;
  h.log_weight = std::log(weight);
  return h;
}

double weight_of_doubt(const std::vector<Hypothesis>& all) {
  double sum = 0.0;
  for (const Hypothesis& h : all) sum += h.heading.believed ? 0.0 : std::exp(h.log_weight);
  return sum;
}

TEST(Aids, AreDoubtedByMoreHypothesesThanTheirWeight) {
  int doubting = 0;
  double weight = 0.0, all = 0.0;
  for (std::uint32_t i = 0; i < 4000; ++i) {
    RandomStream random(5, 0, i);
    Hypothesis h;
    const bool believed = draw_belief(h, 0.03, random);
    doubting += believed ? 0 : 1;
    weight += believed ? 0.0 : std::exp(h.log_weight);
    all += std::exp(h.log_weight);
  }
  EXPECT_NEAR(doubting, 800, 100);
  EXPECT_NEAR(weight / all, 0.03, 0.005);
}

TEST(Aids, WeighTheBelievingAmongThemselves) {
  std::vector<Hypothesis> all = {believer(true, 0.0, 0.4), believer(true, 1.0, 0.4),
                                 believer(false, 2.0, 0.2)};
  const auto no_outlier = [](const Hypothesis&) { return false; };
  weigh_believing(all, {0.0, std::log(0.25), std::nullopt}, false, no_outlier);
  EXPECT_NEAR(std::exp(all[0].log_weight), 4.0 * std::exp(all[1].log_weight), 1e-9);
  EXPECT_NEAR(std::exp(all[0].log_weight) + std::exp(all[1].log_weight), 0.8, 1e-9);
  EXPECT_NEAR(weight_of_doubt(all), 0.2, 1e-12) << "only fixes tell whether they lie";
}

TEST(Aids, AreNoEvidenceWhereMostTakeThemForOutliers) {
  std::vector<Hypothesis> all = {believer(true, 0.0, 0.9), believer(true, 1.0, 0.1)};
  all[0].heading.outlier = true;
  weigh_believing(all, {-5.0, 5.0}, true, [](const Hypothesis& h) { return h.heading.outlier; });
  EXPECT_NEAR(std::exp(all[0].log_weight), 0.9, 1e-12);
}

TEST(Aids, KeepSomeThatDoubtAndTheirWeight) {
  std::vector<Hypothesis> all;
  for (int i = 0; i < 1000; ++i)
    all.push_back(believer(i >= 200, 0.0, i >= 200 ? 0.99 / 800.0 : 0.01 / 200.0));
  RandomStream random(5, 1, 0);
  const Aids aids{false, true};
  const std::vector<Hypothesis> drawn = drawn_by_kind(all, aids, true, 400, random);
  EXPECT_EQ(drawn.size(), 400U);
  EXPECT_NEAR(weight_of_doubt(drawn), 0.01, 1e-9);
  int doubting = 0;
  for (const Hypothesis& h : drawn) doubting += aids.doubted(h) ? 1 : 0;
  EXPECT_EQ(doubting, 20) << "more than their weight of 4";
}

}  // namespace
}  // namespace multipath_localization::multipath
