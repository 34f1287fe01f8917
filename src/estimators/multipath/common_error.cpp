#include "estimators/multipath/common_error.hpp"

#include <algorithm>

#include "support/numbers.hpp"

namespace multipath_localization::multipath {

void CommonError::go_on(FixStatus status, double duration, double sigma) {
  const double most = status == FixStatus::kSingle ? square(sigma) : 0.0;
  variance_ = std::min(most, variance_ + duration / kMemory * most);
}

}  // namespace multipath_localization::multipath
