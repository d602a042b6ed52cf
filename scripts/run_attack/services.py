"""Calls with a limit of time, and those that bring the system back to work."""
import re
import threading

import genpy
import rospy
from actionlib_msgs.msg import GoalID
from std_srvs.srv import SetBool, Trigger

from run_attack.system import wait_until
from run_attack.velocity_sources import SOURCES

PATIENCE = 5.0  # [s] within which every service has to answer
STOP_IS_KNOWN = 5.0  # [s] within which an explorer, even one that is being started, serves and has heard that a stop is cleared
ACTIONS = ('move_base', 'follow_waypoints', 'turtlebot3', 'spin', 'back_up', 'drive_on_heading', 'wait')


class NoAnswer(Exception):
    """A service has not answered in time."""


def call(name, kind, request=None, patience=PATIENCE):
    """The response, None where the service has refused the request or is not there; NoAnswer after `patience` [s]."""
    answer = []

    def ask():
        try:
            answer.append(rospy.ServiceProxy(name, kind).call(request if request is not None else kind._request_class()))
        except (rospy.ServiceException, rospy.exceptions.ROSException, genpy.SerializationError, OSError):
            answer.append(None)
    thread = threading.Thread(target=ask, daemon=True)
    thread.start()
    thread.join(patience)
    if not answer:
        raise NoAnswer('%s does not answer within %.0f s' % (name, patience))
    return answer[0]


def switch(name, on):
    return call(name, SetBool, SetBool._request_class(on))


def explore(on, space=''):
    """The answer of the explorer of that namespace. It is asked to explore again as long as it answers that the robot is stopped, or that
    the arbiter has to say first whether it was: it may not have heard yet of a clear that has just been answered, and would be paused when
    it does. So it is while it has no service, because it is being started."""
    answers = []

    def knows():
        answers.append(switch(space + 'set_exploration_enabled', on))
        return not on or bool(answers[-1]) and not re.search('the robot (is|was) stopped', answers[-1].message)
    wait_until(knows, STOP_IS_KNOWN)
    return answers[-1]


class Goals:
    """Cancels the goals of all actions."""

    def __init__(self):
        self._cancels = [rospy.Publisher(name + '/cancel', GoalID, queue_size=5) for name in ACTIONS]

    def cancel(self):
        for publisher in self._cancels:
            publisher.publish(GoalID())


def set_upright(goals):
    """Takes back what an operator may have switched, bounded or asked for, and begins a new map; the stop is not cleared."""
    goals.cancel()
    for source in SOURCES:
        switch('set_%s_enabled' % source, True)
    switch('simulator/pause', False)
    switch('set_obstacle_avoid_enabled', False)
    switch('frontier_explorer/set_return_to_start', False)
    for name in ('waypoint_follower/clear', 'frontier_explorer/clear_bounds', 'frontier_explorer/clear_inspections',
                 'mapper/reset', 'frontier_explorer/reset'):
        call(name, Trigger)
