#pragma once

#include <map>
#include <string>
#include <string_view>

#include "multipath_localization/core/estimate.hpp"

namespace multipath_localization {

/// What became of the messages of one input: how many were used, how many not, and why.
class ReasonTally {
 public:
  void count(Reason reason) { ++counts_[reason]; }
  void add(const ReasonTally& other);
  void remove(Reason reason);  ///< one that was counted before

  [[nodiscard]] const std::map<Reason, unsigned>& counts() const { return counts_; }
  [[nodiscard]] unsigned total() const;
  [[nodiscard]] unsigned of(Reason reason) const;
  /// By a fault of theirs: `is_fault`.
  [[nodiscard]] unsigned refused() const;
  /// Why most of these were, `accepted` where none was.
  [[nodiscard]] Reason most_frequent_refusal() const;
  /// Whether more than a tenth was refused, which somebody has to be told.
  [[nodiscard]] bool loses() const { return 10 * refused() > total(); }

  /// Whether more than a tenth of those that this estimator has a use for was not used, be it for repeating
  /// what was said before.
  [[nodiscard]] bool falls_short() const;

  /// "refused 12 of 13, most often for: old stamp (what that means)"
  [[nodiscard]] std::string refusal() const;
  /// "1 of 13 used; old stamp 11, repeated 1"
  [[nodiscard]] std::string sum() const;
  /// The same, and what the most frequent refusal means.
  [[nodiscard]] std::string explained_sum() const;

 private:
  std::map<Reason, unsigned> counts_;
};

/// What a refusal for that reason means and where to look; empty where its name says it.
std::string_view meaning(Reason reason);

}  // namespace multipath_localization
