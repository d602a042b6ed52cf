"""Brings the robot into each phase of its work, and out of it."""
import time

import actionlib
import rospy
from frontier_pilot.msg import PatrolAction, PatrolGoal, SpinAction, SpinGoal
from geometry_msgs.msg import Vector3
from std_srvs.srv import Trigger

from run_attack import services
from run_attack.stop_callers import Caller
from run_attack.system import wait_until

PHASES = ('idle', 'exploring', 'patrolling', 'spinning', 'stopped')
MOVING = 0.05  # |v| + |w| of a base that is well on its way


class Phases:
    """Leads the robot, which `watch` sees, into a phase."""

    def __init__(self, watch):
        self._watch = watch
        self._goals = services.Goals()
        self.caller = Caller(persistent=False)
        self._patrol = actionlib.SimpleActionClient('turtlebot3', PatrolAction)
        self._spin = actionlib.SimpleActionClient('spin', SpinAction)

    def wait_for_servers(self):
        return all(client.wait_for_server(rospy.Duration(30.0)) for client in (self._patrol, self._spin))

    def rest(self):
        """Ends whatever there is: the robot stands, and is not stopped. Gives whether that came true."""
        services.explore(False)
        self._goals.cancel()
        return wait_until(lambda: self._watch.speed == 0.0, 5.0) and wait_until(self.caller.clear, 5.0)

    def enter(self, phase):
        """Gives whether the robot is in the phase: on its way in those in which it moves."""
        if phase == 'idle':
            return True
        if phase == 'stopped':
            return self.explore() and self.caller.stop() and wait_until(lambda: self._watch.speed == 0.0, 3.0)
        return {'exploring': self.explore, 'patrolling': self.patrol, 'spinning': self.spin}[phase]()

    def go_on(self, phase):
        """After the fault: gives whether the work of the phase can be done."""
        if phase == 'idle':
            return self.spin()
        if phase == 'stopped':
            return self.rest() and self.explore()
        return self.enter(phase)

    def explore(self, seconds=25.0):
        """The robot drives to explore; a map that is explored already is begun anew."""
        services.explore(True)
        if self._watch.done() or not self._on_the_way(8.0):
            before = self._watch.known
            services.call('mapper/reset', Trigger)
            services.call('frontier_explorer/reset', Trigger)
            return self._on_the_way(seconds) and self._sees_the_new_map(before)
        return True

    def patrol(self):
        """Circles, which need the least room; tried again elsewhere where the way is not free."""
        for attempt in range(4):
            if attempt > 0:
                self._drive_on()
            self._patrol.send_goal(PatrolGoal(Vector3(PatrolGoal.CIRCLE, 0.15, 20.0)))
            if self._on_the_way(3.0):
                return True
        return False

    def spin(self):
        for attempt in range(3):
            if attempt > 0:
                self._drive_on()
            self._spin.send_goal(SpinGoal(target_yaw=60.0))
            if self._on_the_way(4.0):
                return True
        return False

    def _drive_on(self):
        """What is near may leave no room to turn in: the exploration leads away from it, which takes some way."""
        if self.explore(8.0):
            time.sleep(2.0)
        services.explore(False)

    def _sees_the_new_map(self, before):
        """A map with less in it, or the second one: the next one may still be of before the reset, and they come seldom."""
        maps = self._watch.maps
        return wait_until(lambda: self._watch.known < before or self._watch.maps >= maps + 2, 20.0)

    def _on_the_way(self, seconds):
        """Whether the base moves within so many seconds, and not only for a moment."""
        def moves():
            return self._watch.speed is not None and self._watch.speed > MOVING

        def goes_on_moving():
            if not moves():
                return False
            time.sleep(0.3)
            return moves()
        return wait_until(goes_on_moving, seconds)
