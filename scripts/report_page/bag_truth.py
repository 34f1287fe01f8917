"""Where the robot truly was, as a bag of a simulation or a survey tells on `truth`."""
from .bag_node import stamp_of
from .earth import map_of, moved
from .series import append, check_columns, check_times, held

POSES, BIAS, FRAMES = "truth", "truth/bias", "tf_static"
TYPES = {POSES: ("nav_msgs/Odometry", "geometry_msgs/PoseStamped"), BIAS: ("geometry_msgs/Vector3Stamped",),
         FRAMES: ("tf2_msgs/TFMessage", "tf/tfMessage")}


class Truth:
    """Gathers its messages."""

    def __init__(self):
        self.frame, self.places, self.shadows, self.maps = "", {"t": [], "x": [], "y": []}, [], {}
        self.hears = {POSES: self.add_pose, BIAS: self.add_bias, FRAMES: self.add_frames}

    def add_pose(self, message):
        self.frame = message.header.frame_id.lstrip("/")
        pose = getattr(message.pose, "pose", message.pose)
        append(self.places, stamp_of(message), pose.position.x, pose.position.y)

    def add_bias(self, message):
        self.shadows.append((stamp_of(message), int(message.vector.z > 0.5)))

    def add_frames(self, message):
        for item in message.transforms:
            if item.header.frame_id.lstrip("/") == "earth":
                self.maps[item.child_frame_id.lstrip("/")] = map_of(item.transform)

    def columns(self, frame, goal):
        """Truth in the frame of the poses, in the map `goal` where it is known where both lie; None without any."""
        if not self.places["t"] or self.frame != frame:
            return None
        check_columns(POSES, self.places)
        check_times(POSES, self.places["t"])
        columns = dict(self.places, shadow=held(self.shadows, self.places["t"], 0))
        return moved(columns, self.maps[frame], goal) if goal and frame in self.maps else columns

    def notes(self, frame):
        if self.places["t"] and self.frame != frame:
            yield f"Truth is in the frame '{self.frame}', the pose in '{frame}': truth is left out."
