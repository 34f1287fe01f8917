#pragma once

#include <string>

namespace multipath_localization {

/// The process of a running node on this computer.
class NodeProcess {
 public:
  /// Asks the node. Throws std::runtime_error when there is none of that name.
  explicit NodeProcess(const std::string& node);

  /// User and system time it has taken [s].
  [[nodiscard]] double cpu_time() const;
  /// Memory it holds in RAM [MB].
  [[nodiscard]] double resident_memory() const;

 private:
  int pid_;
};

}  // namespace multipath_localization
