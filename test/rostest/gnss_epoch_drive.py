#!/usr/bin/python3
"""Writes a drive of twelve seconds to a folder of its own and prints the folder's path; also says what is in it."""
import math
import tempfile

from synthetic_drive import DATUM, Robot, to_geodetic

SECONDS, RATE = 12.0, 20


def lines_of(robot, i):
    """What one instant adds to each file, by name."""
    t = robot.stamp
    latitude, longitude = to_geodetic(robot.x, robot.y)
    lines = {'odometry.csv': ['%.3f,%.6f,%.6f' % (t, robot.speed, robot.yaw_rate)],
             'truth.csv': ['%.3f,%.10f,%.10f,%.4f,%.6f' % (t, latitude, longitude, DATUM[2],
                                                           math.remainder(robot.yaw, 2.0 * math.pi))]}
    if i % 4 == 0:
        fix = robot.fix()
        lines['fix.csv'] = ['%.3f,%.10f,%.10f,%.4f,0.09,0,0.09' % (t, fix.latitude, fix.longitude, fix.altitude)]
        lines['pseudoranges.csv'] = [
            '%.3f,%d,GPS,%.4f,%.1f,%.4f,%.4f,%.4f,%.4f,%.1f' % (
                t, p.satellite, math.degrees(p.elevation), p.cn0, p.position.x, p.position.y, p.position.z,
                p.pseudorange, p.sigma)
            for p in robot.epoch().pseudoranges]
    return lines


def write_drive(folder):
    files = {'odometry.csv': ['t,vx,wz'],
             'truth.csv': ['t,lat_deg,lon_deg,alt_m,yaw'],
             'fix.csv': ['t,lat_deg,lon_deg,alt_m,cov_ee_m2,cov_en_m2,cov_nn_m2'],
             'pseudoranges.csv': ['t,sat_id,system,elevation_deg,cn0_dbhz,sat_x,sat_y,sat_z,pseudorange_m,std_m']}
    robot = Robot(seed=8, start=100.0)
    for i in range(int(SECONDS * RATE) + 1):
        for name, lines in lines_of(robot, i).items():
            files[name] += lines
        robot.step(1.0 / RATE)
    for name, lines in files.items():
        with open(folder + '/' + name, 'w', encoding='utf-8') as file:
            file.write('\n'.join(lines) + '\n')


if __name__ == '__main__':
    path = tempfile.mkdtemp(prefix='gnss_epoch_drive_')
    write_drive(path)
    print(path, end='')
