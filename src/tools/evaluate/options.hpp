#pragma once

#include <boost/program_options.hpp>

namespace multipath_localization {

/// What the command line of `evaluate` may hold: where the stream comes from, and what is done with it.
boost::program_options::options_description stream_options();
boost::program_options::options_description run_options();

/// What the table means, for the end of the help.
extern const char* const kAfterwards;

}  // namespace multipath_localization
