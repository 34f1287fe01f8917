#include "evaluation/run_json.hpp"

namespace multipath_localization {

namespace {

using nlohmann::json;

/// Writes or reads the members of what is written, each named once.
class Writer {
 public:
  template <class Value>
  void operator()(const char* name, const Value& value) {
    out_[name] = value;
  }
  void operator()(const char* name, const std::optional<double>& value) {
    out_[name] = value ? json(*value) : json();
  }
  void operator()(const char* name, const RunningMean& mean) { out_[name] = {mean.sum, mean.weight}; }
  void operator()(const char* name, const Detection& d) {
    out_[name] = {{"told", d.told}, {"cleared", d.cleared}, {"missed", d.missed}};
    out_[name]["brier"] = {d.brier.sum, d.brier.weight};
  }
  [[nodiscard]] const json& out() const { return out_; }

 private:
  json out_ = json::object();
};

class Reader {
 public:
  explicit Reader(const json& in) : in_(in) {}

  template <class Value>
  void operator()(const char* name, Value& value) {
    in_.at(name).get_to(value);
  }
  void operator()(const char* name, std::optional<double>& value) {
    value = in_.at(name).is_null() ? std::nullopt : std::optional(in_.at(name).get<double>());
  }
  void operator()(const char* name, RunningMean& mean) { read(in_.at(name), mean); }
  void operator()(const char* name, Detection& d) {
    const json& in = in_.at(name);
    in.at("told").get_to(d.told);
    in.at("cleared").get_to(d.cleared);
    in.at("missed").get_to(d.missed);
    read(in.at("brier"), d.brier);
  }

 private:
  static void read(const json& in, RunningMean& mean) {
    in.at(0).get_to(mean.sum);
    in.at(1).get_to(mean.weight);
  }
  const json& in_;
};

template <class Visitor, class ACalibration>
void visit_calibration(Visitor& field, ACalibration& c) {
  field("time", c.time);
  field("inside", c.inside);
  field("pit", c.pit);
  field("stanford", c.stanford);
  field("in_state", c.in_state);
  field("beyond", c.beyond);
  field("good_minutes", c.good_minutes);
  field("false_minutes", c.false_minutes);
  field("open", c.open);
  field("open_good", c.open_good);
  field("position_open", c.position_open);
  field("position_shadow", c.position_shadow);
  field("heading_open", c.heading_open);
  field("heading_shadow", c.heading_shadow);
  field("shadow", c.shadow);
  field("wheel_fault", c.wheel_fault);
  field("nis", c.nis);
  field("nis_next", c.nis_next);
}

template <class Visitor, class ARun>
void visit_run(Visitor& field, ARun& run) {
  field("source", run.source);
  field("estimator", run.estimator);
  field("seed", run.seed);
  field("failure", run.failure);
  field("kind", run.kind);
  field("about", run.about);
  field("traits", run.traits);
  field("rmse_m", run.score.rmse);
  field("median_m", run.score.median);
  field("p95_m", run.score.p95);
  field("max_m", run.score.max);
  field("heading_rmse_rad", run.score.heading_rmse);
  field("nees_mean", run.score.nees_mean);
  field("fix_rmse_m", run.fixes.rmse);
  field("longest_beyond_3_sigma_s", run.longest_beyond_3_sigma);
  field("way_to_alignment_m", run.way_to_alignment);
  field("cpu_s", run.cpu);
}

}  // namespace

json run_to_json(const RunRecord& run) {
  Writer members;
  visit_run(members, run);
  Writer calibration;
  visit_calibration(calibration, run.calibration);
  members("calibration", calibration.out());
  return members.out();
}

RunRecord run_from_json(const json& json) {
  RunRecord run;
  Reader members(json);
  visit_run(members, run);
  Reader calibration(json.at("calibration"));
  visit_calibration(calibration, run.calibration);
  return run;
}

}  // namespace multipath_localization
