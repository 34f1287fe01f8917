#pragma once

#include <map>
#include <string>

/// What reads bytes of strangers, each fed with any bytes at all. A target returns where what it was given is
/// read or refused as documented, and throws where it is not: oracle.hpp.
namespace multipath_localization::fuzz {

void drive(const std::string& bytes);
void messages(const std::string& bytes);
void navigation(const std::string& bytes);
void observations(const std::string& bytes);
void parameters(const std::string& bytes);
void saved(const std::string& bytes);
void scenario(const std::string& bytes);
void services(const std::string& bytes);
void ubx(const std::string& bytes);
void waypoints(const std::string& bytes);

using Target = void (*)(const std::string& bytes);

/// By name, which is that of the target's folder in corpus/, too.
inline const std::map<std::string, Target>& targets() {
  static const std::map<std::string, Target> all = {
      {"drive", drive},
      {"messages", messages},
      {"navigation", navigation},
      {"observations", observations},
      {"parameters", parameters},
      {"saved", saved},
      {"scenario", scenario},
      {"services", services},
      {"ubx", ubx},
      {"waypoints", waypoints},
  };
  return all;
}

}  // namespace multipath_localization::fuzz
