#pragma once

#include <map>
#include <string>

namespace multipath_localization {

/// How long measurements wait for tf to tell where the antenna of their frame is: at the start of a robot the
/// first fix and a latched transform come in whatever order.
class FramePatience {
 public:
  static constexpr double kPatience = 1.5;  ///< on either clock [s]

  /// Whether it lasts for that frame: it is counted from the first call, in stamps and on the wall clock [s].
  /// What has waited in vain once does not wait again.
  bool lasts(const std::string& frame, double stamp, double wall);

 private:
  struct Begun {
    double stamp;
    double wall;
    bool over = false;
  };
  std::map<std::string, Begun> begun_;
};

}  // namespace multipath_localization
