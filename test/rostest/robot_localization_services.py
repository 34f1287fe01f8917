"""Service classes made of robot_localization's definitions, as a client has them that was built against that package."""
import sys
import types

import genmsg
import rospkg
from genmsg.msg_loader import load_msg_from_string, load_srv_from_string
from genpy.generator import msg_generator, srv_generator

MESSAGES = {
    'geographic_msgs/GeoPoint': 'float64 latitude\nfloat64 longitude\nfloat64 altitude\n',
    'geographic_msgs/GeoPose': 'GeoPoint position\ngeometry_msgs/Quaternion orientation\n'}
SERVICES = {
    'robot_localization/SetDatum': 'geographic_msgs/GeoPose geo_pose\n---\n',
    'robot_localization/ToLL': 'geometry_msgs/Point map_point\n---\ngeographic_msgs/GeoPoint ll_point\n',
    'robot_localization/FromLL': 'geographic_msgs/GeoPoint ll_point\n---\ngeometry_msgs/Point map_point\n',
    'robot_localization/SetPose': 'geometry_msgs/PoseWithCovarianceStamped pose\n---\n'}


def module(name):
    """A module of that dotted name, made where there is none."""
    if name not in sys.modules:
        sys.modules[name] = types.ModuleType(name)
        parent, _, own = name.rpartition('.')
        if parent:
            setattr(module(parent), own, sys.modules[name])
    return sys.modules[name]


def define():
    """Makes and returns the modules geographic_msgs.msg and robot_localization.srv."""
    packages = rospkg.RosPack()
    paths = {name: [packages.get_path(name) + '/msg'] for name in ('geometry_msgs', 'std_msgs')}
    context = genmsg.MsgContext.create_default()
    messages = [load_msg_from_string(context, text, name) for name, text in MESSAGES.items()]
    for message in messages:
        exec('\n'.join(msg_generator(context, message, paths)), module('geographic_msgs.msg').__dict__)
    for name, text in SERVICES.items():
        service = load_srv_from_string(context, text, name)
        exec('\n'.join(srv_generator(context, service, paths)), module('robot_localization.srv').__dict__)
    return module('geographic_msgs.msg'), module('robot_localization.srv')
