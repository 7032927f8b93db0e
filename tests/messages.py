"""Reads MCAP files with the readers of others and compares every number with the tables beside them.

messages.py FILE RATE_HZ [imu.csv] [truth.csv] [computed.csv]: an absent table is written as -.
"""

import collections
import csv
import math
import sys

from mcap.reader import make_reader
from mcap_ros2.decoder import DecoderFactory

IMU, FIX, POSE = (
    "sensor_msgs/msg/Imu",
    "sensor_msgs/msg/NavSatFix",
    "geometry_msgs/msg/PoseStamped",
)


def table(name):
    with open(name, newline="") as file:
        return [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]


def product(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(3)) for j in range(3)] for i in range(3)]


def turn(axis, angle):
    """About x, y or z."""
    s, c = math.sin(angle), math.cos(angle)
    i, j = [(1, 2), (2, 0), (0, 1)][axis]
    matrix = [[float(m == n) for n in range(3)] for m in range(3)]
    matrix[i][i], matrix[i][j], matrix[j][i], matrix[j][j] = c, -s, s, c
    return matrix


def matrix(q):
    w, x, y, z = q.w, q.x, q.y, q.z
    return [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]


def near(what, got, expected, bound):
    if not abs(got - expected) <= bound:
        sys.exit(f"mcap: {what}: {got!r}, not {expected!r}")


def check_fix(row, message):
    for name in ["latitude", "longitude"]:
        near(name, getattr(message, name), row[f"{name}_deg"], 1e-13 * 360)
    near("altitude", message.altitude, row["altitude_m"], 1e-9)
    assert message.header.frame_id == "base_link" and message.status.service == 1


def check_pose(row, message):
    # WGS 84.
    a, f = 6378137.0, 1 / 298.257223563
    e2 = f * (2 - f)
    phi, lam = (math.radians(row[key]) for key in ["latitude_deg", "longitude_deg"])
    n, h = a / math.sqrt(1 - e2 * math.sin(phi) ** 2), row["altitude_m"]
    level = (n + h) * math.cos(phi)
    place = [level * math.cos(lam), level * math.sin(lam), (n * (1 - e2) + h) * math.sin(phi)]
    for axis, expected in zip("xyz", place):
        near(f"pose {axis}", getattr(message.pose.position, axis), expected, 1e-8)
    # Forward, left, up to north, east, down, and these to the Earth.
    body = turn(2, math.radians(row["yaw_deg"]))
    body = product(body, turn(1, math.radians(row["pitch_deg"])))
    body = product(body, turn(0, math.radians(row["roll_deg"])))
    ned = product(turn(2, lam), turn(1, -phi - math.pi / 2))
    expected = product(product(ned, body), turn(0, math.pi))
    got = matrix(message.pose.orientation)
    for i in range(3):
        for j in range(3):
            near(f"attitude {i} {j}", got[i][j], expected[i][j], 1e-12)
    assert message.header.frame_id == "earth"


def check_imu(row, message, rate_hz):
    rates, force = message.angular_velocity, message.linear_acceleration
    names = ["dtheta_x_rad", "dtheta_y_rad", "dtheta_z_rad", "dvel_x_m_s", "dvel_y_m_s", "dvel_z_m_s"]
    got = [rates.x, -rates.y, -rates.z, force.x, -force.y, -force.z]
    for name, value in zip(names, got):
        near(name, value / rate_hz, row[name], 1e-15 * abs(row[name]))
    assert message.orientation_covariance[0] == -1


def main(file, rate_hz, imu="-", truth="-", computed="-"):
    expected = {}
    if imu != "-":
        expected["/imu"] = (IMU, table(imu), lambda row, m: check_imu(row, m, float(rate_hz)))
    for name, rows in [("truth", truth), ("computed", computed)]:
        if rows != "-":
            expected[f"/{name}/fix"] = (FIX, table(rows), check_fix)
            expected[f"/{name}/pose"] = (POSE, table(rows), check_pose)
    seen = collections.Counter()
    with open(file, "rb") as stream:
        reader = make_reader(stream, validate_crcs=True, decoder_factories=[DecoderFactory()])
        assert reader.get_header().profile == "ros2"
        for schema, channel, message, decoded in reader.iter_decoded_messages():
            if channel.topic not in expected:
                sys.exit(f"mcap: {file}: {channel.topic} is not expected")
            kind, rows, check = expected[channel.topic]
            assert schema.name == kind, schema.name
            row = rows[seen[channel.topic]]
            stamp = decoded.header.stamp
            near("stamp", stamp.sec * 10**9 + stamp.nanosec, message.log_time, 0)
            near("time", message.log_time / 1e9, row["time_s"], 1e-9)
            check(row, decoded)
            seen[channel.topic] += 1
        counted = reader.get_summary().statistics.message_count
    for topic, (_, rows, _) in expected.items():
        if seen[topic] != len(rows):
            sys.exit(f"mcap: {file}: {seen[topic]} messages of {topic}, {len(rows)} rows")
    assert counted == sum(seen.values())
    print(f"mcap: {file.rsplit('/', 1)[-1]}: {counted} messages, every number that of the tables")


main(*sys.argv[1:])
