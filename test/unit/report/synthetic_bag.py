"""A small bag of an invented run, as the recorder would have written it."""
import json

import rosbag
import rospy
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus, KeyValue
from frontier_pilot.msg import ArbiterStatus, ExplorerStatus, ProcessLoad, ProcessLoads
from geometry_msgs.msg import PoseStamped, TransformStamped
from map_msgs.msg import OccupancyGridUpdate
from nav_msgs.msg import OccupancyGrid, Odometry
from rosgraph_msgs.msg import Log
from std_msgs.msg import Bool, String
from tf2_msgs.msg import TFMessage

BEGIN, SECONDS = 100.0, 60
# Along the way: when a goal was sent, and what the counts (sent, reached, failed) became.
COUNTS = {5: (1, 0, 0), 15: (2, 1, 0), 25: (3, 1, 0), 35: (3, 1, 1), 36: (4, 1, 1)}
PARAMETERS = {'run_id': 'x', 'use_sim_time': True, 'simulator': {'world': '/worlds/small.yaml', 'speed': 3},
              'navigator': {'goal_tolerance': 0.3, 'robot': {'disc_radius': 0.105, 'limits': {'max_linear': 0.5}}},
              'mapper': {'robot': {'limits': {'max_linear': 0.5}}}}


def transform(parent, child, x, y):
    out = TransformStamped()
    out.header.frame_id, out.child_frame_id = parent, child
    out.transform.translation.x, out.transform.translation.y, out.transform.rotation.w = x, y, 1.0
    return TFMessage([out])


def info(moment, **changes):
    parameters = dict(PARAMETERS, **changes)
    return String(json.dumps({'moment': moment, 'wall_time': 1.7e9 + (20.0 if moment == 'end' else 0.0), 'namespace': '/',
                              'topics': {}, 'robot': 'burger', 'parameters': parameters}))


def explorer_status(second):
    sent, reached, failed = [COUNTS[at] for at in sorted(COUNTS) if at <= second][-1] if second >= 5 else (0, 0, 0)
    status = ExplorerStatus(goals_sent=sent, goals_reached=reached, goals_failed=failed, explored_area=0.5 * second,
                            distance_travelled=0.1 * second, estimated_area=35.0, estimated_area_deviation=4.0)
    done = second >= SECONDS - 2
    status.state = ExplorerStatus.DONE if done else ExplorerStatus.NAVIGATING
    status.state_text, status.reason_text = ('done', 'everything within reach is explored') if done else ('driving', 'on the way')
    return status


def messages_at(second):
    """(topic, message) of one second of the run."""
    yield '/tf', transform('map', 'odom', 0.0, 1.0)
    yield '/tf', transform('odom', 'base_footprint', 0.1 * second, 0.0)
    if second in COUNTS:
        goal = PoseStamped()
        goal.pose.position.x, goal.pose.position.y = float(second), 2.0
        yield '/frontier_explorer/goal', goal
    yield '/frontier_explorer/status', explorer_status(second)
    stopped = 20 <= second < 24
    yield '/cmd_vel_arbiter/status', ArbiterStatus(
        state=ArbiterStatus.EMERGENCY_STOP if stopped else ArbiterStatus.DRIVING, active_source='' if stopped else 'nav',
        emergency_stop_cause='emergency_stop called by /teleop_gui' if stopped else '')
    yield '/navigator/status', String('recovering (back up): blocked' if 30 <= second < 33 else 'driving: on the way')
    yield '/simulator/stalled', Bool(second == 40)
    warn = 10 <= second < 20
    yield '/diagnostics', DiagnosticArray(status=[
        DiagnosticStatus(name='mapper: mapping', level=1 if warn else 0, message='%d %% of the scans' % second if warn else 'ok',
                         values=[KeyValue('loops closed', '1' if second >= 45 else '0')])])
    yield '/run_recorder/load', ProcessLoads(wall_time=1.7e9 + second / 3.0, processes=[
        ProcessLoad('/mapper', 7, 0.25, 50000000), ProcessLoad('/navigator', 8, 0.5, 30000000 + 1000000 * second)])


def first_messages(base_frame='base_footprint', **parameters):
    yield '/run_recorder/info', info('start', **parameters)
    odometry = Odometry(child_frame_id=base_frame)
    odometry.header.frame_id = 'odom'
    yield '/odom', odometry
    grid = OccupancyGrid()
    grid.header.frame_id = 'map'
    grid.info.width, grid.info.height, grid.info.resolution = 20, 10, 0.5
    grid.data = [-1] * 200
    yield '/map', grid
    yield '/rosout', Log(level=Log.WARN, name='/mapper', msg='waiting for scan 3')


def last_messages():
    yield '/map_updates', OccupancyGridUpdate(x=2, y=3, width=2, height=1, data=[0, 100])
    yield '/run_recorder/info', info('end', navigator={'goal_tolerance': 0.4})


def write(path, seconds=SECONDS, with_end=True, namespace='', begin=0, base_frame='base_footprint', **parameters):
    """Writes the run, or its seconds from `begin` on and before `seconds`, to `path`; with odometry of that frame, and with these
    parameters besides at the start."""
    with rosbag.Bag(path, 'w', compression='lz4', chunk_threshold=4096) as bag:
        def put(messages, time):
            for topic, message in messages:
                is_global = topic in ('/tf', '/diagnostics', '/rosout')
                bag.write(topic if is_global else namespace + topic, message, rospy.Time.from_sec(BEGIN + time))
        put(first_messages(base_frame, **parameters), float(begin))
        for second in range(begin, seconds):
            put(messages_at(second), second + 0.001)
        if with_end:
            put(last_messages(), float(SECONDS))
