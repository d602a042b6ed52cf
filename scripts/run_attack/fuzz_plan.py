"""Which inputs the fuzzer uses in which round, and what it keeps to itself."""
import re

# What tells the robot where it is and what is around it, and the simulator what the world is. Lies there may move it into a wall.
# The mapper withdraws its map as long as somebody else publishes one. [MAP-3]
WORLD = re.compile(r'/(clock|tf|tf_static|scan|odom|map|map_updates|map_changes|simulator/.*|reset_positions)$')
# Who publishes these drives the robot, with no look at the scan.
WHEELS = re.compile(r'/cmd_vel(_[a-z]+)?$')
# A report of another arbiter that the robot is stopped, true or not, stops it: nothing would move any more.
STOPPING = re.compile(r'/emergency_stop_state$')
# The attack stops and clears itself, and has to know when.
RESERVED = re.compile(r'/(emergency_stop|set_emergency_stop)$')
BLIND = 'disable_collision_checks'  # a field of goals


def chosen(names, honest):
    """The inputs of a round: without what it may not have in an honest one, and never those of the stop."""
    return [name for name in names if not RESERVED.search(name)
            and not (honest and any(rule.search(name) for rule in (WORLD, WHEELS, STOPPING)))]
