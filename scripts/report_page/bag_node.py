"""What one localization_node published in a recorded run."""
import math

from .earth import map_at, moved
from .run import STATES as STATE_NAMES
from .series import BadRun, append, check_columns, check_times, held, in_order

POSES, STATES, FIXES, REPORTS, ORIGIN = (
    "odometry/filtered_map", "localization/state", "odometry/gps", "localization/fix_report", "local_xy_origin")
TYPES = {POSES: "nav_msgs/Odometry", STATES: "multipath_localization/LocalizationState", FIXES: "nav_msgs/Odometry",
         REPORTS: "multipath_localization/FixReport", ORIGIN: "geometry_msgs/PoseStamped"}


def stamp_of(message):
    return message.header.stamp.to_sec()


def yaw_of(q):
    return math.atan2(2.0 * (q.w * q.z + q.x * q.y), 1.0 - 2.0 * (q.y * q.y + q.z * q.z))


class Node:
    """Gathers the messages of a namespace."""

    def __init__(self, namespace):
        self.name, self.frame, self.origins = namespace or "localization_node", "map", []
        self.poses = {key: [] for key in ("t", "x", "y", "yaw", "xx", "xy", "yy")}
        self.motion = {"t": [], "speed": []}
        self.fixes = {"t": [], "x": [], "y": []}
        self.weighings = {key: [] for key in ("t", "kind", "reason", "nis")}
        self.states = []
        self.hears = {POSES: self.add_pose, STATES: self.add_state, FIXES: self.add_fix, REPORTS: self.add_report,
                      ORIGIN: self.add_origin}

    def add_pose(self, message):
        self.frame = message.header.frame_id.lstrip("/")
        pose, P = message.pose.pose, message.pose.covariance
        append(self.poses, stamp_of(message), pose.position.x, pose.position.y, yaw_of(pose.orientation), P[0], P[1], P[7])
        append(self.motion, stamp_of(message), message.twist.twist.linear.x)

    def add_state(self, message):
        self.states.append((stamp_of(message), message.state))

    def add_fix(self, message):
        position = message.pose.pose.position
        if math.isfinite(position.x) and math.isfinite(position.y):
            append(self.fixes, stamp_of(message), position.x, position.y)

    def add_report(self, message):
        compared = message.predicted_sigma > 0.0 and math.isfinite(message.nis)
        append(self.weighings, stamp_of(message), message.kind, message.reason, message.nis if compared else None)

    def add_origin(self, message):
        place = message.pose.position
        self.origins.append((place.y, place.x, place.z))

    def map(self):
        """Where its map lies, None where nothing tells."""
        return map_at(*self.origins[-1]) if self.origins else None

    def notes(self):
        if len(set(self.origins)) > 1:
            yield f"The map of {self.name} was moved on the way: places before and after lie in different maps."
        if not self.states:
            yield f"The recording has no {STATES} of {self.name}: its states are not known."
        if not self.weighings["t"]:
            yield f"The recording has no {REPORTS} of {self.name}: its NIS is not known."

    def run(self, goal):
        """A run of run.py, in the map `goal` where it is known where both lie."""
        of = f"{self.name}, {POSES}"
        check_columns(of, self.poses)
        check_times(of, self.poses["t"])
        unknown = next((state for _, state in self.states if state >= len(STATE_NAMES)), None)
        if unknown is not None:
            raise BadRun(f"{self.name}, {STATES}: {unknown} is no state")
        first = min(self.states)[1] if self.states else None
        estimates = dict(self.poses, state=held(self.states, self.poses["t"], first))
        if goal and self.origins:
            estimates = moved(estimates, self.map(), goal)
        return {"name": self.name, "stream": 0, "estimates": estimates, "headings": {"t": [], "error": []},
                "weighings": in_order(self.weighings), "figures": {}}
