#!/usr/bin/env python3
"""Example of a bridge: fieldcal play --robots-at HOST:PORT sends robot commands here, 100 times a second.

It needs nothing but Python. Write your radio into drive(); everything else may stay.
Usage: bridge.py [PORT], by default 10400.
"""
import socket
import struct
import sys

SILENCE = 0.2  # Without a command for so long all robots stop, s.
STOP = {"forward": 0.0, "left": 0.0, "angular": 0.0, "kick": 0.0, "angle": 0.0, "dribbler": 0.0}


def drive(robot, c):
    """YOUR RADIO: velocities in the robot's frame (m/s, rad/s), kick m/s, angle degrees, dribbler turns/min."""
    print("robot %d: " % robot + ", ".join("%s %.3f" % item for item in c.items()), flush=True)


def varint(data, at):
    value = shift = 0
    while True:
        value |= (data[at] & 127) << shift
        shift += 7
        at += 1
        if data[at - 1] < 128:
            return value, at


def fields(data):
    """Number and value of each field of a protobuf message."""
    at = 0
    while at < len(data):
        key, at = varint(data, at)
        if key & 7 == 0:
            value, at = varint(data, at)
        elif key & 7 == 5:
            value, at = struct.unpack_from("<f", data, at)[0], at + 4
        elif key & 7 == 2:
            size, at = varint(data, at)
            value, at = data[at:at + size], at + size
        else:
            raise ValueError("not a RobotControl")
        yield key >> 3, value


def commands(packet):
    """RobotControl: robot and command, ssl_simulation_robot_control.proto."""
    for command in (value for number, value in fields(packet) if number == 1):
        c, robot = dict(STOP), None
        for number, value in fields(command):
            if number == 1:
                robot = value
            elif number == 2:  # move_command, of which fieldcal sends local_velocity only
                velocity = dict(fields(dict(fields(value))[2]))
                c.update(forward=velocity[1], left=velocity[2], angular=velocity[3])
            elif number in (3, 4, 5):
                c[("kick", "angle", "dribbler")[number - 3]] = value
        yield robot, c


def main():
    sock = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    sock.bind(("", int(sys.argv[1]) if len(sys.argv) > 1 else 10400))
    sock.settimeout(SILENCE)
    moving = set()
    while True:
        try:
            packet, sender = sock.recvfrom(65536)
            for robot, c in commands(packet):
                drive(robot, c)
                moving.add(robot)
            sock.sendto(feedback(moving), sender)
        except socket.timeout:  # The play has ended, or the network has: nobody may drive on.
            for robot in moving:
                drive(robot, STOP)
            moving.clear()
        except (ValueError, IndexError, KeyError, struct.error) as error:
            print("unreadable packet: %s" % error, file=sys.stderr)


def feedback(robots):
    """RobotControlResponse: the robots that heard. fieldcal stops the play when no answer comes."""
    return b"".join(bytes((0x12, 2, 0x08, robot)) for robot in robots)


if __name__ == "__main__":
    main()
