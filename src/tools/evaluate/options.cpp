#include "tools/evaluate/options.hpp"

namespace multipath_localization {

namespace po = boost::program_options;

const char* const kAfterwards = R"(
The table has one line per estimator: means over the seeds, in metres where nothing else is said.
  epochs         truth samples scored; 'without': those without an estimate, which are not scored
  95 %, max      of the position errors; shadow, open: RMSE where fixes are biased, and are not;
                 by satellites: where most are not in line of sight, where they are
  off s <=       longest time without a break that the estimate was off by --off-from or more, worst seed
  beyond ...     longest time without a break that it was outside its own 3 sigma ellipse, worst seed
  NEES           error squared over declared variance, 2 is ideal; 'in 95 %' [%] inside the declared ellipse
  waypoints >=   passed in the seed with the fewest
  missed by <=   the farthest the robot truly was from one it passed, worst seed
What suites over drives end with, for all drives and for each kind of receiver:
  rmse           geometric mean over the drives
  to best other  geometric mean of the RMSE over that of the best of fixes, gated_ekf and two_stage_ekf
  to oracle      the same over that of a filter that knows what is wrong with each fix, and all constants
  behind         share of drives on which it is over 10 % worse than the best other
  beyond         share on which it was outside its own 3 sigma for over 5 s, over 30 s without a break
Exit status: 0 when every run ended, 1 when one did not, 2 when command line or data cannot be used.
)";

po::options_description stream_options() {
  const auto text = [](const char* name) { return po::value<std::string>()->value_name(name); };
  po::options_description options("One stream", 110);
  const auto add = [&](auto... arguments) { options.add_options()(arguments...); };
  add("drive", text("DIR"),
      "a recording: odometry.csv, truth.csv, and fix.csv or pseudoranges.csv or both; without odometry.csv "
      "the motion is by Doppler, without truth.csv nothing is scored");
  add("bag", text("FILE"), "a recording: NavSatFix or GnssEpoch, Odometry, truth as PoseStamped or Odometry");
  add("scenario", text("NAME"),
      "a simulation, steered by the estimate unless it says otherwise: config/scenarios/NAME.yaml, or a "
      "file");
  add("suite", text("NAME"),
      "scenarios in a row, and where the first estimator falls short: "
      "config/suites/NAME.yaml, or a file. 'random': a robot, way and receiver drawn for each seed; "
      "'drives:DIR': every recording in DIR, fixes and odometry alone. These two also run gated_ekf and "
      "two_stage_ekf and end with how all stand");
  add("fix-topic", text("A,B"),
      "of the bag, of one receiver or several; gps/fix with gps_2/fix, ..., or the only NavSatFix");
  add("epoch-topic", text("TOPIC"), "gnss/epoch, or the only GnssEpoch");
  add("left-topic", text("TOPIC"), "NavSatFix of the left one of two antennas; gps/left/fix");
  add("right-topic", text("TOPIC"), "of the right one; gps/right/fix");
  add("imu-topic", text("TOPIC"), "imu/data, or the only Imu");
  add("velocity-topic", text("TOPIC"),
      "of a receiver, with covariance or without; gps/velocity, or the only fix_velocity or vel");
  add("heading-topic", text("TOPIC"), "Imu or PoseWithCovarianceStamped; heading");
  add("level-topic", text("TOPIC"),
      "levels of fixes: gps_common/GPSFix or ublox_msgs/NavPVT; gps/level, or the only one");
  add("without", text("A,B"),
      "inputs of a recording to leave out: gyro, velocity, receivers (all but the first), heading, levels");
  add("odom-topic", text("TOPIC"), "odom, or the only Odometry besides truth");
  add("truth-topic", text("TOPIC"), "truth; without it nothing is scored");
  add("shadow-topic", text("TOPIC"), "Vector3Stamped, z = 1 where fixes are biased; truth/bias if there");
  add("faults", text("FILE"),
      "inject these faults: keys as in config/fault_injector.yaml, ready files in config/faults; zones lie "
      "in "
      "the frame of truth");
  add("datum", text("LAT,LON[,ALT]"),
      "origin of the frame of a bag's truth [deg, m]; left out: that of a static transform earth -> that "
      "frame, else where the median of fix - truth is zero, over the fixes that are told to be under open "
      "sky");
  return options;
}

po::options_description run_options() {
  const auto text = [](const char* name) { return po::value<std::string>()->value_name(name); };
  const auto number = [](const char* name, int value) {
    return po::value<int>()->default_value(value)->value_name(name);
  };
  po::options_description options("Runs and results", 110);
  const auto add = [&](auto... arguments) { options.add_options()(arguments...); };
  add("estimators", text("A,B"),
      "names, or 'all'; left out: the default estimator. NAME{KEY: VALUE, ...} gives it parameters of its "
      "own, LABEL=NAME{KEY: VALUE, ...} a name too");
  add("seeds", po::value<std::string>()->default_value("1")->value_name("N"),
      "run seeds 1..N, or FIRST..LAST; of random robots the seed is the robot's too");
  add("with", text("A,B"),
      "inputs of random robots beside odometry and fixes: gyro, velocity (by Doppler), receivers (a second "
      "one), heading, levels (RTK receivers tell theirs)");
  add("jobs", number("N", 1), "runs at a time");
  add("known-start", "start at the true pose; unknown otherwise");
  add("set", po::value<std::vector<std::string>>()->composing()->value_name("KEY=VALUE"),
      "a parameter of all estimators, of one as NAME.KEY, of the localizer as localizer.KEY, of a scenario "
      "as simulator.KEY and steering.KEY; nested keys joined by dots; may be repeated");
  add("off-from", po::value<double>()->default_value(2.0)->value_name("M"),
      "an error of M metres or more counts as off");
  add("score-from", po::value<double>()->value_name("S"),
      "score from S seconds on; left out: 60 for suites over drives, else 0");
  add("json", text("FILE"), "write the figures of each run");
  add("results", po::value<std::vector<std::string>>()->multitoken()->value_name("FILE"),
      "keep the runs of --suite random in FILE as they end, make only those it lacks; without a suite: how "
      "the runs in FILE, or several, stand");
  add("write", text("DIR"),
      "instead of running anything: write the drives of --suite random as DIR/random_SEED");
  add("plot", text("FILE.png"), "draw the first seed: trajectories, error and declared error over time");
  add("report", text("FILE.html"),
      "a page about the first seed for any browser: map, errors, states, NIS, speeds, figures");
  add("help", "print this");
  return options;
}

}  // namespace multipath_localization
