#include <filter/bootstrapfilter.h>
#include <model/measurementmodel.h>
#include <model/systemmodel.h>
#include <pdf/conditionalpdf.h>
#include <pdf/mcpdf.h>
#include <wrappers/rng/rng.h>

#include "tools/benchmark/full_step.hpp"
#include "tools/benchmark/peer_motion.hpp"

namespace multipath_localization {

namespace {

/// The same step by the bootstrap filter of the Orocos Bayesian Filtering Library, resampled at every step.
class BflFilter {
 public:
  explicit BflFilter(std::size_t size)
      : prior_(static_cast<unsigned>(size), 3), filter_(start(size), 1, 0.0) {}

  void step(const OdometryIncrement& u, const GnssFix& fix) {
    motion_.u = u;
    position_.fix = fix;
    MatrixWrapper::ColumnVector z(2);
    z(1) = fix.position.x();
    z(2) = fix.position.y();
    filter_.Update(&system_, MatrixWrapper::ColumnVector(2), &measurement_, z);
    x_ = filter_.PostGet()->ExpectedValueGet()(1);
  }

  [[nodiscard]] double x() const { return x_; }

 private:
  using Vector = MatrixWrapper::ColumnVector;

  struct Motion : BFL::ConditionalPdf<Vector, Vector> {
    Motion() : BFL::ConditionalPdf<Vector, Vector>(3, 2) {}
    bool SampleFrom(BFL::Sample<Vector>& sample, int, void*) const override {
      const Vector& from = ConditionalArgumentGet(0);
      const Pose2 to = peer_motion({from(1), from(2), from(3)}, u, [] { return BFL::rnorm(0.0, 1.0); });
      Vector state(3);
      state(1) = to.x;
      state(2) = to.y;
      state(3) = to.yaw;
      sample.ValueSet(state);
      return true;
    }
    OdometryIncrement u;
  };

  struct Position : BFL::ConditionalPdf<Vector, Vector> {
    Position() : BFL::ConditionalPdf<Vector, Vector>(2, 1) {}
    BFL::Probability ProbabilityGet(const Vector&) const override {
      const Vector& state = ConditionalArgumentGet(0);
      return std::exp(peer_log_likelihood(state(1), state(2), fix));
    }
    GnssFix fix;
  };

  BFL::MCPdf<Vector>* start(std::size_t size) {
    std::vector<BFL::Sample<Vector>> samples(size);
    for (auto& sample : samples) {
      Vector state(3);
      state(1) = BFL::rnorm(0.0, 0.3);
      state(2) = BFL::rnorm(0.0, 0.3);
      state(3) = BFL::rnorm(0.0, 0.05);
      sample.ValueSet(state);
    }
    prior_.ListOfSamplesSet(samples);
    return &prior_;
  }

  Motion motion_;
  Position position_;
  BFL::SystemModel<Vector> system_{&motion_};
  BFL::MeasurementModel<Vector, Vector> measurement_{&position_};
  BFL::MCPdf<Vector> prior_;
  BFL::BootstrapFilter<Vector, Vector> filter_;
  double x_ = 0.0;
};

}  // namespace

void register_bfl() { register_full_step<BflFilter>("BFL"); }

}  // namespace multipath_localization
