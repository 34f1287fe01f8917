#include "multipath_localization/estimators/make_estimator.hpp"

#include <utility>

#include "estimators/dual_antenna_ekf/dual_antenna_ekf.hpp"
#include "estimators/fallback/fallback_estimator.hpp"
#include "estimators/gated_ekf/gated_ekf.hpp"
#include "estimators/multipath/multipath_particle_filter.hpp"
#include "estimators/nishida/conventional_particle_filter.hpp"
#include "estimators/nishida/nishida_particle_filter.hpp"
#include "estimators/pseudorange_mixture/pseudorange_mixture_filter.hpp"
#include "estimators/pseudorange_particle/pseudorange_particle_filter.hpp"
#include "estimators/two_stage_ekf/two_stage_ekf.hpp"
#include "multipath_localization/core/parameters.hpp"

namespace multipath_localization {

namespace {

struct Entry {
  std::string name;
  std::unique_ptr<Estimator> (*make)(const YAML::Node&, std::uint64_t);
  std::string (*describe)();
};

/// The entry of an estimator built as `Type(Parameters, seed)`.
template <class Type, class Parameters>
Entry entry(const char* name) {
  return {name,
          [](const YAML::Node& source, std::uint64_t seed) -> std::unique_ptr<Estimator> {
            Parameters parameters;
            load(source, parameters);
            return std::make_unique<Type>(parameters, seed);
          },
          [] { return describe(Parameters{}); }};
}

template <class Parameters>
struct WithFallback {
  Parameters of_epochs;
  FallbackParameters fallback;

  void fields(ParameterVisitor& field) {
    of_epochs.fields(field);
    field.group("fallback", fallback, "how it goes on where there are fixes but no pseudoranges");
  }
};

/// The entry of an estimator of raw epochs for which one of fixes stands in.
template <class Type, class Parameters>
Entry entry_with_fallback(const char* name) {
  return {name,
          [](const YAML::Node& source, std::uint64_t seed) -> std::unique_ptr<Estimator> {
            WithFallback<Parameters> parameters;
            load(source, parameters);
            auto of_epochs = std::make_unique<Type>(parameters.of_epochs, seed);
            if (!parameters.fallback.enabled) return of_epochs;
            auto of_fixes = std::make_unique<MultipathParticleFilter>(parameters.fallback.fixes, seed);
            return std::make_unique<FallbackEstimator>(std::move(of_epochs), std::move(of_fixes),
                                                       parameters.fallback);
          },
          [] { return describe(WithFallback<Parameters>{}); }};
}

const std::vector<Entry>& entries() {
  static const std::vector<Entry> all = {
      entry<MultipathParticleFilter, MultipathParticleFilterParameters>("multipath_particle_filter"),
      entry<FixParticleFilter, NishidaParticleFilterParameters>("nishida_particle_filter"),
      entry<FixParticleFilter, ConventionalParticleFilterParameters>("conventional_particle_filter"),
      entry<GatedEkf, GatedEkfParameters>("gated_ekf"),
      entry<TwoStageEkf, TwoStageEkfParameters>("two_stage_ekf"),
      entry<DualAntennaEkf, DualAntennaEkfParameters>("dual_antenna_ekf"),
      entry_with_fallback<PseudorangeParticleFilter, PseudorangeParticleFilterParameters>(
          "pseudorange_particle_filter"),
      entry_with_fallback<PseudorangeMixtureFilter, PseudorangeMixtureFilterParameters>(
          "pseudorange_mixture_filter"),
  };
  return all;
}

const Entry& find(const std::string& name) {
  for (const Entry& candidate : entries()) {
    if (candidate.name == name) return candidate;
  }
  std::string known;
  for (const Entry& candidate : entries()) known += " " + candidate.name;
  throw ParameterError("unknown estimator " + name + "; known are" + known);
}

}  // namespace

const std::vector<std::string>& estimator_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Entry& candidate : entries()) all.push_back(candidate.name);
    return all;
  }();
  return names;
}

std::unique_ptr<Estimator> make_estimator(const std::string& name, const YAML::Node& parameters,
                                          std::uint64_t seed) {
  return find(name).make(parameters, seed);
}

std::string describe_estimator(const std::string& name) { return find(name).describe(); }

}  // namespace multipath_localization
