#!/usr/bin/env python3
"""Example of a bridge: fieldcal play --robots-at HOST:PORT sends robot commands here, 100 times a second.

It needs nothing but Python. Write your radio into drive(); everything else may stay. Usage: bridge.py [PORT]
"""
import logging  # Unlike print, it does not fail when the terminal is gone.
import signal
import socket
import struct
import sys
import time

SILENCE = 0.2  # A robot that gets no command for so long stops, s.
STOP = {"forward": 0.0, "left": 0.0, "angular": 0.0, "kick": 0.0, "angle": 0.0, "dribbler": 0.0}


def drive(robot, c):
    """YOUR RADIO: velocities in the robot's frame (m/s, rad/s), kick m/s, angle degrees, dribbler turns/min."""
    print("robot %d: " % robot + ", ".join("%s %.3f" % item for item in c.items()), flush=True)


def varint(data, at):
    rest, after = varint(data, at + 1) if data[at] > 127 else (0, at + 1)
    return (data[at] & 127) + (rest << 7), after


def fields(data):
    """Number and value of each field of a protobuf message."""
    at = 0
    while at < len(data):
        key, at = varint(data, at)
        if key & 7 == 5:
            value, at = struct.unpack_from("<f", data, at)[0], at + 4
        else:
            value, at = varint(data, at)
        if key & 7 == 2:
            value, at = data[at:at + value], at + value
        yield key >> 3, value


def commands(packet):
    """RobotControl of ssl_simulation_robot_control.proto: for each robot the command. fieldcal sends local velocities."""
    for c in (dict(fields(value)) for number, value in fields(packet) if number == 1):
        velocity = dict(fields(dict(fields(c[2]))[2]))
        yield c[1], dict(STOP, forward=velocity[1], left=velocity[2], angular=velocity[3],
                         kick=c.get(3, 0.0), angle=c.get(4, 0.0), dribbler=c.get(5, 0.0))


def stopped(robot):
    try:
        drive(robot, STOP)
        return True
    except Exception as error:
        logging.error("robot %d is not stopped yet: %r", robot, error)
        return False


def main():
    for number in {signal.SIGINT, signal.SIGTERM, getattr(signal, "SIGHUP", signal.SIGTERM)}:  # Windows has no SIGHUP.
        signal.signal(number, signal.default_int_handler)  # kill and a closed terminal end it as Ctrl-C does.
    sock = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    sock.bind(("", int(sys.argv[1]) if len(sys.argv) > 1 else 10400))
    sock.settimeout(SILENCE / 4)
    heard = {}  # When the robots that may be moving got their last command, s.
    try:
        while True:
            try:
                packet, sender = sock.recvfrom(65536)
                for robot, c in list(commands(packet)):
                    heard[robot] = time.monotonic()
                    drive(robot, c)
                # RobotControlResponse. When none comes, fieldcal stops both robots.
                sock.sendto(b"".join(bytes((0x12, 2, 0x08, robot)) for robot in heard), sender)
            except socket.timeout:
                pass
            except Exception as error:  # A wrong packet, or your radio: go on, and stop the robots if it lasts.
                logging.error("command lost: %r", error)
            now = time.monotonic()  # A silent robot: the play has ended, or the network has. Stop it as soon as the radio can.
            heard = {r: last for r, last in heard.items() if now - last <= SILENCE or not stopped(r)}
    finally:
        end = time.monotonic() + 10 * SILENCE  # So long the radio may take to work again.
        while heard and time.monotonic() < end:
            heard = {r: last for r, last in heard.items() if not stopped(r)}
            time.sleep(SILENCE / 4 if heard else 0)


if __name__ == "__main__":
    main()
