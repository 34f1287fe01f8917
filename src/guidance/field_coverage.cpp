#include "guidance/field_coverage.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "guidance/polygon_inset.hpp"
#include "multipath_localization/core/pose.hpp"
#include "support/plain_numbers.hpp"

namespace multipath_localization {

namespace {

constexpr double kStray = 0.02;      // over the line that the base's centre keeps within [m]
constexpr double kSamePlace = 1e-6;  // [m]
constexpr double kLongLine = 6.0;    // in the radii of arcs
constexpr double kLookedAt = 20.0;   // of the way on along the lap, in the radii of arcs
constexpr std::size_t kMostTracks = 1000;
constexpr std::size_t kMostCorners = 500;  // of the border
constexpr double kWhole = 0.998;           // of what is to be reached: the rest is rounding
constexpr double kMostLeft = 0.02;         // of the tracks, that cannot be turned to

/// A straight way across, whose ends lie on the outermost lap.
struct Track {
  std::array<Eigen::Vector2d, 2> ends;
  std::array<double, 2> stations{};  ///< of the ends, on that lap
  bool driven = false;
};

/// A way from the place the planner is at to a track.
struct Choice {
  std::size_t track;
  std::size_t end;  ///< where it is entered
  double from;      ///< station of the planner
  double to;        ///< that of the end, counted so that the way there is from one to the other
};

class CoveragePlanner {
 public:
  /// The border in `frame`, along whose x the tracks run.
  CoveragePlanner(const Pose2& frame, const Ring& border, double width, double radius);

  std::vector<WayPoint> plan(const Eigen::Vector2d& start);

 private:
  [[nodiscard]] std::vector<Eigen::Vector2d> last_corners() const;
  [[nodiscard]] bool can_go(const std::vector<Eigen::Vector2d>& corners) const;
  bool go(const std::vector<Eigen::Vector2d>& corners, double station, bool either_way);
  void drive_outermost_lap(const Eigen::Vector2d& start);
  bool drive_lap(const Ring& lap, double shift);
  [[nodiscard]] bool stays_within(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const;
  bool drive_lap_from(const Ring& lap, double leave, double run);
  void drive_inner_laps();
  void find_tracks();
  [[nodiscard]] std::vector<Choice> choices() const;
  bool drive_track(const Choice& choice);
  void require_little_left() const;

  Pose2 frame_;  ///< in map
  Ring border_;
  double width_;
  Rounding rounding_;
  Ring outermost_;  ///< lap
  std::vector<Track> tracks_;
  std::vector<Eigen::Vector2d> corners_;  ///< of the way so far
  double station_ = 0.0;                  ///< of its end, on the outermost lap
  bool heads_on_ = true;                  ///< it came there counter-clockwise along the lap
  double covered_depth_ = 0.0;            ///< of the laps driven, from the border [m]
};

void append(std::vector<Eigen::Vector2d>& way, const std::vector<Eigen::Vector2d>& corners) {
  for (const Eigen::Vector2d& corner : corners) {
    if (way.empty() || (corner - way.back()).norm() > kSamePlace) way.push_back(corner);
  }
}

double area_of(const std::vector<Ring>& rings) {
  return std::accumulate(rings.begin(), rings.end(), 0.0,
                         [](double area, const Ring& ring) { return area + ring.area(); });
}

Ring outermost_lap(const Ring& border, double width) {
  const std::vector<Ring> parts = inset(border, 0.5 * width);
  if (parts.size() == 1) return parts.front();
  throw std::invalid_argument(parts.empty() ? "the field is narrower than the width"
                                            : "the field is narrower than the width between parts of it");
}

CoveragePlanner::CoveragePlanner(const Pose2& frame, const Ring& border, double width, double radius)
    : frame_(frame),
      border_(border),
      width_(width),
      rounding_{radius, [this](const Eigen::Vector2d& place) { return outermost_.contains(place, kStray); }},
      outermost_(outermost_lap(border, width)) {}

/// The last corners of the way so far, from a line on that is long enough for whatever arc is at its end.
std::vector<Eigen::Vector2d> CoveragePlanner::last_corners() const {
  std::size_t first = corners_.size() > 3 ? corners_.size() - 3 : 0;
  const double enough = kLongLine * rounding_.radius;
  while (first > 0 && (corners_[first + 1] - corners_[first]).norm() < enough) --first;
  return {corners_.begin() + static_cast<std::ptrdiff_t>(first), corners_.end()};
}

/// Whether the base can turn at each of the corners, on from the way so far.
bool CoveragePlanner::can_go(const std::vector<Eigen::Vector2d>& corners) const {
  std::vector<Eigen::Vector2d> way = last_corners();
  append(way, corners);
  return rounded_way(way, rounding_).has_value();
}

/// Goes on by the corners to a place on the outermost lap, where there is a way on along it.
bool CoveragePlanner::go(const std::vector<Eigen::Vector2d>& corners, double station, bool either_way) {
  const double looked_at = std::min(outermost_.length(), kLookedAt * rounding_.radius);
  for (const double on : {looked_at, -looked_at}) {
    if (on < 0.0 && !either_way) break;
    std::vector<Eigen::Vector2d> further = corners;
    append(further, outermost_.way(station, station + on));
    if (!can_go(further)) continue;
    append(corners_, corners);
    station_ = station;
    heads_on_ = !either_way;
    return true;
  }
  return false;
}

void CoveragePlanner::drive_outermost_lap(const Eigen::Vector2d& start) {
  station_ = outermost_.station(outermost_.nearest_corner(start));
  for (const Eigen::Vector2d& corner : outermost_.way(station_, station_ + outermost_.length())) {
    if (can_go({corner})) {
      append(corners_, {corner});
      continue;
    }
    const Eigen::Vector2d told = frame_ * corners_.back();
    throw std::invalid_argument("the base cannot turn at the corner of the field near " +
                                fixed_text(told.x(), 1) + ", " + fixed_text(told.y(), 1));
  }
  covered_depth_ = width_;
}

bool CoveragePlanner::stays_within(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const {
  const double looks = std::ceil((to - from).norm() / (0.25 * width_)) + 1.0;
  for (double i = 0.0; i <= looks; ++i) {
    if (!rounding_.may_come(from + i / looks * (to - from))) return false;
  }
  return true;
}

bool CoveragePlanner::drive_lap_from(const Ring& lap, double leave, double run) {
  std::vector<Eigen::Vector2d> corners = outermost_.way(station_, leave);
  const double begin = lap.nearest(corners.back()) + run;
  const std::vector<Eigen::Vector2d> round = lap.way(begin, begin + lap.length() + run);
  corners.insert(corners.end(), round.begin(), round.end());
  const double back = outermost_.nearest(corners.back());
  corners.push_back(outermost_.at(back + run));
  const bool within =
      stays_within(outermost_.at(leave), round.front()) && stays_within(round.back(), corners.back());
  return within && go(corners, back + run, false);
}

/// A lap `shift` [m] within the outermost, gone over to and back from at a slant.
bool CoveragePlanner::drive_lap(const Ring& lap, double shift) {
  for (double slant = 1.0; slant <= 3.0; slant += 0.5) {
    const double run = slant * (shift + rounding_.radius);
    for (double on = 0.0; on < outermost_.length(); on += width_) {
      if (drive_lap_from(lap, station_ + on, run)) return true;
    }
  }
  return false;
}

/// Laps within the outermost one, as many as turning into a track takes room: where one leaves out what is
/// too narrow for it, or cannot be driven, the tracks have to do.
void CoveragePlanner::drive_inner_laps() {
  const double room = 0.5 * width_ + 2.0 * rounding_.radius;
  while (covered_depth_ < room) {
    const std::vector<Ring> laps = inset(border_, covered_depth_ + 0.5 * width_);
    double reached = 0.0;
    for (const Ring& lap : laps) reached += area_of(inset(lap, -0.5 * width_));
    if (reached < kWhole * area_of(inset(border_, covered_depth_))) return;
    const std::vector<Eigen::Vector2d> before = corners_;
    const double station = station_;
    for (const Ring& lap : laps) {
      if (drive_lap(lap, covered_depth_)) continue;
      corners_ = before;
      station_ = station;
      return;
    }
    covered_depth_ += width_;
  }
}

void CoveragePlanner::find_tracks() {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const Ring& part : inset(border_, covered_depth_)) {
    for (const Eigen::Vector2d& corner : part.corners()) {
      low = std::min(low, corner.y());
      high = std::max(high, corner.y());
    }
  }
  const double count = std::ceil((high - low) / width_);
  if (count > static_cast<double>(kMostTracks))
    throw std::invalid_argument("the field takes more than 1000 tracks");
  const std::vector<Ring> reached = inset(border_, covered_depth_ - 0.5 * width_);
  for (double i = 0.5; i < count; ++i) {
    const double y = low + i * (high - low) / count;
    for (const auto& [from, to] : outermost_.sections(y)) {
      const auto within = [&, from = from, to = to](const Ring& part) {
        const auto sections = part.sections(y);
        return std::any_of(sections.begin(), sections.end(), [&](const auto& section) {
          return from <= section.first + kSamePlace && section.second <= to + kSamePlace;
        });
      };
      if (std::none_of(reached.begin(), reached.end(), within)) continue;
      const std::array<Eigen::Vector2d, 2> ends = {Eigen::Vector2d(from, y), Eigen::Vector2d(to, y)};
      tracks_.push_back({ends, {outermost_.nearest(ends[0]), outermost_.nearest(ends[1])}});
    }
  }
}

/// The ends of tracks to be driven, the nearest along the lap first.
std::vector<Choice> CoveragePlanner::choices() const {
  std::vector<Choice> choices;
  const double round = outermost_.length();
  for (std::size_t i = 0; i < tracks_.size(); ++i) {
    if (tracks_[i].driven) continue;
    for (std::size_t end = 0; end < 2; ++end) {
      const double on = outermost_.within_round(tracks_[i].stations[end] - station_);
      choices.push_back({i, end, station_, station_ + on});
      if (!heads_on_) choices.push_back({i, end, station_, station_ + on - round});
    }
  }
  std::sort(choices.begin(), choices.end(), [](const Choice& a, const Choice& b) {
    return std::abs(a.to - a.from) < std::abs(b.to - b.from);
  });
  return choices;
}

bool CoveragePlanner::drive_track(const Choice& choice) {
  Track& track = tracks_[choice.track];
  std::vector<Eigen::Vector2d> corners = outermost_.way(choice.from, choice.to);
  corners.back() = track.ends[choice.end];
  corners.push_back(track.ends[1 - choice.end]);
  track.driven = go(corners, track.stations[1 - choice.end], true);
  return track.driven;
}

std::vector<WayPoint> CoveragePlanner::plan(const Eigen::Vector2d& start) {
  drive_outermost_lap(start);
  drive_inner_laps();
  find_tracks();
  const auto drive = [this](const Choice& choice) { return drive_track(choice); };
  for (bool driven = true; driven;) {
    const std::vector<Choice> nearest = choices();
    driven = std::any_of(nearest.begin(), nearest.end(), drive);
  }
  require_little_left();
  std::vector<WayPoint> way = *rounded_way(corners_, rounding_);
  const auto same = [](const WayPoint& a, const WayPoint& b) {
    return (a.position - b.position).norm() < kSamePlace;
  };
  way.erase(std::unique(way.begin(), way.end(), same), way.end());
  return way;
}

/// Throws std::invalid_argument where more than a little could not be turned to.
void CoveragePlanner::require_little_left() const {
  double all = 0.0;
  double left = 0.0;
  for (const Track& track : tracks_) {
    const double length = (track.ends[1] - track.ends[0]).norm();
    all += length;
    if (!track.driven) left += length;
  }
  if (left <= kMostLeft * all) return;
  throw std::invalid_argument("the field has no room for the base to turn from track to track");
}

}  // namespace

std::vector<WayPoint> coverage_of(const Field& field, double turning_radius, const Eigen::Vector2d& start) {
  const std::string fault = fault_of_polygon(field.border);
  if (!fault.empty()) throw std::invalid_argument("the border of the field has " + fault);
  if (field.border.size() > kMostCorners)
    throw std::invalid_argument("the border of the field has more than 500 corners");
  const double heading = field.heading ? *field.heading : Ring(field.border).longest_edge();
  const Pose2 tracks{0.0, 0.0, heading};  // along x of this frame
  std::vector<Eigen::Vector2d> border;
  for (const Eigen::Vector2d& corner : field.border) border.push_back(inverse(tracks) * corner);
  CoveragePlanner planner(tracks, Ring(border), field.width, turning_radius);
  std::vector<WayPoint> way = planner.plan(inverse(tracks) * start);
  for (WayPoint& place : way) place.position = tracks * place.position;
  return way;
}

}  // namespace multipath_localization
