#include "simulation/fix_faults.hpp"
#include "support/plain_numbers.hpp"

namespace multipath_localization {

namespace {

std::string told(const BiasFault& f) {
  return plain_text("bias of ", f.east, " m east, ", f.north, " m north");
}
std::string told(const NoiseFault& f) {
  return plain_text("noise of ", f.white_sigma, " m white, ", f.coloured_sigma, " m coloured over ",
                    f.time_constant, " s");
}
std::string told(const SpikeFault& f) {
  return plain_text("spikes of ", f.length, " m in ", f.share, " of the fixes");
}
std::string told(const DelayFault& f) {
  return plain_text("delay of ", f.delay, " to ", f.delay + f.jitter, " s");
}
std::string told(const CovarianceFault& f) { return plain_text("declared sigma times ", f.sigma_factor); }
std::string told(const StatusFault& f) { return "status " + std::to_string(f.status); }

/// Those of a kind that are there at `time`, each told by `sentence`.
template <class Fault, class Sentence>
void add(std::vector<std::string>& active, const std::vector<Fault>& faults, double time,
         const Sentence& sentence) {
  for (const Fault& fault : faults) {
    if (fault.holds(time)) active.push_back(sentence(fault));
  }
}

}  // namespace

void BiasFault::fields(ParameterVisitor& field) {
  FaultInterval::fields(field);
  field("east", east, {-1e4, 1e4}, "m", "added to the fixes");
  field("north", north, {-1e4, 1e4}, "m", "added to the fixes");
  field("walk_in", walk_in, {0.0, 1e9}, "s", "the bias grows over this time, linearly; 0: it jumps");
}

void NoiseFault::fields(ParameterVisitor& field) {
  FaultInterval::fields(field);
  field("white_sigma", white_sigma, {0.0, 1e4}, "m", "white noise of each component");
  field("coloured_sigma", coloured_sigma, {0.0, 1e4}, "m", "Gauss-Markov noise of each component");
  field("time_constant", time_constant, {1e-3, 1e6}, "s", "its correlation time");
}

void ChanceFault::fields(ParameterVisitor& field) {
  FaultInterval::fields(field);
  field("share", share, {0.0, 1.0}, "1", "of the messages it happens to, by chance");
}

void SpikeFault::fields(ParameterVisitor& field) {
  ChanceFault::fields(field);
  field("length", length, {0.0, 1e6}, "m", "how far a fix is thrown, in any direction");
}

void DelayFault::fields(ParameterVisitor& field) {
  FaultInterval::fields(field);
  field("delay", delay, {0.0, 60.0}, "s", "fixes come in later by this");
  field("jitter", jitter, {0.0, 60.0}, "s", "added to it at most, uniformly; no fix overtakes another");
}

void CovarianceFault::fields(ParameterVisitor& field) {
  FaultInterval::fields(field);
  field("sigma_factor", sigma_factor, {1e-3, 1e3}, "1", "on the standard deviation that is declared");
}

void StatusFault::fields(ParameterVisitor& field) {
  FaultInterval::fields(field);
  field("status", status, {-1, 2}, "1", "NavSatStatus that is claimed: -1 none, 0 fix, 1 SBAS, 2 GBAS");
}

void FixFaultParameters::fields(ParameterVisitor& field) {
  field.list("zones", zones, "regions of the map in which fixes carry a bias; the first counts");
  field.list("biases", biases, "constant, or walking in");
  field.list("noises", noises, "more noise");
  field.list("spikes", spikes, "lone fixes far off");
  field.list("outages", outages, "no fixes");
  field.list("freezes", freezes, "the position, to the bit, and covariance of the fix before, stamps go on");
  field.list("delays", delays, "late fixes");
  field.list("covariances", covariances, "fixes that lie about how good they are");
  field.list("statuses", statuses, "fixes that lie about their kind");
  field.list("losses", losses, "fixes that never arrive");
  field.list("duplicates", duplicates, "fixes that arrive twice");
  field.list("swaps", swaps, "fixes that the next one overtakes");
}

std::vector<std::string> FixFaults::active(double now) const {
  const double time = now - start_;
  const FixFaultParameters& p = parameters_;
  std::vector<std::string> all;
  if (zone_) all.push_back("fix: zone " + p.zones[*zone_].name);
  const auto its_own = [](const auto& fault) { return "fix: " + told(fault); };
  const auto named = [](const char* name) { return [name](const auto&) { return std::string(name); }; };
  const auto shared = [](const char* what) {
    return [what](const ChanceFault& fault) { return plain_text("fix: ", fault.share, " of them ", what); };
  };
  add(all, p.biases, time, its_own);
  add(all, p.noises, time, its_own);
  add(all, p.spikes, time, its_own);
  add(all, p.outages, time, named("fix: outage"));
  add(all, p.freezes, time, named("fix: frozen"));
  add(all, p.delays, time, its_own);
  add(all, p.covariances, time, its_own);
  add(all, p.statuses, time, its_own);
  add(all, p.losses, time, shared("lost"));
  add(all, p.duplicates, time, shared("twice"));
  add(all, p.swaps, time, shared("overtaken"));
  return all;
}

}  // namespace multipath_localization
