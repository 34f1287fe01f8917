"""Series over time: whether they can be used, and what is told by them. Times are seconds, lengths metres."""
import bisect
import math

LONGEST_PAUSE = 86400.0  # [s] between two entries: stamps of two clocks lie further apart
LARGEST = 1e30  # no number of a run is larger, and the square of this one is still a number
MOST_POINTS = 6000  # of a series, several for each pixel of a wide screen


class BadRun(Exception):
    """Why no page can be made of a run."""


def is_number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool) and -LARGEST < value < LARGEST


def check_times(name, times):
    """Refuses times that go back or that two clocks have told."""
    for before, after in zip(times, times[1:]):
        if after < before:
            raise BadRun(f"{name}: time goes back from {before:.3f} s to {after:.3f} s; make a page of each part")
        if after - before > LONGEST_PAUSE:
            raise BadRun(f"{name}: time jumps from {before:.3f} s to {after:.3f} s, as if by another clock")


def check_columns(name, columns):
    """Refuses columns of different length and what is no number in them."""
    if len({len(column) for column in columns.values()}) > 1:
        sizes = ", ".join(f"{key} {len(column)}" for key, column in columns.items())
        raise BadRun(f"{name}: the columns differ in length: {sizes}")
    for key, column in columns.items():
        for i, value in enumerate(column):
            if not is_number(value):
                raise BadRun(f"{name}: {key} {i + 1} is {str(value)[:40]}, which is no number to be drawn")


def selected(columns, indices):
    return {key: [column[i] for i in indices] for key, column in columns.items()}


def in_order(columns):
    """The rows by time: measurements may come late."""
    times = columns["t"]
    return selected(columns, sorted(range(len(times)), key=times.__getitem__))


def thinned(columns, weights):
    """No more than MOST_POINTS rows, in each stretch the one of the largest weight, so that no peak is lost."""
    count = len(weights)
    if count <= MOST_POINTS:
        return columns
    edges = [count * i // MOST_POINTS for i in range(MOST_POINTS + 1)]
    return selected(columns, [max(range(a, b), key=weights.__getitem__) for a, b in zip(edges, edges[1:])])


def append(columns, *row):
    for column, value in zip(columns.values(), row):
        column.append(value)


def held(changes, times, before):
    """What was told last at each of the times, by (time, value) of each change; `before` the first."""
    found, ordered, following, value = [], sorted(changes), 0, before
    for time in times:
        while following < len(ordered) and ordered[following][0] <= time:
            value = ordered[following][1]
            following += 1
        found.append(value)
    return found


def intervals(times, flags):
    """Pairs of times between which the flag is set."""
    found, begin = [], None
    for time, flag in zip(times, flags):
        if flag and begin is None:
            begin = time
        elif not flag and begin is not None:
            found.append([begin, time])
            begin = None
    return found + ([[begin, times[-1]]] if begin is not None else [])


def at(track, time, longest=1.0):
    """(x, y) of a track, interpolated linearly; None outside it and in its gaps over `longest` [s]."""
    times = track["t"]
    i = bisect.bisect_left(times, time)
    if i == len(times) or (i == 0 and times[0] != time):
        return None
    if times[i] == time:
        return track["x"][i], track["y"][i]
    before, after = times[i - 1], times[i]
    if after - before > longest:
        return None
    part = (time - before) / (after - before)
    return tuple(track[key][i - 1] + part * (track[key][i] - track[key][i - 1]) for key in "xy")


def speeds(track, over=1.0):
    """How fast a track goes over the last second [m/s]."""
    times, found, j = track["t"], {"t": [], "speed": []}, 0
    for i, time in enumerate(times):
        while j + 1 < i and times[j + 1] <= time - over:
            j += 1
        if 0.5 * over < time - times[j] < 3.0 * over:
            way = math.hypot(track["x"][i] - track["x"][j], track["y"][i] - track["y"][j])
            found["t"].append(0.5 * (time + times[j]))
            found["speed"].append(way / (time - times[j]))
    return found


def length(track):
    """The way along a track, without what jitters by less than half a metre [m]."""
    way, last = 0.0, None
    for point in zip(track["x"], track["y"]):
        step = math.dist(point, last) if last else 0.0
        if last is None or step >= 0.5:
            way, last = way + step, point
    return way


def quantile(values, fraction):
    """Linear between order statistics."""
    ordered = sorted(values)
    place = fraction * (len(ordered) - 1)
    below = int(place)
    above = min(below + 1, len(ordered) - 1)
    return ordered[below] + (place - below) * (ordered[above] - ordered[below])
