#pragma once

#include <nlohmann/json.hpp>

#include "evaluation/batch.hpp"

namespace multipath_localization {

/// A run with all that is summed up over suites, but for what is drawn.
nlohmann::json run_to_json(const RunRecord& run);

/// The run that was written. Throws nlohmann::json::exception on anything else.
RunRecord run_from_json(const nlohmann::json& json);

}  // namespace multipath_localization
