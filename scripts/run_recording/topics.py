"""The topics that the record of a run holds, by what a report calls them. They are resolved by the recorder, so that
remappings and namespaces apply."""

SOURCES = ('avoid', 'behavior', 'patrol', 'nav', 'manual')
ACTIONS = ('move_base', 'follow_waypoints', 'turtlebot3', 'spin', 'back_up', 'drive_on_heading', 'wait')

# Without pictures of what is in other topics: costmaps, plans, and the markers for rviz.
TOPICS = (
    ['map', 'map_updates', 'odom', 'cmd_vel'] +
    ['cmd_vel_' + source for source in SOURCES] +
    ['cmd_vel_arbiter/status', 'emergency_stop_state', 'obstacle_avoider/status', 'navigator/status',
     'frontier_explorer/status', 'frontier_explorer/goal', 'move_base_simple/goal', 'waypoint_follower/add', 'initialpose', 'battery_state',
     'simulator/stalled', 'run_recorder/info', 'run_recorder/load'] +
    [action + '/' + part for action in ACTIONS for part in ('goal', 'cancel', 'result')] +
    ['/tf', '/tf_static', '/diagnostics', '/rosout'])
SCAN = 'scan'
