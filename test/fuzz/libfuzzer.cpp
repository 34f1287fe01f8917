#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>

#include "targets.hpp"

namespace {

multipath_localization::fuzz::Target target = nullptr;

}  // namespace

/// One program for all targets: the name it is called by tells which.
extern "C" int LLVMFuzzerInitialize(int* /*argc*/, char*** argv) {
  const std::string path = (*argv)[0];
  const std::string name = path.substr(path.find_last_of('/') + 1);
  const auto found = multipath_localization::fuzz::targets().find(name);
  if (found == multipath_localization::fuzz::targets().end()) {
    std::cerr << "ERROR: there is no target " << name << "\n";
    std::exit(1);
  }
  target = found->second;
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  target(std::string(reinterpret_cast<const char*>(data), size));
  return 0;
}
