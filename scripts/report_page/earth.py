"""Where maps lie on the Earth, WGS 84."""
import collections
import math

MAJOR, ECCENTRICITY2 = 6378137.0, 6.69437999014e-3

Map = collections.namedtuple("Map", "origin east north")  # Earth-centred: its origin [m], the directions of its axes


def map_at(latitude, longitude, altitude):
    """The map that begins there [deg, m]."""
    phi, lam = math.radians(latitude), math.radians(longitude)
    across = MAJOR / math.sqrt(1.0 - ECCENTRICITY2 * math.sin(phi) ** 2)
    origin = ((across + altitude) * math.cos(phi) * math.cos(lam), (across + altitude) * math.cos(phi) * math.sin(lam),
              (across * (1.0 - ECCENTRICITY2) + altitude) * math.sin(phi))
    north = (-math.sin(phi) * math.cos(lam), -math.sin(phi) * math.sin(lam), math.cos(phi))
    return Map(origin, (-math.sin(lam), math.cos(lam), 0.0), north)


def map_of(transform):
    """The map that a transform earth -> map tells."""
    q, t = transform.rotation, transform.translation
    east = (1.0 - 2.0 * (q.y ** 2 + q.z ** 2), 2.0 * (q.x * q.y + q.w * q.z), 2.0 * (q.x * q.z - q.w * q.y))
    north = (2.0 * (q.x * q.y - q.w * q.z), 1.0 - 2.0 * (q.x ** 2 + q.z ** 2), 2.0 * (q.y * q.z + q.w * q.x))
    return Map((t.x, t.y, t.z), east, north)


def moved(columns, start, goal):
    """Columns x and y of one map in another one near it, whose axes are taken to point alike."""
    between = [a - b for a, b in zip(start.origin, goal.origin)]
    east, north = (sum(a * b for a, b in zip(axis, between)) for axis in (goal.east, goal.north))
    return dict(columns, x=[x + east for x in columns["x"]], y=[y + north for y in columns["y"]])
