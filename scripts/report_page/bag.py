"""Reads a recorded run of one localization_node, or of several in namespaces of their own."""
import pathlib
import struct

import genpy
import rosbag

from . import bag_node, bag_truth
from .run import distances
from .series import BadRun, check_columns, in_order


UNREADABLE = (rosbag.ROSBagException, genpy.MessageException, struct.error, OSError, EOFError, KeyError, ValueError)
EMPTY = {"t": [], "x": [], "y": []}


def hearers(topics, nodes, truth):
    """{topic: what takes its messages}; puts into `nodes` a node for each namespace."""
    found = {}
    for topic, kind in topics.items():
        path = topic.strip("/")
        name = next((name for name in bag_node.TYPES if f"/{path}".endswith(f"/{name}")), None)
        if name and kind == bag_node.TYPES[name]:
            namespace = path[:-len(name)].strip("/")
            found[topic] = nodes.setdefault(namespace, bag_node.Node(namespace)).hears[name]
        elif kind in bag_truth.TYPES.get(path, ()):
            found[topic] = truth.hears[path]
    return found


def collect(file):
    """(nodes with poses, Truth) of a bag."""
    nodes, truth = {}, bag_truth.Truth()
    with rosbag.Bag(str(file)) as bag:
        topics = {topic: info.msg_type for topic, info in bag.get_type_and_topic_info().topics.items()}
        hears = hearers(topics, nodes, truth)
        for topic, message, _ in bag.read_messages(topics=list(hears)) if hears else ():
            hears[topic](message)
    heard = [node for _, node in sorted(nodes.items()) if node.poses["t"]]
    if not heard:
        raise BadRun(f"holds no pose of localization_node ({bag_node.POSES}), but {', '.join(sorted(topics)) or 'nothing'}. "
                     f"Of a bag of sensors alone `evaluate --bag {file} --report OUT.html` makes a page")
    return heard, truth


def begin_at_zero(stream, runs):
    """Counts all times from the first pose on, whose stamp it returns."""
    start = min(run["estimates"]["t"][0] for run in runs)
    tables = [stream["fixes"], stream["odometry"], stream["truth"] or {"t": []}]
    tables += [run[key] for run in runs for key in ("estimates", "weighings")]
    for columns in tables:
        columns["t"] = [time - start for time in columns["t"]]
    return start


def read_bag(file):
    """A recording as run.py has it. Throws BadRun."""
    try:
        nodes, truth = collect(file)
    except rosbag.ROSBagUnindexedException:
        raise BadRun(f"has no index, as it was not closed: `rosbag reindex {file}` makes one") from None
    except UNREADABLE as error:
        raise BadRun(f"cannot be read as a bag: {error}") from None
    except AttributeError as error:
        raise BadRun(f"holds messages of another version of this package: {error}") from None
    first = nodes[0]
    notes = [note for node in nodes for note in node.notes()] + list(truth.notes(first.frame))
    if not first.fixes["t"]:
        notes.append(f"The recording has no {bag_node.FIXES}: the map is without fixes.")
    runs = [node.run(first.map()) for node in nodes]
    check_columns(bag_node.POSES, first.motion)
    stream = {"truth": truth.columns(first.frame, first.map()), "fixes": in_order(first.fixes), "odometry": first.motion}
    start = begin_at_zero(stream, runs)
    stream["fix_errors"] = distances(stream["truth"] or EMPTY, stream["fixes"])
    return {"title": pathlib.Path(file).stem, "start": start, "notes": notes, "streams": [stream], "runs": runs}
