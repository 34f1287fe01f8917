#include "multipath_localization/core/estimate.hpp"

#include "multipath_localization/core/localization_state.hpp"

namespace multipath_localization {

std::string_view to_string(Reason reason) {
  switch (reason) {
    case Reason::kAccepted: return "accepted";
    case Reason::kUnused: return "unused";
    case Reason::kNotFinite: return "not finite";
    case Reason::kInvalidCovariance: return "invalid covariance";
    case Reason::kInvalidPosition: return "invalid position";
    case Reason::kNoFix: return "no fix";
    case Reason::kFrozen: return "frozen";
    case Reason::kGated: return "gated";
    case Reason::kZeroStamp: return "zero stamp";
    case Reason::kFutureStamp: return "future stamp";
    case Reason::kOldStamp: return "old stamp";
    case Reason::kNotStarted: return "not started";
    case Reason::kInvalidFrame: return "invalid frame";
  }
  return "unknown";
}

std::string_view to_string(LocalizationState state) {
  switch (state) {
    case LocalizationState::kNotReady: return "NOT_READY";
    case LocalizationState::kAligning: return "ALIGNING";
    case LocalizationState::kGood: return "GOOD";
    case LocalizationState::kMultipath: return "MULTIPATH";
    case LocalizationState::kDeadReckoning: return "DEAD_RECKONING";
    case LocalizationState::kLost: return "LOST";
  }
  return "unknown";
}

}  // namespace multipath_localization
