#pragma once

#include <dynamic_reconfigure/Config.h>
#include <dynamic_reconfigure/ConfigDescription.h>

#include <functional>
#include <string>
#include <vector>

#include "multipath_localization/core/parameters.hpp"

/// Parameters as dynamic_reconfigure speaks of them. Names are those of the parameter server, groups and keys
/// parted by slashes; range, unit and meaning come from fields(). Lists are left out.
namespace multipath_localization {

/// Shows parameters to a visitor.
using VisitParameters = std::function<void(ParameterVisitor&)>;

/// Makes a group of what a function shows.
struct VisitedGroup {
  VisitParameters visit;

  void fields(ParameterVisitor& field) const { visit(field); }
};

/// What there is to set; their values as they are now stand for the defaults.
dynamic_reconfigure::ConfigDescription to_description(const VisitParameters& visit);

/// The values as they are.
dynamic_reconfigure::Config to_config(const VisitParameters& visit);

/// Sets those parameters that `config` names. A number out of range becomes the nearest one in it; one that
/// is none, a text that is no choice and a name that is not known change nothing and are returned.
std::vector<std::string> set_parameters(const dynamic_reconfigure::Config& config,
                                        const VisitParameters& visit);

}  // namespace multipath_localization
